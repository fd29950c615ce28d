import { TextField } from "../../components";
import { say } from "../../core/messages";
import { RIG_FIELDS, type RigFieldName, type RigProblems, type RigTyped } from "./rig";

interface Typing {
  typed: RigTyped;
  problems: RigProblems;
  change: (part: Partial<RigTyped>) => void;
}

interface Props extends Typing {
  /** Cut from a video: its frame rate is the line rate. */
  noRate?: boolean;
  plain?: boolean;
}

const MAIN = ["baseline", "uBaseline", "rate", "ratePpm"] as const;
const ADVANCED = [
  ...(["misalignment", "uMisalignment", "divergence", "uDivergence"] as const),
  ...(["distance", "uDistance", "correlation", "shadow"] as const),
] as const;

export function RigFields({ noRate, plain, ...of }: Props) {
  return (
    <>
      <div class="grid grid--tight">
        <Fields of={of} names={noRate ? MAIN.slice(0, 2) : MAIN} />
      </div>
      {!plain && <Advanced of={of} />}
    </>
  );
}

/** Folded until something stands in it or is wrong with it; how much shadow is left out always stands. */
function Advanced({ of }: { of: Typing }) {
  const used = ADVANCED.some((name) => (name !== "shadow" && of.typed[name] !== "") || of.problems[name]);
  return (
    <details class="scan__advanced" open={used || undefined}>
      <summary>{say("scans-rig-more")}</summary>
      <div class="grid grid--tight scan__pairs">
        <Fields of={of} names={ADVANCED} />
      </div>
    </details>
  );
}

function Fields({ of, names }: { of: Typing; names: readonly RigFieldName[] }) {
  return (
    <>
      {names.map((name) => {
        const { label, unit, hint, placeholder } = RIG_FIELDS[name];
        return (
          <TextField
            key={name}
            says={label}
            unit={unit()}
            hint={hint && say(hint)}
            placeholder={placeholder?.()}
            value={of.typed[name]}
            problem={of.problems[name]}
            onInput={(text) => of.change({ [name]: text })}
          />
        );
      })}
    </>
  );
}
