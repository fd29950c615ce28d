/** The shells of a page: its head, and a panel with a title by which it is known. */
import type { ComponentChildren, HTMLAttributes } from "preact";
import { useId } from "preact/hooks";
import { type Named, nameOf } from "./named";

type PageHeadProps = Named & {
  /** What the page is for, in a sentence or two. */
  lead?: ComponentChildren;
  more?: ComponentChildren;
  /** On the right: what can be done. */
  children?: ComponentChildren;
};

export function PageHead({ lead, more, children, ...name }: PageHeadProps) {
  return (
    <header class="page__head">
      <div>
        <h1>{nameOf(name)}</h1>
        {lead && <p class="page__lead">{lead}</p>}
        {more}
      </div>
      {children}
    </header>
  );
}

interface PanelProps extends Omit<HTMLAttributes<HTMLElement>, "label"> {
  /** In its head, beside the title: words, or what can be done. */
  note?: string;
  aside?: ComponentChildren;
  wrap?: boolean;
  /** Within another part of the page: its title stands below that one's. */
  within?: boolean;
}

export function Panel(props: Named & PanelProps) {
  const { says, label, note, aside, wrap, within, id, class: more, children, ...rest } = props;
  const Title = within ? "h3" : "h2";
  const own = useId();
  const titleId = id ?? own;
  return (
    <section
      class={more ? `panel ${more}` : "panel"}
      aria-labelledby={rest["aria-label"] ? undefined : titleId}
      {...rest}
    >
      <header class={`row row--apart row--far panel__head${wrap ? " row--wrap" : ""}`}>
        <Title id={titleId as string}>{nameOf(props)}</Title>
        {note && <span class="muted small">{note}</span>}
        {aside}
      </header>
      {children}
    </section>
  );
}
