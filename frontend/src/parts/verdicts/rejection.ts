/** A rejection that is begun and not given yet, a tool of its page's picture: Enter gives it once it has a reason, Esc
 *  leaves it. */
import { signal } from "@preact/signals";
import type { ButtonCommand } from "../../components/CommandButton";
import type { ActionId } from "../../core/commands";
import { type PlainKey, say } from "../../core/messages";

export class Rejection {
  readonly begun = signal(false);
  readonly reason = signal("");
  readonly commands: readonly ButtonCommand[];

  /** `reasons`: those that are offered, in the order of their digit keys. */
  constructor(
    readonly reasons: readonly PlainKey[],
    private readonly give: (reason: string) => void,
  ) {
    this.commands = reasons.map((key, i) => ({
      id: `reviewReason${i + 1}` as ActionId,
      run: () => {
        this.reason.value = say(key);
      },
      enabled: () => this.begun.value,
    }));
  }

  begin(): void {
    this.reason.value = "";
    this.begun.value = true;
  }

  confirm(): boolean {
    const reason = this.reason.value.trim();
    const ready = this.begun.value && reason !== "";
    if (ready) this.give(reason);
    return ready;
  }

  cancel(): boolean {
    const begun = this.begun.value;
    this.begun.value = false;
    return begun;
  }
}
