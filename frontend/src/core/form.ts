import type { Signal } from "@preact/signals";
import { useState } from "preact/hooks";

/** `<TextField label=... {...field("name")} />`: what stands in a field, and what is done with what is typed there. */
export function fieldsOf<T extends object>(values: T, change: (part: Partial<T>) => void) {
  return <K extends keyof T>(name: K) => ({
    value: values[name],
    onInput: (value: T[K]) => change({ [name]: value } as unknown as Partial<T>),
  });
}

/** What a form does when it is sent: the page stays. */
export function sent(send: () => unknown) {
  return (event: Event): void => {
    event.preventDefault();
    void send();
  };
}

/** The same for a value that stands in a signal. */
export function held<T>(signal: Signal<T>) {
  const onInput = (value: T) => {
    signal.value = value;
  };
  return { value: signal.value, onInput };
}

export function useForm<T extends object>(first: T | (() => T)) {
  const [values, setValues] = useState<T>(first);
  const change = (part: Partial<T>) => setValues((now) => ({ ...now, ...part }));
  return { values, change, field: fieldsOf(values, change) };
}
