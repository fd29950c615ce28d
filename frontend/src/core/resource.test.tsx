import { render } from "preact";
import { act } from "preact/test-utils";
import { afterEach, describe, expect, it } from "vitest";
import { type Resource, useResource } from "./resource";

/** Answers come only when let go. */
let answers: Map<string, (value: string) => void>;
let seen: Resource<string>;

function Reader({ path, keep }: { path: string; keep?: boolean }) {
  seen = useResource(() => new Promise<string>((resolve) => answers.set(path, resolve)), [path], { keep });
  return null;
}

const show = (path: string, keep?: boolean) =>
  act(() => render(<Reader path={path} keep={keep ?? false} />, document.body));
const letGo = (path: string, value: string) => act(async () => answers.get(path)?.(value));

describe("useResource", () => {
  afterEach(() => render(null, document.body));

  it("drops what was there when something else is read", async () => {
    answers = new Map();
    await show("a");
    await letGo("a", "A");
    expect(seen.data).toBe("A");
    await show("b");
    expect(seen).toMatchObject({ data: null, loading: true });
  });

  it("keeps what was there until the new answer comes, where that is asked for", async () => {
    answers = new Map();
    await show("a", true);
    await letGo("a", "A");
    await show("b", true);
    expect(seen).toMatchObject({ data: "A", loading: true });
    await letGo("a", "too late");
    expect(seen.data).toBe("A");
    await letGo("b", "B");
    expect(seen).toMatchObject({ data: "B", loading: false });
  });

  it("keeps what was there while it is read again", async () => {
    answers = new Map();
    await show("a");
    await letGo("a", "A");
    await act(() => void seen.reload());
    expect(seen).toMatchObject({ data: "A", loading: true });
  });

  it("changes the value that is there now, not the one of an earlier render", async () => {
    answers = new Map();
    await show("a");
    await letGo("a", "A");
    const { set } = seen;
    await act(() => set((now) => `${now}1`));
    await act(() => set((now) => `${now}2`));
    expect(seen.data).toBe("A12");
  });
});
