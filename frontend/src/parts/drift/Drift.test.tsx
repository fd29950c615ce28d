import { render } from "preact";
import { afterEach, expect, it, vi } from "vitest";
import { FakeServer } from "../../../testing/server";
import { DriftVerdict } from "./Drift";

afterEach(() => {
  render(null, document.body);
  vi.unstubAllGlobals();
});

it("says that it cannot be told whether the camera moved, and not nothing", async () => {
  new FakeServer().on("GET", /\/recordings\/1\/drift$/, () => {
    throw 400;
  });
  render(<DriftVerdict recordingId={1} poseId={3} />, document.body);
  await vi.waitFor(() => expect(document.body.textContent).toContain("(status 400)"));
});
