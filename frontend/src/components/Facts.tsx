/** What is known of a thing: names and values, side by side. */
import { type ComponentChildren, Fragment } from "preact";

/** The value may be found by a test. What is no pair is left out. */
export type Fact =
  | readonly [name: ComponentChildren, value: ComponentChildren, testId?: string]
  | false
  | null
  | undefined
  | "";

interface FactsProps {
  of: readonly Fact[];
  small?: boolean;
  class?: string;
  "data-testid"?: string;
}

export function Facts({ of, small, class: more, ...rest }: FactsProps) {
  return (
    <dl {...rest} class={["facts", small && "small", more].filter(Boolean).join(" ")}>
      {of.map(
        (fact, at) =>
          fact && (
            <Fragment key={at}>
              <dt>{fact[0]}</dt>
              <dd data-testid={fact[2]}>{fact[1]}</dd>
            </Fragment>
          ),
      )}
    </dl>
  );
}
