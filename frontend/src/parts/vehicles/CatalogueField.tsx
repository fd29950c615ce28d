/** Make or model, completed from the catalogue: type a few letters, arrows and Enter take a row with its dimensions. */
import { useContext, useId, useMemo, useRef, useState } from "preact/hooks";
import { Field } from "../../components";
import { TypingHold, useTyping } from "../../components/typing";
import { api } from "../../core/api";
import { Latest } from "../../core/latest";
import { say } from "../../core/messages";
import type { CatalogueRow } from "../../core/types";
import { formatLength } from "../../core/units";
import { yearsOf } from "./ModelYears";
import "./vehicle.css";

interface CatalogueFieldProps {
  label: string;
  value: string;
  /** What to look for when this is typed. */
  query(text: string): string;
  disabled?: boolean;
  onChoose(row: CatalogueRow): void;
  onCommit(text: string): void;
}

export function CatalogueField(props: CatalogueFieldProps) {
  const typing = useTyping(props.value);
  const { text } = typing;
  const hold = useContext(TypingHold);
  const [rows, setRows] = useState<readonly CatalogueRow[] | null>(null);
  const [active, setActive] = useState(-1);
  const searching = useRef(false);
  const input = useRef<HTMLInputElement>(null);
  const listId = useId();
  const asker = useMemo(
    () =>
      new Latest<string, CatalogueRow[]>(
        (q) => api.ask("GET /catalogue", { q }),
        (found) => {
          if (!searching.current) return;
          setRows(found);
          setActive(-1);
        },
      ),
    [],
  );

  const close = (): void => {
    searching.current = false;
    asker.cancel();
    setRows(null);
    setActive(-1);
  };
  /** The next key is a command again, and not one more letter. */
  const leave = (): void => input.current?.blur();
  const choose = (row: CatalogueRow): void => {
    close();
    typing.undo();
    props.onChoose(row);
    leave();
  };
  const commit = (): void => {
    close();
    const changed = typing.finish();
    if (changed !== null) props.onCommit(changed);
    hold?.end();
  };
  const search = (typed: string): void => {
    searching.current = true;
    const q = props.query(typed).trim();
    if (q.length > 0) asker.want(q);
    else setRows(null);
  };
  const turn = (by: 1 | -1): boolean => {
    const count = rows?.length ?? 0;
    if (count > 0) setActive((active + by + count) % count);
    return count > 0;
  };
  const chosen = rows?.[active];
  const keys: Record<string, () => unknown> = {
    ArrowDown: () => (rows ? turn(1) : search(text)),
    ArrowUp: () => turn(-1),
    Enter: () => (chosen ? choose(chosen) : leave()),
    Escape: () => {
      close();
      typing.undo();
      leave();
    },
  };
  const onKeyDown = (event: KeyboardEvent): void => {
    // Ctrl+Enter belongs to the page: it goes on to the next vehicle
    if (event.key === "Enter" && event.ctrlKey) return;
    const act = keys[event.key];
    if (!act || act() === false) return;
    event.preventDefault();
    event.stopPropagation();
  };
  const open = rows !== null && rows.length > 0;
  return (
    <div class="combo">
      <Field label={props.label}>
        {(wiring) => (
          <input
            {...wiring}
            ref={input}
            class="input"
            role="combobox"
            aria-expanded={open}
            aria-controls={listId}
            aria-autocomplete="list"
            aria-activedescendant={active >= 0 ? `${listId}-${active}` : undefined}
            autoComplete="off"
            value={text}
            disabled={props.disabled}
            onInput={(event) => {
              typing.type(event.currentTarget.value);
              search(event.currentTarget.value);
            }}
            onKeyDown={onKeyDown}
            onBlur={commit}
          />
        )}
      </Field>
      <div
        class="combo__list"
        id={listId}
        role="listbox"
        aria-label={say("catalogue-list", { field: props.label })}
        hidden={!open}
      >
        {rows?.map((row, i) => (
          // biome-ignore lint/a11y/useKeyWithClickEvents: the input above holds the focus and its keys
          // biome-ignore lint/a11y/useFocusableInteractive: aria-activedescendant points here
          <div
            key={row.id}
            id={`${listId}-${i}`}
            role="option"
            class="combo__row"
            aria-selected={i === active}
            onPointerDown={(event) => event.preventDefault()}
            onClick={() => choose(row)}
          >
            <span class="clip">
              <strong>{row.make}</strong> {row.model} <span class="muted">{yearsOf(row)}</span>
            </span>
            <span class="nowrap">{formatLength(row.height_m)}</span>
          </div>
        ))}
      </div>
    </div>
  );
}
