import { expect, it, vi } from "vitest";
import { startUpload, uploads } from "./uploads";

const seen = vi.hoisted(() => ({ loaded: 0, started: 0 }));
vi.mock("tus-js-client", () => {
  seen.loaded += 1;
  class Upload {
    findPreviousUploads = async () => [];
    start = () => {
      seen.started += 1;
    };
  }
  return { Upload };
});

it("loads what sends files with the first file, not before", async () => {
  expect(seen.loaded).toBe(0);
  await startUpload(5, new File(["abc"], "day.mp4"), () => {});
  expect(seen).toEqual({ loaded: 1, started: 1 });
  expect(uploads.value).toMatchObject([{ name: "day.mp4", state: "sending" }]);
});
