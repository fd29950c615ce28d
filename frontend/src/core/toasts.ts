import { signal } from "@preact/signals";
import { explain } from "./api";

export interface Toast {
  id: number;
  kind: "info" | "problem";
  text: string;
  action?: { label: string; run: () => void };
  /** The newest about the same stands alone. */
  about?: string;
}

export const toasts = signal<Toast[]>([]);
let nextId = 1;

/** Says something in the corner. News goes away by itself, a problem stays until it is dismissed. */
export function toast(text: string, options: Partial<Omit<Toast, "id" | "text">> = {}): void {
  const made: Toast = { id: nextId++, kind: "info", text, ...options };
  const older = (old: Toast): boolean =>
    old.text === text || (made.about !== undefined && old.about === made.about);
  toasts.value = [...toasts.value.filter((old) => !older(old)), made].slice(-4);
  if (made.kind === "info") setTimeout(() => dismiss(made.id), made.action ? 10_000 : 5_000);
}

export function toastProblem(error: unknown): void {
  toast(explain(error), { kind: "problem" });
}

export function telling(work: () => Promise<void>): Promise<void> {
  return work().catch(toastProblem);
}

export function dismiss(id: number): void {
  toasts.value = toasts.value.filter((old) => old.id !== id);
}
