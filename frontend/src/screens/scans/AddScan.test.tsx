import { render } from "preact";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { FakeServer } from "../../../testing/server";
import { startUpload } from "../../parts/uploads/uploads";
import { AddScan } from "./AddScan";

vi.mock("../../parts/uploads/uploads", () => ({ uploads: { value: [] }, startUpload: vi.fn() }));

const strip = (id: number, filename: string) => ({ id, filename, size_bytes: 1000 });
const list = vi.fn(() => [strip(1, "a.png"), strip(2, "b.png"), strip(3, "c.png")]);

const box = (label: string): HTMLSelectElement => {
  const found = [...document.querySelectorAll("label")].find((one) => one.textContent?.startsWith(label));
  return document.getElementById(found?.htmlFor ?? "") as HTMLSelectElement;
};

async function choose(label: string, value: string): Promise<void> {
  await vi.waitFor(() => expect([...box(label).options].map((one) => one.value)).toContain(value));
  box(label).value = value;
  box(label).dispatchEvent(new Event("change", { bubbles: true }));
}

/** Drops a file and answers what the upload calls when it is there. */
function drop(): () => void {
  const input = document.querySelector<HTMLInputElement>("input[type=file]");
  Object.defineProperty(input, "files", { value: [new File(["x"], "c.png")], configurable: true });
  input?.dispatchEvent(new Event("change", { bubbles: true }));
  return vi.mocked(startUpload).mock.calls.at(-1)?.[2] as () => void;
}

beforeEach(() => {
  list.mockClear();
  new FakeServer().on("GET", /^\/surveys\/5\/strip-uploads$/, list);
  render(<AddScan surveyId={5} added={async () => {}} />, document.body);
});

afterEach(() => {
  render(null, document.body);
  vi.unstubAllGlobals();
});

describe("strips that arrive", () => {
  it("are chosen by name where nothing was chosen", async () => {
    await vi.waitFor(() => expect(box("Camera 1")).toBeInstanceOf(HTMLSelectElement));
    drop()();
    await vi.waitFor(() => expect([box("Camera 1").value, box("Camera 2").value]).toEqual(["1", "2"]));
  });

  it("leave what was chosen while they were on their way", async () => {
    const arrived = drop();
    await choose("Camera 1", "3");
    await choose("Time runs", "height");
    list.mockClear();
    arrived();
    await vi.waitFor(() => expect(list).toHaveBeenCalledTimes(2));
    await new Promise((done) => setTimeout(done));
    expect([box("Camera 1").value, box("Camera 2").value, box("Time runs").value]).toEqual([
      "3",
      "",
      "height",
    ]);
  });

  it("keep the time axis that was chosen while they were on their way", async () => {
    const arrived = drop();
    await choose("Time runs", "height");
    arrived();
    await vi.waitFor(() => expect(box("Camera 2").value).toBe("2"));
    expect(box("Time runs").value).toBe("height");
  });
});
