/** The guide opens beside, so that what was begun on a page (a placed contact) is there when it is closed. */
import { render } from "preact";
import { afterEach, describe, expect, it } from "vitest";
import { isOurs, navigate } from "../core/address";
import { match } from "../core/places";
import { TopBar } from "./TopBar";

const ADDRESSES = [
  "/",
  "/surveys/5",
  "/surveys/5/measure",
  "/surveys/5/review",
  "/surveys/5/export",
  "/surveys/5/scan",
  "/statistics",
  "/catalogue",
  "/account",
];
const SOURCES = import.meta.glob(["../**/*.tsx", "!../**/*.test.tsx", "!../screens/guide/*"], {
  query: "?raw",
  import: "default",
  eager: true,
}) as Record<string, string>;
const box = document.createElement("div");
const link = () => box.querySelector<HTMLAnchorElement>('a[href^="/guide"]');

afterEach(() => {
  render(null, box);
  navigate("/");
});

describe.each(ADDRESSES)("the guide from %s", (address) => {
  it("opens in a tab of its own, at what it says of the page", () => {
    navigate(address);
    render(<TopBar />, box);
    const [page] = match(address)?.place.guide.split("#") ?? [];
    expect(page).toBeDefined();
    expect(link()?.getAttribute("href")).toContain(`page=${page}`);
    expect([link()?.target, link()?.rel]).toEqual(["_blank", "noopener"]);
    // the page does not take the click, and stays where it is
    expect(isOurs(link() as HTMLAnchorElement, new MouseEvent("click", { button: 0 }))).toBe(false);
  });
});

it("within the guide its pages follow each other in one tab", () => {
  navigate("/guide?page=operator");
  render(<TopBar />, box);
  expect(link()?.target).toBe("");
});

it("no other page has a link to it that leaves the page", () => {
  const links = Object.entries(SOURCES).flatMap(([file, text]) =>
    [...text.matchAll(/<(?:a|Button)\b[^>]*href=\{?[^>]*(?:guideAddress\(|\/guide)[^>]*>/g)].map((found) => [
      file,
      /\bbeside\b/.test(found[0]) || /target="_blank"/.test(found[0]),
    ]),
  );
  expect(links).toEqual([["./TopBar.tsx", true]]);
});
