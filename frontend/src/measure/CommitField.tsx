/** A one-line field that tells its value when it is left or Enter is pressed, not at every letter. Esc brings the old one back. */
import { useEffect, useState } from "preact/hooks";
import { Field } from "../components";

interface CommitFieldProps {
  label: string;
  value: string;
  numeric?: boolean;
  unit?: string;
  hint?: string;
  disabled?: boolean;
  /** What is wrong with a text, or null. */
  check?(text: string): string | null;
  onCommit(text: string): void;
}

export function CommitField(props: CommitFieldProps) {
  const [text, setText] = useState(props.value);
  const [problem, setProblem] = useState<string | null>(null);
  useEffect(() => {
    setText(props.value);
    setProblem(null);
  }, [props.value]);
  const commit = (): void => {
    const trimmed = text.trim();
    const wrong = props.check?.(trimmed) ?? null;
    setProblem(wrong);
    if (!wrong && trimmed !== props.value) props.onCommit(trimmed);
  };
  return (
    <Field label={props.label} problem={problem} hint={props.hint}>
      {(wiring) => {
        const input = (
          <input
            {...wiring}
            class={`input${props.numeric ? " input--num" : ""}`}
            value={text}
            disabled={props.disabled}
            inputMode={props.numeric ? "decimal" : undefined}
            autoComplete="off"
            onInput={(event) => setText(event.currentTarget.value)}
            onBlur={commit}
            onKeyDown={(event) => {
              if (event.key === "Enter") commit();
              if (event.key === "Escape") {
                setText(props.value);
                setProblem(null);
              }
            }}
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
