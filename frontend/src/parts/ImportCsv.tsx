/** A CSV that is looked at before anything of it is stored: chosen, what each line would do, stored, done. */
import type { ComponentChildren } from "preact";
import { useState } from "preact/hooks";
import { Button, Dialog, DropFiles, Loading, Notice, Problem } from "../components";
import { useAction } from "../core/action";

interface Props<Choices, Plan, Done> {
  words: Readonly<Record<"title" | "choose" | "drop" | "hint" | "looking", string>>;
  /** How a file is taken before anything else is said; `keep`: what was said counts for another file too. */
  usual: Choices;
  keep?: boolean;
  look: (file: File, taken: Choices) => Promise<Plan>;
  store: (file: File, taken: Choices) => Promise<Done>;
  usable: (plan: Plan) => number;
  storeWords: (count: number) => string;
  doneWords: (done: Done) => string;
  before?: ComponentChildren;
  preview: (plan: Plan, taken: Choices, change: (part: Partial<Choices>) => void) => ComponentChildren;
  onClose: () => void;
}

export function ImportCsv<Choices, Plan, Done>(props: Props<Choices, Plan, Done>) {
  const { words, usual, onClose } = props;
  const [file, setFile] = useState<File | null>(null);
  const [taken, setTaken] = useState(usual);
  const [plan, setPlan] = useState<Plan | null>(null);
  const [done, setDone] = useState<Done | null>(null);
  const { busy, problem, run } = useAction();
  const look = async (chosen: File, next: Choices) => {
    setFile(chosen);
    setTaken(next);
    if (!(await run(async () => setPlan(await props.look(chosen, next))))) setPlan(null);
  };
  const store = () => file && run(async () => setDone(await props.store(file, taken)));
  const count = plan === null ? 0 : props.usable(plan);
  return (
    <Dialog
      wide
      title={words.title}
      onClose={onClose}
      actions={
        <>
          <Button says={done ? "action-close" : "action-cancel"} onClick={onClose} />
          {!done && (
            <Button kind="primary" busy={busy} disabled={count === 0} onClick={() => void store()}>
              {props.storeWords(count)}
            </Button>
          )}
        </>
      }
    >
      <div class="stack">
        {done ? (
          <Notice>{props.doneWords(done)}</Notice>
        ) : (
          <DropFiles
            label={words.choose}
            title={file ? file.name : words.drop}
            hint={words.hint}
            accept=".csv,text/csv"
            add={(files) => files[0] && void look(files[0], props.keep ? taken : usual)}
          />
        )}
        {!file && !done && props.before}
        <Problem error={problem} />
        {busy && !plan && <Loading what={words.looking} />}
        {plan &&
          !done &&
          props.preview(plan, taken, (part) => file && void look(file, { ...taken, ...part }))}
      </div>
    </Dialog>
  );
}
