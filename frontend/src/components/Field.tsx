import type { ComponentChildren } from "preact";
import { useId, useRef } from "preact/hooks";
import { localNumber } from "../core/units";
import { Icon } from "./Icon";
import { type Named, nameOf } from "./named";

interface Wiring {
  id: string;
  "aria-describedby": string | undefined;
  "aria-invalid": boolean | undefined;
}

type FieldProps = Named & {
  hint?: ComponentChildren;
  problem?: string | null;
  hideLabel?: boolean;
  children: (wiring: Wiring) => ComponentChildren;
};

/** Label, control, hint and problem, wired together. The control is drawn by the function inside: `{(w) => <input {...w} />}`. */
export function Field({ hint, problem, hideLabel, children, ...name }: FieldProps) {
  const id = useId();
  const described = [hint && `${id}-hint`, problem && `${id}-problem`].filter(Boolean).join(" ");
  return (
    <div class="stack stack--dense field">
      <label class={hideLabel ? "visually-hidden" : "field__label"} for={id}>
        {nameOf(name)}
      </label>
      {children({
        id,
        "aria-describedby": described || undefined,
        "aria-invalid": problem ? true : undefined,
      })}
      {problem && (
        <p class="field__problem" id={`${id}-problem`}>
          <Icon name="warning" size={14} />
          {problem}
        </p>
      )}
      {hint && (
        <p class="field__hint" id={`${id}-hint`}>
          {hint}
        </p>
      )}
    </div>
  );
}

type TextFieldProps = Named & {
  value: string;
  onInput: (value: string) => void;
  hint?: ComponentChildren;
  problem?: string | null;
  hideLabel?: boolean;
  type?: "text" | "email" | "password" | "search";
  /** A figure, as everything with a unit is: right-aligned, decimal keyboard. */
  numeric?: boolean;
  unit?: string;
  placeholder?: string;
  autoComplete?: string;
  required?: boolean;
  disabled?: boolean;
  rows?: number;
  /** What may be meant; anything else can be typed too. */
  suggestions?: readonly string[];
  onChange?: (value: string) => void;
};

export function TextField(props: TextFieldProps) {
  const { says: _says, label: _label, hint, problem, hideLabel, suggestions, ...control } = props;
  return (
    <Field label={nameOf(props)} hint={hint} problem={problem} hideLabel={hideLabel}>
      {(wiring) => (
        <>
          <TextControl {...wiring} {...control} list={suggestions && `${wiring.id}-list`} />
          {suggestions && (
            <datalist id={`${wiring.id}-list`}>
              {suggestions.map((one) => (
                <option key={one} value={one} />
              ))}
            </datalist>
          )}
        </>
      )}
    </Field>
  );
}

interface TextControlProps
  extends Partial<Wiring>,
    Omit<TextFieldProps, keyof Named | "hint" | "problem" | "hideLabel" | "suggestions"> {
  /** The list of what may be meant, by its id. */
  list?: string;
  onBlur?: () => void;
  onKeyDown?: (event: KeyboardEvent & Typed) => void;
}

type Typed = Event & { currentTarget: HTMLInputElement | HTMLTextAreaElement };

/**
 * What is typed into: one line or several, a figure with its unit or words. A figure is shown as the language writes it
 * until someone types; typed back to what was shown, it is the value again with all its digits.
 */
export function TextControl(props: TextControlProps) {
  const {
    rows,
    unit,
    numeric = unit !== undefined,
    type,
    list,
    autoComplete,
    onInput,
    onChange,
    ...rest
  } = props;
  const written = numeric ? localNumber : (text: string) => text;
  const { value } = rest;
  const typing = useRef({ from: value, told: value, shown: written(value) });
  if (value !== typing.current.told) typing.current = { from: value, told: value, shown: written(value) };
  const told = (event: Typed): string => {
    const shown = event.currentTarget.value;
    const { from } = typing.current;
    typing.current = { from, told: shown === written(from) ? from : shown, shown };
    return typing.current.told;
  };
  const own = {
    ...rest,
    value: typing.current.shown,
    class: `input${numeric ? " input--num" : ""}`,
    onInput: (event: Typed) => onInput(told(event)),
    onChange: onChange && ((event: Typed) => onChange(told(event))),
  };
  if (rows) return <textarea {...own} rows={rows} />;
  const input = (
    <input
      {...own}
      placeholder={rest.placeholder && written(rest.placeholder)}
      type={(type ?? "text") as "text"}
      inputMode={numeric ? "decimal" : undefined}
      autoComplete={autoComplete ?? "off"}
      list={list}
    />
  );
  return unit ? (
    <span class="row input-unit">
      {input}
      <span class="muted small">{unit}</span>
    </span>
  ) : (
    input
  );
}

type DateFieldProps = Named & {
  /** "2026-05-03"; empty: none. */
  value: string;
  onChange: (value: string | null) => void;
};

export function DateField({ value, onChange, ...name }: DateFieldProps) {
  return (
    <Field label={nameOf(name)}>
      {(wiring) => (
        <input
          {...wiring}
          class="input"
          type="date"
          value={value}
          onChange={(event) => onChange(event.currentTarget.value || null)}
        />
      )}
    </Field>
  );
}

interface SelectFieldProps<T extends string>
  extends Pick<SelectProps<T>, "value" | "options" | "onInput" | "disabled">,
    Pick<TextFieldProps, "hint" | "problem" | "hideLabel"> {}

export function SelectField<T extends string>(props: Named & SelectFieldProps<T>) {
  const { says: _says, label: _label, hint, problem, hideLabel, ...control } = props;
  return (
    <Field label={nameOf(props)} hint={hint} problem={problem} hideLabel={hideLabel}>
      {(wiring) => <Select {...wiring} {...control} />}
    </Field>
  );
}

interface SelectProps<T> extends Partial<Wiring> {
  class?: string;
  title?: string;
  disabled?: boolean;
  "aria-label"?: string;
  "data-testid"?: string;
  value: T;
  options: readonly { value: T; label: string; disabled?: boolean }[];
  onInput: (value: T) => void;
}

/** One of several, where its name stands elsewhere. */
export function Select<T extends string | number>(props: SelectProps<T>) {
  const { value, options, onInput, class: more, ...rest } = props;
  return (
    <select
      {...rest}
      class={more ? `input ${more}` : "input"}
      value={value}
      onChange={({ currentTarget }) => onInput(options[currentTarget.selectedIndex]?.value ?? value)}
    >
      {options.map((option) => (
        <option key={option.value} value={option.value} disabled={option.disabled}>
          {option.label}
        </option>
      ))}
    </select>
  );
}

type CheckProps = Named & {
  checked: boolean;
  onInput: (on: boolean) => void;
  disabled?: boolean;
  class?: string;
  title?: string;
};

/** Yes or no: a box to tick with its words behind it. */
export function Check({ checked, onInput, disabled, class: shape, title, ...name }: CheckProps) {
  return (
    <label class={`check ${shape ?? ""}`} title={title}>
      <input
        type="checkbox"
        checked={checked}
        disabled={disabled}
        onChange={(event) => onInput(event.currentTarget.checked)}
      />
      {nameOf(name)}
    </label>
  );
}

interface OptionalFieldProps<T extends string> extends Omit<SelectFieldProps<T>, "value" | "onInput"> {
  value: T | null;
  onInput: (value: T | null) => void;
  none: string;
}

export function OptionalField<T extends string>({
  value,
  onInput,
  none,
  options,
  ...rest
}: Named & OptionalFieldProps<T>) {
  return (
    <SelectField<T | "">
      {...rest}
      value={value ?? ""}
      options={[{ value: "", label: none }, ...options]}
      onInput={(chosen) => onInput(chosen || null)}
    />
  );
}

type SegmentsProps<T extends string> = Named<string> & {
  value: T;
  options: readonly { value: T; label: ComponentChildren }[];
  onInput: (value: T) => void;
  disabled?: boolean;
};

/** A few choices side by side, one taken: radio buttons, so arrows and Tab work as everywhere. */
export function Segments<T extends string>(props: SegmentsProps<T>) {
  const { value, options, onInput, disabled } = props;
  const name = useId();
  return (
    <div class="segments" role="radiogroup" aria-label={nameOf(props)}>
      {options.map((option) => (
        <label key={option.value}>
          <input
            type="radio"
            name={name}
            checked={option.value === value}
            disabled={disabled}
            onChange={() => onInput(option.value)}
          />
          {option.label}
        </label>
      ))}
    </div>
  );
}
