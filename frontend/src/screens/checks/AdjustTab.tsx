/** What vehicles of known wheelbase and height say of each road pose in force; put in force by a person only. */
import { useState } from "preact/hooks";
import {
  Button,
  DataTable,
  Empty,
  JobProgress,
  Loaded,
  Notice,
  Notices,
  Panel,
  Problem,
  TextField,
} from "../../components";
import { api } from "../../core/api";
import { useJobAction } from "../../core/jobs";
import { allOf, say, sentenceOf, wordsOf } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { canWork } from "../../core/session";
import { refreshSurvey } from "../../core/survey";
import { toast } from "../../core/toasts";
import type { Job, PoseAdjustment } from "../../core/types";
import {
  fixed,
  formatHeight,
  formatLength,
  formatSmall,
  lengthUnit,
  parseSmall,
  smallScale,
  smallText,
} from "../../core/units";
import { TARGET_WORDS, vehicleName } from "../../core/words";
import { scaled } from "../../parts/figures/numbers";

type Known = PoseAdjustment["known"];
const USUAL: Known = { u_wheelbase_m: 0.01, u_wheelbase_common_m: 0.005, u_roof_common_m: 0.005 };
const MOVED: Readonly<Record<string, string>> = wordsOf("adjust-moved-");
const MILLI = 1000;

export function AdjustTab({ surveyId }: { surveyId: number }) {
  const [known, setKnown] = useState(USUAL);
  const read = useAsked(
    "GET /surveys/{survey_id}/checks/adjustment",
    { survey_id: surveyId, ...known },
    { keep: true },
  );
  const again = () => Promise.all([read.reload(), refreshSurvey()]);
  const { job, underWay, busy, problem, run, follow, cancel } = useJobAction({
    stopped: say("computing-job"),
    over: again,
  });
  const decide = (ask: () => Promise<{ job: Job | null }>, done: string) =>
    run(async () => {
      try {
        const answer = await ask();
        toast(done);
        follow(answer.job?.id ?? null);
      } finally {
        await again();
      }
    });
  if (!read.data) return <Loaded of={read} what={say("adjust-loading")} />;
  return (
    <>
      <KnownFields known={known} change={setKnown} />
      <Problem error={problem ?? read.error} />
      {job && <JobProgress panel job={job} onCancel={cancel} />}
      {read.data.length === 0 && <Empty says="adjust-no-pose" />}
      {read.data.map((one) => (
        <OfPose
          key={one.pose_id}
          surveyId={surveyId}
          found={one}
          busy={busy || underWay || read.loading}
          put={(change) =>
            decide(
              () =>
                api.write(
                  "POST /poses/{pose_id}/adjustment",
                  { pose_id: one.pose_id },
                  { body: { ...one.known, camera_height_change_m: change } },
                ),
              say("adjust-put-done"),
            )
          }
          takeBack={() =>
            decide(
              () => api.write("POST /poses/{pose_id}/adjustment/undo", { pose_id: one.pose_id }),
              say("adjust-taken-back"),
            )
          }
        />
      ))}
    </>
  );
}

function KnownFields({ known, change }: { known: Known; change(next: Known): void }) {
  const unit = smallScale()[1];
  const field = (name: keyof Known, label: string) => (
    <SmallField
      key={`${name} ${unit}`}
      label={label}
      value={known[name]}
      set={(m) => change({ ...known, [name]: m })}
    />
  );
  return (
    <div class="row row--wrap row--end">
      {field("u_wheelbase_m", say("adjust-u-wheelbase", { unit }))}
      {field("u_wheelbase_common_m", say("adjust-u-wheelbase-common", { unit }))}
      {field("u_roof_common_m", say("adjust-u-roof-common", { unit }))}
    </div>
  );
}

function SmallField({ label, value, set }: { label: string; value: number; set(m: number): void }) {
  const [text, setText] = useState(smallText(value));
  const typed = parseSmall(text);
  const good = typed !== null && typed >= 0 && typed <= 1;
  return (
    <TextField
      label={label}
      numeric
      value={text}
      onInput={(next) => {
        setText(next);
        const metres = parseSmall(next);
        if (metres !== null && metres >= 0 && metres <= 1) set(metres);
      }}
      problem={good ? null : say("adjust-u-problem", { example: smallText(0.01, lengthUnit.value, 2) })}
    />
  );
}

interface PoseProps {
  surveyId: number;
  found: PoseAdjustment;
  busy: boolean;
  put(change: number): Promise<unknown>;
  takeBack(): Promise<unknown>;
}

function OfPose({ surveyId, found, busy, put, takeBack }: PoseProps) {
  const camera = found.moved.find((one) => one.name === "camera_height_m");
  return (
    <Panel
      label={say("adjust-pose", { pose: String(found.pose_id), recordings: allOf([...found.recordings]) })}
      aside={
        <>
          {canWork.value && found.adjusted_from !== null && (
            <Button says="adjust-take-back" small icon="undo" busy={busy} onClick={() => void takeBack()} />
          )}
          {canWork.value && camera && found.used > 0 && (
            <Button
              says="adjust-put"
              small
              kind="primary"
              busy={busy}
              onClick={() => void put(camera.value)}
            />
          )}
        </>
      }
      wrap
      data-testid="adjustment"
    >
      <div class="panel__body stack">
        {found.adjusted_from !== null ? (
          <p>{say("adjust-adjusted", { pose: String(found.adjusted_from) })}</p>
        ) : (
          <p>{say("adjust-seen", { tyres: found.tyres, roofs: found.roofs })}</p>
        )}
        {found.reason && found.adjusted_from === null && <Notice>{sentenceOf(found.reason)}</Notice>}
        {found.used > 0 && <p>{inWords(found)}</p>}
        <Notices of={found.notes} kind="warning" />
      </div>
      {found.moved.length > 0 && <MovedTable found={found} />}
      <LeftOut surveyId={surveyId} found={found} />
      {found.without_model.length > 0 && <ModelsTable found={found} />}
      {found.heights.length > 0 && <HeightsTable surveyId={surveyId} found={found} />}
    </Panel>
  );
}

function inWords(found: PoseAdjustment): string {
  const words = [say("adjust-used", { used: found.used, passes: found.passes })];
  if (found.chi2 !== null && found.chi2_limit !== null) {
    const holds = found.chi2 <= found.chi2_limit;
    const values = {
      chi2: fixed(found.chi2, 1),
      freedom: found.degrees_of_freedom,
      limit: fixed(found.chi2_limit, 1),
    };
    words.push(holds ? say("adjust-global-holds", values) : say("adjust-global-fails", values));
  }
  if (found.largest_change_m !== null)
    words.push(say("adjust-largest", { largest: formatSmall(found.largest_change_m) }));
  return words.join(" ");
}

/** A small length or angle in the unit that its name ends in. */
function inItsUnit(name: string, value: number): string {
  return name.endsWith("_rad") ? `${fixed(value * MILLI, 2)} mrad` : formatSmall(value);
}

/** What moved; of the error common to one assumed inset, which inset. */
function movedWords({ name, of_m }: PoseAdjustment["moved"][number]): string {
  const what = MOVED[name] ?? "";
  return of_m === null ? what : say("adjust-common-of", { what, length: formatLength(of_m, 2) });
}

function MovedTable({ found }: { found: PoseAdjustment }) {
  const named = found.moved.filter((one) => MOVED[one.name] && one.by_u !== null);
  return (
    <DataTable
      label={say("adjust-moved-title")}
      caption={say("adjust-moved-title")}
      data-testid="moved"
      rows={named}
      keyOf={(one) => `${one.name} ${one.of_m}`}
      columns={({ col, num }) => [
        col(say("adjust-what"), movedWords),
        num(say("adjust-value"), (one) => inItsUnit(one.name, one.value)),
        { ...num(say("adjust-by-u"), (one) => scaled(one.by_u, 1, 1)), title: say("adjust-by-u-help") },
        num(say("adjust-u-before"), (one) => inItsUnit(one.name, one.u_before)),
        num(say("adjust-u-after"), (one) => inItsUnit(one.name, one.u_after)),
      ]}
    />
  );
}

function LeftOut({ surveyId, found }: { surveyId: number; found: PoseAdjustment }) {
  if (found.left_out.length === 0)
    return found.used > 0 ? <p class="panel__body muted">{say("adjust-left-none")}</p> : null;
  return (
    <DataTable
      label={say("adjust-left-title")}
      scroll="tall"
      caption={say("adjust-left-title")}
      data-testid="left-out"
      rows={found.left_out}
      keyOf={(one) => `${one.vehicle_id} ${one.what}`}
      columns={({ col }) => [
        col(say("computing-vehicle"), (one) => (
          <a href={vehicleAt(surveyId, one)}>{vehicleName(one.number)}</a>
        )),
        col(say("adjust-what"), (one) => say(one.what === "tyres" ? "adjust-of-tyres" : "adjust-of-roof")),
        col(say("computing-kind"), (one) => sentenceOf(one.reason)),
      ]}
    />
  );
}

function ModelsTable({ found }: { found: PoseAdjustment }) {
  return (
    <>
      <DataTable
        label={say("adjust-models-title")}
        scroll="tall"
        caption={say("adjust-models-title")}
        rows={found.without_model}
        keyOf={(one) => one.model}
        columns={({ col, num }) => [
          col(say("adjust-model"), (one) => one.model),
          num(say("adjust-vehicles"), (one) => one.vehicles),
          num(say("adjust-camera"), (one) => formatSmall(one.camera_height_change_m)),
          num(say("adjust-by-u"), (one) => fixed(one.by_u, 1)),
        ]}
      />
      <p class="panel__body muted small">{say("adjust-models-note")}</p>
    </>
  );
}

function HeightsTable({ surveyId, found }: { surveyId: number; found: PoseAdjustment }) {
  return (
    <DataTable
      label={say("adjust-heights-title")}
      scroll="heads-stay again-heights"
      caption={say("adjust-heights-title")}
      data-testid="adjusted-heights"
      rows={found.heights}
      keyOf={(one) => one.measurement_id}
      columns={({ col, num }) => [
        col(say("computing-vehicle"), (one) => (
          <a href={vehicleAt(surveyId, one)}>{vehicleName(one.number)}</a>
        )),
        col(say("computing-target"), (one) => TARGET_WORDS[one.target]),
        num(say("adjust-now"), (one) => formatHeight(one.height_m, one.U95_height_m)),
        num(say("adjust-then"), (one) => formatHeight(one.adjusted_m, one.U95_adjusted_m)),
        num(say("computing-change"), (one) => formatSmall(one.change_m)),
      ]}
    />
  );
}

function vehicleAt(surveyId: number, { vehicle_id }: { vehicle_id: number }): string {
  return `/surveys/${surveyId}/measure?vehicle=${vehicle_id}`;
}
