import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { ApiError, api } from "./api";
import { type Kind, Outbox, type Wanted } from "./outbox";
import { saveState } from "./save";
import { shapeOf } from "./shape";

interface Note {
  readonly id: number;
  readonly text: string;
}

type NoteKind = Kind<Note, string, null>;

function noteKind(send: NoteKind["send"], more: Partial<NoteKind> = {}): NoteKind {
  return {
    send,
    read: async (_wish, error) => (error.body as { current: Note }).current,
    isSaved: shapeOf<Note>({ id: "number", text: "string" }),
    done: ({ saved, want }) => saved?.text.trim() === want,
    version: (saved) => saved?.id ?? 0,
    words: (saved) => saved?.text ?? "",
    ...more,
  };
}

function note(key: string, want: string, lane = "notes"): Wanted<Note, string, null> {
  return { key, kind: "note", lane, about: null, what: key, mine: want, page: "/", saved: null, want };
}

/** The locks of a browser: a page that is closed leaves its own. */
class Browser {
  private readonly waiting = new Map<string, (() => void)[]>();

  /** The locks as one page sees them, and how it is closed. */
  page(): { locks: Pick<LockManager, "request">; close: () => void } {
    const mine: string[] = [];
    const request = (name: string, ...rest: unknown[]): Promise<unknown> => {
      const take = rest.at(-1) as () => unknown;
      const queue = this.waiting.get(name);
      if (queue) {
        queue.push(take);
        return Promise.resolve();
      }
      this.waiting.set(name, []);
      mine.push(name);
      if (take() === undefined) this.free(name);
      return Promise.resolve();
    };
    const close = (): void => {
      for (const name of mine) this.free(name);
    };
    return { locks: { request } as unknown as Pick<LockManager, "request">, close };
  }

  private free(name: string): void {
    const queue = this.waiting.get(name) ?? [];
    this.waiting.delete(name);
    for (const take of queue) take();
  }
}

const told = () => new Promise((done) => setTimeout(done));

const opened: Outbox[] = [];

beforeEach(() => localStorage.clear());
afterEach(() => {
  for (const box of opened.splice(0)) box.close();
  vi.unstubAllGlobals();
});

describe("what a page kept that is closed", () => {
  function page(browser: Browser, name: string, send: NoteKind["send"]): { box: Outbox; close: () => void } {
    const { locks, close } = browser.page();
    const box = new Outbox(name, () => localStorage, Date.now, locks);
    box.register("note", noteKind(send));
    box.open(1);
    opened.push(box);
    return { box, close };
  }
  const unreachable = () => new Promise<null>(() => {});

  it("is sent at once by a page that is opened then", async () => {
    const browser = new Browser();
    const first = page(browser, "first", unreachable);
    first.box.want(note("a", "one"));
    first.close();
    const sent: string[] = [];
    const { box } = page(browser, "second", async ({ want }) => {
      sent.push(want);
      return { id: 1, text: want };
    });
    expect(box.get("a")?.state).toBe("saving");
    await box.settled("a");
    expect(sent).toEqual(["one"]);
    expect(localStorage.length).toBe(0);
  });

  it("is sent by a page that was open already, and by one of them only", async () => {
    const browser = new Browser();
    const sent: string[] = [];
    const storing: NoteKind["send"] = async ({ want }) => {
      sent.push(want);
      return { id: 1, text: want };
    };
    const others = [page(browser, "second", storing), page(browser, "third", storing)];
    const first = page(browser, "first", unreachable);
    first.box.want(note("a", "one"));
    const key = "sightline.outbox.1.a";
    window.dispatchEvent(new StorageEvent("storage", { key })); // the browser tells the others
    expect(others.map(({ box }) => box.wishes.value.size)).toEqual([0, 0]);
    first.close();
    expect(others.map(({ box }) => box.wishes.value.size)).toEqual([1, 0]);
    await told();
    expect(sent).toEqual(["one"]);
    expect(localStorage.length).toBe(0);
  });

  it("stays with a page that is only slow", async () => {
    const browser = new Browser();
    const { box } = page(browser, "first", unreachable);
    box.want(note("a", "one"));
    expect(page(browser, "second", unreachable).box.wishes.value.size).toBe(0);
  });

  it("goes out in the order in which it was done", async () => {
    const browser = new Browser();
    const first = page(browser, "first", unreachable);
    for (const [key, want] of [
      ["b", "one"],
      ["a", "two"],
      ["c", "three"],
    ] as const)
      first.box.want(note(key, want));
    first.close();
    const sent: string[] = [];
    page(browser, "second", async ({ want }) => {
      sent.push(want);
      return { id: 1, text: want };
    });
    await told();
    expect(sent).toEqual(["one", "two", "three"]);
  });
});

describe("an answer that cannot be understood", () => {
  function box(kind: NoteKind): Outbox {
    const made = new Outbox("a", () => localStorage, Date.now, undefined);
    made.register("note", kind);
    made.open(1);
    opened.push(made);
    return made;
  }
  const good: NoteKind["send"] = async ({ key, want }) =>
    (key === "bad" ? { id: 1 } : { id: 2, text: want }) as Note;

  it("leaves the wish with a reason, and the next one of its lane goes out", async () => {
    const made = box(noteKind(good));
    made.want(note("bad", "one"));
    made.want(note("next", "two"));
    expect(await made.settled("next")).toBeUndefined();
    expect(made.get("bad")).toMatchObject({ state: "failed", saved: null });
    expect(made.get("bad")?.problem).toContain("could not be read");
    expect(localStorage.length).toBe(1);
    made.discard("bad");
    expect(localStorage.length).toBe(0);
  });

  it.each<[string, Partial<NoteKind>]>([
    [
      "when it is compared",
      { done: ({ saved }) => saved?.id === 1 && (saved.text.at(9) as string).length > 0 },
    ],
    ["when its version is read", { version: (saved) => (saved as Note).text.length }],
    ["when it is put into words", { words: (saved) => (saved as Note).text.slice(0) }],
    [
      "when both are put together",
      {
        fits: () => {
          throw new TypeError("no");
        },
      },
    ],
  ])("may fail anywhere: %s", async (_where, more) => {
    vi.spyOn(console, "error").mockImplementation(() => {});
    const conflict = new ApiError("Olga was quicker.", 409, null, { current: { id: 1, text: "hers" } });
    const made = box(
      noteKind(async (wish, signal) => {
        if (wish.key === "bad") throw conflict;
        return good(wish, signal);
      }, more),
    );
    made.want(note("bad", "one"));
    made.want(note("next", "two", "notes"));
    await made.settled("bad");
    await told();
    const bad = made.get("bad");
    expect(["failed", "conflict"]).toContain(bad?.state);
    expect(bad?.problem).toBeTruthy();
    expect(typeof (bad && made.theirs(bad))).toBe("string");
    expect(["failed", undefined]).toContain(made.get("next")?.state);
    made.discard("bad");
    expect(made.get("bad")).toBeUndefined();
  });

  it("is no reason for the outbox to stop where a page cannot show it", async () => {
    vi.spyOn(console, "error").mockImplementation(() => {});
    const made = box(noteKind(good));
    made.listen("note", () => {
      throw new TypeError("Cannot read properties of undefined (reading '0')");
    });
    made.want(note("one", "one"));
    made.want(note("two", "two"));
    expect(await made.settled("two")).toBeUndefined();
    expect(made.wishes.value.size).toBe(0);
  });

  it("kept by an earlier version of the page is asked for again", async () => {
    const old = { ...note("a", "one"), saved: { nested: {} }, order: 1, tab: "a", touched: 0 };
    localStorage.setItem("sightline.outbox.1.a", JSON.stringify(old));
    const seen: unknown[] = [];
    const made = box(
      noteKind(async ({ want, saved }) => {
        seen.push(saved);
        return { id: 1, text: want };
      }),
    );
    await made.settled("a");
    expect(seen).toEqual([null]);
    expect(made.wishes.value.size).toBe(0);
  });
});

describe("what waits for the connection", () => {
  it("can be taken back, and what is behind it goes out", async () => {
    const server = vi.fn<typeof fetch>(async (_url, init) => {
      if (String(init?.body).includes("bad")) throw new TypeError("failed to fetch");
      return new Response(JSON.stringify({ id: 1, text: "two" }));
    });
    vi.stubGlobal("fetch", server);
    const made = new Outbox("a", () => localStorage, Date.now, undefined);
    made.register(
      "note",
      noteKind(async ({ want }, sending) => {
        const body = { name: want };
        return (await api.write("POST /surveys", {}, { body, ...sending })) as unknown as Note;
      }),
    );
    made.open(1);
    made.want(note("bad", "bad"));
    made.want(note("two", "two"));
    await vi.waitFor(() => expect(saveState.value.waiting).toBe(1));
    expect(made.get("two")?.state).toBe("saving");
    made.discard("bad");
    await made.settled("two");
    expect(made.wishes.value.size).toBe(0);
    expect(saveState.value).toMatchObject({ waiting: 0, pending: 0, failed: false });
  });
});

describe("a write that was sent", () => {
  /** What the server was asked for, under which key. */
  interface Sent {
    readonly want: string;
    readonly key: string;
  }
  function box(answer: (sent: Sent) => Promise<Note>): { made: Outbox; sent: Sent[] } {
    const sent: Sent[] = [];
    const made = new Outbox("a", () => localStorage, Date.now, undefined);
    const kind = noteKind(async ({ want }, { idempotencyKey: key }) => {
      sent.push({ want, key });
      return answer({ want, key });
    });
    made.register("note", kind);
    made.open(1);
    opened.push(made);
    return { made, sent };
  }
  const lost = () => new Promise<Note>(() => {});
  const stored = async ({ want }: Sent): Promise<Note> => ({ id: 1, text: want });

  it("is sent again by the next page with the key that it had", async () => {
    const before = box(lost);
    before.made.want(note("a", "one"));
    await vi.waitFor(() => expect(before.sent).toHaveLength(1));
    before.made.close();
    const after = box(stored);
    await after.made.settled("a");
    expect(after.sent).toEqual(before.sent);
    expect(localStorage.length).toBe(0);
  });

  it("is finished before what was wanted meanwhile, which has a key of its own", async () => {
    const before = box(lost);
    before.made.want(note("a", "one"));
    await vi.waitFor(() => expect(before.sent).toHaveLength(1));
    before.made.want(note("a", "two"));
    before.made.close();
    const after = box(stored);
    await after.made.settled("a");
    expect(after.sent.map(({ want }) => want)).toEqual(["one", "two"]);
    expect(after.sent[0]).toEqual(before.sent[0]);
    expect(after.sent[1]?.key).not.toBe(after.sent[0]?.key);
  });

  it.each([
    ["another key once it was refused", 422, 2],
    ["its key as long as nobody has looked", 401, 1],
    ["its key where the server failed", 500, 1],
  ])("has %s", async (_which, status, keys) => {
    const { made, sent } = box(async () => {
      throw new ApiError("No.", status);
    });
    made.want(note("a", "one"));
    await made.settled("a");
    made.send("a");
    await made.settled("a");
    expect(sent).toHaveLength(2);
    expect(new Set(sent.map(({ key }) => key)).size).toBe(keys);
    expect(made.get("a")?.state).toBe("failed");
  });

  it.each(["request-done-before", "request-key-of-another"])(
    "is there where the server says so without its answer (%s)",
    async (code) => {
      const ended: unknown[] = [];
      const current = { id: 7, text: "as it is stored" };
      const { made } = box(lost);
      made.listen("note", ({ state, saved }) => {
        if (state === "saved") ended.push(saved);
      });
      made.register(
        "note",
        noteKind(
          async () => {
            throw new ApiError("Stored.", 409, { code, values: {} }, { current });
          },
          { once: true },
        ),
      );
      made.want(note("a", "one"));
      await made.settled("a");
      expect(ended).toEqual([current]);
      expect(made.wishes.value.size).toBe(0);
    },
  );

  it("is let go of where the server has it and nothing tells what it is", async () => {
    const { made } = box(lost);
    made.register(
      "note",
      noteKind(
        async () => {
          throw new ApiError("Stored.", 409, { code: "request-done-before", values: {} });
        },
        { read: async () => null },
      ),
    );
    made.want(note("a", "one"));
    await made.settled("a");
    expect(made.wishes.value.size).toBe(0);
    expect(localStorage.length).toBe(0);
  });
});
