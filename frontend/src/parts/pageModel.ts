import { useEffect, useMemo } from "preact/hooks";

interface Model {
  load(): Promise<void>;
  close(): void;
}

/** The model of a page, made anew where it is of another thing: loaded when it is shown, closed when it is left. */
export function usePageModel<M extends Model>(make: () => M, of: readonly unknown[]): M {
  const model = useMemo(make, of);
  useEffect(() => {
    void model.load();
    return () => model.close();
  }, [model]);
  return model;
}
