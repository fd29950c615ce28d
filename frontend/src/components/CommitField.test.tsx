import { render } from "preact";
import { useState } from "preact/hooks";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { speak } from "../core/messages";
import { CommitField } from "./CommitField";
import { TextField } from "./index";

const told = vi.fn<(text: string) => void>();
const rested = () => new Promise((done) => setTimeout(done, 0));
const box = () => document.querySelector("input") as HTMLInputElement;

async function type(text: string): Promise<void> {
  box().value = text;
  box().dispatchEvent(new Event("input", { bubbles: true }));
  await rested();
}

beforeEach(() => speak("fr"));
afterEach(async () => {
  render(null, document.body);
  told.mockClear();
  await speak("en");
});

it("is the value again with all its digits where it is typed back to what was shown", async () => {
  render(<CommitField label="Hauteur" numeric value="1.62345" onCommit={told} />, document.body);
  await rested();
  expect(box().value).toBe("1,62345");
  await type("1,6");
  await type("1,62345");
  box().dispatchEvent(new Event("blur"));
  expect(told).not.toHaveBeenCalled();
  await type("1,6");
  box().dispatchEvent(new Event("blur"));
  expect(told).toHaveBeenCalledWith("1,6");
});

it("shows the usual again where it is emptied, whether it was in force or not", async () => {
  render(<CommitField label="u" numeric value="17.3" usual="17.3" onCommit={told} />, document.body);
  await rested();
  await type("");
  box().dispatchEvent(new Event("blur"));
  await rested();
  expect(box().value).toBe("17,3");
  expect(told).not.toHaveBeenCalled();
  render(<CommitField label="u" numeric value="20" usual="17.3" onCommit={told} />, document.body);
  await rested();
  await type("");
  box().dispatchEvent(new Event("blur"));
  expect(told).toHaveBeenCalledWith("17.3");
});

it("leaves what is being typed as it is typed", async () => {
  function Form() {
    const [text, setText] = useState("15");
    return <TextField label="Hauteur" numeric value={text} onInput={setText} />;
  }
  render(<Form />, document.body);
  await rested();
  await type("1.5");
  expect(box().value).toBe("1.5");
});
