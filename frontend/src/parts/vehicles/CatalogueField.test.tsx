import { render } from "preact";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { CommitField } from "../../components/CommitField";
import type { CatalogueRow } from "../../core/types";
import { CatalogueField } from "./CatalogueField";
import { ModelYears, yearsElsewhere } from "./ModelYears";

const row = (facts: Partial<CatalogueRow> = {}): CatalogueRow =>
  ({ id: 1, make: "Haldmann", model: "Corvo", year_from: 2016, year_to: 2020, ...facts }) as CatalogueRow;

beforeEach(() => {
  vi.stubGlobal("fetch", async () => new Response(JSON.stringify([row()])));
});
afterEach(() => {
  render(null, document.body);
  vi.unstubAllGlobals();
});

function input(): HTMLInputElement {
  const found = document.querySelector("input");
  if (!found) throw new Error("no field");
  return found;
}

async function type(text: string): Promise<void> {
  input().focus();
  input().value = text;
  input().dispatchEvent(new InputEvent("input", { bubbles: true }));
  await new Promise((resolve) => setTimeout(resolve));
}

async function press(key: string): Promise<void> {
  input().dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
  await new Promise((resolve) => setTimeout(resolve));
}

describe("a field completed from the catalogue", () => {
  const onChoose = vi.fn();
  const onCommit = vi.fn();
  beforeEach(() => {
    vi.clearAllMocks();
    const field = (
      <CatalogueField
        label="Make"
        value="Old"
        query={(text) => text}
        onChoose={onChoose}
        onCommit={onCommit}
      />
    );
    render(field, document.body);
  });

  it("is left when a row is taken by Enter: the next key is a command, not a letter", async () => {
    await type("hald");
    await vi.waitFor(() => expect(document.querySelector("[role=option]")).not.toBeNull());
    await press("Enter");
    expect(onChoose).toHaveBeenCalledWith(row());
    expect(onCommit).not.toHaveBeenCalled();
    expect(document.activeElement).not.toBe(input());
  });

  it("goes back and is left by Esc, with the list open too", async () => {
    await type("hald");
    await vi.waitFor(() => expect(document.querySelector("[role=option]")).not.toBeNull());
    await press("Escape");
    expect(input().value).toBe("Old");
    expect(document.activeElement).not.toBe(input());
    expect(onCommit).not.toHaveBeenCalled();
  });

  it("keeps what is typed where no row is marked: Up from the first, or none found", async () => {
    await type("Haldman");
    await vi.waitFor(() => expect(document.querySelector("[aria-selected=true]")).not.toBeNull());
    await press("ArrowUp");
    await press("Enter");
    expect(onCommit.mock.calls).toEqual([["Haldman"]]);
    expect(document.activeElement).not.toBe(input());
    vi.stubGlobal("fetch", async () => new Response("[]"));
    await type("Own make");
    await press("Enter");
    await vi.waitFor(() => expect(onCommit.mock.calls).toEqual([["Haldman"], ["Own make"]]));
    expect(onChoose).not.toHaveBeenCalled();
  });

  it("waits with Enter for the row of what is typed, not of fewer letters", async () => {
    const asked: [string, (found: Response) => void][] = [];
    vi.stubGlobal("fetch", (url: string) => new Promise((answer) => asked.push([url, answer])));
    await type("h");
    await type("haldm");
    await press("Enter");
    asked[0]?.[1](new Response(JSON.stringify([row({ id: 2, make: "Hother" })])));
    await vi.waitFor(() => expect(asked).toHaveLength(2));
    expect([onChoose.mock.calls, onCommit.mock.calls]).toEqual([[], []]);
    asked[1]?.[1](new Response(JSON.stringify([row()])));
    await vi.waitFor(() => expect(onChoose.mock.calls).toEqual([[row()]]));
  });
});

describe("a field that tells its value when it is left", () => {
  const onCommit = vi.fn();
  beforeEach(() => {
    vi.clearAllMocks();
    const check = (text: string) => (/^\d*$/.test(text) ? null : "A number.");
    render(<CommitField label="Year" value="2019" check={check} onCommit={onCommit} />, document.body);
  });

  it("is left by Enter and by Esc, which takes nothing and complains of nothing", async () => {
    await type("2020");
    await press("Enter");
    expect(onCommit.mock.calls).toEqual([["2020"]]);
    expect(document.activeElement).not.toBe(input());
    await type("twenty");
    await press("Escape");
    expect(input().value).toBe("2019");
    expect(document.querySelector(".field__problem")).toBeNull();
    expect(onCommit).toHaveBeenCalledOnce();
    expect(document.activeElement).not.toBe(input());
  });

  it("keeps the hand in it where what is typed cannot be taken", async () => {
    await type("twenty");
    await press("Enter");
    expect(document.querySelector(".field__problem")?.textContent).toBe("A number.");
    expect(document.activeElement).toBe(input());
  });
});

describe("the years of a model", () => {
  it("are told where the given one is none of them", async () => {
    render(<ModelYears make="haldmann" model="Corvo" year={2012} />, document.body);
    await vi.waitFor(() => expect(document.body.textContent).toContain("2016–2020"));
  });

  it("are not told where one fits, where an end is open, or where the model is not known", () => {
    expect(yearsElsewhere([row()], "Haldmann", "Corvo", 2016)).toBeNull();
    expect(
      yearsElsewhere([row(), row({ year_from: 2021, year_to: null })], "Haldmann", "Corvo", 2025),
    ).toBeNull();
    expect(yearsElsewhere([row()], "Haldmann", "Corvo Sport", 2012)).toBeNull();
    expect(yearsElsewhere([row({ year_to: null })], "Haldmann", "Corvo", 2012)).toBe("2016–");
  });
});
