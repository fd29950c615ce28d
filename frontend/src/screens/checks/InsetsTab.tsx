/** Per target: the inset in force, what the survey itself says of it, and a button to use that. */
import { useState } from "preact/hooks";
import { Button, Loading, Problem, TableScroll } from "../../components";
import { api } from "../../core/api";
import { useResource } from "../../core/resource";
import { canWork } from "../../core/session";
import { refreshSurvey } from "../../core/survey";
import { toast } from "../../core/toasts";
import type { Survey, Target } from "../../core/types";
import { formatLength, formatSmall, plural } from "../../core/units";
import { InsetDrawing } from "./InsetDrawing";
import { type Estimate, type InsetCheck, TARGET_NAMES, TARGETS_MANY, type TargetInsets } from "./types";

const METHODS: Record<Estimate["method"], string> = {
  known_heights: "manufacturers’ heights",
  trend: "trend with distance",
  two_frames: "two-frame measurements",
};

export function InsetsTab({ survey }: { survey: Survey }) {
  const check = useResource(
    (signal) => api.ask("GET /surveys/{survey_id}/checks/insets", { survey_id: survey.id }, { signal }),
    [survey.id],
  );
  const [problem, setProblem] = useState<unknown>(null);
  const [busy, setBusy] = useState<string | null>(null);
  const use = async (target: Target, estimate: Estimate) => {
    if (!estimate.offer) return;
    setBusy(`${target} ${estimate.method}`);
    setProblem(null);
    try {
      const { name, site, description, version } = survey;
      const insets = { [target]: estimate.offer };
      await api.write(
        "PUT /surveys/{survey_id}",
        { survey_id: survey.id },
        { body: { name, site, description, version, insets } },
      );
      toast(`The inset of ${TARGETS_MANY[target]} is changed for new measurements; stored ones keep theirs.`);
    } catch (error) {
      setProblem(error);
    }
    await Promise.all([refreshSurvey(), check.reload()]);
    setBusy(null);
  };
  return (
    <>
      <Problem error={problem} />
      <section class="panel" aria-label="Insets">
        <header class="panel__head">
          <h2>Insets in force, and what this survey says</h2>
        </header>
        <Problem error={check.error} again={check.reload} />
        {!check.data && check.loading && <Loading what="the estimates" />}
        {check.data && (
          <TableScroll label="Insets in force">
            <table class="table insets-check" data-testid="insets-check">
              <thead>
                <tr>
                  <th>target</th>
                  <th>in force</th>
                  <th>from</th>
                  <th>inset ± u of the mean</th>
                  <th class="num insets-check__moves">moves a typical height by</th>
                </tr>
              </thead>
              {check.data.targets.map((one) => (
                <TargetRows key={one.target} target={one} busy={busy} use={use} />
              ))}
            </table>
          </TableScroll>
        )}
        <p class="panel__body muted small insets-check__foot">
          An inset used here counts for measurements made from now on; those that are stored keep theirs, with
          its value beside them. Its ± is that of a single vehicle: the mean’s, and how much vehicles differ
          among themselves.
        </p>
      </section>
      {check.data && <Explanation check={check.data} />}
    </>
  );
}

interface RowsProps {
  target: TargetInsets;
  busy: string | null;
  use(target: Target, estimate: Estimate): Promise<void>;
}

function TargetRows({ target, busy, use }: RowsProps) {
  const rows = target.estimates.length;
  return (
    <tbody>
      {target.estimates.map((one, i) => (
        <tr key={one.method}>
          {i === 0 && (
            <>
              <th scope="rowgroup" rowSpan={rows}>
                {TARGET_NAMES[target.target]}
                <div class="small muted">{plural(target.measured, "measurement")}</div>
                {target.other_insets > 0 && (
                  <div class="small muted">and {target.other_insets} on another spot</div>
                )}
              </th>
              <td rowSpan={rows} class="insets-check__force">
                <span class="nowrap">
                  {formatLength(target.in_force.inset_m, 2)} ± {formatLength(target.in_force.u_inset_m, 2)}
                </span>{" "}
                {target.is_default && <span class="badge">estimate</span>}
                {target.in_force.note && <div class="small muted">{target.in_force.note}</div>}
              </td>
            </>
          )}
          <td>{METHODS[one.method]}</td>
          {one.reason ? (
            <td colSpan={2} class="muted small">
              {one.reason}
            </td>
          ) : (
            <Figures target={target.target} one={one} busy={busy} use={use} />
          )}
        </tr>
      ))}
    </tbody>
  );
}

function Figures(props: { target: Target; one: Estimate; busy: string | null; use: RowsProps["use"] }) {
  const { target, one, busy, use } = props;
  const name = `${target} ${one.method}`;
  return (
    <>
      <td>
        <span class="nowrap">
          {formatLength(one.inset_m, 2)} ± {formatLength(one.u_inset_m, 2)}
        </span>
        <div class="small muted">
          {plural(one.vehicles, "vehicle")}
          {one.left_out.length > 0 && (
            <span title="They do not fit the others; look at their clicks and heights.">
              {" "}
              without {one.left_out.map((vehicle) => `#${vehicle.number}`).join(", ")}
            </span>
          )}
        </div>
        {one.spread_m !== null && (
          <div class="small muted">{formatLength(one.spread_m, 2)} between vehicles</div>
        )}
        {one.caution && <div class="small">{one.caution}</div>}
        {one.offer && canWork.value && (
          <Button small busy={busy === name} disabled={busy !== null} onClick={() => void use(target, one)}>
            Use {formatLength(one.offer.inset_m, 2)} ± {formatLength(one.offer.u_inset_m, 2)} for{" "}
            {TARGETS_MANY[target]}
          </Button>
        )}
      </td>
      <td class="num">{formatSmall(one.difference_m)}</td>
    </>
  );
}

function Explanation({ check }: { check: InsetCheck }) {
  return (
    <section class="panel" aria-label="What the inset is">
      <header class="panel__head">
        <h2>What the inset is, and why it matters</h2>
      </header>
      <div class="panel__body inset-words">
        <InsetDrawing />
        <div class="stack">
          <p>
            A height is read where the line of sight meets the <strong>side plane</strong>: the upright plane
            through the tyre’s contact with the road, along the traffic. A roof edge or a driver’s eye lies
            behind that plane, by its <strong>inset</strong>. Read on the plane, a target below the camera
            seems too high, and one above it too low.
          </p>
          <p class="inset-words__formula">
            read − true = (H<sub>c</sub> − h) · inset / (D + inset)
          </p>
          <p class="muted">
            H<sub>c</sub> is the camera’s height, h the target’s, D the distance from the camera to the side
            plane. A camera as high as its target does not mind the inset. Every stored height is corrected
            for it; the uncorrected one is kept beside it.
          </p>
        </div>
      </div>
      <TableScroll label="What a missing inset does to a height">
        <table class="table">
          <caption class="inset-words__caption">
            How much too high a target reads without its inset, for the camera at{" "}
            {formatLength(check.camera_height_m, 2)}
          </caption>
          <thead>
            <tr>
              <th>target</th>
              <th class="num">height</th>
              <th class="num">inset</th>
              {check.cases_at_m.map((distance) => (
                <th class="num" key={distance}>
                  at {formatLength(distance, 0)}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {check.cases.map((one) => (
              <tr key={`${one.target} ${one.words} ${one.height_m}`}>
                <td>
                  {TARGET_NAMES[one.target]}
                  {one.words && <span class="muted">, {one.words}</span>}
                </td>
                <td class="num">{formatLength(one.height_m, 2)}</td>
                <td class="num">{formatLength(one.inset_m, 2)}</td>
                {one.bias_m.map((bias, i) => (
                  <td class="num" key={check.cases_at_m[i]}>
                    {formatSmall(bias)}
                  </td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </TableScroll>
    </section>
  );
}
