import { useEffect, useState } from "preact/hooks";
import { Panel, Problem, TextField } from "../../components";
import { api } from "../../core/api";
import { useForm } from "../../core/form";
import { say, sentenceOf } from "../../core/messages";
import { lengthText, lengthUnit, parseLength, parseNumber } from "../../core/units";
import type { SampleSize } from "./model";

const PAUSE_MS = 300;

/** How many vehicles a percentile's interval of a wanted width takes. */
export function SamplePlan({ sdM }: { sdM: number | null }) {
  const unit = lengthUnit.value;
  const shown = (metres: number) => lengthText(metres, unit, 3);
  const form = useForm({ percent: "10", width: shown(0.02), sd: shown(sdM ?? 0.08) });
  const { percent, width, sd } = form.values;
  const [found, setFound] = useState<SampleSize | null>(null);
  const [error, setError] = useState<unknown>(null);
  useEffect(() => {
    form.change({ width: shown(0.02), sd: shown(sdM ?? 0.08) });
  }, [unit]);
  const asked = [parseNumber(percent), parseLength(width), parseLength(sd)] as const;
  const complete = asked.every((value) => value !== null);
  useEffect(() => {
    const [percent, width_m, sd_m] = asked;
    if (percent === null || width_m === null || sd_m === null) return;
    const stop = new AbortController();
    const timer = setTimeout(() => {
      const own = { signal: stop.signal };
      api.ask("GET /statistics/sample-size", { percent, width_m, sd_m }, own).then(
        (answer) => {
          setFound(answer);
          setError(null);
        },
        (reason) => {
          if (!stop.signal.aborted) setError(reason);
        },
      );
    }, PAUSE_MS);
    return () => {
      clearTimeout(timer);
      stop.abort();
    };
  }, asked);
  return (
    <Panel says="statistics-plan-title" class="stat-noprint">
      <form class="stat-plan" onSubmit={(event) => event.preventDefault()}>
        <TextField says="statistics-plan-percentile" numeric {...form.field("percent")} />
        <TextField says="statistics-plan-width" unit={unit} {...form.field("width")} />
        <TextField says="statistics-plan-sd" unit={unit} {...form.field("sd")} />
        <p class="stat-plan__answer" data-testid="sample-size" role="status">
          {!complete ? say("statistics-plan-incomplete") : error ? "" : sentenceOf(found?.words)}
        </p>
      </form>
      {complete && <Problem error={error} />}
    </Panel>
  );
}
