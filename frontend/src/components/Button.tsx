import type { ComponentChildren, Ref } from "preact";
import { Icon, type IconName } from "./Icon";

export interface ButtonProps {
  children?: ComponentChildren;
  kind?: "plain" | "primary" | "quiet";
  small?: boolean;
  icon?: IconName;
  /** Name of a button that shows only an icon; also its title. */
  label?: string;
  title?: string;
  type?: "button" | "submit";
  disabled?: boolean;
  /** Shows that the press is being worked on, and takes no other. */
  busy?: boolean;
  pressed?: boolean;
  /** Makes it a link that looks like a button. */
  href?: string;
  download?: boolean | string;
  /** Opens beside, in a tab of its own: what was begun on this page stays. */
  beside?: boolean;
  class?: string;
  onClick?: (event: MouseEvent) => void;
  buttonRef?: Ref<HTMLButtonElement>;
}

function tabOf({ beside }: ButtonProps) {
  return beside ? { target: "_blank", rel: "noopener" } : {};
}

export function Button(props: ButtonProps) {
  const { kind = "plain", small, icon, label, children, busy } = props;
  const names = ["btn", kind !== "plain" && `btn--${kind}`, small && "btn--small"];
  if (!children) names.push("btn--icon");
  if (props.class) names.push(props.class);
  const className = names.filter(Boolean).join(" ");
  const inside = (
    <>
      {busy ? (
        <span class="spinner" aria-hidden="true" />
      ) : (
        icon && <Icon name={icon} size={small ? 14 : 16} />
      )}
      {children}
    </>
  );
  const title = props.title ?? (children ? undefined : label);
  if (props.href !== undefined && !props.disabled) {
    return (
      <a
        class={className}
        href={props.href}
        title={title}
        aria-label={label}
        download={props.download}
        {...tabOf(props)}
      >
        {inside}
      </a>
    );
  }
  return (
    <button
      ref={props.buttonRef}
      type={props.type ?? "button"}
      class={className}
      disabled={props.disabled || busy}
      aria-busy={busy || undefined}
      aria-pressed={props.pressed}
      aria-label={label}
      title={title}
      onClick={props.onClick}
    >
      {inside}
    </button>
  );
}
