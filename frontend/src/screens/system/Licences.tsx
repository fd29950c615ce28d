/** The libraries that the server runs on and that the pages are made of, with the licences that they state. */
import inPages from "virtual:licences";
import { useState } from "preact/hooks";
import { Button, Loading, Problem } from "../../components";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { useResource } from "../../core/resource";

export function Licences() {
  const [open, setOpen] = useState(false);
  return (
    <section class="panel">
      <header class="panel__head">
        <h2>{say("system-licences")}</h2>
        <Button onClick={() => setOpen(!open)}>
          {say(open ? "system-licences-hide" : "system-licences-show")}
        </Button>
      </header>
      {open && <Lists />}
    </section>
  );
}

function Lists() {
  const found = useResource((signal) => api.ask("GET /system/licences", {}, { signal }), []);
  return (
    <>
      <Problem error={found.error} again={found.reload} />
      {!found.data && found.loading && <Loading what={say("system-licences-loading")} />}
      {found.data && <List title={say("system-licences-server")} libraries={found.data} />}
      <List title={say("system-licences-pages")} libraries={inPages} />
    </>
  );
}

interface Library {
  name: string;
  version: string;
  licence: string | null;
}

function List({ title, libraries }: { title: string; libraries: readonly Library[] }) {
  return (
    <div class="table-scroll">
      <table class="table">
        <thead>
          <tr>
            <th>{title}</th>
            <th>{say("system-licences-version")}</th>
            <th>{say("system-licences-licence")}</th>
          </tr>
        </thead>
        <tbody>
          {libraries.map((one) => (
            <tr key={`${one.name} ${one.version}`}>
              <td>{one.name}</td>
              <td class="nowrap">{one.version}</td>
              <td>{one.licence ?? say("system-licences-none")}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
