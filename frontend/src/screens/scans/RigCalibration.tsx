/** The rig calibrated by passes of a staff or board: typed or from a CSV, looked at, put in force; those before it. */

import { Fragment } from "preact";
import { useState } from "preact/hooks";
import type { components } from "#schema";
import {
  Button,
  DataTable,
  Dialog,
  DropFiles,
  Loading,
  Notice,
  num,
  Problem,
  Segments,
  Table,
  TextField,
} from "../../components";
import { useAction } from "../../core/action";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { useResource } from "../../core/resource";
import { toast, toastProblem } from "../../core/toasts";
import type { Scan } from "../../core/types";
import {
  fixed,
  formatCount,
  formatHeight,
  formatLength,
  formatSmall,
  lengthUnit,
  parseLength,
  parseNumber,
} from "../../core/units";
import { typedLanes } from "./lanes";
import { type RigChange, typedOf } from "./rig";
import { COLUMNS, headOf, nextPass, type PassTyped, tableOf, USUAL, type Way } from "./rigPasses";

type Look = components["schemas"]["CalibrationLook"];
type Figures = components["schemas"]["CalibrationFigures"];
type Shown = components["schemas"]["RigCalibrationShown"];
/** Where the vehicles drive: without it their baseline would be the one at the cameras. */
type Lane = { distance_m: number; u_distance_m: number };
type PutRig = (values: RigChange, version: number) => Promise<Scan>;

interface Props {
  scan: Scan;
  onClose: () => void;
  /** Changes values of the rig, and tells whoever shows it. */
  put: PutRig;
  /** The scan as it is after a calibration was put in force. */
  take: (scan: Scan) => Promise<void>;
}

const WAYS: readonly Way[] = ["board", "positions", "speed"];
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
  const [look, setLook] = useState<Look | null>(null);
  const { busy, problem, run } = useAction();
  const said = saidOf(beside);
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
      tellStored(scan, stored, put);
    });
  const figures = look?.figures ?? null;
  return (
    <Dialog
      wide
      title={say("scans-calibrate-title")}
      onClose={onClose}
      actions={
        <>
          <Button onClick={onClose}>{say("action-cancel")}</Button>
          <Button kind="primary" busy={busy} disabled={!figures} onClick={() => void store()}>
            {say("scans-calibrate-store")}
          </Button>
        </>
      }
    >
      <div class="stack">
        <p class="small">{say("scans-calibrate-how")}</p>
        <Segments
          label={say("scans-calibrate-way")}
          value={way}
          options={WAYS.map((value) => ({ value, label: say(`scans-calibrate-way-${value}`) }))}
          onChange={(chosen) => {
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
          <Button small onClick={() => setPasses([...passes, nextPass(way, passes[passes.length - 1])])}>
            {say("scans-passes-add")}
          </Button>
          <Button
            small
            disabled={!said || tableOf(way, passes) === null}
            onClick={() => void compute(tableOf(way, passes))}
          >
            {say("scans-calibrate-compute")}
          </Button>
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
        {look && <Answer look={look} />}
        <History scan={scan} put={put} onClose={onClose} lane={said && laneOf(said)} />
      </div>
    </Dialog>
  );
}

/** What is said beside the passes, as typed. */
interface BesideTyped {
  distance: string;
  uDistance: string;
  tape: string;
}

type BesideName = keyof BesideTyped;
type Said = Lane & { u_tape_ratio: number };

function besideOf(scan: Scan): BesideTyped {
  const { distance, uDistance } = typedOf(scan);
  const [first] = typedLanes(scan.rig.lanes);
  if (!distance && first) return { distance: first.distance, uDistance: first.uDistance, tape: "" };
  return { distance, uDistance, tape: "" };
}

/** The value of a field in SI units, null where it cannot be. */
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

function saidOf(typed: BesideTyped): Said | null {
  const distance_m = READ.distance(typed.distance);
  const u_distance_m = READ.uDistance(typed.uDistance);
  const u_tape_ratio = READ.tape(typed.tape);
  if (distance_m === null || u_distance_m === null || u_tape_ratio === null) return null;
  return { distance_m, u_distance_m, u_tape_ratio };
}

function laneOf({ distance_m, u_distance_m }: Said): Lane {
  return { distance_m, u_distance_m };
}

interface BesideProps {
  typed: BesideTyped;
  change: (part: Partial<BesideTyped>) => void;
}

function Beside({ typed, change }: BesideProps) {
  const wired = (name: BesideName, problem: string) => ({
    numeric: true,
    value: typed[name],
    problem: READ[name](typed[name]) === null ? problem : null,
    onInput: (text: string) => change({ [name]: text }),
  });
  return (
    <div class="scan__fields">
      <TextField
        label={say("scans-rig-distance")}
        unit={lengthUnit.value}
        {...wired("distance", say("scans-calibrate-distance-problem"))}
      />
      <TextField
        label={say("scans-rig-u")}
        unit={lengthUnit.value}
        hint={say("scans-rig-distance-u-hint")}
        {...wired("uDistance", say("scans-rig-problem-length"))}
      />
      <TextField
        label={say("scans-calibrate-tape")}
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
                placeholder={USUAL[name]}
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

function Answer({ look }: { look: Look }) {
  const { figures } = look;
  return (
    <section class="stack stack--tight" aria-label={say("scans-calibrate-answer")} data-testid="rig-answer">
      {look.reason && <Notice kind="warning">{look.reason}</Notice>}
      {figures && <FiguresOf figures={figures} />}
      {figures && <Residuals figures={figures} />}
      {look.refused.length > 0 && (
        <ul class="small">
          {look.refused.map((one) => (
            <li key={one.row}>
              {say("scans-passes-refused", { row: one.row })} <span>{one.reason}</span>
            </li>
          ))}
        </ul>
      )}
    </section>
  );
}

function FiguresOf({ figures }: { figures: Figures }) {
  const lanes = figures.lanes.length > 0 ? figures.lanes : figures.lane ? [figures.lane] : [];
  const mrad = (value: number) => fixed(1000 * value, 3);
  return (
    <>
      <dl class="facts small">
        {lanes.map((lane) => (
          <Fragment key={lane.name}>
            <dt>
              {say("scans-calibrate-lane", { distance: formatLength(lane.distance_m, 2) })}
              {lane.name && ` (${lane.name})`}
            </dt>
            <dd>
              {formatHeight(lane.baseline_m, lane.U95_baseline_m, 4)}{" "}
              <span class="muted">
                {say("scans-calibrate-share", { percent: fixed(lane.U95_percent, 3) })}
              </span>
            </dd>
          </Fragment>
        ))}
        <dt>{say("scans-calibrate-baseline")}</dt>
        <dd>{formatHeight(figures.baseline_m, figures.U95_baseline_m, 4)}</dd>
        <dt>{say("scans-rig-divergence")}</dt>
        <dd>
          {say("scans-calibrate-mrad", {
            value: mrad(figures.divergence_rad),
            U95: mrad(figures.U95_divergence_rad),
          })}
        </dd>
        <dt>{say("scans-rig-correlation")}</dt>
        <dd>{fixed(figures.baseline_correlation, 3)}</dd>
        <dt>{say("scans-calibrate-agree")}</dt>
        <dd>
          {say("scans-calibrate-chi2", {
            chi2: fixed(figures.chi2, 1),
            degrees: figures.degrees_of_freedom,
            percent: fixed(100 * figures.p_value, 1),
          })}
        </dd>
      </dl>
      {[...lanes.map((one) => one.warning), ...figures.warnings].map(
        (one) => one && <Notice key={one}>{one}</Notice>,
      )}
    </>
  );
}

function Residuals({ figures }: { figures: Figures }) {
  return (
    <DataTable
      label={say("scans-calibrate-passes")}
      scroll="scan__lines"
      class="table--dense"
      rows={figures.passes}
      keyOf={(one) => one.name}
      columns={({ col, num }) => [
        col(say("scans-passes-number"), (one) => one.name),
        num(say("scans-passes-distance-shown"), (one) => formatLength(one.distance_m, 2)),
        num(say("scans-calibrate-span"), (one) =>
          say("with-u", { value: formatLength(one.span_m, 4), u: formatLength(one.u_span_m, 4) }),
        ),
        num(say("scans-calibrate-residual"), (one) => formatSmall(one.residual_m)),
      ]}
    />
  );
}

interface HistoryProps extends Pick<Props, "scan" | "put" | "onClose"> {
  lane: Lane | null;
}

function History({ scan, put, onClose, lane }: HistoryProps) {
  const found = useResource(
    (signal) => api.ask("GET /scans/{scan_id}/rig-calibrations", { scan_id: scan.id }, { signal }),
    [scan.id, scan.version],
  );
  if (found.error) return <Problem error={found.error} again={found.reload} />;
  if (!found.data || found.data.length === 0) return null;
  const use = async (one: Shown): Promise<void> => {
    try {
      const stored = await put({ ...calibrated(one.figures), ...lane }, scan.version);
      onClose();
      tellStored(scan, stored, put);
    } catch (error) {
      toastProblem(error);
    }
  };
  return (
    <section class="stack stack--tight" aria-label={say("scans-calibrate-history")}>
      <h3>{say("scans-calibrate-history")}</h3>
      <ul class="plain small" data-testid="rig-history">
        {found.data.map((one) => (
          <li key={one.id} class="row row--wrap">
            <span>
              {say("scans-calibrate-one", {
                number: one.revision,
                who: one.created_by?.name ?? "–",
                passes: formatCount(one.figures.passes.length),
              })}
            </span>
            <span class="nowrap">{formatHeight(one.figures.baseline_m, one.figures.U95_baseline_m, 4)}</span>
            {one.in_force ? (
              <strong>{say("scans-calibrate-in-force")}</strong>
            ) : (
              <Button
                small
                disabled={!lane}
                label={say("scans-calibrate-use-one", { number: one.revision })}
                onClick={() => void use(one)}
              >
                {say("scans-traffic-use")}
              </Button>
            )}
          </li>
        ))}
      </ul>
    </section>
  );
}

function calibrated(from: Figures | Scan["rig"]): RigChange {
  return {
    baseline_m: from.baseline_m,
    u_baseline_m: from.u_baseline_m,
    divergence_rad: from.divergence_rad,
    u_divergence_rad: from.u_divergence_rad,
    baseline_correlation: from.baseline_correlation,
  };
}

/** Putting the values before back in force is one press; the calibration stays in the history. */
function tellStored(before: Scan, stored: Scan, put: PutRig): void {
  const run = async (): Promise<void> => {
    const now = await api.ask("GET /scans/{scan_id}", { scan_id: before.id });
    const { distance_m, u_distance_m } = before.rig;
    await put({ ...calibrated(before.rig), distance_m, u_distance_m }, now.version);
  };
  toast(say(stored.counts.older > 0 ? "scans-rig-stored-older" : "scans-rig-stored"), {
    action: { label: say("command-undo"), run: () => void run().catch(toastProblem) },
  });
}
