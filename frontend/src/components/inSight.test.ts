import { afterEach, expect, it, vi } from "vitest";
import { bringInSight } from "./inSight";

const sized = (element: HTMLElement, top: number, height: number, inside: number, scrolls = true) => {
  element.style.overflowY = scrolls ? "auto" : "visible";
  Object.defineProperties(element, {
    clientHeight: { value: height, configurable: true },
    scrollHeight: { value: inside, configurable: true },
  });
  element.getBoundingClientRect = () => ({ top, bottom: top + height }) as DOMRect;
};

function page(): { main: HTMLElement; list: HTMLElement; row: HTMLElement } {
  document.body.innerHTML = '<main id="main"><div id="list"><p><b id="row"></b></p></div></main>';
  const [main, list, row] = ["main", "list", "row"].map((id) => document.getElementById(id) as HTMLElement);
  if (!main || !list || !row) throw new Error("no page");
  sized(main, 0, 450, 800);
  return { main, list, row };
}

afterEach(() => {
  document.body.innerHTML = "";
});

it("scrolls the row's list as far as needed, and never the page with the picture", () => {
  const { main, list, row } = page();
  sized(list, 500, 100, 300);
  sized(row, 640, 30, 30, false);
  bringInSight(row);
  expect([list.scrollTop, main.scrollTop]).toEqual([70, 0]);
});

it("lets the list begin with a whole row", () => {
  const { list, row } = page();
  sized(list, 500, 100, 300);
  sized(row, 640, 30, 30, false);
  const first = document.createElement("b");
  list.prepend(first);
  sized(first, 480, 30, 30, false); // once the row is seen
  vi.spyOn(document, "elementFromPoint").mockReturnValue(first);
  bringInSight(row);
  expect(list.scrollTop).toBe(70 + 10);
});

it("leaves the page alone where the list does not scroll", () => {
  const { main, list, row } = page();
  sized(list, 500, 100, 100);
  sized(row, 640, 30, 30, false);
  bringInSight(row);
  expect([list.scrollTop, main.scrollTop]).toEqual([0, 0]);
});
