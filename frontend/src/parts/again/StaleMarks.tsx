/** Under a height: why it is out of date. */
import { Icon } from "../../components";
import { staleWords } from "./stale";

export function StaleMarks({ measurementId }: { measurementId: number }) {
  return (
    <>
      {staleWords(measurementId).map((words) => (
        <p key={words} class="small row" data-testid="out-of-date-mark">
          <Icon name="warning" size={14} />
          <span class="grow">{words}</span>
        </p>
      ))}
    </>
  );
}
