import { afterEach, expect, it } from "vitest";
import { bringInSight } from "./inSight";

const LIST = '<div id="list"><div id="box"><div><p><b data-row="1"></b></p><p><b data-row="2"></b></p></div>';
const BLOCKS = `<main id="main">${LIST}<div><p><b data-row="3"></b></p></div></div></div></main>`;
const TABLE = `<main id="main"><div id="list"><table><thead><tr><th id="head"></th></tr></thead><tbody id="box">
  <tr data-row="1"></tr><tr data-row="2"></tr><tr data-row="3"></tr></tbody></table></div></main>`;

function at(id: string): HTMLElement {
  const found = document.getElementById(id);
  if (!found) throw new Error(`no ${id}`);
  return found;
}

/** A page whose list is 100 high from 500 on, with three rows of 40 px below what stays. */
function page(body: string, inside: number, stays = 0): (id: number) => [number, number] {
  document.body.innerHTML = body;
  const [main, list] = [at("main"), at("list")];
  for (const [one, top, height, whole] of [
    [main, 0, 450, 800],
    [list, 500, 100, inside],
  ] as const) {
    one.style.overflowY = "auto";
    Object.defineProperties(one, { clientHeight: { value: height }, scrollHeight: { value: whole } });
    one.getBoundingClientRect = () => ({ top, bottom: top + height }) as DOMRect;
  }
  document.querySelectorAll("[data-row]").forEach((row, i) => {
    row.getBoundingClientRect = () => {
      const top = 500 + stays + 40 * i - list.scrollTop;
      return { top, bottom: top + 40 } as DOMRect;
    };
  });
  const head = document.getElementById("head");
  if (head) {
    head.style.position = "sticky";
    head.getBoundingClientRect = () => ({ top: 500, bottom: 500 + stays }) as DOMRect;
  }
  return (id) => {
    bringInSight(at("box"), "data-row", id);
    return [list.scrollTop, main.scrollTop];
  };
}

afterEach(() => {
  document.body.innerHTML = "";
});

it("lets the list begin with a whole row, of whatever block, and never scrolls the page with the picture", () => {
  const show = page(BLOCKS, 120);
  expect(show(2)).toEqual([0, 0]);
  expect(show(3)).toEqual([40, 0]); // 20 would do, and cut the first
  expect(show(1)).toEqual([0, 0]);
});

it("lets a table begin with a whole row below its head", () => {
  const show = page(TABLE, 150, 30);
  expect(show(2)).toEqual([40, 0]); // 10 would do
  expect(show(1)).toEqual([0, 0]);
  expect(show(3)).toEqual([80, 0]);
});

it("leaves the page alone where the list does not scroll", () => {
  expect(page(BLOCKS, 100)(3)).toEqual([0, 0]);
});
