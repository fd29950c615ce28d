import { signal } from "@preact/signals";
import { render } from "preact";
import { useEffect } from "preact/hooks";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { navigate } from "../core/address";
import { say } from "../core/messages";
import { me } from "../core/session";
import { topTools } from "../core/topbar";
import type { Job, Me, Recording, Role, Survey } from "../core/types";
import { INSET_NAMES } from "../core/words";
import { App } from "./App";

type Answer = unknown | (() => Response);
let answers: Record<string, Answer> = {};
const asked: string[] = [];

const person = (role: Role): Me => ({
  person: {
    id: 1,
    name: "Ada Byron",
    email: "ada@example.org",
    role,
    active: true,
    created_at: "2026-11-21T10:00:00Z",
    last_seen_at: null,
    has_password: true,
  },
  version: "0.1.0",
  needs_password: false,
  needs_name: false,
  demo_survey_id: null,
});

const inset = { inset_m: 0, u_inset_m: 0, note: "", code: null };
const survey: Survey = {
  id: 5,
  name: "Rouen south",
  site: "",
  description: "",
  is_demo: false,
  simulated: false,
  open_to_all: false,
  my_role: "manager",
  version: 1,
  created_at: "2026-11-21T10:00:00Z",
  roof_insets: {},
  inset_choices: {},
  place: {
    latitude_deg: null,
    longitude_deg: null,
    road_class: null,
    lane: null,
    travel_direction: null,
    speed_limit_mps: null,
    street_lamps: null,
    time_zone: null,
  },
  traffic: { traffic_side: null, steering_side: null, camera_place: null },
  asked: { daytime: ["roof", "driver_eye"], low_light: ["roof", "taillight"] },
  classes: [],
  sampling: {
    method: "every",
    step: 1,
    start: 1,
    share_percent: 100,
    seed: 1,
    free_flowing_s: null,
    outside_counts: false,
    quotas: [],
  },
  insets: Object.fromEntries(INSET_NAMES.map((name) => [name, inset])) as Survey["insets"],
  counts: {
    recordings: 1,
    vehicles: 4,
    not_visible: 0,
    vehicles_measured: 3,
    measurements: 9,
    to_review: 2,
    accepted: 6,
    rejected: 1,
  },
  steps: [
    {
      key: "camera",
      state: "done",
      summary: [{ code: "overview-calibrated", values: { count: 1 }, message: "" }],
    },
    { key: "recordings", state: "next", summary: [{ code: "overview-drop-video", values: {}, message: "" }] },
  ],
  scans: {
    state: "none",
    summary: [{ code: "overview-no-scans", values: {}, message: "" }],
    scans: 0,
    ready: 0,
    vehicles: 0,
    to_review: 0,
    accepted: 0,
    rejected: 0,
    not_measurable: 0,
    heights: 0,
    heights_to_review: 0,
    heights_accepted: 0,
    heights_rejected: 0,
  },
  since_package: null,
};

const job = (part: Partial<Job>): Job => ({
  id: 1,
  kind: "demonstration",
  state: "running",
  progress: 0.4,
  message: { code: "told", values: {}, message: "drawing daytime.mp4" },
  error: null,
  result: null,
  survey_id: null,
  recording_id: null,
  scan_id: null,
  created_at: "2026-11-21T10:00:00Z",
  finished_at: null,
  cancellable: true,
  ...part,
});

beforeEach(() => {
  answers = {};
  asked.length = 0;
  vi.stubGlobal("fetch", async (path: string, init: RequestInit) => {
    asked.push(`${init.method} ${path}`);
    const known = answers[path.replace("/api", "").replace(/\?.*/, "")];
    if (typeof known === "function") return known();
    const found = known !== undefined;
    const body = found ? known : { error: { code: "not_found", message: `nothing at ${path}` } };
    return new Response(JSON.stringify(body), { status: found ? 200 : 404 });
  });
});

afterEach(() => {
  render(null, document.body);
  me.value = undefined;
  navigate("/");
  vi.unstubAllGlobals();
});

const show = (path: string) => {
  navigate(path);
  render(<App />, document.body);
};
const text = () => document.body.textContent ?? "";
const shown = (words: string) => vi.waitFor(() => expect(text()).toContain(words));

describe("who is not signed in", () => {
  it("is led to the sign-in page, and back afterwards", async () => {
    const refusal = { error: { code: "not_signed_in", message: "Sign in first." } };
    answers["/session"] = () => new Response(JSON.stringify(refusal), { status: 401 });
    show("/surveys/5/camera");
    await shown("No password yet?");
    expect(location.pathname + location.search).toBe("/sign-in?next=%2Fsurveys%2F5%2Fcamera");
  });
});

it("says in one sentence that a part outside the pages broke, and goes on when it is well again", async () => {
  answers = { "/session": person("operator"), "/surveys": [], "/jobs": [] };
  const isBroken = signal(true);
  const Tools = () => {
    useEffect(() => {}, []);
    if (isBroken.value) throw new Error("broken");
    return <p>well again</p>;
  };
  vi.spyOn(console, "error").mockImplementation(() => {});
  topTools.value = <Tools />;
  show("/");
  await shown(say("problem-page"));
  isBroken.value = false;
  document.querySelector("button")?.click();
  await shown("well again");
  await shown("No surveys yet");
  topTools.value = null;
});

describe("the surveys", () => {
  it("tell an operator what to do when there are none", async () => {
    answers = { "/session": person("operator"), "/surveys": [], "/jobs": [] };
    show("/");
    await shown("No surveys yet");
    expect(text()).toContain("New survey");
  });

  it("offer a viewer nothing that a viewer may not do", async () => {
    answers = { "/session": person("viewer"), "/surveys": [], "/jobs": [] };
    show("/");
    await shown("No surveys yet. An operator can create");
    expect(text()).not.toContain("New survey");
  });

  it("show how far each is", async () => {
    answers = { "/session": person("operator"), "/surveys": [survey], "/jobs": [] };
    show("/");
    await shown("Rouen south");
    expect(text()).toContain("3 of 4");
    expect(text()).toContain("7 of 9");
    expect(text()).toContain("Drop the day’s video here.");
  });

  it("stand above those that were never filmed", async () => {
    const drawn = { ...survey, id: 6, name: "Invented road A", simulated: true };
    answers = { "/session": person("operator"), "/surveys": [drawn, survey], "/jobs": [] };
    show("/");
    await shown("Rouen south");
    expect(document.querySelectorAll(".card").length).toBe(1);
    const below = document.querySelector<HTMLDetailsElement>("[data-testid=simulated]");
    expect(below?.open).toBe(false);
    expect(below?.querySelector("a[href='/surveys/6']")?.textContent).toBe("Invented road A");
  });

  it("show the demonstration survey while it is made, also while its job waits", async () => {
    answers = {
      "/session": person("operator"),
      "/surveys": [],
      "/jobs": [job({ state: "queued", message: null })],
    };
    show("/");
    await shown("being created");
    expect(text()).not.toContain("No surveys yet");
  });

  it("say why it could not be made", async () => {
    const failed = job({
      state: "failed",
      error: {
        code: "said",
        values: { sentence: "The disk is full; make room and start again." },
        message: "The disk is full; make room and start again.",
      },
    });
    answers = { "/session": person("operator"), "/surveys": [], "/jobs": [failed] };
    show("/");
    await shown("The disk is full");
  });
});

describe("a recording that failed", () => {
  const recording: Recording = {
    id: 3,
    survey_id: 5,
    name: "bad.mp4",
    state: "failed",
    error: {
      code: "said",
      values: { sentence: "bad.mp4 is a text file, not a video; choose a video file." },
      message: "bad.mp4 is a text file, not a video; choose a video file.",
    },
    job: null,
    sha256: "0936",
    size_bytes: 18,
    width_px: null,
    height_px: null,
    frame_count: null,
    duration_s: null,
    codec: null,
    container: null,
    vfr: false,
    notes: [],
    camera_id: null,
    pose_id: null,
    lighting: null,
    lighting_proposed: null,
    stream_number: null,
    pictures: [],
    clock_doubt: null,
    filmed_hz: null,
    start_proposed: null,
    started_at: null,
    time_zone: null,
    started_local: null,
    weather: null,
    street_lighting: null,
    misfits: [],
    created_at: "2026-11-21T10:00:00Z",
    thumbs: [],
  };

  it("says why, and can be read again", async () => {
    answers = {
      "/session": person("operator"),
      "/surveys/5": survey,
      "/surveys/5/recordings": [recording],
      "/surveys/5/cameras": [],
      "/surveys/5/uploads": [],
      "/recordings/3/ingest": job({ kind: "ingest" }),
    };
    show("/surveys/5/recordings");
    await shown("is a text file, not a video");
    asked.length = 0;
    [...document.querySelectorAll("button")].find((button) => button.textContent === "Import again")?.click();
    await vi.waitFor(() => expect(asked).toContain("POST /api/recordings/3/ingest"));
    await vi.waitFor(() => expect(asked).toContain("GET /api/surveys/5")); // the last that is read again
  });
});

describe("an address that leads nowhere", () => {
  it("says so and leads back", async () => {
    answers = { "/session": person("operator") };
    show("/surveys/0");
    await shown("Page not found");
  });
});

describe("an address made of a page's name", () => {
  it("leads to the page with what it asks, and leaves no step to go back to", async () => {
    answers = { "/session": person("operator"), "/surveys/5": survey };
    const before = history.length;
    show("/surveys/5/results?target=driver_eye");
    await vi.waitFor(() =>
      expect(location.pathname + location.search).toBe("/statistics?survey=5&target=driver_eye"),
    );
    expect(history.length).toBe(before + 1);
    expect(text()).not.toContain("Page not found");
  });
});

describe("going to another page", () => {
  it("announces its title and puts the focus on its heading, but not when the app is loaded", async () => {
    answers = { "/session": person("operator"), "/surveys": [], "/jobs": [] };
    show("/");
    await shown("No surveys yet");
    const announced = () => document.querySelector("[data-testid=arrival]")?.textContent;
    expect(document.activeElement?.tagName).toBe("BODY");
    expect(announced()).toBe("");
    navigate("/account");
    await shown("Account");
    await vi.waitFor(() => expect(document.activeElement?.tagName).toBe("H1"));
    expect(document.activeElement?.textContent).toBe("Account");
    expect(announced()).toBe("Account");
  });
});
