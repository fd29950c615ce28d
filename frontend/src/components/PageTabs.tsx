import { pathname, query } from "../core/address";
import type { PageTab } from "../core/tabs";

/** Pages that belong together, side by side under their heading. That of the open one leads where one is: what the
 *  page has put into its address since stays. */
export function PageTabs({ label, tabs }: { label: string; tabs: readonly PageTab[] }) {
  const asked = query.value.toString();
  const open = pathname.value + (asked ? `?${asked}` : "");
  return (
    <nav class="page-tabs" aria-label={label}>
      {tabs.map(({ href, word, here }) => (
        <a key={href} href={here ? open : href} aria-current={here ? "page" : undefined}>
          {word}
        </a>
      ))}
    </nav>
  );
}
