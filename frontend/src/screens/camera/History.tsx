import { Button, DataTable, Panel, StateMark } from "../../components";
import { say, sentenceOf, wordsOf } from "../../core/messages";
import { formatMoment } from "../../core/times";
import type { CameraDetail } from "../../core/types";

interface Props {
  camera: CameraDetail;
  shownId: number | null;
  show: (id: number) => void;
}

const SOURCES = wordsOf("camera-source-");

/** Every calibration this camera ever had; results name the one they were computed with, so none goes away. */
export function History({ camera, shownId, show }: Props) {
  const newestFirst = [...camera.calibrations].sort((a, b) => b.id - a.id);
  if (newestFirst.length < 2) return null;
  return (
    <Panel says="camera-calibrations">
      <DataTable
        label={say("camera-calibrations")}
        class="table--hover"
        rows={newestFirst}
        keyOf={(entry) => entry.id}
        columns={({ col, actions }) => [
          col(say("camera-history-made"), (entry) => formatMoment(entry.created_at), "nowrap"),
          col(say("camera-history-by"), (entry) => entry.created_by?.name ?? "–", "nowrap"),
          col(say("camera-history-from"), (entry) => SOURCES[entry.source], "nowrap"),
          col(say("camera-history-verdict"), (entry) => (
            <StateMark state={entry.trusted ? "trusted" : "not_trusted"} />
          )),
          col(say("camera-history-summary"), (entry) => sentenceOf(entry.summary)),
          actions(
            say("camera-history-show"),
            (entry) => (
              <>
                {entry.id === camera.current_calibration_id && (
                  <span class="badge badge--solid">{say("in-use")}</span>
                )}{" "}
                {entry.id === shownId ? (
                  <span class="muted small">{say("camera-history-shown")}</span>
                ) : (
                  <Button says="camera-show" small onClick={() => show(entry.id)} />
                )}
              </>
            ),
            "num",
          ),
        ]}
      />
    </Panel>
  );
}
