import { afterEach, describe, expect, it, vi } from "vitest";
import { loadSession, me } from "./session";
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
