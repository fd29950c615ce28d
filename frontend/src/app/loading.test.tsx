import { readFileSync } from "node:fs";
import { render } from "preact";
import { afterEach, describe, expect, it, vi } from "vitest";
import { match, PLACES } from "../core/places";
import { Screen } from "./Screen";
import { loadScreen, roomOf } from "./screens";

vi.mock("../screens/camera/CameraScreen", () => ({ default: () => <p>the camera</p> }));

afterEach(() => render(null, document.body));

describe("a screen's code", () => {
  it("is shown too when it comes after the page was drawn and before its effects have run", async () => {
    const here = match("/surveys/5/camera");
    const coming = loadScreen("camera");
    if (here) render(<Screen here={here} />, document.body);
    await coming;
    await vi.waitFor(() => expect(document.body.textContent).toBe("the camera"));
  });

  it("comes with the words of the folder that it is in", () => {
    const text = readFileSync(`${import.meta.dirname}/screens.ts`, "utf8");
    const folders = [...text.matchAll(/"?([\w-]+)"?: \(\) => import\("\.\.\/screens\/(\w+)\//g)].map((m) => [
      m[1],
      m[2],
    ]);
    expect(Object.fromEntries(folders)).toEqual(
      Object.fromEntries(PLACES.map(({ name }) => [name, roomOf(name)])),
    );
  });
});
