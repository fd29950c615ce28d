import { signal } from "@preact/signals";
import { render } from "preact";
import { useRef } from "preact/hooks";
import { act } from "preact/test-utils";
import { afterEach, beforeEach, expect, it } from "vitest";
import { useOneTabStop, useRowsIn } from "./oneTabStop";

function List({ current, rows }: { current: number; rows: number }) {
  const box = useRef<HTMLUListElement>(null);
  useOneTabStop(box, "button");
  return (
    <ul ref={box}>
      {Array.from({ length: rows }, (_, n) => (
        <li key={n}>
          <button type="button" aria-current={n === current ? "true" : undefined}>
            {n}
          </button>
        </li>
      ))}
    </ul>
  );
}

const buttons = () => [...document.querySelectorAll("button")];
const stops = () => buttons().flatMap((one, n) => (one.tabIndex === 0 ? [n] : []));
/** Rendered, its effects run, and what the observer of changes was told done. */
const shown = (current: number, rows = 4) =>
  act(async () => render(<List current={current} rows={rows} />, document.body));
const press = (key: string) =>
  document.activeElement?.dispatchEvent(
    new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }),
  );

let heard: string[];
const hear = (event: KeyboardEvent) => heard.push(event.key);

beforeEach(() => {
  heard = [];
  window.addEventListener("keydown", hear);
});
afterEach(() => {
  window.removeEventListener("keydown", hear);
  render(null, document.body);
});

it("is one tab stop, at the current row, which follows it and the rows that come", async () => {
  await shown(2);
  expect(stops()).toEqual([2]);
  await shown(0, 6);
  expect(stops()).toEqual([0]);
  await shown(-1, 3);
  expect(stops()).toEqual([0]);
});

it("goes by arrows, Home and End within its ends, and lets no other command hear them", async () => {
  await shown(1);
  buttons()[1]?.focus();
  const seen: (string | null)[] = [];
  for (const key of ["ArrowDown", "ArrowDown", "ArrowDown", "Home", "ArrowUp", "End"]) {
    press(key);
    seen.push(document.activeElement?.textContent ?? null);
  }
  expect(seen).toEqual(["2", "3", "3", "0", "0", "3"]);
  expect(heard).toEqual([]);
  expect(stops()).toEqual([3]); // leaving and coming back by Tab finds the place
  press("n");
  expect(heard).toEqual(["n"]);
});

const here = signal<number | null>(3);

function Kept() {
  const box = useRowsIn<HTMLUListElement>("li", "data-row", here);
  return (
    <ul ref={box} style={{ overflowY: "auto" }}>
      {[1, 2, 3].map((id) => (
        <li key={id} data-row={id} />
      ))}
    </ul>
  );
}

it("keeps its current row in sight when the window gets smaller", async () => {
  await act(async () => render(<Kept />, document.body));
  const list = document.querySelector("ul");
  if (!list) throw new Error("no list");
  let height = 120;
  Object.defineProperties(list, { clientHeight: { get: () => height }, scrollHeight: { value: 120 } });
  list.getBoundingClientRect = () => ({ top: 0, bottom: height }) as DOMRect;
  list.querySelectorAll("li").forEach((row, i) => {
    const top = () => 40 * i - list.scrollTop;
    row.getBoundingClientRect = () => ({ top: top(), bottom: top() + 40 }) as DOMRect;
  });
  const resized = async () => {
    window.dispatchEvent(new Event("resize"));
    await new Promise(requestAnimationFrame);
    return list.scrollTop;
  };
  expect(await resized()).toBe(0);
  height = 80;
  expect(await resized()).toBe(40);
});
