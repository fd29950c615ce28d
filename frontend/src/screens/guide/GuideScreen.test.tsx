import { type Signal, signal } from "@preact/signals";
import { render } from "preact";
import { afterEach, expect, it, vi } from "vitest";
import { navigate } from "../../core/address";
import * as messages from "../../core/messages";
import GuideScreen from "./GuideScreen";

// which language is spoken is set here without its catalogue, so that only the guide's pages are tried
vi.mock("../../core/messages", async (original) => ({
  ...(await original<typeof messages>()),
  language: signal("fr"),
}));
const language = messages.language as Signal<string>;
const text = () => document.querySelector<HTMLElement>(".guide__text");

afterEach(() => {
  render(null, document.body);
  navigate("/");
});

it("shows the page in the language that the app speaks, and goes over to another with it", async () => {
  navigate("/guide?page=operator&section=road");
  language.value = "fr";
  render(<GuideScreen />, document.body);
  await vi.waitFor(() => expect(text()?.lang).toBe("fr"));
  expect(text()?.querySelector("#guide-road")?.textContent).toBe("Route");
  language.value = "en";
  await vi.waitFor(() => expect(text()?.lang).toBe("en"));
  expect(text()?.querySelector("#guide-road")?.textContent).toBe("Road");
});

it("shows a page that is in no other language in English, and says so to those who hear it read", async () => {
  navigate("/guide?page=formats");
  language.value = "fr";
  render(<GuideScreen />, document.body);
  await vi.waitFor(() => expect(text()?.lang).toBe("en"));
  expect(text()?.textContent).toContain("clicks.csv");
});
