import { afterEach, describe, expect, it, vi } from "vitest";
import {
  ACTIONS,
  type ActionId,
  addCommands,
  chordOf,
  conflicts,
  mergeKeys,
  overrides,
  reservedReason,
  showChord,
} from "./commands";

const press = (init: KeyboardEventInit & { key: string }, target: EventTarget = document.body) => {
  const event = new KeyboardEvent("keydown", { bubbles: true, cancelable: true, ...init });
  target.dispatchEvent(event);
  return event;
};

let off: (() => void)[] = [];
type Runs = Partial<Record<ActionId, (down: boolean) => unknown>>;
const listen = (runs: () => Runs, held: readonly ActionId[] = []) => {
  const stop = addCommands(() =>
    (Object.keys(runs()) as ActionId[]).map((id) => ({
      id,
      held: held.includes(id),
      run: (down) => runs()[id]?.(down) !== false,
    })),
  );
  off.push(stop);
  return stop;
};

afterEach(() => {
  for (const stop of off) stop();
  off = [];
  overrides.value = {};
  document.body.innerHTML = "";
});

it("lets J and K only step: what joins or splits passes on one page is no step on another", () => {
  const own = (Object.keys(ACTIONS) as ActionId[]).filter((id) =>
    ACTIONS[id].keys.some((key) => key === "J" || key === "K"),
  );
  expect(own).toEqual(["reviewNext", "reviewPrevious"]);
});

describe("chords", () => {
  const mods = { ctrlKey: false, metaKey: false, altKey: false, shiftKey: false };

  it.each([
    [{ key: "z", ctrlKey: true }, "Ctrl+Z"],
    [{ key: "Z", ctrlKey: true, shiftKey: true }, "Ctrl+Shift+Z"],
    [{ key: "z", metaKey: true }, "Ctrl+Z"],
    [{ key: "?", shiftKey: true }, "?"],
    [{ key: "ArrowLeft", shiftKey: true }, "Shift+ArrowLeft"],
    [{ key: " " }, "Space"],
    [{ key: "+", shiftKey: true }, "+"],
  ])("%j is %s", (keys, chord) => {
    expect(chordOf({ ...mods, ...keys })).toBe(chord);
  });

  it("shows arrows and names as keycaps do", () => {
    expect(showChord("Shift+ArrowLeft")).toBe("Shift ←");
    expect(showChord("+")).toBe("+");
    expect(showChord("PageDown")).toBe("PgDn");
  });
});

describe("the usual keys", () => {
  it("do not clash", () => {
    expect(conflicts(mergeKeys({}))).toEqual([]);
  });

  it("leave the browser its own keys", () => {
    for (const action of Object.values(ACTIONS))
      for (const key of action.keys) expect(reservedReason(key)).toBeNull();
    expect(reservedReason("Ctrl+W")).toMatch(/browser/);
  });

  it("warn when a change makes two actions answer to one key", () => {
    const found = conflicts(mergeKeys({ passNext: ["F"] }));
    expect(found).toEqual([{ chord: "F", actions: ["frameNext", "passNext"] }]);
  });
});

describe("dispatch", () => {
  it("runs the action and keeps the key from the page", () => {
    const next = vi.fn();
    listen(() => ({ frameNext: next }));
    expect(press({ key: "f" }).defaultPrevented).toBe(true);
    expect(next).toHaveBeenCalledTimes(1);
  });

  it("asks the newest layer first, and the next one when it declines", () => {
    const calls: string[] = [];
    listen(() => ({ cancel: () => void calls.push("old") }));
    listen(() => ({
      cancel: () => {
        calls.push("new");
        return false;
      },
    }));
    press({ key: "Escape" });
    expect(calls).toEqual(["new", "old"]);
  });

  it("moves a selected point with the arrows before it moves the frame", () => {
    const calls: string[] = [];
    let selected = true;
    listen(() => ({
      frameNext: () => void calls.push("frame"),
      nudgeRight: () => (selected ? void calls.push("point") : false),
    }));
    press({ key: "ArrowRight" });
    selected = false;
    press({ key: "ArrowRight" });
    expect(calls).toEqual(["point", "frame"]);
  });

  it("leaves letters to a text field", () => {
    const next = vi.fn();
    listen(() => ({ frameNext: next }));
    document.body.innerHTML = "<input>";
    press({ key: "f" }, document.querySelector("input") as HTMLInputElement);
    expect(next).not.toHaveBeenCalled();
  });

  it("leaves a list that was chosen from with the pointer, not one that the arrows go through", () => {
    document.body.innerHTML = "<select><option>Day</option></select>";
    const list = document.querySelector("select") as HTMLSelectElement;
    const change = () => list.dispatchEvent(new Event("change", { bubbles: true }));
    list.focus();
    press({ key: "ArrowDown" }, list);
    change();
    expect(document.activeElement).toBe(list);
    list.dispatchEvent(new Event("pointerdown", { bubbles: true }));
    change();
    expect(document.activeElement).not.toBe(list);
  });

  it("leaves Space to a focused button", () => {
    const play = vi.fn();
    listen(() => ({ play }));
    document.body.innerHTML = "<button></button>";
    press({ key: " " }, document.querySelector("button") as HTMLButtonElement);
    expect(play).not.toHaveBeenCalled();
    press({ key: " " });
    expect(play).toHaveBeenCalledTimes(1);
  });

  it("tells a held key of down once and of up", () => {
    const calls: boolean[] = [];
    listen(() => ({ loupe: (down) => void calls.push(down) }), ["loupe"]);
    press({ key: "z" });
    press({ key: "z", repeat: true });
    document.body.dispatchEvent(new KeyboardEvent("keyup", { key: "z", bubbles: true }));
    expect(calls).toEqual([true, false]);
  });

  it("follows a changed key at once", () => {
    const next = vi.fn();
    listen(() => ({ frameNext: next }));
    overrides.value = { frameNext: ["W"] };
    press({ key: "f" });
    expect(next).not.toHaveBeenCalled();
    press({ key: "w" });
    expect(next).toHaveBeenCalledTimes(1);
  });

  it("is silent while a dialog is open", () => {
    const next = vi.fn();
    listen(() => ({ frameNext: next }));
    document.body.innerHTML = "<dialog open></dialog>";
    press({ key: "f" });
    expect(next).not.toHaveBeenCalled();
  });
});
