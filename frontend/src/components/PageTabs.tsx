import type { PageTab } from "../core/tabs";

/** Pages that belong together, side by side under their heading; the open one leads nowhere. */
export function PageTabs({ label, tabs }: { label: string; tabs: readonly PageTab[] }) {
  return (
    <nav class="page-tabs" aria-label={label}>
      {tabs.map(({ href, word, here }) =>
        here ? (
          <span key={href} aria-current="page">
            {word}
          </span>
        ) : (
          <a key={href} href={href}>
            {word}
          </a>
        ),
      )}
    </nav>
  );
}
