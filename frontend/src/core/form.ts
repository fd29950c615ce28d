/** What a form holds while it is typed, and what each of its fields is drawn with. */
import { useState } from "preact/hooks";

/** `<TextField label=... {...field("name")} />`: what stands in a field, and what is done with what is typed there. */
export function fieldsOf<T extends object>(values: T, change: (part: Partial<T>) => void) {
  return <K extends keyof T>(name: K) => ({
    value: values[name],
    onInput: (value: T[K]) => change({ [name]: value } as unknown as Partial<T>),
  });
}

export function useForm<T extends object>(first: T | (() => T)) {
  const [values, setValues] = useState<T>(first);
  const change = (part: Partial<T>) => setValues((now) => ({ ...now, ...part }));
  return { values, change, field: fieldsOf(values, change) };
}
