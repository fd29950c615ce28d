/** The libraries that the server runs on and that the pages are made of, with the licences that they state. */
import inPages from "virtual:licences";
import { useState } from "preact/hooks";
import { Button, DataTable, Loaded, Panel } from "../../components";
import { say } from "../../core/messages";
import { useAsked } from "../../core/resource";

export function Licences() {
  const [open, setOpen] = useState(false);
  return (
    <Panel
      says="system-licences"
      aside={
        <Button
          says={open ? "system-licences-hide" : "system-licences-show"}
          onClick={() => setOpen(!open)}
        />
      }
    >
      {open && <Lists />}
    </Panel>
  );
}

function Lists() {
  const found = useAsked("GET /system/licences");
  return (
    <>
      <Loaded of={found} what={say("system-licences-loading")} />
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
    <DataTable
      label={title}
      rows={libraries}
      keyOf={(one) => `${one.name} ${one.version}`}
      columns={({ col }) => [
        col(title, (one) => one.name),
        col(say("system-licences-version"), (one) => one.version, "nowrap"),
        col(say("system-licences-licence"), (one) => one.licence ?? say("system-licences-none")),
      ]}
    />
  );
}
