import { render } from "preact";
import { afterEach, describe, expect, it, vi } from "vitest";
import { match } from "../core/places";
import { Screen } from "./Screen";

let broken = true;

vi.mock("./screens", () => ({
  loadScreen: async () => {},
  loadedScreen: () => () => {
    if (broken) throw new Error("a panel broke");
    return <p>the page</p>;
  },
}));

const show = (path: string) => {
  const here = match(path);
  if (here) render(<Screen here={here} />, document.body);
};
const text = () => document.body.textContent ?? "";

afterEach(() => render(null, document.body));

describe("a screen that breaks", () => {
  it("says so in one sentence and can be tried again", async () => {
    vi.spyOn(console, "error").mockImplementation(() => {});
    broken = true;
    show("/surveys/5/camera");
    await vi.waitFor(() => expect(text()).toContain("Something went wrong in this page"));
    broken = false;
    [...document.querySelectorAll("button")].find((button) => button.textContent === "Try again")?.click();
    await vi.waitFor(() => expect(text()).toBe("the page"));
  });

  it("does not break the next one", async () => {
    vi.spyOn(console, "error").mockImplementation(() => {});
    broken = true;
    show("/surveys/5/camera");
    await vi.waitFor(() => expect(text()).toContain("Something went wrong"));
    broken = false;
    show("/surveys/5/recordings");
    await vi.waitFor(() => expect(text()).toBe("the page"));
  });
});
