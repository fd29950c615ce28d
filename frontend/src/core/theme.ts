import { computed, effect, signal } from "@preact/signals";
import { stored } from "./stored";

export type ThemeChoice = "system" | "light" | "dark";

export const themeChoice = stored<ThemeChoice>("theme", "system", (v) =>
  ["system", "light", "dark"].includes(v),
);

const query = window.matchMedia?.("(prefers-color-scheme: dark)");
const systemDark = signal(query?.matches ?? false);
query?.addEventListener?.("change", (event) => {
  systemDark.value = event.matches;
});

export const theme = computed<"light" | "dark">(() =>
  themeChoice.value === "system" ? (systemDark.value ? "dark" : "light") : themeChoice.value,
);

effect(() => {
  document.documentElement.dataset["theme"] = theme.value;
});
