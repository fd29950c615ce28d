import { useState } from "preact/hooks";
import {
  Button,
  choices,
  DataTable,
  DropFiles,
  Icon,
  IconButton,
  JobProgress,
  Notice,
  Panel,
  Problem,
  Segments,
  StateMark,
} from "../../components";
import { Said } from "../../components/Said";
import { say, sentenceOf, wordsOf } from "../../core/messages";
import { may } from "../../core/session";
import { formatMoment } from "../../core/times";
import type { CalibrationImage, CameraDetail } from "../../core/types";
import { STATE_WORDS } from "../../core/words";
import { SampleLink } from "../../parts/samples/SampleLink";
import { EditCamera } from "./AddCamera";
import { BoardFields, useTypedBoard } from "./BoardFields";
import { type Board, readBoard } from "./board";
import { CalibrateForm, type Source } from "./CalibrateForm";
import { CalibrationPanel } from "./CalibrationPanel";
import { CornerMarks } from "./CornerMarks";
import { type CameraWork, useCameraWork } from "./useCameraWork";

interface Props {
  camera: CameraDetail;
  surveyId: number;
  reload: () => Promise<void>;
  set: (change: (now: CameraDetail) => CameraDetail) => void;
}

/** One camera: the result, its history, and the bench to calibrate it on. */
export function CameraBench({ camera, surveyId, reload, set }: Props) {
  const [typed, setTyped] = useTypedBoard(camera);
  const [source, setSource] = useState<Source>("images");
  const board = readBoard(typed);
  const work = useCameraWork(camera, board, reload, set);
  const canWork = may("operator");
  const found = camera.images.filter((image) => image.found).length;
  const stale = board !== null && camera.images.some((image) => !sameBoard(image, board));
  return (
    <>
      <Words camera={camera} changed={reload} />
      {work.shownId !== null && (
        <CalibrationPanel
          id={work.shownId}
          camera={camera}
          makeCurrent={canWork ? work.makeCurrent : undefined}
        />
      )}
      <History camera={camera} shownId={work.shownId} show={work.setShownId} />
      {canWork && (
        <Panel
          says={camera.calibrations.length > 0 ? "camera-calibrate-again" : "camera-calibrate"}
          aside={<ImportButton take={(file) => void work.importFile(file)} />}
        >
          <div class="panel__body stack camera-panel">
            <BoardFields board={typed} change={setTyped} />
            <Segments<Source>
              says="camera-where-boards"
              value={source}
              onInput={setSource}
              options={choices(wordsOf("camera-from-"))}
            />
            {source === "images" && <Images camera={camera} board={board} stale={stale} work={work} />}
            <CalibrateForm
              surveyId={surveyId}
              source={source}
              usable={found}
              ready={board !== null && work.waiting === 0 && (source === "clip" || !stale)}
              busy={work.calibrating}
              calibrate={(recipe) => void work.calibrate(recipe)}
            />
            {work.job && <JobProgress job={work.job} onCancel={work.cancel} />}
            <Problem error={work.problem} />
          </div>
        </Panel>
      )}
    </>
  );
}

interface ImagesProps {
  camera: CameraDetail;
  board: Board | null;
  stale: boolean;
  work: CameraWork;
}

function Images({ camera, board, stale, work }: ImagesProps) {
  const found = camera.images.filter((image) => image.found).length;
  return (
    <>
      {stale && board && <OtherBoard board={board} work={work} />}
      <DropFiles
        label={say("camera-choose-pictures")}
        title={say("camera-drop-pictures")}
        hint={say("camera-drop-hint")}
        accept="image/*"
        disabled={!board || work.waiting > 0}
        add={(files) => void work.addImages(files)}
      />
      {camera.images.length === 0 && <SampleLink kind="pictures" />}
      <SendingState work={work} />
      {camera.images.length > 0 && (
        <>
          <p>
            <Said what="camera-found-in" values={{ found, count: camera.images.length }} />{" "}
            <span class="muted">{advice(found)}</span>
          </p>
          <ImageGrid images={camera.images} remove={(image) => void work.removeImage(image)} />
        </>
      )}
    </>
  );
}

/** A board lying on its side is the same board: the detector names columns and rows as it sees them. */
function sameBoard(image: CalibrationImage, board: Board): boolean {
  if ((image.dictionary ?? undefined) !== board.dictionary) return false;
  const share = (board.marker_m ?? 0) / board.square_m;
  if (Math.abs((image.marker_share ?? 0) - share) > 1e-3) return false;
  const flat = image.columns === board.columns && image.rows === board.rows;
  return flat || (image.columns === board.rows && image.rows === board.columns);
}

function advice(found: number): string {
  if (found < 3) return say("camera-too-few");
  if (found < 10) return say("camera-more-better");
  return "";
}

function OtherBoard({ board, work }: { board: Board; work: CameraWork }) {
  const { columns, rows, dictionary } = board;
  return (
    <Notice
      kind="warning"
      actions={<Button says="camera-look-again" busy={work.busy} onClick={() => void work.detectAgain()} />}
    >
      {dictionary
        ? say("camera-other-board-markers", { columns, rows, dictionary })
        : say("camera-other-board", { columns, rows })}
    </Notice>
  );
}

function SendingState({ work }: { work: CameraWork }) {
  return (
    <>
      {work.waiting > 0 && (
        <p class="row" role="status">
          <span class="spinner" /> {say("camera-to-go", { count: work.waiting })}
        </p>
      )}
      {work.refused.map(({ name, problem }) => (
        <Notice kind="problem" key={name}>
          {problem}
        </Notice>
      ))}
    </>
  );
}

function ImportButton({ take }: { take: (file: File) => void }) {
  return (
    <label class="btn btn--file" title={say("camera-import-title")}>
      <Icon name="upload" />
      {say("camera-import")}
      <input
        class="visually-hidden"
        type="file"
        aria-label={say("camera-import")}
        accept=".yaml,.yml,.json,.xml,.cameramodel,.txt"
        onChange={(event) => {
          const file = event.currentTarget.files?.[0];
          event.currentTarget.value = "";
          if (file) take(file);
        }}
      />
    </label>
  );
}

/** What is said of the camera: the lens and its setting, for which alone a calibration holds. */
function Words({ camera, changed }: { camera: CameraDetail; changed: () => Promise<void> }) {
  const [editing, setEditing] = useState(false);
  const { lens, zoom, focus, notes, taken_from } = camera;
  const words = [
    taken_from && say("camera-taken-from", { place: taken_from }),
    lens,
    zoom && say("camera-zoomed", { zoom }),
    focus && say("camera-focused", { focus }),
    notes,
  ].filter(Boolean);
  return (
    <div class="row row--wrap small" data-testid="camera-words">
      <span>{words.length > 0 ? words.join("  ·  ") : say("camera-words-none")}</span>
      {may("operator") && <Button says="camera-edit" small kind="quiet" onClick={() => setEditing(true)} />}
      {editing && <EditCamera camera={camera} changed={changed} close={() => setEditing(false)} />}
    </div>
  );
}

function ImageGrid({
  images,
  remove,
}: {
  images: CalibrationImage[];
  remove: (image: CalibrationImage) => void;
}) {
  return (
    <ul class="grid grid--fill" style={{ "--least": "176px" }}>
      {images.map((image) => (
        <li key={image.id} class="shot">
          <div class="shot__picture" style={{ aspectRatio: `${image.width_px} / ${image.height_px}` }}>
            <img src={image.url} alt={image.found ? "" : image.name} loading="lazy" />
            {image.found && (
              <CornerMarks
                width={image.width_px}
                height={image.height_px}
                corners={image.corners_px}
                columns={image.columns}
                ids={image.ids}
                label={say("camera-corners-found", { count: image.corners_px.length, image: image.name })}
              />
            )}
          </div>
          <div class="row row--apart small">
            <span class="clip" title={image.name}>
              {image.name}
            </span>
            <IconButton
              icon="close"
              label={say("camera-remove", { image: image.name })}
              onClick={() => remove(image)}
            />
          </div>
          <p class="small">
            <StateMark
              state={image.found ? "used" : "left_out"}
              word={image.found ? foundInWords(image) : STATE_WORDS.left_out}
            />
          </p>
          {image.reason && <p class="small muted">{sentenceOf(image.reason)}</p>}
        </li>
      ))}
    </ul>
  );
}

function foundInWords({ ids, columns, rows }: CalibrationImage): string {
  return ids
    ? say("camera-found-some", { found: ids.length, all: columns * rows })
    : say("camera-found-all", { columns, rows });
}

interface HistoryProps {
  camera: CameraDetail;
  shownId: number | null;
  show: (id: number) => void;
}

const SOURCES = wordsOf("camera-source-");

/** Every calibration this camera ever had; results name the one they were computed with, so none goes away. */
function History({ camera, shownId, show }: HistoryProps) {
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
