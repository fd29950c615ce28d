import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import {
  ApiError,
  address,
  api,
  connection,
  explain,
  onSignedOut,
  PATIENCE_MS,
  toApiError,
  tryAgainNow,
} from "./api";
import { changeSave, saveState } from "./save";

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
    await expect(api.write("POST /surveys", {}, { body: { name: "A" } })).resolves.toEqual({ id: 1 });
    const [path, init] = server.mock.calls[0] ?? [];
    expect(path).toBe("/api/surveys");
    expect(init?.method).toBe("POST");
    expect(init?.headers).toMatchObject({ "X-Sightline": "1", "Content-Type": "application/json" });
    expect(init?.body).toBe('{"name":"A"}');
  });

  it("send a file as form data and leave the boundary to the browser", async () => {
    server.mockResolvedValue(answer(200, {}));
    await api.write("POST /cameras/{camera_id}/images", { camera_id: 1 }, { body: new File(["x"], "a.jpg") });
    const init = server.mock.calls[0]?.[1];
    expect(init?.body).toBeInstanceOf(FormData);
    expect((init as { body: FormData }).body.get("file")).toBeInstanceOf(File);
    expect(init?.headers).not.toHaveProperty("Content-Type");
  });

  it("give undefined for 204", async () => {
    server.mockResolvedValue(answer(204, null));
    await expect(api.write("DELETE /uploads/{upload_id}", { upload_id: 1 })).resolves.toBeUndefined();
  });
});

describe("the two verbs", () => {
  beforeEach(() => changeSave(() => ({ pending: 0, waiting: 0, savedAt: null, failed: false })));

  it("a question never says saved, even when it is a POST", async () => {
    let answered: (answer: Response) => void = () => {};
    server.mockReturnValueOnce(new Promise((done) => (answered = done)));
    const at = { line: 4, row_px: 2 };
    const body = { target: "roof", contact_line: at.line, contact_row_px: at.row_px } as const;
    const asked = api.ask("POST /scans/{scan_id}/line-height", { scan_id: 3 }, { body });
    expect(saveState.value.pending).toBe(0);
    answered(answer(200, {}));
    await asked;
    server.mockResolvedValueOnce(answer(422, null));
    await api.ask("POST /audit/verify").catch(() => {});
    expect(saveState.value).toEqual({ pending: 0, waiting: 0, savedAt: null, failed: false });
  });

  it("what is written does", async () => {
    server.mockResolvedValue(answer(201, { id: 1 }));
    const done = api.write("POST /surveys", {}, { body: { name: "A" } });
    expect(saveState.value.pending).toBe(1);
    await done;
    expect(saveState.value).toMatchObject({ pending: 0, failed: false });
    expect(saveState.value.savedAt).toBeInstanceOf(Date);
  });

  it("fill the path and put the rest into the query", () => {
    const params = { survey_id: 5, state: "all", after: undefined, eye: [1, 2], q: "a b/&" };
    expect(address("/surveys/{survey_id}/x", params)).toBe("/surveys/5/x?state=all&eye=1&eye=2&q=a+b%2F%26");
    expect(address("/jobs", {})).toBe("/jobs");
  });
});

describe("errors", () => {
  it("carry the server's sentence, code, status and body", async () => {
    const body = {
      error: { kind: "conflict", code: "x", values: {}, message: "Ada changed this a minute ago." },
      current: { id: 7 },
    };
    server.mockResolvedValue(answer(409, body));
    const error = await api
      .write("PUT /vehicles/{vehicle_id}", { vehicle_id: 7 }, { body: { version: 1 } })
      .catch((e: unknown) => e);
    expect(error).toBeInstanceOf(ApiError);
    expect(error).toMatchObject({
      status: 409,
      said: { code: "x", values: {} },
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
      answer(401, { error: { kind: "not_signed_in", code: "x", values: {}, message: "Sign in." } }),
    );
    await api.ask("GET /session", {}, { allowSignedOut: true }).catch(() => {});
    expect(told).not.toHaveBeenCalled();
    await api.ask("GET /surveys").catch(() => {});
    expect(told).toHaveBeenCalledTimes(1);
    stop();
  });
});

describe("a lost connection", () => {
  it("keeps a repeatable write, says so, and sends it when the server is back", async () => {
    server.mockRejectedValueOnce(new TypeError("failed to fetch"));
    const done = api.write(
      "PUT /vehicles/{vehicle_id}",
      { vehicle_id: 1 },
      { body: { version: 3, make: "Saab" } },
    );
    await vi.waitFor(() => expect(connection.value.lost).toBe(true));
    expect(saveState.value).toMatchObject({ pending: 1, waiting: 1 });
    server.mockResolvedValueOnce(answer(200, { ok: true }));
    tryAgainNow();
    await expect(done).resolves.toEqual({ ok: true });
    expect(connection.value.lost).toBe(false);
    expect(saveState.value).toMatchObject({ pending: 0, waiting: 0, failed: false });
    expect(server.mock.calls[1]?.[1]?.body).toBe('{"version":3,"make":"Saab"}');
  });

  it("names what the server says is away, and forgets it when nothing answers", async () => {
    const code = "database-no-answer";
    const said = { kind: "database_away", code, values: {}, message: "The database does not answer." };
    server.mockResolvedValueOnce(answer(503, { error: said }));
    const done = api.ask("GET /surveys");
    await vi.waitFor(() => expect(connection.value.lost).toBe(true));
    expect(explain(connection.value.away)).toMatch(/^The database does not answer/);
    server.mockResolvedValueOnce(new Response("Bad gateway", { status: 502 }));
    tryAgainNow();
    await vi.waitFor(() => expect(connection.value).toMatchObject({ lost: true, away: null }));
    server.mockResolvedValueOnce(answer(200, []));
    tryAgainNow();
    await expect(done).resolves.toEqual([]);
  });

  it("does not send a POST that stores nothing again unless that is wished, and says so in words", async () => {
    server.mockRejectedValueOnce(new TypeError("failed to fetch"));
    const error = await api.ask("POST /audit/verify").catch((e: unknown) => e);
    expect(error).toMatchObject({ status: 0, said: { code: "problem-unreachable" } });
    expect(server).toHaveBeenCalledTimes(1);
  });

  const keyOf = (call: number) => new Headers(server.mock.calls[call]?.[1]?.headers).get("Idempotency-Key");

  it("sends every write again with its key, by which the server knows it", async () => {
    server.mockRejectedValueOnce(new TypeError("failed to fetch"));
    const done = api.write("POST /surveys", {}, { body: { name: "A" } });
    await vi.waitFor(() => expect(connection.value.lost).toBe(true));
    server.mockImplementation(async () => answer(201, { id: 1 }));
    tryAgainNow();
    await expect(done).resolves.toEqual({ id: 1 });
    expect(keyOf(0)).toMatch(/^[0-9a-f-]{36}$/);
    expect(keyOf(1)).toBe(keyOf(0));
    await api.write("POST /surveys", {}, { body: { name: "A" } });
    expect(keyOf(2)).not.toBe(keyOf(0));
  });

  it("takes the key that is given; a question has none", async () => {
    server.mockImplementation(async () => answer(200, { id: 1 }));
    await api.write("POST /surveys", {}, { body: { name: "A" }, idempotencyKey: "mine" });
    await api.ask("GET /surveys");
    expect([keyOf(0), keyOf(1)]).toEqual(["mine", null]);
  });

  it("treats a proxy without its server as a lost connection", async () => {
    server.mockResolvedValueOnce(answer(502, null));
    const done = api.ask("GET /surveys");
    await vi.waitFor(() => expect(connection.value.lost).toBe(true));
    server.mockResolvedValueOnce(answer(200, []));
    tryAgainNow();
    await expect(done).resolves.toEqual([]);
  });

  it.each([
    ["a network's sign-in page in place of the answer", () => new Response("<html>Sign in</html>")],
    [
      "an answer that breaks off",
      () => Object.assign(answer(200, {}), { text: () => Promise.reject(new TypeError()) }),
    ],
  ])("is what %s is taken for", async (_what, broken) => {
    server.mockImplementationOnce(async () => broken());
    const done = api.ask("GET /surveys");
    await vi.waitFor(() => expect(connection.value.lost).toBe(true));
    server.mockResolvedValueOnce(answer(200, []));
    tryAgainNow();
    await expect(done).resolves.toEqual([]);
  });

  it("is what no answer within three minutes is taken for", async () => {
    vi.useFakeTimers();
    server.mockImplementationOnce(
      (_url, init) =>
        new Promise((_, reject) =>
          init?.signal?.addEventListener("abort", () => reject(init.signal?.reason)),
        ),
    );
    const done = api.ask("GET /surveys");
    await vi.advanceTimersByTimeAsync(PATIENCE_MS - 1);
    expect(connection.value.lost).toBe(false);
    server.mockResolvedValueOnce(answer(200, []));
    await vi.advanceTimersByTimeAsync(1);
    expect(connection.value.lost).toBe(true);
    tryAgainNow();
    await expect(done).resolves.toEqual([]);
    vi.useRealTimers();
  });

  it("says that an answer that is none cannot be read, where the question may not be repeated", async () => {
    server.mockResolvedValueOnce(new Response("<html>Sign in</html>"));
    const error = await api.ask("POST /audit/verify").catch((e: unknown) => e);
    expect(error).toMatchObject({ said: { code: "problem-unreadable" } });
  });

  it("sends a write whose answer is none again, for its key tells what became of it", async () => {
    server.mockResolvedValueOnce(new Response("<html>Sign in</html>"));
    const done = api.write("POST /surveys", {}, { body: { name: "A" } });
    await vi.waitFor(() => expect(connection.value.lost).toBe(true));
    server.mockResolvedValueOnce(answer(201, { id: 1 }));
    tryAgainNow();
    await expect(done).resolves.toEqual({ id: 1 });
    expect(keyOf(1)).toBe(keyOf(0));
  });

  it("lets go of a request that is not wanted any more", async () => {
    server.mockRejectedValueOnce(new TypeError("failed to fetch"));
    const stop = new AbortController();
    const done = api.ask("GET /surveys", {}, { signal: stop.signal });
    await vi.waitFor(() => expect(connection.value.lost).toBe(true));
    stop.abort();
    await expect(done).rejects.toMatchObject({ name: "AbortError" });
    expect(connection.value.lost).toBe(false);
  });
});
