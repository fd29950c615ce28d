/** Parts whose code comes when they are first shown. */
import { signal } from "@preact/signals";
import type { ComponentType } from "preact";
import { useEffect } from "preact/hooks";
import { Problem } from "./Feedback";

export function late<P extends object>(load: () => Promise<ComponentType<P>>): ComponentType<P> {
  const here = signal<ComponentType<P> | null>(null);
  const problem = signal<unknown>(null);
  const fetch = async (): Promise<void> => {
    try {
      here.value = await load();
      problem.value = null;
    } catch (error) {
      problem.value = error;
    }
  };
  return function Late(props: P) {
    const Part = here.value;
    useEffect(() => {
      if (!here.value) void fetch();
    }, []);
    return Part ? <Part {...props} /> : <Problem error={problem.value} again={() => void fetch()} />;
  };
}
