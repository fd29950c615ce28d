import type { ComponentChildren } from "preact";
import { type PlainKey, say } from "../core/messages";
import { Icon, type IconName } from "./Icon";

export interface ButtonProps {
  children?: ComponentChildren;
  says?: PlainKey;
  kind?: "plain" | "primary" | "quiet";
  small?: boolean;
  icon?: IconName;
  /** Name of a button that shows only an icon; also its title. */
  label?: string;
  title?: string;
  type?: "button" | "submit";
  /** The form that it sends, where it does not stand in it. */
  form?: string;
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
}

function tabOf({ beside }: ButtonProps) {
  return beside ? { target: "_blank", rel: "noopener" } : {};
}

function classOf({ kind = "plain", small, says, children, class: more }: ButtonProps): string {
  const shape = [
    kind !== "plain" && `btn--${kind}`,
    small && "btn--small",
    !says && !children && "btn--icon",
  ];
  return ["btn", ...shape, more].filter(Boolean).join(" ");
}

export function Button(props: ButtonProps) {
  const { small, icon, label, busy } = props;
  const children = props.says ? say(props.says) : props.children;
  const className = classOf(props);
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
      type={props.type ?? "button"}
      form={props.form}
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

type IconButtonProps = Required<Pick<ButtonProps, "icon" | "label" | "onClick">> &
  Pick<ButtonProps, "title" | "disabled" | "pressed">;

/** A small quiet sign: beside a thing, what can be done with it. */
export function IconButton(props: IconButtonProps) {
  return <Button {...props} small kind="quiet" />;
}
