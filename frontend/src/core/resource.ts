import { useCallback, useEffect, useRef, useState } from "preact/hooks";

export interface Resource<T> {
  data: T | null;
  error: unknown;
  loading: boolean;
  reload: () => Promise<void>;
  /** Puts in a newer value that an answer brought, without asking again. */
  set: (value: T) => void;
}

/** Something read from the server, read again when `deps` change. Old data stays while new data is on its way. */
export function useResource<T>(
  read: (signal: AbortSignal) => Promise<T>,
  deps: readonly unknown[],
): Resource<T> {
  const [state, setState] = useState<{ data: T | null; error: unknown; loading: boolean }>({
    data: null,
    error: null,
    loading: true,
  });
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
    setState({ data: null, error: null, loading: true });
    void load();
    return () => stop.current?.abort();
  }, deps);
  return { ...state, reload: load, set: (data) => setState({ data, error: null, loading: false }) };
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
