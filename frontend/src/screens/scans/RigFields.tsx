import { TextField } from "../../components";
import { lengthUnit } from "../../core/units";
import type { RigProblems, RigTyped } from "./rig";

interface Typing {
  typed: RigTyped;
  problems: RigProblems;
  change: (part: Partial<RigTyped>) => void;
}

interface Props extends Typing {
  /** Cut from a video: its frame rate is the line rate. */
  noRate?: boolean;
  /** Leave out what is rarely known. */
  plain?: boolean;
}

export function RigFields({ noRate, plain, ...of }: Props) {
  const unit = lengthUnit.value;
  return (
    <>
      <div class="scan__fields">
        <Typed
          name="baseline"
          of={of}
          label="Baseline"
          unit={unit}
          hint="Between the two scanning planes, at the vehicles."
        />
        <Typed
          name="uBaseline"
          of={of}
          label="Its standard uncertainty"
          unit={unit}
          hint="A speed is never better known than this."
        />
        {!noRate && (
          <>
            <Typed name="rate" of={of} label="Lines a second" unit="Hz" />
            <Typed
              name="ratePpm"
              of={of}
              label="Clock’s uncertainty"
              unit="ppm"
              hint="A quartz keeps about 50 ppm."
            />
          </>
        )}
      </div>
      {!plain && <Advanced of={of} />}
    </>
  );
}

const ADVANCED = ["divergence", "uDivergence", "distance", "misalignment", "uMisalignment"] as const;

/** Folded until something stands in it or is wrong with it. */
function Advanced({ of }: { of: Typing }) {
  const used = ADVANCED.some((name) => of.typed[name] !== "" || of.problems[name]);
  return (
    <details class="scan__advanced" open={used || undefined}>
      <summary>More: misalignment, divergence, distance of the lane</summary>
      <div class="scan__pairs">
        <Typed
          name="misalignment"
          of={of}
          label="Misalignment"
          unit="px"
          placeholder="from the traffic"
          hint="Row of a point in strip 2 minus its row in strip 1. Empty: estimated from the traffic, vehicle by vehicle."
        />
        <Typed name="uMisalignment" of={of} label="Its standard uncertainty" unit="px" />
        <Typed
          name="divergence"
          of={of}
          label="Divergence of the planes"
          unit="mrad"
          hint="Positive: they open towards the vehicles. The baseline is then the one at the cameras."
        />
        <Typed
          name="uDivergence"
          of={of}
          label="Its standard uncertainty"
          unit="mrad"
          hint="Planes that were set parallel: what the setting leaves."
        />
        <Typed
          name="distance"
          of={of}
          label="Distance of the lane"
          unit={lengthUnit.value}
          hint="From the cameras to the vehicles’ near side. Needed for the divergence only."
        />
      </div>
    </details>
  );
}

interface TypedProps {
  name: keyof RigTyped & keyof RigProblems;
  of: Typing;
  label: string;
  unit: string;
  hint?: string;
  placeholder?: string;
}

/** One value of the rig, as typed. */
function Typed({ name, of, ...shown }: TypedProps) {
  return (
    <TextField
      value={of.typed[name]}
      numeric
      problem={of.problems[name]}
      onInput={(text) => of.change({ [name]: text })}
      {...shown}
    />
  );
}
