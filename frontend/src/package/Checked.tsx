import type { ComponentChildren } from "preact";
import type { Check } from "./verdict";

interface Props {
  checks: readonly Check[];
  ended: boolean;
  verdicts: Readonly<Record<Check["state"], string>>;
  /** What stands between verdict and checks. */
  underWay?: ComponentChildren;
  children: ComponentChildren;
}

/** What a page checked of its own file, the verdict of it all first. */
export function Checked({ checks, ended, verdicts, underWay, children }: Props) {
  const wrong = checks.some((one) => one.state === "wrong");
  const state = wrong ? "wrong" : ended ? "fine" : "open";
  return (
    <section class="opened__section" aria-live="polite">
      <p class={`opened__verdict opened__verdict--${state}`} data-verdict={state}>
        {verdicts[state]}
      </p>
      {underWay}
      <ul class="opened__checks">
        {checks.map((one) => (
          <li
            key={one.name}
            class={`opened__check opened__check--${one.state}`}
            data-check={one.name}
            data-state={one.state}
          >
            {one.words}
          </li>
        ))}
      </ul>
      {children}
    </section>
  );
}
