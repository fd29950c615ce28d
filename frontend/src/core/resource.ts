import { useCallback, useEffect, useRef, useState } from "preact/hooks";
import { api, type RequestOptions } from "./api";
import { language } from "./messages";
import type { AnswerOf, ParamsOf, Question } from "./routes";

export interface Resource<T> extends State<T> {
  reload: () => Promise<void>;
  /** Puts in a newer value that an answer brought, or changes the value that is there now, without asking again. */
  set: (next: T | ((now: T) => T)) => void;
}

interface Options {
  /** Keep showing what is there while an answer for new `deps` is on its way; otherwise it goes at once. */
  keep?: boolean;
}

interface State<T> {
  data: T | null;
  error: unknown;
  loading: boolean;
}

/** Something read from the server, read again when `deps` change or on `reload`, during which old data stays. Another
 *  language asks again: the answer's sentences come in the language spoken. */
export function useResource<T>(
  read: (signal: AbortSignal) => Promise<T>,
  deps: readonly unknown[],
  { keep = false }: Options = {},
): Resource<T> {
  const [state, setState] = useState<State<T>>({ data: null, error: null, loading: true });
  const latest = useRef(read);
  latest.current = read;
  const stop = useRef<AbortController | null>(null);
  const load = useCallback(async () => {
    stop.current?.abort();
    const own = new AbortController();
    stop.current = own;
    setState((old) => ({ ...old, loading: true }));
    try {
      const data = await latest.current(own.signal);
      if (!own.signal.aborted) setState({ data, error: null, loading: false });
    } catch (error) {
      if (!own.signal.aborted) setState((old) => ({ ...old, error, loading: false }));
    }
  }, []);
  useEffect(() => {
    if (!keep) setState({ data: null, error: null, loading: true });
    void load();
    return () => stop.current?.abort();
  }, [...deps, language.value]);
  const set = useCallback((next: T | ((now: T) => T)) => setState((old) => withNext(old, next)), []);
  return { ...state, reload: load, set };
}

/** The answer to a question, asked again when another thing is asked, or when one of `also` is another; null: nothing is. */
export function useAsked<R extends Question>(
  route: R | null,
  params: ParamsOf<R> = {} as ParamsOf<R>,
  { also = [], ...options }: Options & { also?: readonly unknown[] } = {},
): Resource<AnswerOf<R>> {
  const ask = api.ask as (route: R, params: ParamsOf<R>, how: RequestOptions) => Promise<AnswerOf<R>>;
  return useResource(
    async (signal) => (route === null ? (null as unknown as AnswerOf<R>) : ask(route, params, { signal })),
    [route, JSON.stringify(params), ...also],
    options,
  );
}

function withNext<T>(old: State<T>, next: T | ((now: T) => T)): State<T> {
  if (!(next instanceof Function)) return { data: next, error: null, loading: false };
  return old.data === null ? old : { ...old, data: next(old.data) };
}

/** Runs something regularly while the component is shown; the next run waits for the one before. */
export function useEvery(ms: number | null, run: () => Promise<unknown> | unknown): void {
  const latest = useRef(run);
  latest.current = run;
  useEffect(() => {
    if (ms === null) return;
    let timer: ReturnType<typeof setTimeout>;
    let stopped = false;
    const again = async () => {
      try {
        await latest.current();
      } finally {
        if (!stopped) timer = setTimeout(again, ms);
      }
    };
    timer = setTimeout(again, ms);
    return () => {
      stopped = true;
      clearTimeout(timer);
    };
  }, [ms]);
}
