/**
 * A field that tells its value when it is left or Enter is pressed, not at every letter. Esc brings the old one back.
 * Enter and Esc leave it, so that the next key is a command again and not one more letter.
 */
import { useContext, useState } from "preact/hooks";
import { Field } from "./index";
import { TypingHold, useTyping } from "./typing";

interface CommitFieldProps {
  label: string;
  value: string;
  numeric?: boolean;
  unit?: string;
  hint?: string;
  disabled?: boolean;
  /** More than one line; then Enter makes a new one. */
  rows?: number;
  /** What is wrong with a text, or null. */
  check?(text: string): string | null;
  onCommit(text: string): void;
}

export function CommitField(props: CommitFieldProps) {
  const typing = useTyping(props.value);
  const hold = useContext(TypingHold);
  const [problem, setProblem] = useState<string | null>(null);
  /** False where what is typed cannot be taken: the field stays as it is. */
  const commit = (): boolean => {
    const wrong = (typing.open() && props.check?.(typing.text.trim())) || null;
    setProblem(wrong);
    if (wrong) return false;
    const text = typing.finish();
    if (text !== null) props.onCommit(text);
    hold?.end();
    return true;
  };
  const onKeyDown = (event: KeyboardEvent & { currentTarget: HTMLElement }): void => {
    if (event.key === "Enter" && !event.ctrlKey && !props.rows && commit()) event.currentTarget.blur();
    if (event.key !== "Escape") return;
    typing.undo();
    setProblem(null);
    event.currentTarget.blur();
  };
  const common = {
    value: typing.text,
    disabled: props.disabled,
    onInput: (event: { currentTarget: { value: string } }) => typing.type(event.currentTarget.value),
    onBlur: commit,
    onKeyDown,
  };
  return (
    <Field label={props.label} problem={problem} hint={props.hint}>
      {(wiring) => {
        if (props.rows) return <textarea {...wiring} {...common} class="input" rows={props.rows} />;
        const input = (
          <input
            {...wiring}
            {...common}
            class={`input${props.numeric ? " input--num" : ""}`}
            inputMode={props.numeric ? "decimal" : undefined}
            autoComplete="off"
          />
        );
        return props.unit ? (
          <span class="input-unit">
            {input}
            <span>{props.unit}</span>
          </span>
        ) : (
          input
        );
      }}
    </Field>
  );
}
