import { Button, Panel, StateMark, Table } from "../../components";
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
    <Panel title={say("camera-calibrations")}>
      <Table
        label={say("camera-calibrations")}
        class="table--hover"
        heads={[
          say("camera-history-made"),
          say("camera-history-by"),
          say("camera-history-from"),
          say("camera-history-verdict"),
          say("camera-history-summary"),
          <span class="visually-hidden">{say("camera-history-show")}</span>,
        ]}
      >
        {newestFirst.map((entry) => (
          <tr key={entry.id}>
            <td class="nowrap">{formatMoment(entry.created_at)}</td>
            <td class="nowrap">{entry.created_by?.name ?? "–"}</td>
            <td class="nowrap">{SOURCES[entry.source]}</td>
            <td>
              <StateMark state={entry.trusted ? "trusted" : "not_trusted"} />
            </td>
            <td>{sentenceOf(entry.summary)}</td>
            <td class="num">
              {entry.id === camera.current_calibration_id && (
                <span class="badge badge--solid">{say("in-use")}</span>
              )}{" "}
              {entry.id === shownId ? (
                <span class="muted small">{say("camera-history-shown")}</span>
              ) : (
                <Button small onClick={() => show(entry.id)}>
                  {say("camera-show")}
                </Button>
              )}
            </td>
          </tr>
        ))}
      </Table>
    </Panel>
  );
}
