/** Both strips of one vehicle, the second resampled by the fitted motion: what fits vanishes in the difference. */
import { useEffect, useState } from "preact/hooks";
import { Segments } from "../../components";
import type { ScanVehicleDetail } from "../../core/types";

type Shown = "first" | "second" | "blink" | "difference";
const BLINK_MS = 450;

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
    <section class="panel scan__match" aria-labelledby="scan-match">
      <header class="panel__head">
        <h3 id="scan-match">Strip 2 laid over strip 1</h3>
        <Segments
          label="Picture of the match"
          value={shown}
          options={[
            { value: "first", label: "1" },
            { value: "second", label: "2" },
            { value: "blink", label: "blink" },
            { value: "difference", label: "difference" },
          ]}
          onChange={setShown}
        />
      </header>
      <div class="scan__match-box">
        {(["first", "second", "difference"] as const).map((one) => (
          <img
            key={one}
            src={urls[one]}
            hidden={one !== picture}
            alt={
              one === "difference"
                ? "Difference of the two strips; even grey where they agree"
                : `The vehicle on camera ${one === "first" ? 1 : 2}`
            }
          />
        ))}
      </div>
      <p class="small muted">
        Strip 2 is moved by the fitted speed and acceleration. Even grey: the same in both; wheels turn and
        what shines through windows stays behind, so they show.
      </p>
    </section>
  );
}
