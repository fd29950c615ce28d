/** One line on the frame when the camera had moved by then. */
import { Said } from "../../../components/Said";
import { useAsked } from "../../../core/resource";
import { fixed, formatLength, formatSmall } from "../../../core/units";

export function DriftLine(props: { surveyId: number; recordingId: number; frame: number }) {
  const { recordingId, frame } = props;
  const drift = useAsked("GET /recordings/{recording_id}/drift", { recording_id: recordingId }).data;
  const span = drift?.flagged.find((one) => one.first_frame <= frame && frame <= one.last_frame);
  if (!span) return null;
  const moved_px = fixed(span.moved_px, 1);
  const { change_m, distance_m } = span;
  const page = `/surveys/${props.surveyId}/pose?recording=${recordingId}`;
  const parts = { link: (text: string) => <a href={page}>{text}</a> };
  return (
    <p class="frame-note" role="status" data-testid="drift-line">
      {change_m == null || distance_m == null ? (
        <Said what="measure-drift" values={{ moved_px }} parts={parts} />
      ) : (
        <Said
          what="measure-drift-off"
          values={{ moved_px, off: formatSmall(Math.abs(change_m)), distance: formatLength(distance_m, 1) }}
          parts={parts}
        />
      )}
    </p>
  );
}
