/** Beside a package: what was added or changed since it was built, as the server counted it. */
import { Remark } from "../../components";
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
    <Remark icon="warning" data-testid="package-outdated">
      {say("export-outdated", { what: allOf(what) })}
    </Remark>
  );
}
