import { render } from "preact";
import { afterEach, describe, expect, it, vi } from "vitest";
import { speak } from "../core/messages";
import { toast, toasts } from "../core/toasts";
import type { Job } from "../core/types";
import { JobProgress } from "./Feedback";
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

it("a job's progress names the job where nothing else on the page does", async () => {
  const job = { kind: "drift", state: "running", progress: 0, message: null } as unknown as Job;
  const told = () => document.body.querySelector("[role=progressbar]")?.getAttribute("aria-label");
  render(<JobProgress job={job} named />, document.body);
  expect(told()).toBe("Camera stability check");
  const queued = { ...job, state: "queued" } as Job;
  render(<JobProgress job={queued} named />, document.body);
  expect(told()).toBe("Camera stability check: Queued");
  await speak("fr");
  render(<JobProgress key="fr" job={queued} named />, document.body);
  expect(told()).toMatch(/^Contrôle de stabilité de la caméra\u00a0: /);
  await speak("en");
});

it("a job is cancelled where the server says that it may be", () => {
  const buttons = (cancellable: boolean) => {
    const job = { kind: "drift", state: "running", progress: 0, message: null, cancellable };
    render(<JobProgress job={job as unknown as Job} onCancel={() => undefined} />, document.body);
    return document.querySelectorAll("button").length;
  };
  expect([buttons(true), buttons(false)]).toEqual([1, 0]);
});
