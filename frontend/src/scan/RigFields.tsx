import { TextField } from "../components";
import { lengthUnit } from "../units";
import type { RigTyped } from "./rig";

interface Props {
  typed: RigTyped;
  problems: Partial<Record<keyof RigTyped, string>>;
  change: (part: Partial<RigTyped>) => void;
  /** Cut from a video: its frame rate is the line rate. */
  noRate?: boolean;
}

export function RigFields({ typed, problems, change, noRate }: Props) {
  const unit = lengthUnit.value;
  return (
    <div class="scan__fields">
      <TextField
        label="Baseline"
        value={typed.baseline}
        numeric
        unit={unit}
        problem={problems.baseline}
        hint="Between the two scanning planes, at the vehicles."
        onInput={(baseline) => change({ baseline })}
      />
      <TextField
        label="Its standard uncertainty"
        value={typed.uBaseline}
        numeric
        unit={unit}
        problem={problems.uBaseline}
        hint="A speed is never better known than this."
        onInput={(uBaseline) => change({ uBaseline })}
      />
      {!noRate && (
        <>
          <TextField
            label="Lines a second"
            value={typed.rate}
            numeric
            problem={problems.rate}
            onInput={(rate) => change({ rate })}
          />
          <TextField
            label="Clock’s uncertainty"
            value={typed.ratePpm}
            numeric
            unit="ppm"
            problem={problems.ratePpm}
            hint="A quartz keeps about 50 ppm."
            onInput={(ratePpm) => change({ ratePpm })}
          />
        </>
      )}
    </div>
  );
}
