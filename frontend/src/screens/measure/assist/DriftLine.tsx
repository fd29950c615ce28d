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
  const off = formatSmall(span.change_m === null ? null : Math.abs(span.change_m));
  const distance = formatLength(drift?.check?.distance_m ?? null, 1);
  const page = `/surveys/${props.surveyId}/pose?recording=${recordingId}`;
  const parts = { link: (text: string) => <a href={page}>{text}</a> };
  return (
    <p class="frame-note" role="status" data-testid="drift-line">
      {span.change_m === null ? (
        <Said what="measure-drift" values={{ moved_px }} parts={parts} />
      ) : (
        <Said what="measure-drift-off" values={{ moved_px, off, distance }} parts={parts} />
      )}
    </p>
  );
}
