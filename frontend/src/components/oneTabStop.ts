import { type ReadonlySignal, useSignalEffect } from "@preact/signals";
import type { RefObject } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { bringInSight } from "./inSight";

/** The box of a list that is one tab stop and keeps its current row in sight: the one whose `name` is the id. */
export function useRowsIn<E extends HTMLElement>(
  rows: string,
  name: string,
  id: ReadonlySignal<number | null>,
) {
  const box = useRef<E>(null);
  useOneTabStop(box, rows);
  useSignalEffect(() => {
    const current = id.value;
    const show = () => requestAnimationFrame(() => bringInSight(box.current, name, current));
    show();
    window.addEventListener("resize", show); // a smaller window has a smaller list
    return () => window.removeEventListener("resize", show);
  });
  return box;
}

/** A list is one tab stop: Tab comes to its current row, the arrows, Home and End go from row to row. */
export function useOneTabStop(box: RefObject<HTMLElement | null>, rows: string): void {
  useEffect(() => {
    const list = box.current;
    if (!list) return;
    const all = () => [...list.querySelectorAll<HTMLElement>(rows)];
    const settle = () => {
      const found = all();
      const focused = found.find((one) => one === document.activeElement);
      const stop = focused ?? found.find(isCurrent) ?? found[0];
      for (const one of found) one.tabIndex = one === stop ? 0 : -1;
    };
    const go = (event: KeyboardEvent) => {
      const found = all();
      const at = found.indexOf(event.target as HTMLElement);
      const to = at < 0 || event.ctrlKey || event.altKey || event.metaKey ? null : STEPS[event.key];
      if (!to) return;
      event.preventDefault();
      event.stopPropagation(); // these keys go through frames elsewhere
      found[Math.min(Math.max(to(at, found.length), 0), found.length - 1)]?.focus();
    };
    const watch = new MutationObserver(settle);
    watch.observe(list, {
      subtree: true,
      childList: true,
      attributeFilter: ["aria-current", "aria-pressed"],
    });
    settle();
    list.addEventListener("keydown", go);
    list.addEventListener("focusin", settle);
    list.addEventListener("focusout", settle);
    return () => {
      watch.disconnect();
      list.removeEventListener("keydown", go);
      list.removeEventListener("focusin", settle);
      list.removeEventListener("focusout", settle);
    };
  }, [rows]);
}

const isCurrent = (one: HTMLElement) =>
  one.getAttribute("aria-current") === "true" || one.getAttribute("aria-pressed") === "true";

const STEPS: Readonly<Record<string, (at: number, count: number) => number>> = {
  ArrowDown: (at) => at + 1,
  ArrowUp: (at) => at - 1,
  Home: () => 0,
  End: (_at, count) => count - 1,
};
