import { TextField } from "../../components";
import { say } from "../../core/messages";
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
          label={say("scans-rig-baseline")}
          unit={unit}
          hint={say("scans-rig-baseline-hint")}
        />
        <Typed
          name="uBaseline"
          of={of}
          label={say("scans-rig-u")}
          unit={unit}
          hint={say("scans-rig-baseline-u-hint")}
        />
        {!noRate && (
          <>
            <Typed name="rate" of={of} label={say("scans-rig-rate")} unit={say("unit-hz")} />
            <Typed
              name="ratePpm"
              of={of}
              label={say("scans-rig-clock")}
              unit={say("unit-ppm")}
              hint={say("scans-rig-clock-hint")}
            />
          </>
        )}
      </div>
      {!plain && <Advanced of={of} />}
    </>
  );
}

const ADVANCED = [
  "divergence",
  "uDivergence",
  "distance",
  "uDistance",
  "correlation",
  "misalignment",
  "uMisalignment",
] as const;

/** Folded until something stands in it or is wrong with it. */
function Advanced({ of }: { of: Typing }) {
  const used = ADVANCED.some((name) => of.typed[name] !== "" || of.problems[name]);
  return (
    <details class="scan__advanced" open={used || undefined}>
      <summary>{say("scans-rig-more")}</summary>
      <div class="scan__pairs">
        <Typed
          name="misalignment"
          of={of}
          label={say("scans-rig-misalignment")}
          unit={say("unit-px")}
          placeholder={say("scans-rig-from-traffic")}
          hint={say("scans-rig-misalignment-hint")}
        />
        <Typed name="uMisalignment" of={of} label={say("scans-rig-u")} unit={say("unit-px")} />
        <Typed
          name="divergence"
          of={of}
          label={say("scans-rig-divergence")}
          unit={say("unit-mrad")}
          hint={say("scans-rig-divergence-hint")}
        />
        <Typed
          name="uDivergence"
          of={of}
          label={say("scans-rig-u")}
          unit={say("unit-mrad")}
          hint={say("scans-rig-divergence-u-hint")}
        />
        <Typed
          name="distance"
          of={of}
          label={say("scans-rig-distance")}
          unit={lengthUnit.value}
          hint={say("scans-rig-distance-hint")}
        />
        <Typed
          name="uDistance"
          of={of}
          label={say("scans-rig-u")}
          unit={lengthUnit.value}
          hint={say("scans-rig-distance-u-hint")}
        />
        <Typed
          name="correlation"
          of={of}
          label={say("scans-rig-correlation")}
          unit=""
          hint={say("scans-rig-correlation-hint")}
        />
        <Typed
          name="shadow"
          of={of}
          label={say("scans-rig-shadow")}
          unit="%"
          placeholder="15"
          hint={say("scans-rig-shadow-hint")}
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
