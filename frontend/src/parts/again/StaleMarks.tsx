/** Under a height: why it is out of date. */
import { Remark } from "../../components";
import { staleWords } from "./stale";

export function StaleMarks({ measurementId }: { measurementId: number }) {
  return (
    <>
      {staleWords(measurementId).map((words) => (
        <Remark key={words} icon="warning" data-testid="out-of-date-mark">
          {words}
        </Remark>
      ))}
    </>
  );
}
