/** One line on the frame when the camera had moved by then. */
import { api } from "../../../core/api";
import { useResource } from "../../../core/resource";
import type { Drift } from "../../../core/types";
import { fixed, formatSmall } from "../../../core/units";

export function DriftLine(props: { surveyId: number; recordingId: number; frame: number }) {
  const { recordingId, frame } = props;
  const drift = useResource<Drift>(
    (signal) => api.ask("GET /recordings/{recording_id}/drift", { recording_id: recordingId }, { signal }),
    [recordingId],
  ).data;
  const span = drift?.flagged.find((one) => one.first_frame <= frame && frame <= one.last_frame);
  if (!span) return null;
  const off =
    span.change_m === null ? "" : `, heights here are off by up to ${formatSmall(Math.abs(span.change_m))}`;
  return (
    <p class="frame-note" role="status" data-testid="drift-line">
      The camera had moved by {fixed(span.moved_px, 1)} px since its road pose{off}.{" "}
      <a href={`/surveys/${props.surveyId}/pose?recording=${recordingId}`}>Take a new pose or decide</a>
    </p>
  );
}
