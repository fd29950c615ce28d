/** One lot: its plan's operating characteristic with both risk points, how far its sample is, and what is decided. */
import { useState } from "preact/hooks";
import { ask, Button, Panel, Problem, Progress } from "../../components";
import { useAction } from "../../core/action";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { may } from "../../core/session";
import { formatMoment } from "../../core/times";
import type { ShownLot } from "../../core/types";
import { fixed, formatCount } from "../../core/units";
import { percent } from "../../parts/figures/numbers";
import { PlotFigure } from "../../parts/figures/PlotFigure";
import { readable, readRows } from "../../parts/figures/reading";
import { commonInWords, leftInWords } from "./lots";

interface Props {
  surveyId: number;
  shown: ShownLot;
  done(): Promise<void>;
}

const ROUTES = {
  accept: "POST /lots/{lot_id}/accept",
  inspect: "POST /lots/{lot_id}/inspect",
  dissolve: "POST /lots/{lot_id}/dissolve",
  "take-back": "POST /lots/{lot_id}/take-back",
} as const;
type Act = keyof typeof ROUTES;

export function LotPanel({ surveyId, shown, done }: Props) {
  const { lot } = shown;
  const left = leftInWords(shown);
  const title = say("lots-named", { number: String(lot.number), common: commonInWords(lot.common) });
  return (
    <Panel label={title} data-testid="lot">
      <div class="panel__body stack">
        <p data-testid="lot-words">{inWords(shown)}</p>
        {left && <p class="small">{say("lots-left", { reasons: left })}</p>}
        <Progress
          value={shown.progress.judged / Math.max(1, shown.progress.sample)}
          label={say("lots-judged")}
          figure={say("lots-of", { part: shown.progress.judged, all: shown.progress.sample })}
          still
        />
        <Acts surveyId={surveyId} shown={shown} done={done} />
        <Curve shown={shown} />
        <p class="small muted">
          {say("lots-drawn", {
            when: formatMoment(lot.created_at),
            person: lot.created_by?.name ?? say("lots-nobody"),
            seed: lot.seed.slice(0, 16),
          })}
        </p>
      </div>
    </Panel>
  );
}

function inWords({ lot, progress, state, outgoing }: ShownLot): string {
  const bad = { count: progress.nonconforming, most: formatCount(lot.acceptance_number) };
  const plan = say("lots-plan", {
    size: formatCount(lot.size),
    sample: formatCount(progress.sample),
    most: formatCount(lot.acceptance_number),
  });
  if (state === "open") {
    const waits = progress.sample - progress.judged;
    if (progress.nonconforming > lot.acceptance_number) return `${plan} ${say("lots-says-refused", bad)}`;
    if (waits > 0) return `${plan} ${say("lots-says-waits", { count: waits })}`;
    return `${plan} ${say("lots-says-accept", bad)}`;
  }
  if (state === "accepted" && outgoing) {
    const values = {
      count: progress.rest,
      bad: formatCount(progress.nonconforming),
      estimate: fixed(outgoing.estimate, 1),
      most: formatCount(outgoing.at_most),
      share: percent(outgoing.count > 0 ? outgoing.at_most / outgoing.count : 0),
    };
    return `${plan} ${say("lots-says-accepted", values)}`;
  }
  if (state === "full_inspection") return `${plan} ${say("lots-says-inspected", { count: progress.rest })}`;
  if (state === "taken_back") return `${plan} ${say("lots-says-taken-back", { count: progress.rest })}`;
  return `${plan} ${say("lots-says-dissolved")}`;
}

function Acts({ surveyId, shown, done }: Props) {
  const [busy, setBusy] = useState<Act | null>(null);
  const { problem, run } = useAction();
  const { lot, progress, state } = shown;
  const act = async (one: Act) => {
    setBusy(one);
    await run(() => api.write(ROUTES[one], { lot_id: lot.id }));
    await done();
    setBusy(null);
  };
  const inspect = async () => {
    const yes = await ask({
      title: say("lots-inspect"),
      body: say("lots-inspect-text", { count: progress.rest }),
      action: say("lots-inspect"),
    });
    if (yes) await act("inspect");
  };
  if (!may("reviewer")) return null;
  const doing = (one: Act, start = () => act(one)) => ({
    busy: busy === one,
    onClick: () => void start(),
  });
  return (
    <>
      <Problem error={problem} />
      <div class="row row--wrap">
        {state === "open" && (
          <>
            {progress.judged < progress.sample && (
              <Button says="lots-judge" kind="primary" href={`/surveys/${surveyId}/review?lot=${lot.id}`} />
            )}
            <Button
              says="lots-accept"
              {...doing("accept")}
              kind={progress.may_accept ? "primary" : undefined}
              disabled={!progress.may_accept}
            />
            <Button says="lots-inspect" {...doing("inspect", inspect)} />
            {progress.judged === 0 && <Button says="lots-dissolve" {...doing("dissolve")} kind="quiet" />}
          </>
        )}
        {state === "accepted" && <Button says="lots-take-back" {...doing("take-back")} icon="undo" />}
      </div>
      {state === "open" && progress.own > 0 && (
        <p class="small">{say("lots-own", { count: progress.own })}</p>
      )}
    </>
  );
}

type CurvePoint = ShownLot["curve"][number];
const PERCENT = {
  x: (one: CurvePoint) => one.fraction * 100,
  y: (one: CurvePoint) => one.accepted * 100,
};

function Curve({ shown }: { shown: ShownLot }) {
  const { kept, curve, lot } = shown;
  const points = [
    { fraction: kept.producer_quality, accepted: 1 - kept.producer_risk },
    { fraction: kept.consumer_quality, accepted: kept.consumer_risk },
  ];
  const values = {
    good: percent(kept.producer_quality),
    refused: percent(kept.producer_risk),
    bad: percent(kept.consumer_quality),
    passed: percent(kept.consumer_risk),
  };
  return (
    <PlotFigure
      name={`lot-${lot.number}-plan`}
      title={say("lots-curve")}
      says={say("lots-curve-says", values)}
      note={say("lots-curve-note", values)}
      data={shown}
      options={(plot) => ({
        x: { label: say("lots-curve-x"), zero: true },
        y: { label: say("lots-curve-y"), domain: [0, 100] },
        marks: [
          readable(
            plot.line(curve, { ...PERCENT, stroke: "var(--ink)", strokeWidth: 1.6 }),
            readRows(curve, PERCENT, "line"),
          ),
          plot.dot(points, { ...PERCENT, r: 5, fill: "var(--ink)" }),
          ...points.map((one, i) =>
            plot.text([one], {
              ...PERCENT,
              text: [say(i === 0 ? "lots-producer" : "lots-consumer")],
              // beside the first: the axis has its name above, the curve falls below
              dx: i === 0 ? 24 : 9,
              dy: i === 0 ? 5 : -9,
              textAnchor: "start",
            }),
          ),
        ],
      })}
      table={() => ({
        columns: ["fraction_nonconforming", "probability_accepted"],
        rows: curve.map((one) => [one.fraction, one.accepted]),
      })}
    />
  );
}
