/** The lanes of a rig, each with its distance and by what its vehicles are told. */
import { Button, SelectField, TextField } from "../../components";
import { say } from "../../core/messages";
import { lengthUnit } from "../../core/units";
import { type LaneProblems, type LaneTyped, type LaneWay, MOST_LANES, NEW_LANE } from "./lanes";

interface Props {
  lanes: readonly LaneTyped[];
  problems: readonly LaneProblems[];
  change: (lanes: readonly LaneTyped[]) => void;
}

export function LaneFields({ lanes, problems, change }: Props) {
  const put = (at: number, part: Partial<LaneTyped>) =>
    change(lanes.map((one, each) => (each === at ? { ...one, ...part } : one)));
  return (
    <details class="scan__advanced" open={lanes.length > 0 || undefined} data-testid="rig-lanes">
      <summary>{say("scans-lanes")}</summary>
      <p class="small muted">{say("scans-lanes-why")}</p>
      {lanes.map((one, at) => (
        <Lane
          key={at}
          number={at + 1}
          lane={one}
          problems={problems[at] ?? {}}
          put={(part) => put(at, part)}
          remove={() => change(lanes.filter((_, each) => each !== at))}
        />
      ))}
      <Button
        says="scans-lane-add"
        small
        icon="add"
        disabled={lanes.length >= MOST_LANES}
        onClick={() => change([...lanes, NEW_LANE])}
      />
    </details>
  );
}

interface LaneProps {
  number: number;
  lane: LaneTyped;
  problems: LaneProblems;
  put: (part: Partial<LaneTyped>) => void;
  remove: () => void;
}

const WAYS: readonly LaneWay[] = ["either", "camera_1_first", "camera_2_first"];

function Lane({ number, lane, problems, put, remove }: LaneProps) {
  const unit = lengthUnit.value;
  const typed = (name: Exclude<keyof LaneTyped, "direction" | "stored">) => ({
    value: lane[name],
    problem: problems[name],
    onInput: (text: string) => put({ [name]: text }),
  });
  return (
    <fieldset class="scan__lane">
      <legend class="visually-hidden">{say("scans-lane-of", { number: String(number) })}</legend>
      <div class="grid grid--tight scan__pairs">
        <TextField says="scans-lane-name" {...typed("name")} />
        <SelectField
          says="scan-direction"
          value={lane.direction}
          options={WAYS.map((value) => ({ value, label: say("scans-lane-way", { way: value }) }))}
          onInput={(direction) => put({ direction })}
        />
        <TextField says="scans-lane-distance" unit={unit} {...typed("distance")} />
        <TextField says="scans-rig-u" unit={unit} {...typed("uDistance")} />
        <TextField
          says="scans-lane-from"
          unit={say("unit-px")}
          hint={say("scans-lane-rows-hint")}
          {...typed("from")}
        />
        <TextField says="scans-lane-to" unit={say("unit-px")} {...typed("to")} />
        <TextField
          says="scans-rig-shadow"
          unit="%"
          placeholder={say("scans-lane-shadow-rig")}
          {...typed("shadow")}
        />
      </div>
      <Button says="scans-lane-remove" small icon="trash" onClick={remove} />
    </fieldset>
  );
}
