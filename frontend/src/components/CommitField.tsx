/**
 * A field that tells its value when it is left or Enter is pressed, not at every letter. Esc brings the old one back.
 * Enter and Esc leave it, so that the next key is a command again and not one more letter.
 */
import { useContext, useState } from "preact/hooks";
import { lengthProblem, lengthText, lengthUnit, parseLength } from "../core/units";
import { Field, TextControl } from "./index";
import { type Named, nameOf } from "./named";
import { TypingHold, useTyping } from "./typing";

type CommitFieldProps = Named & {
  value: string;
  /** What it is where it is emptied. */
  usual?: string;
  numeric?: boolean;
  unit?: string;
  hint?: string;
  disabled?: boolean;
  /** More than one line; then Enter makes a new one. */
  rows?: number;
  check?(text: string): string | null;
  onCommit(text: string): void;
};

export function CommitField(props: CommitFieldProps) {
  const { unit, numeric, rows, disabled } = props;
  const typing = useTyping(props.value, props.usual);
  const hold = useContext(TypingHold);
  const [problem, setProblem] = useState<string | null>(null);
  /** False where what is typed cannot be taken: the field stays as it is. */
  const commit = (): boolean => {
    const wrong = (typing.open() && props.check?.(typing.told())) || null;
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
  return (
    <Field label={nameOf(props)} problem={problem} hint={props.hint}>
      {(wiring) => (
        <TextControl
          {...{ ...wiring, unit, numeric, rows, disabled }}
          value={typing.text}
          onInput={typing.type}
          onBlur={() => void commit()}
          onKeyDown={onKeyDown}
        />
      )}
    </Field>
  );
}

type LengthFieldProps = Named & {
  metres: number | null;
  digits?: number;
  hint?: string;
  disabled?: boolean;
  /** What is wrong with a text, or null; usually any length will do, and none. */
  check?(text: string): string | null;
  onCommit(metres: number | null): void;
};

export function LengthField({ metres, digits, check, onCommit, ...rest }: LengthFieldProps) {
  return (
    <CommitField
      {...rest}
      value={lengthText(metres, lengthUnit.value, digits)}
      unit={lengthUnit.value}
      check={check ?? ((text) => lengthProblem(text, { empty: true }))}
      onCommit={(text) => onCommit(parseLength(text))}
    />
  );
}
