/** The list of jobs: what each may have done to it is what the server says. */
import { render } from "preact";
import { afterEach, expect, it, vi } from "vitest";
import { FakeServer } from "../../../testing/server";
import JobsScreen from "./JobsScreen";

afterEach(() => {
  render(null, document.body);
  vi.unstubAllGlobals();
});

it("offers to cancel only what the server says may be cancelled", async () => {
  const created_at = "2026-11-21T10:00:00Z";
  const waiting = { state: "queued", progress: 0, message: null, error: null, survey_id: null, created_at };
  new FakeServer().on("GET", /^\/jobs/, () => [
    { ...waiting, id: 2, kind: "tidy", cancellable: false },
    { ...waiting, id: 1, kind: "ingest", cancellable: true },
  ]);
  render(<JobsScreen />, document.body);
  const buttons = (id: number) => document.querySelectorAll(`[data-testid=job-${id}] button`).length;
  await vi.waitFor(() => expect(buttons(1)).toBe(1));
  expect(buttons(2)).toBe(0);
});
