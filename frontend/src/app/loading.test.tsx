import { render } from "preact";
import { afterEach, describe, expect, it, vi } from "vitest";
import { match } from "../core/places";
import { Screen } from "./Screen";
import { loadScreen } from "./screens";

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
});
