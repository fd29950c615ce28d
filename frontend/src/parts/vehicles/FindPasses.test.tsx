import { render } from "preact";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { me } from "../../core/session";
import type { Job, Me } from "../../core/types";
import { FindPasses } from "./FindPasses";

const failed = {
  id: 4,
  kind: "passes",
  state: "failed",
  error: {
    code: "said",
    values: { sentence: "The video ends after 3 frames; upload it again." },
    message: "The video ends after 3 frames; upload it again.",
  },
};

beforeEach(() => {
  me.value = { person: { id: 1, name: "Ada", role: "operator" } } as Me;
  vi.stubGlobal("fetch", async () => new Response(JSON.stringify(failed)));
});

afterEach(() => {
  render(null, document.body);
  me.value = undefined;
  vi.unstubAllGlobals();
});

it("says why a search failed, in the words of the search", async () => {
  const job = { ...failed, state: "running", error: null } as Job;
  const recording = { id: 3, name: "day.mp4", state: "ready" as const, job };
  render(<FindPasses recording={recording} found={() => {}} />, document.body);
  await vi.waitFor(() => expect(document.body.textContent).toContain(failed.error.message));
});
