/** How far people lean on proposals that they are shown: heights shown against those measured free, with the goal beside it. */
import { DataTable, Panel, Problem, Select } from "../../components";
import { api } from "../../core/api";
import { say, sayCode } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { may } from "../../core/session";
import { toastProblem } from "../../core/toasts";
import type { Anchoring } from "../../core/types";
import { formatSmall } from "../../core/units";
import { TARGET_WORDS } from "../../core/words";
import { shiftWords } from "./words";

export function AnchoringPanel({ surveyId }: { surveyId: number }) {
  const found = useAsked("GET /surveys/{survey_id}/anchoring", { survey_id: surveyId });
  const data = found.data;
  const choose = async (free_one_in: number): Promise<void> => {
    const version = data?.plan.version ?? 0;
    await api
      .write(
        "PUT /surveys/{survey_id}/free-plan",
        { survey_id: surveyId },
        { body: { free_one_in, version } },
      )
      .catch(toastProblem);
    await found.reload();
  };
  if (!data) return <Problem error={found.error} again={found.reload} />;
  return (
    <Panel says="anchoring-title" aside={<Plan plan={data.plan} choose={choose} />} data-testid="anchoring">
      <DataTable
        label={say("anchoring-title")}
        class="repeats"
        rows={data.targets}
        keyOf={(one) => one.target ?? "all"}
        columns={({ col, num }) => [
          col(say("repeats-target"), ({ target }) => (
            <strong>{target === null ? say("repeats-all-targets") : TARGET_WORDS[target]}</strong>
          )),
          num(
            say("anchoring-shown"),
            ({ shift }) => <Mean count={shift.shown} mean_m={shift.shown_m} />,
            "nowrap",
          ),
          num(
            say("anchoring-free"),
            ({ shift }) => <Mean count={shift.free} mean_m={shift.free_m} />,
            "nowrap",
          ),
          col(say("anchoring-shift"), ({ shift }) => shiftWords(shift) ?? "–", "nowrap"),
          col(
            say("anchoring-goal", { goal: formatSmall(data.goal_m) }),
            ({ verdict, shift }) =>
              verdict
                ? say("anchoring-verdict", { verdict })
                : sayCode({ code: shift.reason ?? "", values: {} }),
            "small",
          ),
        ]}
      />
      <p class="repeats__note small muted">
        {say("anchoring-help")}{" "}
        {say("anchoring-counts", { confirmed: data.confirmed, moved: data.moved, afresh: data.afresh })}
      </p>
    </Panel>
  );
}

/** How many vehicles, and by how much they were stored above what was proposed. */
function Mean({ count, mean_m }: { count: number; mean_m: number | null }) {
  return (
    <>
      {say("anchoring-vehicles", { count })}
      {mean_m !== null && <p class="small muted">{formatSmall(mean_m)}</p>}
    </>
  );
}

const PLANS = [0, 5, 10, 20, 50];

/** One vehicle in how many: told to everybody, chosen by an administrator. */
function Plan({ plan, choose }: { plan: Anchoring["plan"]; choose: (one_in: number) => void }) {
  const oneIn = plan.free_one_in;
  const words = (one_in: number) => say("anchoring-plan", { one_in });
  if (!may("manager")) return <span class="muted small">{words(oneIn)}</span>;
  return (
    <Select
      aria-label={say("anchoring-plan-choose")}
      title={say("anchoring-plan-choose")}
      data-testid="free-plan"
      value={oneIn}
      options={(PLANS.includes(oneIn) ? PLANS : [oneIn, ...PLANS]).map((value) => ({
        value,
        label: words(value),
      }))}
      onInput={choose}
    />
  );
}
