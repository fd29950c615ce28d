/** The only door to the server. One error shape, one header against cross-site requests, retries that are never silent. */
import { computed, signal } from "@preact/signals";
import { language, type MessageKey, type Said, say, sayCode, sentence } from "./messages";
import { newKey } from "./random";
import type { AddressOf, AnswerOf, BodyOf, Deed, ParamsOf, Question, Route } from "./routes";
import { changeSave } from "./save";

export class ApiError extends Error {
  /** @param status HTTP status; 0 when the server could not be reached
   *  @param said the sentence's code and values; the message is the same in English
   *  @param body the whole answer, for errors that carry more (a 409 carries `current`) */
  constructor(
    message: string,
    readonly status: number,
    readonly said: Said | null = null,
    readonly body: unknown = null,
  ) {
    super(message);
    this.name = "ApiError";
  }
}

export interface RequestOptions {
  signal?: AbortSignal;
  /** The key by which the server knows a write again: one of its own unless given. */
  idempotencyKey?: string;
  /** Send a question again when the connection breaks: on by default for all but POST. A write bears a key and always is. */
  retry?: boolean;
  /** Do not lead to the sign-in page on 401. */
  allowSignedOut?: boolean;
}

interface Waiting {
  again: () => void;
}

const waiting = signal<Waiting[]>([]);
const nextTryAt = signal<number | null>(null);
/** What the last answer said is away: the database, say; null where there was no answer, or one of a proxy. */
const away = signal<ApiError | null>(null);
let attempt = 0;
let timer: ReturnType<typeof setTimeout> | undefined;

/** The connection as the notice under the top bar shows it. */
export const connection = computed(() => ({
  lost: waiting.value.length > 0,
  waiting: waiting.value.length,
  nextTryAt: nextTryAt.value,
  away: away.value,
}));

/** Sends everything that waits for the connection again, now. */
export function tryAgainNow(): void {
  clearTimeout(timer);
  timer = undefined;
  nextTryAt.value = null;
  const batch = waiting.value;
  waiting.value = [];
  for (const entry of batch) entry.again();
}

window.addEventListener("online", tryAgainNow);

function waitForConnection(abort?: AbortSignal): Promise<void> {
  return new Promise((resolve, reject) => {
    const entry: Waiting = { again: resolve };
    abort?.addEventListener("abort", () => {
      waiting.value = waiting.value.filter((other) => other !== entry);
      reject(abort.reason);
    });
    waiting.value = [...waiting.value, entry];
    if (timer === undefined) {
      const delay = Math.min(15_000, 1_000 * 2 ** Math.min(attempt++, 4));
      nextTryAt.value = Date.now() + delay;
      timer = setTimeout(tryAgainNow, delay);
    }
  });
}

const signedOutListeners = new Set<() => void>();

export function onSignedOut(listener: () => void): () => void {
  signedOutListeners.add(listener);
  return () => signedOutListeners.delete(listener);
}

async function request<T>(
  method: string,
  path: string,
  body: unknown,
  options: RequestOptions,
  write: boolean,
): Promise<T> {
  if (write) changeSave((s) => ({ pending: s.pending + 1, failed: false }));
  try {
    const answer = await send(method, path, body, options, write);
    const value = read<T>(answer, options);
    if (write) changeSave(() => ({ savedAt: new Date() }));
    return value;
  } catch (error) {
    if (write && !options.signal?.aborted) changeSave(() => ({ failed: true }));
    throw error;
  } finally {
    if (write) changeSave((s) => ({ pending: s.pending - 1 }));
  }
}

/** What a proxy in front of a restarting server answers: the same as no connection. */
const SERVER_AWAY = [502, 503, 504];
/** A connection that has brought no answer by then is taken for lost; files may take longer. */
export const PATIENCE_MS = 180_000;

interface Answer {
  readonly status: number;
  readonly ok: boolean;
  readonly body: unknown;
  /** It is whole, and this program's server may have written it: a network's sign-in page answers 200 to everything. */
  readonly readable: boolean;
}

async function send(
  method: string,
  path: string,
  body: unknown,
  options: RequestOptions,
  write: boolean,
): Promise<Answer> {
  const { signal } = options;
  const { idempotencyKey: key = write ? newKey() : null } = options;
  const init: RequestInit = { method, ...contentOf(body, key), signal, credentials: "same-origin" };
  const mayRepeat = key !== null || (options.retry ?? method !== "POST");
  for (;;) {
    const answer = await fetchOnce(path, init, mayRepeat);
    const unable = answer && (SERVER_AWAY.includes(answer.status) || !answer.readable);
    if (answer && !(mayRepeat && unable)) {
      attempt = 0;
      return answer;
    }
    away.value = saidBy(answer);
    if (write) changeSave((s) => ({ waiting: s.waiting + 1 }));
    try {
      await waitForConnection(signal);
    } finally {
      if (write) changeSave((s) => ({ waiting: s.waiting - 1 }));
    }
  }
}

function saidBy(answer: Answer | null): ApiError | null {
  const error = answer && toApiError(answer.status, answer.body);
  return error?.said ? error : null;
}

function contentOf(body: unknown, key: string | null): Pick<RequestInit, "headers" | "body"> {
  const headers: Record<string, string> = {
    Accept: "application/json",
    "Accept-Language": language.value,
    "X-Sightline": "1",
    ...(key === null ? {} : { "Idempotency-Key": key }),
  };
  if (body === undefined) return { headers, body };
  if (body instanceof File) {
    const form = new FormData();
    form.append("file", body, body.name);
    return { headers, body: form };
  }
  headers["Content-Type"] = "application/json";
  return { headers, body: JSON.stringify(body) };
}

/** The whole answer; null where there is no connection and the request may be repeated. */
async function fetchOnce(path: string, init: RequestInit, mayRepeat: boolean): Promise<Answer | null> {
  const patience = patienceOf(init);
  try {
    return await readWhole(await fetch(`/api${path}`, { ...init, signal: patience.signal }));
  } catch (error) {
    if (init.signal?.aborted) throw error;
    if (mayRepeat) return null;
    throw problemOf("problem-unreachable", {}, 0);
  } finally {
    patience.end();
  }
}

/** Ends a request that is not wanted any more, or that takes too long. */
function patienceOf({ signal, body }: RequestInit): { signal: AbortSignal; end: () => void } {
  const late = new AbortController();
  const stop = (): void => late.abort(signal?.reason);
  if (signal?.aborted) stop();
  signal?.addEventListener("abort", stop);
  const timer = body instanceof FormData ? undefined : setTimeout(() => late.abort(), PATIENCE_MS);
  const end = (): void => {
    clearTimeout(timer);
    signal?.removeEventListener("abort", stop);
  };
  return { signal: late.signal, end };
}

async function readWhole(answer: Response): Promise<Answer> {
  const { status, ok } = answer;
  if (status === 204) return { status, ok, body: undefined, readable: true };
  const text = await answer.text();
  try {
    return { status, ok, body: JSON.parse(text), readable: true };
  } catch {
    return { status, ok, body: null, readable: !ok };
  }
}

function read<T>({ status, ok, body, readable }: Answer, options: RequestOptions): T {
  if (ok && readable) return body as T;
  if (ok) throw problemOf("problem-unreadable", {}, status);
  if (status === 401 && !options.allowSignedOut) for (const tell of signedOutListeners) tell();
  throw toApiError(status, body);
}

/** The server's error shape as an ApiError; an answer of another shape (a proxy's page) still gives a sentence. */
export function toApiError(status: number, body: unknown): ApiError {
  const error = (body as { error?: Partial<Said> & { message?: string } } | null)?.error;
  const message =
    typeof error?.message === "string"
      ? error.message
      : say(status >= 500 ? "problem-server" : "problem-refused", { status: String(status) });
  const said = typeof error?.code === "string" ? { code: error.code, values: error.values ?? {} } : null;
  return new ApiError(message, status, said, body);
}

/** An error of this program's own, told like one of the server's. */
export function problemOf(code: MessageKey, values: Said["values"], status: number): ApiError {
  return new ApiError(sentence(code, values), status, { code, values });
}

/** Whether a write is refused because it was stored already, and its answer cannot be had any more. */
export function isStoredAlready(error: ApiError): boolean {
  return error.said?.code === "request-done-before" || error.said?.code === "request-key-of-another";
}

/** One sentence for any error, to show to a person. */
export function explain(error: unknown): string {
  if (error instanceof ApiError) return (error.said && sayCode(error.said)) ?? error.message;
  if (error instanceof Error && error.name === "AbortError") return say("problem-stopped");
  console.error(error);
  return say("problem-page");
}

type Args<R extends Route> = [BodyOf<R>] extends [never]
  ? NothingGiven<R> extends true
    ? [params?: ParamsOf<R>, options?: RequestOptions]
    : [params: ParamsOf<R>, options?: RequestOptions]
  : [params: ParamsOf<R>, options: RequestOptions & { body: BodyOf<R> }];
type NothingGiven<R extends Route> = Record<never, never> extends ParamsOf<R> ? true : false;

function call<R extends Route>(write: boolean, route: R, args: Args<R>): Promise<AnswerOf<R>> {
  const [params, options] = args as [Record<string, unknown>?, (RequestOptions & { body?: unknown })?];
  const [method = "", template = ""] = route.split(" ");
  return request(method, address(template, params ?? {}), options?.body, options ?? {}, write);
}

/** The path with its braces filled; what has no brace goes into the query, unless it is undefined or null. */
export function address(template: string, params: Readonly<Record<string, unknown>>): string {
  const query = new URLSearchParams();
  let path = template;
  for (const [name, value] of Object.entries(params)) {
    if (value === undefined || value === null) continue;
    const filled = path.replace(`{${name}}`, encodeURIComponent(String(value)));
    if (filled === path) for (const item of [value].flat()) query.append(name, String(item));
    path = filled;
  }
  return query.size > 0 ? `${path}?${query}` : path;
}

/** What an address says, as a query: the one place where a value's type is left to the server to check. */
export function fromAddress<R extends Route>(query: AddressOf<R>): ParamsOf<R> {
  return query as ParamsOf<R>;
}

/** The two verbs. A route is written as the server describes it, and so are its parameters, its body and its answer. */
export const api = {
  /** Changes nothing, so that the top bar says nothing of it. */
  ask: <R extends Question>(route: R, ...args: Args<R>) => call(false, route, args),
  /** Stores something: the top bar says "saving", then "saved" or that it failed. */
  write: <R extends Deed>(route: R, ...args: Args<R>) => call(true, route, args),
};
