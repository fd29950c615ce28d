import { effect, type Signal, signal } from "@preact/signals";

/** A signal kept in this browser's local storage; a value that cannot be read or is not allowed falls back. */
export function stored<T>(key: string, fallback: T, allowed?: (value: T) => boolean): Signal<T> {
  const name = `sightline.${key}`;
  const kept = signal(read(name, fallback, allowed));
  let first = true;
  effect(() => {
    const value = kept.value;
    if (first) {
      first = false;
      return;
    }
    try {
      localStorage.setItem(name, JSON.stringify(value));
    } catch {
      // private mode or a full store: the setting lasts until the page is closed
    }
  });
  return kept;
}

function read<T>(name: string, fallback: T, allowed?: (value: T) => boolean): T {
  try {
    const text = localStorage.getItem(name);
    if (text === null) return fallback;
    const value = JSON.parse(text) as T;
    return allowed && !allowed(value) ? fallback : value;
  } catch {
    return fallback;
  }
}
