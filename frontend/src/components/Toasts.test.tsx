import { render } from "preact";
import { afterEach, describe, expect, it, vi } from "vitest";
import { toast, toasts } from "../core/toasts";
import { Toasts } from "./Toasts";

afterEach(() => {
  toasts.value = [];
  render(null, document.body);
});

describe("toasts", () => {
  it("stand in one live region, news and problems alike", async () => {
    render(<Toasts />, document.body);
    toast("Saved.");
    toast("This was not done.", { kind: "problem" });
    await vi.waitFor(() => expect(document.querySelectorAll(".toast").length).toBe(2));
    expect(document.querySelectorAll("[role=status], [role=alert], [aria-live]").length).toBe(1);
  });
});
