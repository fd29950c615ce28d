import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { ApiError, api, connection, explain, onSignedOut, toApiError, tryAgainNow } from "./api";
import { saveState } from "./save";

const answer = (status: number, body: unknown) =>
  new Response(status === 204 ? null : JSON.stringify(body), {
    status,
    headers: { "Content-Type": "application/json" },
  });

const server = vi.fn<typeof fetch>();

beforeEach(() => {
  server.mockReset();
  vi.stubGlobal("fetch", server);
});

afterEach(() => {
  tryAgainNow();
  vi.unstubAllGlobals();
});

describe("requests", () => {
  it("carry the header against cross-site requests and JSON", async () => {
    server.mockResolvedValue(answer(200, { id: 1 }));
    await expect(api.post("/surveys", { name: "A" })).resolves.toEqual({ id: 1 });
    const [path, init] = server.mock.calls[0] ?? [];
    expect(path).toBe("/api/surveys");
    expect(init?.method).toBe("POST");
    expect(init?.headers).toMatchObject({ "X-Sightline": "1", "Content-Type": "application/json" });
    expect(init?.body).toBe('{"name":"A"}');
  });

  it("send a file as form data and leave the boundary to the browser", async () => {
    server.mockResolvedValue(answer(200, {}));
    await api.file("/cameras/1/images", new File(["x"], "a.jpg"));
    const init = server.mock.calls[0]?.[1];
    expect(init?.body).toBeInstanceOf(FormData);
    expect((init as { body: FormData }).body.get("file")).toBeInstanceOf(File);
    expect(init?.headers).not.toHaveProperty("Content-Type");
  });

  it("give undefined for 204", async () => {
    server.mockResolvedValue(answer(204, null));
    await expect(api.del("/uploads/1")).resolves.toBeUndefined();
  });
});

describe("errors", () => {
  it("carry the server's sentence, code, status and body", async () => {
    const body = {
      error: { code: "conflict", message: "Ada changed this a minute ago." },
      current: { id: 7 },
    };
    server.mockResolvedValue(answer(409, body));
    const error = await api.put("/vehicles/7", {}).catch((e: unknown) => e);
    expect(error).toBeInstanceOf(ApiError);
    expect(error).toMatchObject({
      status: 409,
      code: "conflict",
      message: "Ada changed this a minute ago.",
      body,
    });
    expect(saveState.value.failed).toBe(true);
  });

  it("are a sentence even when a proxy answers with a page", () => {
    expect(toApiError(500, null).message).toMatch(/status 500/);
    expect(explain(toApiError(418, null))).toMatch(/status 418/);
  });

  it("never show a programming error to people", () => {
    const log = vi.spyOn(console, "error").mockImplementation(() => {});
    expect(explain(new TypeError("x is undefined"))).not.toMatch(/undefined/);
    expect(log).toHaveBeenCalled();
  });

  it("tell that nobody is signed in, unless the caller wants to know itself", async () => {
    const told = vi.fn();
    const stop = onSignedOut(told);
    server.mockImplementation(async () =>
      answer(401, { error: { code: "not_signed_in", message: "Sign in." } }),
    );
    await api.get("/session", { allowSignedOut: true }).catch(() => {});
    expect(told).not.toHaveBeenCalled();
    await api.get("/surveys").catch(() => {});
    expect(told).toHaveBeenCalledTimes(1);
    stop();
  });
});

describe("a lost connection", () => {
  it("keeps a repeatable write, says so, and sends it when the server is back", async () => {
    server.mockRejectedValueOnce(new TypeError("failed to fetch"));
    const done = api.put("/vehicles/1", { make: "Saab" });
    await vi.waitFor(() => expect(connection.value.lost).toBe(true));
    expect(saveState.value).toMatchObject({ pending: 1, waiting: 1 });
    server.mockResolvedValueOnce(answer(200, { ok: true }));
    tryAgainNow();
    await expect(done).resolves.toEqual({ ok: true });
    expect(connection.value.lost).toBe(false);
    expect(saveState.value).toMatchObject({ pending: 0, waiting: 0, failed: false });
    expect(server.mock.calls[1]?.[1]?.body).toBe('{"make":"Saab"}');
  });

  it("does not send a write twice that may not be, and says so in words", async () => {
    server.mockRejectedValueOnce(new TypeError("failed to fetch"));
    const error = await api.post("/surveys", {}).catch((e: unknown) => e);
    expect(error).toMatchObject({ status: 0, code: "unreachable" });
    expect(server).toHaveBeenCalledTimes(1);
  });

  it("treats a proxy without its server as a lost connection", async () => {
    server.mockResolvedValueOnce(answer(502, null));
    const done = api.get("/surveys");
    await vi.waitFor(() => expect(connection.value.lost).toBe(true));
    server.mockResolvedValueOnce(answer(200, []));
    tryAgainNow();
    await expect(done).resolves.toEqual([]);
  });

  it("lets go of a request that is not wanted any more", async () => {
    server.mockRejectedValueOnce(new TypeError("failed to fetch"));
    const stop = new AbortController();
    const done = api.get("/surveys", { signal: stop.signal });
    await vi.waitFor(() => expect(connection.value.lost).toBe(true));
    stop.abort();
    await expect(done).rejects.toMatchObject({ name: "AbortError" });
    expect(connection.value.lost).toBe(false);
  });
});
