import { describe, expect, it } from "vitest";
import { UndoStack } from "./undo";

function counter() {
  const stack = new UndoStack();
  const log: string[] = [];
  const add = (name: string) =>
    stack.push({
      label: name,
      undo: () => void log.push(`-${name}`),
      redo: () => void log.push(`+${name}`),
    });
  return { stack, log, add };
}

describe("UndoStack", () => {
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
    const stack = new UndoStack();
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
    await Promise.all([stack.undo(), stack.undo()]);
    expect(log).toEqual(["start b", "end b", "start a", "end a"]);
  });

  it("keeps a step that failed, and says so", async () => {
    const stack = new UndoStack();
    stack.push({ label: "a", undo: () => Promise.reject(new Error("changed by AB")), redo() {} });
    await expect(stack.undo()).rejects.toThrow("changed by AB");
    expect(stack.undoLabel.value).toBe("a");
    expect(stack.redoLabel.value).toBeNull();
  });
});
