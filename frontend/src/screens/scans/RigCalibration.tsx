/** The rig calibrated by passes of a staff or board: typed or from a CSV, looked at, put in force; those before it. */
import { useState } from "preact/hooks";
import {
  Button,
  choices,
  Dialog,
  DropFiles,
  Loading,
  num,
  Problem,
  Segments,
  Table,
  TextField,
} from "../../components";
import { useAction } from "../../core/action";
import { api } from "../../core/api";
import { say, wordsOf } from "../../core/messages";
import type { CalibrationLook, Scan } from "../../core/types";
import { kept, lengthUnit, localNumber, parseLength, parseNumber } from "../../core/units";
import { RigAnswer } from "./RigAnswer";
import { type Lane, type PutRig, RigHistory, tellStored } from "./RigHistory";
import { DISTANCE_DIGITS, OF_CALIBRATION, typedLength } from "./rig";
import { COLUMNS, headOf, nextPass, type PassTyped, tableOf, USUAL, type Way } from "./rigPasses";

interface Props {
  scan: Scan;
  onClose: () => void;
  put: PutRig;
  /** The scan as it is after a calibration was put in force. */
  take: (scan: Scan) => Promise<void>;
}

const FIRST_ROWS = 4;
const MOST_SHARE = 0.1;

function rowsOf(way: Way): PassTyped[] {
  return Array.from({ length: FIRST_ROWS }, () => nextPass(way));
}

export function RigCalibration({ scan, onClose, put, take }: Props) {
  const [way, setWay] = useState<Way>("board");
  const [passes, setPasses] = useState<PassTyped[]>(() => rowsOf("board"));
  const [beside, setBeside] = useState<BesideTyped>(() => besideOf(scan));
  const [file, setFile] = useState<File | null>(null);
  const [look, setLook] = useState<CalibrationLook | null>(null);
  const { busy, problem, run } = useAction();
  const said = saidOf(beside, scan);
  const attempt = async (work: () => Promise<void>): Promise<void> => {
    if (!(await run(work))) setLook(null);
  };
  const compute = (chosen: File | null) =>
    attempt(async () => {
      setFile(chosen);
      if (!chosen || !said) return;
      const place = "POST /scans/{scan_id}/rig-calibrations/preview";
      setLook(await api.ask(place, { scan_id: scan.id, ...said }, { body: chosen }));
    });
  /** What is shown is always what would be stored. */
  const changed = (): void => {
    setLook(null);
    setFile(null);
  };
  const store = () =>
    attempt(async () => {
      if (!file || !said) return;
      const asked = { scan_id: scan.id, ...said, version: scan.version };
      const stored = await api.write("POST /scans/{scan_id}/rig-calibrations", asked, { body: file });
      await take(stored);
      onClose();
      tellStored(scan, stored, OF_CALIBRATION, put);
    });
  const figures = look?.figures ?? null;
  return (
    <Dialog
      wide
      title={say("scans-calibrate-title")}
      onClose={onClose}
      actions={
        <>
          <Button says="action-cancel" onClick={onClose} />
          <Button
            says="scans-calibrate-store"
            kind="primary"
            busy={busy}
            disabled={!figures}
            onClick={() => void store()}
          />
        </>
      }
    >
      <div class="stack">
        <p class="small">{say("scans-calibrate-how")}</p>
        <Segments
          says="scans-calibrate-way"
          value={way}
          options={choices(wordsOf("scans-calibrate-way-"))}
          onInput={(chosen) => {
            setWay(chosen);
            setPasses(rowsOf(chosen));
            changed();
          }}
        />
        <p class="small muted">{say(`scans-calibrate-hint-${way}`)}</p>
        <Passes
          way={way}
          passes={passes}
          change={(next) => {
            setPasses(next);
            changed();
          }}
        />
        <div class="row row--wrap">
          <Button
            says="scans-passes-add"
            small
            onClick={() => setPasses([...passes, nextPass(way, passes[passes.length - 1])])}
          />
          <Button
            says="scans-calibrate-compute"
            small
            disabled={!said || tableOf(way, passes) === null}
            onClick={() => void compute(tableOf(way, passes))}
          />
        </div>
        <DropFiles
          label={say("scans-passes-choose")}
          title={say("scans-passes-drop")}
          hint={say("scans-passes-drop-hint")}
          accept=".csv,text/csv"
          add={(files) => files[0] && void compute(files[0])}
        />
        <Beside
          typed={beside}
          change={(part) => {
            setBeside({ ...beside, ...part });
            changed();
          }}
        />
        <Problem error={problem} />
        {busy && !look && <Loading what={say("scans-calibrate-busy")} />}
        {look && <RigAnswer look={look} />}
        <RigHistory scan={scan} put={put} onClose={onClose} lane={said && laneOf(said)} />
      </div>
    </Dialog>
  );
}

type BesideTyped = ReturnType<typeof besideOf>;
type BesideName = keyof BesideTyped;
type Said = Lane & { u_tape_ratio: number };

/** Where the vehicles drive, as it is stored: the first lane, where only lanes have a distance. */
function standing({ rig }: Scan): Partial<Lane> {
  const { distance_m, u_distance_m } = (rig.distance_m === null && rig.lanes[0]) || rig;
  return distance_m === null ? {} : { distance_m, u_distance_m };
}

export function besideOf(scan: Scan) {
  const { distance_m, u_distance_m } = standing(scan);
  return {
    distance: distance_m === undefined ? "" : typedLength(distance_m, DISTANCE_DIGITS),
    uDistance: u_distance_m ? typedLength(u_distance_m) : "",
    tape: "",
  };
}

const READ: Readonly<Record<BesideName, (text: string) => number | null>> = {
  distance: (text) => within(parseLength(text), (value) => value > 0),
  uDistance: (text) => (text.trim() === "" ? 0 : within(parseLength(text), (value) => value >= 0)),
  tape: (text) => {
    const percent = text.trim() === "" ? 0 : parseNumber(text);
    return within(percent === null ? null : percent / 100, (value) => value >= 0 && value <= MOST_SHARE);
  },
};

function within(value: number | null, fine: (value: number) => boolean): number | null {
  return value !== null && fine(value) ? value : null;
}

export function saidOf(typed: BesideTyped, scan: Scan): Said | null {
  const [shown, stands] = [besideOf(scan), standing(scan)];
  const distance_m = kept(typed.distance, shown.distance, stands.distance_m, READ.distance);
  const u_distance_m = kept(typed.uDistance, shown.uDistance, stands.u_distance_m, READ.uDistance);
  const u_tape_ratio = READ.tape(typed.tape);
  if (distance_m === null || u_distance_m === null || u_tape_ratio === null) return null;
  return { distance_m, u_distance_m, u_tape_ratio };
}

function laneOf({ distance_m, u_distance_m }: Said): Lane {
  return { distance_m, u_distance_m };
}

function Beside({ typed, change }: { typed: BesideTyped; change: (part: Partial<BesideTyped>) => void }) {
  const wired = (name: BesideName, problem: string) => ({
    numeric: true,
    value: typed[name],
    problem: READ[name](typed[name]) === null ? problem : null,
    onInput: (text: string) => change({ [name]: text }),
  });
  return (
    <div class="grid grid--tight">
      <TextField
        says="scans-rig-distance"
        unit={lengthUnit.value}
        {...wired("distance", say("scans-calibrate-distance-problem"))}
      />
      <TextField
        says="scans-rig-u"
        unit={lengthUnit.value}
        hint={say("scans-rig-distance-u-hint")}
        {...wired("uDistance", say("scans-rig-problem-length"))}
      />
      <TextField
        says="scans-calibrate-tape"
        unit="%"
        hint={say("scans-calibrate-tape-hint")}
        {...wired("tape", say("scans-calibrate-tape-problem"))}
      />
    </div>
  );
}

interface PassesProps {
  way: Way;
  passes: readonly PassTyped[];
  change: (passes: PassTyped[]) => void;
}

function Passes({ way, passes, change }: PassesProps) {
  const columns = COLUMNS[way];
  return (
    <Table
      label={say("scans-passes")}
      class="table--dense scan__passes"
      heads={[num(say("scans-passes-number")), ...columns.map((name) => num(headOf(name)))]}
    >
      {passes.map((pass, at) => (
        <tr key={at}>
          <th scope="row" class="num">
            {at + 1}
          </th>
          {columns.map((name) => (
            <td key={name}>
              <input
                class="input input--num"
                inputMode="decimal"
                aria-label={say("scans-passes-cell", { number: at + 1, column: headOf(name) })}
                value={pass[name] ?? ""}
                placeholder={localNumber(USUAL[name] ?? "")}
                onInput={(event) => {
                  const cell = event.currentTarget.value;
                  change(passes.map((one, row) => (row === at ? { ...one, [name]: cell } : one)));
                }}
              />
            </td>
          ))}
        </tr>
      ))}
    </Table>
  );
}
