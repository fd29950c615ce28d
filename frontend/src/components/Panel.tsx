/** The shells of a page: its head, and a panel with a title by which it is known. */
import type { ComponentChildren, HTMLAttributes } from "preact";
import { useId } from "preact/hooks";

interface PageHeadProps {
  title: ComponentChildren;
  /** What the page is for, in a sentence or two. */
  lead?: ComponentChildren;
  /** What stands below it. */
  more?: ComponentChildren;
  /** On the right: what can be done. */
  children?: ComponentChildren;
}

export function PageHead({ title, lead, more, children }: PageHeadProps) {
  return (
    <header class="page__head">
      <div>
        <h1>{title}</h1>
        {lead && <p class="page__lead">{lead}</p>}
        {more}
      </div>
      {children}
    </header>
  );
}

interface PanelProps extends Omit<HTMLAttributes<HTMLElement>, "title"> {
  title: ComponentChildren;
  /** In its head, beside the title: words, or what can be done. */
  note?: string;
  aside?: ComponentChildren;
  /** The head may take more than one line. */
  wrap?: boolean;
}

export function Panel({ title, note, aside, wrap, id, class: more, children, ...rest }: PanelProps) {
  const own = useId();
  const titleId = id ?? own;
  return (
    <section
      class={more ? `panel ${more}` : "panel"}
      aria-labelledby={rest["aria-label"] ? undefined : titleId}
      {...rest}
    >
      <header class={wrap ? "panel__head row--wrap" : "panel__head"}>
        <h2 id={titleId as string}>{title}</h2>
        {note && <span class="muted small">{note}</span>}
        {aside}
      </header>
      {children}
    </section>
  );
}
