/** Per target: the inset in force, what the survey itself says of it, and a button to use that. */
import { useState } from "preact/hooks";
import { Button, DataTable, Loaded, Panel, Problem, TableScroll } from "../../components";
import { Said } from "../../components/Said";
import { useAction } from "../../core/action";
import { allOf, say, sentenceOf, wordsOf } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { canWork } from "../../core/session";
import { changeSurvey, refreshSurvey } from "../../core/survey";
import { toast } from "../../core/toasts";
import type { Estimate, InsetCheck, InsetName, Survey, TargetInsets } from "../../core/types";
import { formatAway, formatLength, formatSmall } from "../../core/units";
import { INSET_PLACE_WORDS, INSET_WORDS, insetNote, vehicleName } from "../../core/words";
import { InsetDrawing } from "./InsetDrawing";
import { TARGET_NAMES } from "./words";

const METHODS: Readonly<Record<Estimate["method"], string>> = wordsOf("checks-by-");

export function InsetsTab({ survey }: { survey: Survey }) {
  const check = useAsked("GET /surveys/{survey_id}/checks/insets", { survey_id: survey.id });
  const { problem, run } = useAction();
  const [busy, setBusy] = useState<string | null>(null);
  const use = async (name: InsetName, estimate: Estimate) => {
    if (!estimate.offer) return;
    setBusy(`${name} ${estimate.method}`);
    await run(async () => {
      await changeSurvey(survey, { insets: { [name]: estimate.offer } });
      toast(say("checks-used", { target: name }));
    });
    await Promise.all([refreshSurvey(), check.reload()]);
    setBusy(null);
  };
  return (
    <>
      <Problem error={problem} />
      <Panel aria-label={say("checks-insets")} says="checks-insets-title">
        <Loaded of={check} what={say("checks-insets-loading")} />
        {check.data && (
          <TableScroll label={say("checks-insets-table")}>
            <table class="table insets-check" data-testid="insets-check">
              <thead>
                <tr>
                  <th>{say("checks-target")}</th>
                  <th>{say("checks-in-force")}</th>
                  <th>{say("checks-from")}</th>
                  <th>{say("checks-inset-and-u")}</th>
                  <th class="num insets-check__moves">{say("checks-moves")}</th>
                </tr>
              </thead>
              {check.data.targets.map((one) => (
                <TargetRows key={one.name} target={one} busy={busy} use={use} />
              ))}
            </table>
          </TableScroll>
        )}
        <p class="panel__body muted small insets-check__foot">{say("checks-insets-note")}</p>
      </Panel>
      {check.data && <Explanation check={check.data} />}
    </>
  );
}

interface RowsProps {
  target: TargetInsets;
  busy: string | null;
  use(name: InsetName, estimate: Estimate): Promise<void>;
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
                {INSET_WORDS[target.name]}
                <div class="small muted">{say("checks-measurements", { count: target.measured })}</div>
                {target.other_insets > 0 && (
                  <div class="small muted">{say("checks-other-insets", { count: target.other_insets })}</div>
                )}
              </th>
              <td rowSpan={rows} class="insets-check__force">
                <span class="nowrap">{insetWithU(target.in_force)}</span>{" "}
                {target.is_default && <span class="badge">{say("checks-estimate")}</span>}
                {target.in_force.note && <div class="small muted">{insetNote(target.in_force)}</div>}
              </td>
            </>
          )}
          <td>{METHODS[one.method]}</td>
          {one.reason ? (
            <td colSpan={2} class="muted small">
              {sentenceOf(one.reason)}
            </td>
          ) : (
            <Figures name={target.name} one={one} busy={busy} use={use} />
          )}
        </tr>
      ))}
    </tbody>
  );
}

/** To the millimetre: the mean of many vehicles is known better than to a centimetre. */
export function insetWithU(of: { inset_m: number | null; u_inset_m: number | null }): string {
  return say("with-u", { value: formatLength(of.inset_m), u: formatLength(of.u_inset_m) });
}

function Figures(props: { name: InsetName; one: Estimate; busy: string | null; use: RowsProps["use"] }) {
  const { name, one, busy, use } = props;
  const at = `${name} ${one.method}`;
  return (
    <>
      <td>
        <span class="nowrap">{insetWithU(one)}</span>
        <div class="small muted">
          <Vehicles one={one} />
        </div>
        {one.spread_m !== null && (
          <div class="small muted">{say("checks-spread", { spread: formatLength(one.spread_m, 2) })}</div>
        )}
        {one.caution && <div class="small">{sentenceOf(one.caution)}</div>}
        {one.offer && canWork.value && (
          <Button small busy={busy === at} disabled={busy !== null} onClick={() => void use(name, one)}>
            {say("checks-use", {
              target: name,
              inset: formatLength(one.offer.inset_m, 2),
              u_inset: formatLength(one.offer.u_inset_m, 2),
            })}
          </Button>
        )}
      </td>
      <td class="num">{formatSmall(one.difference_m)}</td>
    </>
  );
}

/** How many vehicles an estimate stands on, and which it leaves out. */
function Vehicles({ one }: { one: Estimate }) {
  const count = one.vehicles;
  if (one.left_out.length === 0) return <>{say("checks-vehicles", { count })}</>;
  const left_out = allOf(one.left_out.map((vehicle) => vehicleName(vehicle.number)));
  return (
    <Said
      what="checks-vehicles-without"
      values={{ count, left_out }}
      parts={{ without: (text) => <span title={say("checks-left-out-help")}>{text}</span> }}
    />
  );
}

/** What an inset is, and what leaving it out does. */
export function Explanation({ check }: { check: InsetCheck }) {
  return (
    <Panel aria-label={say("checks-inset-what")} says="checks-inset-title">
      <div class="panel__body inset-words">
        <InsetDrawing />
        <div class="stack">
          <p>
            <Said what="checks-inset-plane" />
          </p>
          <p class="inset-words__formula">
            <Said what="checks-inset-formula" />
          </p>
          <p class="muted">
            <Said what="checks-inset-symbols" />
          </p>
        </div>
      </div>
      <DataTable
        label={say("checks-missing-inset")}
        caption={say("checks-missing-inset-caption", {
          camera_height: formatLength(check.camera_height_m, 2),
        })}
        rows={check.cases}
        keyOf={(one) => `${one.target} ${one.place} ${one.height_m}`}
        columns={({ col, num }) => [
          col(say("checks-target"), (one) => (
            <>
              {TARGET_NAMES[one.target]}
              {one.place && <span class="muted">, {INSET_PLACE_WORDS[one.place]}</span>}
            </>
          )),
          num(say("checks-height"), (one) => formatLength(one.height_m, 2)),
          num(say("checks-inset"), (one) => formatLength(one.inset_m, 2)),
          ...check.cases_at_m.map((distance, i) =>
            num(say("checks-at", { distance: formatAway(distance) }), (one) =>
              formatSmall(one.bias_m[i] ?? 0),
            ),
          ),
        ]}
      />
    </Panel>
  );
}
