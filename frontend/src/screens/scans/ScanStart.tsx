/** When line 0 of a line scan was taken: proposed from its video, confirmed by a person with its uncertainty. */
import { useState } from "preact/hooks";
import { FormDialog, TextField } from "../../components";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { canWork } from "../../core/session";
import { formatPlaceMoment } from "../../core/times";
import type { Scan } from "../../core/types";
import { parseNumber, significant } from "../../core/units";
import { StartFields, StartLine, startWords, useStart } from "../../parts/filming/start";

interface Props {
  scan: Scan;
  changed: (scan: Scan) => Promise<void>;
}

export function ScanStart({ scan, changed }: Props) {
  const confirmed = scan.started_local !== null;
  const words = startWords(scan, say("scans-start-unknown"));
  return (
    <StartLine
      testId="scan-start"
      words={
        confirmed ? say("scans-start-words", { start: words, u_s: significant(scan.u_start_s ?? 0) }) : words
      }
      of={scan}
      edit={say("scans-start-edit-of", { recording: scan.name })}
      mayChange={canWork.value}
      dialog={(close) => <StartDialog scan={scan} changed={changed} close={close} />}
    />
  );
}

function plain(seconds: number | null): string {
  return String(Number((seconds ?? 0).toPrecision(3)));
}

function StartDialog({ scan, changed, close }: Props & { close: () => void }) {
  const start = useStart(scan);
  const [u, setU] = useState(scan.u_start_s === null ? "" : plain(scan.u_start_s));
  const [problem, setProblem] = useState<string | null>(null);
  const submit = async () => {
    const said = start.said();
    const u_s = parseNumber(u);
    if (said && (u_s === null || u_s <= 0)) return setProblem(say("scans-start-u-problem"));
    const body = { version: scan.version, start: said && { ...said, u_s: u_s as number } };
    await start.learning(async () =>
      changed(await api.write("PATCH /scans/{scan_id}", { scan_id: scan.id }, { body })),
    );
    close();
  };
  return (
    <FormDialog
      label={say("filmed-title", { recording: scan.name })}
      action={say(start.local && !scan.started_at ? "filmed-confirm-action" : "action-save")}
      onClose={close}
      submit={submit}
    >
      <StartFields
        start={start}
        label={say("scans-start-line")}
        hint={
          start.proposed
            ? say("scans-start-from-video", { time: formatPlaceMoment(start.proposed) })
            : say("scans-start-hint")
        }
        step="0.001"
      />
      <TextField
        says="scans-start-u"
        unit="s"
        value={u}
        hint={say("scans-start-u-hint")}
        problem={problem}
        onInput={(text) => {
          setU(text);
          setProblem(null);
        }}
      />
    </FormDialog>
  );
}
