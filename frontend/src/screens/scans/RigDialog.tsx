/** The rig's values can be corrected; results keep those that they were made with until they are measured again. */
import { useState } from "preact/hooks";
import { Button, FormDialog, TextField } from "../../components";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import type { Scan } from "../../core/types";
import { LaneFields } from "./LaneFields";
import { type LaneProblems, type LaneTyped, lanesOf, sameLanes, typedLanes } from "./lanes";
import type { ScanModel } from "./model";
import { RigCalibration } from "./RigCalibration";
import { RigFields } from "./RigFields";
import { type PutRig, tellStored } from "./RigHistory";
import { RigOfTraffic } from "./RigOfTraffic";
import {
  isValues,
  type RigName,
  type RigProblems,
  type RigTyped,
  type RigValues,
  sentOf,
  typedOf,
  valuesOf,
  withoutCorrelation,
} from "./rig";

interface Props {
  scan: Scan;
  onClose: () => void;
  /** On the bench: a change joins its stack of undo. */
  model?: ScanModel;
  /** Elsewhere: called after each change, and each that is taken back. */
  changed?: () => Promise<void>;
  /** Values that are offered, filled in. */
  offered?: Partial<RigTyped>;
}

export function RigDialog({ model, scan, onClose, changed, offered }: Props) {
  const [typed, setTyped] = useState<RigTyped>(() => ({ ...typedOf(scan), ...offered }));
  const [name, setName] = useState(scan.name);
  const [problems, setProblems] = useState<RigProblems>({});
  const [lanes, setLanes] = useState<readonly LaneTyped[]>(() => typedLanes(scan.rig.lanes));
  const [ofLanes, setOfLanes] = useState<readonly LaneProblems[]>([]);
  const [calibrating, setCalibrating] = useState(false);
  /** Whoever shows the scan shows it as it is stored. */
  const take = async (stored: Scan): Promise<void> => {
    model?.take(stored);
    await model?.refresh();
    await changed?.();
  };
  const put: PutRig = async (values, version) => {
    const body = { ...values, version };
    const stored = await api.write("PATCH /scans/{scan_id}", { scan_id: scan.id }, { body });
    await take(stored);
    return stored;
  };
  const change = (part: Partial<RigTyped>): void => {
    setTyped({ ...typed, ...withoutCorrelation(part) });
    setProblems({});
  };
  const submit = async () => {
    const values = valuesOf(typed, lanes.length > 0);
    const found = lanesOf(lanes);
    const sound = found.lanes.length === lanes.length;
    if (isValues(values) && sound)
      return store({
        ...changedOnly(values),
        ...(sameLanes(lanes, scan.rig.lanes) ? {} : { lanes: found.lanes }),
      });
    if (!isValues(values)) setProblems(values);
    setOfLanes(found.problems);
  };
  /** A field that nobody touched keeps all of its digits. */
  const changedOnly = (values: RigValues): Partial<RigValues> => {
    const before = valuesOf(typedOf(scan), scan.rig.lanes.length > 0);
    const names = Object.keys(values) as (keyof RigValues)[];
    const moved = names.filter((key) => !isValues(before) || values[key] !== before[key]);
    return sentOf(values, moved);
  };
  const store = async (values: Partial<Scan["rig"]>): Promise<void> => {
    const words = name.trim() && name.trim() !== scan.name ? { name: name.trim() } : {};
    if (Object.keys({ ...values, ...words }).length === 0) return onClose();
    const all = { ...values, ...words };
    const names = Object.keys(all) as RigName[];
    const stored = put(all, scan.version);
    await (model
      ? model.history.run(say("scans-rig-undo"), async (changes) => {
          changes.touch(model.rig, names);
          await stored;
        })
      : stored);
    onClose();
    // on the bench it is taken back as any step
    tellStored(scan, await stored, names, model ? undefined : put);
  };
  if (calibrating) return <RigCalibration scan={scan} onClose={onClose} put={put} take={take} />;
  return (
    <FormDialog says="scans-rig-title" action={say("scans-rig-store")} onClose={onClose} submit={submit}>
      <TextField says="field-name" value={name} onInput={setName} />
      <RigFields typed={typed} problems={problems} noRate={scan.source === "video"} change={change} />
      <LaneFields
        lanes={lanes}
        problems={ofLanes}
        change={(now) => {
          setLanes(now);
          setOfLanes([]);
          setProblems({});
        }}
      />
      <p class="row row--wrap">
        <Button says="scans-calibrate" small onClick={() => setCalibrating(true)} />
        <span class="small muted">{say("scans-calibrate-why")}</span>
      </p>
      {scan.run && (
        <section class="stack stack--tight" aria-label={say("scans-rig-traffic")}>
          <h3>{say("scans-rig-traffic-title")}</h3>
          <RigOfTraffic
            scan={scan}
            use={change}
            narrow
            changed={async () => {
              onClose();
              await (model ? model.load() : changed?.());
            }}
          />
        </section>
      )}
      <p class="small muted">{say("scans-rig-note")}</p>
    </FormDialog>
  );
}
