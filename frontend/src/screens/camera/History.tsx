import { Button, StateMark, TableScroll } from "../../components";
import { formatMoment } from "../../core/times";
import type { CameraDetail } from "../../core/types";

interface Props {
  camera: CameraDetail;
  shownId: number | null;
  show: (id: number) => void;
}

const SOURCES = { images: "images", clip: "a recording", import: "a file" } as const;

/** Every calibration this camera ever had; results name the one they were computed with, so none goes away. */
export function History({ camera, shownId, show }: Props) {
  const newestFirst = [...camera.calibrations].sort((a, b) => b.id - a.id);
  if (newestFirst.length < 2) return null;
  return (
    <section class="panel">
      <header class="panel__head">
        <h2>Calibrations</h2>
      </header>
      <TableScroll label="Calibrations">
        <table class="table table--hover">
          <thead>
            <tr>
              <th>made</th>
              <th>by</th>
              <th>from</th>
              <th>verdict</th>
              <th>summary</th>
              <th>
                <span class="visually-hidden">show</span>
              </th>
            </tr>
          </thead>
          <tbody>
            {newestFirst.map((entry) => (
              <tr key={entry.id}>
                <td class="nowrap">{formatMoment(entry.created_at)}</td>
                <td class="nowrap">{entry.created_by?.name ?? "–"}</td>
                <td class="nowrap">{SOURCES[entry.source]}</td>
                <td>
                  <StateMark state={entry.trusted ? "trusted" : "not_trusted"} />
                </td>
                <td>{entry.summary}</td>
                <td class="num">
                  {entry.id === camera.current_calibration_id && (
                    <span class="badge badge--solid">in use</span>
                  )}{" "}
                  {entry.id === shownId ? (
                    <span class="muted small">shown</span>
                  ) : (
                    <Button small onClick={() => show(entry.id)}>
                      Show
                    </Button>
                  )}
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      </TableScroll>
    </section>
  );
}
