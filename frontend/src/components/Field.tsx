import type { ComponentChildren } from "preact";
import { useId } from "preact/hooks";
import { Icon } from "./Icon";

interface Wiring {
  id: string;
  "aria-describedby": string | undefined;
  "aria-invalid": boolean | undefined;
}

interface FieldProps {
  label: ComponentChildren;
  hint?: ComponentChildren;
  /** One sentence on what is wrong with what was entered. */
  problem?: string | null;
  hideLabel?: boolean;
  children: (wiring: Wiring) => ComponentChildren;
}

/** Label, control, hint and problem, wired together. The control is drawn by the function inside: `{(w) => <input {...w} />}`. */
export function Field({ label, hint, problem, hideLabel, children }: FieldProps) {
  const id = useId();
  const described = [hint && `${id}-hint`, problem && `${id}-problem`].filter(Boolean).join(" ");
  return (
    <div class="field">
      <label class={hideLabel ? "visually-hidden" : "field__label"} for={id}>
        {label}
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

interface TextFieldProps {
  label: ComponentChildren;
  value: string;
  onInput: (value: string) => void;
  hint?: ComponentChildren;
  problem?: string | null;
  hideLabel?: boolean;
  type?: "text" | "email" | "password" | "search";
  /** A figure: right-aligned, decimal keyboard. */
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
}

function typed(event: Event): string {
  return (event.currentTarget as HTMLInputElement | HTMLTextAreaElement).value;
}

export function TextField(props: TextFieldProps) {
  const { label, hint, problem, hideLabel, value, numeric, unit, rows } = props;
  const common = {
    class: `input${numeric ? " input--num" : ""}`,
    value,
    placeholder: props.placeholder,
    required: props.required,
    disabled: props.disabled,
    onInput: (event: Event) => props.onInput(typed(event)),
    onChange: (event: Event) => props.onChange?.(typed(event)),
  };
  return (
    <Field label={label} hint={hint} problem={problem} hideLabel={hideLabel}>
      {(wiring) => {
        if (rows) return <textarea {...wiring} {...common} rows={rows} />;
        const input = (
          <input
            {...wiring}
            {...common}
            type={(props.type ?? "text") as "text"}
            inputMode={numeric ? "decimal" : undefined}
            autoComplete={props.autoComplete ?? "off"}
            list={props.suggestions && `${wiring.id}-list`}
          />
        );
        if (props.suggestions) {
          return (
            <>
              {input}
              <datalist id={`${wiring.id}-list`}>
                {props.suggestions.map((one) => (
                  <option key={one} value={one} />
                ))}
              </datalist>
            </>
          );
        }
        return unit ? (
          <span class="input-unit">
            {input}
            <span>{unit}</span>
          </span>
        ) : (
          input
        );
      }}
    </Field>
  );
}

interface DateFieldProps {
  label: ComponentChildren;
  /** "2026-05-03"; empty: none. */
  value: string;
  onChange: (value: string | null) => void;
}

export function DateField({ label, value, onChange }: DateFieldProps) {
  return (
    <Field label={label}>
      {(wiring) => (
        <input
          {...wiring}
          class="input"
          type="date"
          value={value}
          onChange={(event) => onChange(typed(event) || null)}
        />
      )}
    </Field>
  );
}

interface SelectFieldProps<T extends string> {
  label: ComponentChildren;
  value: T;
  options: readonly { value: T; label: string; disabled?: boolean }[];
  onInput: (value: T) => void;
  hint?: ComponentChildren;
  problem?: string | null;
  hideLabel?: boolean;
  disabled?: boolean;
}

export function SelectField<T extends string>(props: SelectFieldProps<T>) {
  return (
    <Field label={props.label} hint={props.hint} problem={props.problem} hideLabel={props.hideLabel}>
      {(wiring) => (
        <select
          {...wiring}
          class="input"
          value={props.value}
          disabled={props.disabled}
          onChange={(event) => props.onInput(event.currentTarget.value as T)}
        >
          {props.options.map((option) => (
            <option key={option.value} value={option.value} disabled={option.disabled}>
              {option.label}
            </option>
          ))}
        </select>
      )}
    </Field>
  );
}

interface OptionalFieldProps<T extends string> extends Omit<SelectFieldProps<T>, "value" | "onInput"> {
  value: T | null;
  onInput: (value: T | null) => void;
  /** What it is called to choose none. */
  none: string;
}

export function OptionalField<T extends string>({
  value,
  onInput,
  none,
  options,
  ...rest
}: OptionalFieldProps<T>) {
  return (
    <SelectField<T | "">
      {...rest}
      value={value ?? ""}
      options={[{ value: "", label: none }, ...options]}
      onInput={(chosen) => onInput(chosen || null)}
    />
  );
}

interface SegmentsProps<T extends string> {
  label: string;
  value: T;
  options: readonly { value: T; label: ComponentChildren }[];
  onInput: (value: T) => void;
  disabled?: boolean;
}

/** A few choices side by side, one taken: radio buttons, so arrows and Tab work as everywhere. */
export function Segments<T extends string>({ label, value, options, onInput, disabled }: SegmentsProps<T>) {
  const name = useId();
  return (
    <div class="segments" role="radiogroup" aria-label={label}>
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
