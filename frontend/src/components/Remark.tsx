import type { ComponentChildren, HTMLAttributes } from "preact";
import { Icon, type IconName } from "./Icon";

interface RemarkProps extends Omit<HTMLAttributes<HTMLParagraphElement>, "icon"> {
  icon: IconName;
  children: ComponentChildren;
  /** Behind the words: what can be done about it. */
  action?: ComponentChildren;
  "data-testid"?: string;
}

/** A line of small words with what kind they are of: to be known, or to be looked at. */
export function Remark({ icon, children, action, class: shape, ...rest }: RemarkProps) {
  return (
    <p {...rest} class={shape ?? "small row"}>
      <Icon name={icon} size={14} />
      <span class="grow">{children}</span>
      {action}
    </p>
  );
}
