import { afterEach, describe, expect, it, vi } from "vitest";
import { api } from "./api";
import { enter, loadSession, me } from "./session";
import type { Me } from "./types";

const ADA = { person: { id: 1, name: "Ada Byron", role: "admin" } } as Me;

afterEach(() => {
  me.value = undefined;
});

describe("who is signed in", () => {
  it("is not forgotten by an answer from before the sign-in", async () => {
    let answer: (response: Response) => void = () => {};
    vi.stubGlobal("fetch", () => new Promise<Response>((resolve) => (answer = resolve)));
    const asked = loadSession();
    me.value = ADA; // the one-time link was quicker
    const error = { kind: "not_signed_in", code: "x", values: {}, message: "Sign in." };
    answer(new Response(JSON.stringify({ error }), { status: 401 }));
    await asked;
    expect(me.value).toBe(ADA);
  });

  it("is nobody where the server says so", async () => {
    const error = { kind: "not_signed_in", code: "x", values: {}, message: "Sign in." };
    vi.stubGlobal("fetch", async () => new Response(JSON.stringify({ error }), { status: 401 }));
    await loadSession();
    expect(me.value).toBeNull();
  });
});

describe("who signs in on a page that was somebody else's", () => {
  const BEN = { person: { id: 2, name: "Ben", role: "viewer" } } as Me;

  /** The server says that nobody is signed in, as where the session ended by itself. */
  async function ended(): Promise<void> {
    const error = { kind: "not_signed_in", code: "x", values: {}, message: "Sign in." };
    vi.stubGlobal("fetch", async () => new Response(JSON.stringify({ error }), { status: 401 }));
    await api.ask("GET /surveys").catch(() => {});
  }

  it("loads it anew: it may hold what they may not see", async () => {
    const loaded = vi.spyOn(location, "replace").mockImplementation(() => {});
    me.value = ADA;
    await ended();
    enter(BEN, "/surveys/1");
    expect(loaded).toHaveBeenCalledWith("/surveys/1");
    expect(me.value).toBeNull();
  });

  it("goes on in it where they are the same", async () => {
    const loaded = vi.spyOn(location, "replace").mockImplementation(() => {});
    me.value = ADA;
    await ended();
    enter(ADA, "/surveys/1");
    expect(loaded).not.toHaveBeenCalled();
    expect([me.value, location.pathname]).toEqual([ADA, "/surveys/1"]);
  });
});
