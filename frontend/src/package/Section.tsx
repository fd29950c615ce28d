/** What the pages of a package and of an evidence file are laid out with: parts under their names, tables with their heads. */
import type { ComponentChildren, HTMLAttributes } from "preact";

export function Section({ name, children, ...rest }: { name: string } & HTMLAttributes<HTMLElement>) {
  return (
    <section class="opened__section" {...rest}>
      <h2 class="opened__name">{name}</h2>
      {children}
    </section>
  );
}

interface GridProps {
  heads: readonly (string | { name: string; title: string })[];
  /** As high as the page at the most. */
  list?: boolean;
  class?: string;
  children: ComponentChildren;
}

/** A table that scrolls by itself where it is too wide. */
export function Grid({ heads, list, class: more, children }: GridProps) {
  return (
    <div class={list ? "opened__scroll opened__list" : "opened__scroll"}>
      <table class={more ? `opened__rows ${more}` : "opened__rows"}>
        <thead>
          <tr>
            {heads.map((head) => {
              const { name, title } = typeof head === "string" ? { name: head, title: undefined } : head;
              return (
                <th key={name} scope="col" title={title}>
                  {name}
                </th>
              );
            })}
          </tr>
        </thead>
        <tbody>{children}</tbody>
      </table>
    </div>
  );
}

interface FactsProps {
  rows: readonly (readonly [name: string, value: string])[];
  class?: string;
}

export function Facts({ rows, class: shape }: FactsProps) {
  return (
    <table class="opened__rows">
      <tbody>
        {rows.map(([name, value]) => (
          <tr key={name}>
            <th scope="row">{name}</th>
            <td class={shape}>{value}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
