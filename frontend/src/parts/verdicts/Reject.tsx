/** A rejection needs a reason that the operator can act on: a digit chooses one, Enter gives it; or in one's own words. */
import { useEffect, useRef } from "preact/hooks";
import { Button } from "../../components";
import type { ButtonProps } from "../../components/Button";
import { type ActionId, commandName, hint, keyMap, showChord } from "../../core/commands";
import { say } from "../../core/messages";
import type { Rejection } from "./rejection";
import "./reject.css";

interface JudgeProps extends Pick<ButtonProps, "kind" | "icon" | "disabled" | "onClick"> {
  of: ActionId;
  testId: string;
}

export function JudgeButton({ of, testId, ...rest }: JudgeProps) {
  const key = keyMap.value[of][0];
  return (
    <span data-testid={testId}>
      <Button {...rest} title={commandName(of) + hint(of)}>
        {commandName(of)} {key && <kbd>{showChord(key)}</kbd>}
      </Button>
    </span>
  );
}

export function Reject({ rejection, busy }: { rejection: Rejection; busy: boolean }) {
  const box = useRef<HTMLDivElement>(null);
  // not the field: a digit would be written into it
  useEffect(() => box.current?.focus(), []);
  const reason = rejection.reason.value;
  return (
    <div class="stack stack--tight" data-testid="review-reasons" ref={box} tabIndex={-1}>
      <h3>{say("review-reject-why")}</h3>
      <div class="stack stack--dense reject__reasons">
        {rejection.reasons.map((key, i) => {
          const words = say(key);
          const chord = keyMap.value[`reviewReason${i + 1}` as ActionId][0];
          return (
            <Button
              key={key}
              small
              pressed={reason === words}
              onClick={() => {
                rejection.reason.value = words;
                box.current?.focus();
              }}
            >
              {chord && <kbd>{showChord(chord)}</kbd>} {words}
            </Button>
          );
        })}
      </div>
      <label class="stack stack--dense field">
        <span class="field__label">{say("review-reject-words")}</span>
        <textarea
          class="input"
          rows={2}
          value={reason}
          onInput={(event) => {
            rejection.reason.value = event.currentTarget.value;
          }}
          onKeyDown={(event) => {
            if (event.key === "Escape") rejection.cancel();
            if (event.key === "Enter" && !event.shiftKey) {
              event.preventDefault();
              rejection.confirm();
            }
          }}
        />
      </label>
      <div class="row">
        <span class="grow" data-testid="review-send-rejection">
          <Button kind="primary" busy={busy} disabled={!reason.trim()} onClick={() => rejection.confirm()}>
            {commandName("reviewReject")}
          </Button>
        </span>
        <Button says="action-cancel" onClick={() => rejection.cancel()} />
      </div>
    </div>
  );
}
