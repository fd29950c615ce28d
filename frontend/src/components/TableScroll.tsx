import type { ComponentChildren } from "preact";

/** A table that may be wider than its place: scrolled by pointer, and by keyboard once it has the focus. No landmark: the
 * panel around it is one of the same name. */
export function TableScroll(props: { label: string; class?: string; children: ComponentChildren }) {
  const classes = props.class ? `${props.class} table-scroll` : "table-scroll";
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reachable by keyboard
    <div class={classes} role="group" aria-label={props.label} tabIndex={0}>
      {props.children}
    </div>
  );
}
