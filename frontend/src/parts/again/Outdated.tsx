/** Beside a package: what was added or changed since it was built, as the server counted it. */
import { Icon } from "../../components";
import { allOf, say } from "../../core/messages";
import type { Survey } from "../../core/types";

/** Nothing where the package holds all there is, or where there is none. */
export function Outdated({ since }: { since: Survey["since_package"] }) {
  if (!since) return null;
  const { heights, reviews, other } = since;
  const what = [
    heights > 0 && say("export-since-heights", { count: heights }),
    reviews > 0 && say("export-since-reviews", { count: reviews }),
    other > 0 && say("export-since-other", { count: other }),
  ].filter((words): words is string => words !== false);
  if (what.length === 0) return null;
  return (
    <p class="small row" data-testid="package-outdated">
      <Icon name="warning" size={14} />
      <span class="grow">{say("export-outdated", { what: allOf(what) })}</span>
    </p>
  );
}
