/**
 * Make or model, completed from the catalogue: type a few letters, Enter takes the row that is marked, at first the best
 * one, with its dimensions. Up from the first row marks none: Enter then keeps what was typed.
 */
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
  /** Where the hand goes by a key. */
  field?: { current: HTMLInputElement | null };
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
  const arrived = useRef<(first: CatalogueRow | undefined) => void>(() => {});
  /** Enter was pressed before the catalogue had answered. */
  const awaited = useRef(false);
  /** What is looked for now: an answer to fewer letters is not taken for its own. */
  const latest = useRef("");
  const own = useRef<HTMLInputElement>(null);
  const input = props.field ?? own;
  const listId = useId();
  const asker = useMemo(
    () =>
      new Latest<string, CatalogueRow[]>(
        (q) => api.ask("GET /catalogue", { q }),
        (found, q) => {
          if (!searching.current || q !== latest.current) return;
          setRows(found);
          setActive(found.length > 0 ? 0 : -1);
          if (awaited.current) arrived.current(found[0]);
        },
        () => awaited.current && arrived.current(undefined),
      ),
    [],
  );

  const close = (): void => {
    searching.current = false;
    awaited.current = false;
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
    // what was found for other letters is not what Enter takes
    setRows(null);
    setActive(-1);
    awaited.current = false;
    latest.current = q;
    if (q.length > 0) asker.want(q);
    else searching.current = false;
  };
  /** Through the rows, and through none of them. */
  const turn = (by: 1 | -1): boolean => {
    const count = rows?.length ?? 0;
    if (count > 0) setActive(((active + 1 + by + count + 1) % (count + 1)) - 1);
    return count > 0;
  };
  arrived.current = (first) => (first ? choose(first) : leave());
  const enter = (): void => {
    if (searching.current && rows === null) awaited.current = true;
    else if (chosen) choose(chosen);
    else leave();
  };
  const chosen = rows?.[active];
  const keys: Record<string, () => unknown> = {
    ArrowDown: () => (rows ? turn(1) : search(text)),
    ArrowUp: () => turn(-1),
    Enter: enter,
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
