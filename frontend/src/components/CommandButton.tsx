/** The button of a command: its words, its key in the title, its switch and its state come from the one object. */
import type { ComponentChildren } from "preact";
import { type Command, hint, labelOf } from "../core/commands";
import { Button, type ButtonProps } from "./Button";
import type { IconName } from "./Icon";

export interface ButtonCommand extends Command {
  readonly icon?: IconName;
}

interface Props extends Pick<ButtonProps, "kind" | "small"> {
  command: ButtonCommand;
  title?: string;
  /** The word on the button; without one it shows its icon. */
  children?: ComponentChildren;
}

export function CommandButton({ command, kind = "quiet", small = true, title, children }: Props) {
  const label = labelOf(command);
  return (
    <Button
      small={small}
      kind={kind}
      icon={command.icon}
      label={children ? undefined : label}
      title={title ?? `${label}${hint(command.id)}`}
      pressed={command.pressed?.()}
      disabled={command.enabled?.() === false}
      onClick={() => void command.run(true)}
    >
      {children}
    </Button>
  );
}

/** Its line in a menu. */
export function CommandItem({ command }: { command: Command }) {
  return (
    <button
      type="button"
      class="row menu__item"
      disabled={command.enabled?.() === false}
      onClick={() => void command.run(true)}
    >
      {labelOf(command)}
      {hint(command.id)}
    </button>
  );
}
