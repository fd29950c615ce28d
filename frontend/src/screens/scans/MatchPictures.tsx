/** Both strips of one vehicle, the second resampled by the fitted motion: what fits vanishes in the difference. */
import { useEffect, useState } from "preact/hooks";
import { choices, Panel, Segments } from "../../components";
import { say, wordsOf } from "../../core/messages";
import type { ScanVehicleDetail } from "../../core/types";

const SHOWN = wordsOf("scan-match-", "first", "second", "blink", "difference");
type Shown = keyof typeof SHOWN;
const BLINK_MS = 450;
const ALTS = wordsOf("scan-match-alt-", "first", "second", "difference");

export function MatchPictures({ detail }: { detail: ScanVehicleDetail }) {
  const [shown, setShown] = useState<Shown>("difference");
  const [odd, setOdd] = useState(false);
  const match = detail.match;
  useEffect(() => {
    if (shown !== "blink") return;
    const timer = setInterval(() => setOdd((now) => !now), BLINK_MS);
    return () => clearInterval(timer);
  }, [shown]);
  if (!match) return null;
  const urls = { first: match.first_url, second: match.second_url, difference: match.difference_url };
  const picture = shown === "blink" ? (odd ? "second" : "first") : shown;
  return (
    <Panel
      says="scan-match-title"
      within
      aside={<Segments says="scan-match-picture" value={shown} options={choices(SHOWN)} onInput={setShown} />}
    >
      <div class="scan__match-box">
        {(["first", "second", "difference"] as const).map((one) => (
          <img key={one} src={urls[one]} hidden={one !== picture} alt={ALTS[one]} />
        ))}
      </div>
      <p class="panel__note small muted">{say("scan-match-note")}</p>
    </Panel>
  );
}
