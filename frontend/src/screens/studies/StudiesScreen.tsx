import { useState } from "preact/hooks";
import { Button, DataTable, Empty, FormDialog, Loaded, PageHead, TextField } from "../../components";
import { navigate } from "../../core/address";
import { api } from "../../core/api";
import { useForm } from "../../core/form";
import { say } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { may } from "../../core/session";
import { formatMoment } from "../../core/times";
import type { ListedStudy } from "../../core/types";
import { formatCount } from "../../core/units";

export default function StudiesScreen() {
  const studies = useAsked("GET /studies");
  const [making, setMaking] = useState(false);
  const make = may("operator") && (
    <Button says="studies-new" kind="primary" icon="add" onClick={() => setMaking(true)} />
  );
  return (
    <div class="page page--alone">
      <PageHead says="page-studies" lead={say("studies-lead")}>
        {studies.data && studies.data.length > 0 && make}
      </PageHead>
      <Loaded of={studies} what={say("studies-loading")} />
      {studies.data?.length === 0 && (
        <Empty panel says="studies-none-title" why="studies-none" actions={make || undefined} />
      )}
      {studies.data && studies.data.length > 0 && <List studies={studies.data} />}
      {making && <NewStudy close={() => setMaking(false)} />}
    </div>
  );
}

function List({ studies }: { studies: readonly ListedStudy[] }) {
  return (
    <section class="panel" aria-label={say("page-studies")}>
      <DataTable
        label={say("page-studies")}
        class="table--hover"
        data-testid="studies"
        rows={studies}
        keyOf={(one) => one.id}
        columns={({ col, num, rowHead }) => [
          rowHead(say("studies-name"), (one) => (
            <>
              <a href={`/study?id=${one.id}`}>{one.name}</a>{" "}
              {one.simulated && <span class="badge">{say("study-simulated")}</span>}
            </>
          )),
          num(say("studies-surveys"), (one) => one.surveys),
          num(say("studies-sites"), (one) => one.sites),
          num(say("studies-heights"), (one) => (one.heights === null ? "–" : formatCount(one.heights))),
          col(
            say("studies-computed"),
            (one) => (one.computed_at ? formatMoment(one.computed_at) : say("studies-not-computed")),
            "nowrap",
          ),
        ]}
      />
    </section>
  );
}

function NewStudy({ close }: { close: () => void }) {
  const form = useForm({ name: "", description: "" });
  const { name, description } = form.values;
  const make = async () => {
    const made = await api.write("POST /studies", {}, { body: { name, description } });
    navigate(`/study?id=${made.id}`);
  };
  return (
    <FormDialog says="studies-new" action={say("studies-new-make")} onClose={close} submit={make}>
      <TextField says="study-name" {...form.field("name")} />
      <TextField says="study-description" {...form.field("description")} rows={3} />
    </FormDialog>
  );
}
