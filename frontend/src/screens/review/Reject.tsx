/** A rejection needs a reason that the operator can act on: a digit chooses one, Enter gives it; or in one's own words. */
import { useEffect, useRef } from "preact/hooks";
import { Button } from "../../components";
import type { ButtonProps } from "../../components/Button";
import { type ActionId, commandName, hint, keyMap, showChord } from "../../core/commands";
import { say } from "../../core/messages";
import type { ReviewModel } from "./model";
import { REASONS } from "./reasons";

interface JudgeProps extends Pick<ButtonProps, "kind" | "icon" | "disabled" | "onClick"> {
  of: ActionId;
  testId: string;
}

/** The button of a verdict, with its key on it. */
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

export function RejectButton({ model }: { model: ReviewModel }) {
  return (
    <JudgeButton
      of="reviewReject"
      testId="review-reject"
      icon="close"
      disabled={!model.mayReject}
      onClick={() => model.startReject()}
    />
  );
}

export function Reject({ model }: { model: ReviewModel }) {
  const box = useRef<HTMLElement>(null);
  // not the field: a digit would be written into it
  useEffect(() => box.current?.focus(), []);
  const reason = model.reason.value;
  const send = (): void => {
    if (reason.trim()) void model.judge("rejected", reason.trim());
  };
  return (
    <footer class="review__verdict" data-testid="review-reasons" ref={box} tabIndex={-1}>
      <h3>{say("review-reject-why")}</h3>
      <div class="review__reasons">
        {REASONS.map((key, i) => {
          const words = say(key);
          const chord = keyMap.value[`reviewReason${i + 1}` as ActionId][0];
          return (
            <Button
              key={key}
              small
              pressed={reason === words}
              onClick={() => {
                model.reason.value = words;
                box.current?.focus();
              }}
            >
              {chord && <kbd>{showChord(chord)}</kbd>} {words}
            </Button>
          );
        })}
      </div>
      <label class="field">
        <span class="field__label">{say("review-reject-words")}</span>
        <textarea
          class="input"
          rows={2}
          value={reason}
          onInput={(event) => {
            model.reason.value = event.currentTarget.value;
          }}
          onKeyDown={(event) => {
            if (event.key === "Escape") model.cancel();
            if (event.key === "Enter" && !event.shiftKey) {
              event.preventDefault();
              send();
            }
          }}
        />
      </label>
      <div class="row">
        <span class="grow" data-testid="review-send-rejection">
          <Button kind="primary" busy={model.busy.value} disabled={!reason.trim()} onClick={send}>
            {commandName("reviewReject")}
          </Button>
        </span>
        <Button says="action-cancel" onClick={() => model.cancel()} />
      </div>
    </footer>
  );
}
