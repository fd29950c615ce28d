import { TextField } from "../components";
import { lengthUnit } from "../units";
import type { RigProblems, RigTyped } from "./rig";

interface Props {
  typed: RigTyped;
  problems: RigProblems;
  change: (part: Partial<RigTyped>) => void;
  /** Cut from a video: its frame rate is the line rate. */
  noRate?: boolean;
  /** Leave out what is rarely known. */
  plain?: boolean;
}

export function RigFields({ typed, problems, change, noRate, plain }: Props) {
  const unit = lengthUnit.value;
  return (
    <>
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
              unit="Hz"
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
      {!plain && <Advanced typed={typed} problems={problems} change={change} />}
    </>
  );
}

const ADVANCED = ["divergence", "uDivergence", "distance", "misalignment", "uMisalignment"] as const;

/** Folded until something stands in it or is wrong with it. */
function Advanced({ typed, problems, change }: Pick<Props, "typed" | "problems" | "change">) {
  const used = ADVANCED.some((name) => typed[name] !== "" || problems[name]);
  return (
    <details class="scan__advanced" open={used || undefined}>
      <summary>More: misalignment, divergence, distance of the lane</summary>
      <div class="scan__pairs">
        <TextField
          label="Misalignment"
          value={typed.misalignment}
          numeric
          unit="px"
          placeholder="from the traffic"
          problem={problems.misalignment}
          hint="Row of a point in strip 2 minus its row in strip 1. Empty: estimated from the traffic, vehicle by vehicle."
          onInput={(misalignment) => change({ misalignment })}
        />
        <TextField
          label="Its standard uncertainty"
          value={typed.uMisalignment}
          numeric
          unit="px"
          problem={problems.uMisalignment}
          onInput={(uMisalignment) => change({ uMisalignment })}
        />
        <TextField
          label="Divergence of the planes"
          value={typed.divergence}
          numeric
          unit="mrad"
          problem={problems.divergence}
          hint="Positive: they open towards the vehicles. The baseline is then the one at the cameras."
          onInput={(divergence) => change({ divergence })}
        />
        <TextField
          label="Its standard uncertainty"
          value={typed.uDivergence}
          numeric
          unit="mrad"
          problem={problems.uDivergence}
          hint="Planes that were set parallel: what the setting leaves."
          onInput={(uDivergence) => change({ uDivergence })}
        />
        <TextField
          label="Distance of the lane"
          value={typed.distance}
          numeric
          unit={lengthUnit.value}
          problem={problems.distance}
          hint="From the cameras to the vehicles’ near side. Needed for the divergence only."
          onInput={(distance) => change({ distance })}
        />
      </div>
    </details>
  );
}
