import { type ActionId, keyMap, showChord } from "../../core/commands";
import { canWork } from "../../core/session";
import type { Target } from "../../core/types";
import { TARGET_WORDS, TARGETS } from "../../core/words";

/** What chooses a target: "target1" the first of them. */
export function targetAction(target: Target): ActionId {
  return `target${TARGETS.indexOf(target) + 1}` as ActionId;
}

/** The key of a target, as a keycap shows it; empty if it has none. */
export function targetKey(target: Target): string {
  const key = keyMap.value[targetAction(target)]?.[0];
  return key ? showChord(key) : "";
}

interface Props {
  target: Target;
  pressed: boolean;
  title: string;
  testId: string;
  onClick: () => void;
}

export function TargetButton({ target, pressed, title, testId, onClick }: Props) {
  return (
    <button
      type="button"
      class="row height-row__target"
      data-testid={testId}
      aria-pressed={pressed}
      disabled={!canWork.value}
      title={title}
      onClick={onClick}
    >
      <kbd>{targetKey(target)}</kbd>
      <span>{TARGET_WORDS[target]}</span>
    </button>
  );
}
