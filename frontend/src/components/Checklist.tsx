import type { ComponentChildren } from "preact";
import { useEffect, useId, useRef } from "preact/hooks";
import { Button } from "./Button";
import { Check } from "./Field";

interface Group {
  /** What its choices are; none for a list of one kind. */
  title?: string;
  options: readonly { value: string; label: string }[];
  chosen: readonly string[];
  onChange(chosen: string[]): void;
}

interface Props {
  label: ComponentChildren;
  /** What is chosen, in a few words, shown while the list is closed. */
  words: string;
  /** What the list is, for those who hear it. */
  help: string;
  groups: readonly Group[];
}

/** Several choices out of lists that open below: nothing chosen stands for all. */
export function Checklist({ label, words, help, groups }: Props) {
  const id = useId();
  const list = useClosing();
  const clear = () => {
    for (const group of groups) if (group.chosen.length > 0) group.onChange([]);
  };
  return (
    <div class="stack stack--dense field">
      <span class="field__label" id={id}>
        {label}
      </span>
      <details class="checklist" ref={list}>
        <summary class="input clip" aria-describedby={id} title={words}>
          {words}
        </summary>
        <fieldset class="stack stack--tight checklist__list">
          <legend class="visually-hidden">{help}</legend>
          {groups.map((group) => (
            <div class="stack stack--dense" key={group.title}>
              {group.title && <p class="field__hint">{group.title}</p>}
              {group.options.map(({ value, label: word }) => (
                <Check
                  key={value}
                  label={word}
                  checked={group.chosen.includes(value)}
                  onInput={(on) =>
                    group.onChange(
                      on ? [...group.chosen, value] : group.chosen.filter((one) => one !== value),
                    )
                  }
                />
              ))}
            </div>
          ))}
          {groups.some((group) => group.chosen.length > 0) && (
            <Button says="checklist-all" small onClick={clear} />
          )}
        </fieldset>
      </details>
    </div>
  );
}

/** Closes an open list by Esc, or by a press beside it, as menus do. */
function useClosing() {
  const list = useRef<HTMLDetailsElement>(null);
  useEffect(() => {
    const details = list.current;
    if (!details) return;
    const close = () => details.removeAttribute("open");
    const pressed = (event: Event) => {
      if (!details.contains(event.target as Node)) close();
    };
    const escaped = (event: KeyboardEvent) => {
      if (event.key !== "Escape" || !details.open) return;
      event.stopPropagation();
      close();
      details.querySelector("summary")?.focus();
    };
    document.addEventListener("pointerdown", pressed);
    details.addEventListener("keydown", escaped);
    return () => {
      document.removeEventListener("pointerdown", pressed);
      details.removeEventListener("keydown", escaped);
    };
  }, []);
  return list;
}
