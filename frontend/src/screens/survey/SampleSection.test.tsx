import { render } from "preact";
import { afterEach, expect, it } from "vitest";
import { Rate } from "./SampleSection";

afterEach(() => render(null, document.body));

it("a response rate is 100 % of all passes alone", () => {
  render(<Rate rate={0.995} low={0.9725} high={0.9999} />, document.body);
  expect(document.body.textContent).toMatch(/^99\.5\s%97\.3 to 100\.0$/);
});
