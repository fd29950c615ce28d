import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { History, type Ledger } from "./history";

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

function counter() {
  const stack = new History();
  const log: string[] = [];
  const add = (name: string) =>
    stack.push({ label: name, undo: () => void log.push(`-${name}`), redo: () => void log.push(`+${name}`) });
  return { stack, log, add };
}

describe("History", () => {
  it("takes back and does again in order", async () => {
    const { stack, log, add } = counter();
    add("a");
    add("b");
    await stack.undo();
    await stack.undo();
    await stack.redo();
    expect(log).toEqual(["-b", "-a", "+a"]);
    expect(stack.undoLabel.value).toBe("a");
    expect(stack.redoLabel.value).toBe("b");
  });

  it("forgets what was undone once something new is done", async () => {
    const { stack, add } = counter();
    add("a");
    await stack.undo();
    add("b");
    expect(stack.redoLabel.value).toBeNull();
    await stack.redo();
    expect(stack.undoLabel.value).toBe("b");
  });

  it("lets other work wait for an undo that is under way", async () => {
    const { stack, log } = counter();
    let finish = () => {};
    const slow = new Promise<void>((resolve) => {
      finish = resolve;
    });
    stack.push({ label: "slow", undo: () => slow.then(() => void log.push("-slow")), redo: () => {} });
    const undone = stack.undo();
    const after = stack.inTurn(async () => void log.push("after"));
    finish();
    await Promise.all([undone, after]);
    expect(log).toEqual(["-slow", "after"]);
  });

  it("does nothing on an empty stack", async () => {
    const { stack, log } = counter();
    await stack.undo();
    await stack.redo();
    expect(log).toEqual([]);
  });

  it("runs one step at a time even when asked quickly", async () => {
    const stack = new History();
    const log: string[] = [];
    for (const name of ["a", "b"]) {
      stack.push({
        label: name,
        undo: async () => {
          log.push(`start ${name}`);
          await new Promise((done) => setTimeout(done, 2));
          log.push(`end ${name}`);
        },
        redo: () => {},
      });
    }
    const both = Promise.all([stack.undo(), stack.undo()]);
    await vi.runAllTimersAsync();
    await both;
    expect(log).toEqual(["start b", "end b", "start a", "end a"]);
  });

  it("keeps a step that failed, and says so", async () => {
    const stack = new History();
    stack.push({ label: "a", undo: () => Promise.reject(new Error("changed by AB")), redo() {} });
    await expect(stack.undo()).rejects.toThrow("changed by AB");
    expect(stack.undoLabel.value).toBe("a");
    expect(stack.redoLabel.value).toBeNull();
  });
});

describe("change sets", () => {
  function points() {
    const values = new Map<string, readonly number[] | null>([["roof", [3, 4]]]);
    const ledger: Ledger<string, readonly number[] | null> = {
      read: (key) => values.get(key) ?? null,
      write: (key, value) => void values.set(key, value),
    };
    return { values, ledger, history: new History() };
  }

  it("put back what they touched, last first, and do it again", async () => {
    const { values, ledger, history } = points();
    history.run("roof", (changes) => {
      changes.write(ledger, "roof", [5, 6]);
      changes.write(ledger, "roof", [7, 8]);
      changes.write(ledger, "contact", [1, 1]);
    });
    expect(history.undoLabel.value).toBe("roof");
    await history.undo();
    expect(Object.fromEntries(values)).toEqual({ roof: [3, 4], contact: null });
    await history.redo();
    expect(Object.fromEntries(values)).toEqual({ roof: [7, 8], contact: [1, 1] });
  });

  it("leave no step, and nothing undone to forget, when everything is as before", async () => {
    const { ledger, history } = points();
    history.run("roof", (changes) => void changes.write(ledger, "roof", [5, 6]));
    await history.undo();
    history.run("forth and back", (changes) => {
      changes.write(ledger, "roof", [3.1, 4]);
      changes.write(ledger, "roof", [3.1 - 0.1, 4]);
    });
    expect(history.undoLabel.value).toBeNull();
    expect(history.redoLabel.value).toBe("roof");
  });

  it("are dropped without a trace: a drag that was cancelled", () => {
    const { values, ledger, history } = points();
    const changes = history.begin("move of a point");
    changes.touch(ledger, "roof");
    values.set("roof", [9, 9]);
    changes.drop();
    expect(values.get("roof")).toEqual([3, 4]);
    expect(history.undoLabel.value).toBeNull();
  });

  it("of work that failed are no step", async () => {
    const { ledger, history } = points();
    const failing = history.run("roof", async (changes) => {
      await changes.write(ledger, "roof", [5, 6]);
      throw new Error("offline");
    });
    await expect(failing).rejects.toThrow("offline");
    expect(history.undoLabel.value).toBeNull();
  });
});
