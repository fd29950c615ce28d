import { useState } from "preact/hooks";
import { Button, Empty, FormDialog, Loading, Problem, TableScroll, TextField } from "../../components";
import { navigate } from "../../core/address";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { useResource } from "../../core/resource";
import { may } from "../../core/session";
import { formatMoment } from "../../core/times";
import type { ListedStudy } from "../../core/types";

/** Surveys joined: every study with what its newest computing was of. */
export default function StudiesScreen() {
  const studies = useResource((signal) => api.ask("GET /studies", {}, { signal }), []);
  const [making, setMaking] = useState(false);
  const make = may("operator") && (
    <Button kind="primary" icon="add" onClick={() => setMaking(true)}>
      {say("studies-new")}
    </Button>
  );
  return (
    <div class="page page--alone">
      <header class="page__head">
        <div>
          <h1>{say("page-studies")}</h1>
          <p class="page__lead">{say("studies-lead")}</p>
        </div>
        {studies.data && studies.data.length > 0 && make}
      </header>
      <Problem error={studies.error} again={studies.reload} />
      {!studies.data && studies.loading && <Loading what={say("studies-loading")} />}
      {studies.data?.length === 0 && (
        <section class="panel">
          <Empty title={say("studies-none-title")} actions={make || undefined}>
            <p>{say("studies-none")}</p>
          </Empty>
        </section>
      )}
      {studies.data && studies.data.length > 0 && <List studies={studies.data} />}
      {making && <NewStudy close={() => setMaking(false)} />}
    </div>
  );
}

function List({ studies }: { studies: readonly ListedStudy[] }) {
  return (
    <section class="panel" aria-label={say("page-studies")}>
      <TableScroll label={say("page-studies")}>
        <table class="table table--hover" data-testid="studies">
          <thead>
            <tr>
              <th>{say("studies-name")}</th>
              <th class="num">{say("studies-surveys")}</th>
              <th class="num">{say("studies-sites")}</th>
              <th class="num">{say("studies-heights")}</th>
              <th>{say("studies-computed")}</th>
            </tr>
          </thead>
          <tbody>
            {studies.map((one) => (
              <tr key={one.id}>
                <th scope="row">
                  <a href={`/study?id=${one.id}`}>{one.name}</a>{" "}
                  {one.simulated && <span class="badge">{say("study-simulated")}</span>}
                </th>
                <td class="num">{one.surveys}</td>
                <td class="num">{one.sites}</td>
                <td class="num">{one.heights ?? "–"}</td>
                <td class="nowrap">
                  {one.computed_at ? formatMoment(one.computed_at) : say("studies-not-computed")}
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      </TableScroll>
    </section>
  );
}

function NewStudy({ close }: { close: () => void }) {
  const [name, setName] = useState("");
  const [description, setDescription] = useState("");
  const make = async () => {
    const made = await api.write("POST /studies", {}, { body: { name, description } });
    navigate(`/study?id=${made.id}`);
  };
  return (
    <FormDialog title={say("studies-new")} action={say("studies-new-make")} onClose={close} submit={make}>
      <TextField label={say("study-name")} value={name} onInput={setName} />
      <TextField label={say("study-description")} value={description} onInput={setDescription} rows={3} />
    </FormDialog>
  );
}
