/** Parts whose code comes when they are first shown: `soon` those that a page always shows, after what it is opened for;
 *  `late` those that wait for an action, whose words come with them. */
import { signal } from "@preact/signals";
import type { ComponentType } from "preact";
import { useEffect } from "preact/hooks";
import { learnLate } from "../core/messages";
import { Problem } from "./Feedback";

export function late<P extends object>(load: () => Promise<ComponentType<P>>): ComponentType<P> {
  return soon(async () => (await Promise.all([load(), learnLate()]))[0]);
}

export function soon<P extends object>(load: () => Promise<ComponentType<P>>): ComponentType<P> {
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
