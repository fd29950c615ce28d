/** A page that stands alone and breaks says so, in place of leaving nothing. */
import { beforeEach, expect, it, vi } from "vitest";

const breaks = () => {
  throw new Error("a table without its column");
};
vi.mock("./say", () => ({ say: (key: string) => key }));
vi.mock("./theme", () => ({}));
vi.mock("./opened", () => ({ done: { value: true }, open: async () => {} }));
vi.mock("./Page", () => ({ Page: breaks }));
vi.mock("./evidence/Page", () => ({ Page: breaks }));
vi.mock("./evidence/document", () => ({ held: () => ({}) }));

beforeEach(() => {
  document.body.innerHTML = '<div id="opened"></div>';
});

const said = () => vi.waitFor(() => expect(document.querySelector('[role="alert"]')).not.toBeNull());

it("the page of a package", async () => {
  await import("./main");
  await said();
  expect(document.body.textContent).toBe("opened-broken");
});

it("the page of an evidence file", async () => {
  await import("./evidence/main");
  await said();
  expect(document.body.textContent).toBe("opened-broken");
});
