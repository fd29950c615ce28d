import { useState } from "preact/hooks";
import { api } from "../../api";
import { Button, Icon, JobProgress, Notice, Problem, TextField } from "../../components";
import { cancelJob, useJob } from "../../state/jobs";
import { may } from "../../state/session";
import { refreshSurvey } from "../../state/survey";
import { toast } from "../../state/toasts";
import type { Calibration, CalibrationImage, CameraDetail, Job } from "../../types";
import { plural } from "../../units";
import { BoardDrawing } from "./BoardDrawing";
import { type Board, problemsOf, readBoard, type TypedBoard } from "./board";
import { CalibrateForm, type Recipe } from "./CalibrateForm";
import { CalibrationPanel } from "./CalibrationPanel";
import { History } from "./History";
import { ImageGrid } from "./ImageGrid";

interface Props {
  camera: CameraDetail;
  surveyId: number;
  reload: () => Promise<void>;
  set: (camera: CameraDetail) => void;
}

interface Sending {
  name: string;
  problem: string | null;
}

/** One camera: board, images, calibrate, result, history. */
export function CameraBench({ camera, surveyId, reload, set }: Props) {
  const [board, setBoard] = useState<TypedBoard>(() => firstBoard(camera));
  const [sending, setSending] = useState<Sending[]>([]);
  const [detecting, setDetecting] = useState(false);
  const [problem, setProblem] = useState<unknown>(null);
  const [jobId, setJobId] = useState<number | null>(null);
  const [failed, setFailed] = useState<string | null>(null);
  const [shownId, setShownId] = useState<number | null>(
    camera.current_calibration_id ?? camera.calibrations.at(-1)?.id ?? null,
  );
  const read = readBoard(board);
  const canWork = may("operator");

  const job = useJob(
    jobId,
    (over) => {
      setJobId(null);
      setFailed(over.state === "failed" ? (over.error ?? "The calibration failed; try again.") : null);
      const made = over.result?.["calibration_id"];
      if (made) setShownId(made);
      void reload().then(refreshSurvey);
      if (made) document.getElementById("main")?.scrollTo({ top: 0, behavior: "smooth" });
    },
    (error) => {
      setJobId(null);
      setProblem(error);
    },
  );

  const addImages = async (files: File[]) => {
    if (!read) return;
    setSending(files.map((file) => ({ name: file.name, problem: null })));
    const images = [...camera.images];
    const failures: Sending[] = [];
    for (const [index, file] of files.entries()) {
      try {
        images.push(
          await api.file<CalibrationImage>(
            `/cameras/${camera.id}/images?columns=${read.columns}&rows=${read.rows}`,
            file,
          ),
        );
        set({ ...camera, images: [...images] });
      } catch (error) {
        failures.push({
          name: file.name,
          problem: error instanceof Error ? error.message : "could not be sent",
        });
      }
      setSending([
        ...failures,
        ...files.slice(index + 1).map((rest) => ({ name: rest.name, problem: null })),
      ]);
    }
    await refreshSurvey();
  };

  const detectAgain = async () => {
    if (!read) return;
    setDetecting(true);
    setProblem(null);
    try {
      const images = await api.post<CalibrationImage[]>(`/cameras/${camera.id}/images/detect`, {
        columns: read.columns,
        rows: read.rows,
      });
      set({ ...camera, images });
    } catch (error) {
      setProblem(error);
    }
    setDetecting(false);
  };

  const removeImage = async (image: CalibrationImage) => {
    try {
      await api.del(`/calibration-images/${image.id}`);
      set({ ...camera, images: camera.images.filter((other) => other.id !== image.id) });
    } catch (error) {
      setProblem(error);
    }
  };

  const calibrate = async (recipe: Recipe) => {
    if (!read) return;
    setProblem(null);
    setFailed(null);
    try {
      setJobId((await api.post<Job>(`/cameras/${camera.id}/calibrations`, { ...read, ...recipe })).id);
    } catch (error) {
      setProblem(error);
    }
  };

  const importFile = async (file: File) => {
    setProblem(null);
    setFailed(null);
    try {
      const made = await api.file<Calibration>(`/cameras/${camera.id}/calibrations/import`, file);
      toast(`${file.name} was read.`);
      setShownId(made.id);
      document.getElementById("main")?.scrollTo({ top: 0, behavior: "smooth" });
      await reload();
      await refreshSurvey();
    } catch (error) {
      setProblem(error);
    }
  };

  const makeCurrent = async (id: number) => {
    setProblem(null);
    try {
      await api.put(`/cameras/${camera.id}/current-calibration`, { calibration_id: id });
      await reload();
      await refreshSurvey();
    } catch (error) {
      setProblem(error);
    }
  };

  const found = camera.images.filter((image) => image.found).length;
  const stale = read !== null && camera.images.some((image) => !sameBoard(image, read));
  const waiting = sending.filter((entry) => entry.problem === null).length;
  return (
    <>
      {shownId !== null && (
        <CalibrationPanel id={shownId} camera={camera} makeCurrent={canWork ? makeCurrent : undefined} />
      )}
      {camera.calibrations.length > 0 && <History camera={camera} shownId={shownId} show={setShownId} />}
      {canWork && (
        <section class="panel">
          <header class="panel__head">
            <h2>{camera.calibrations.length > 0 ? "Calibrate again" : "Calibrate"}</h2>
            <ImportButton take={(file) => void importFile(file)} />
          </header>
          <div class="panel__body stack">
            <BoardFields board={board} change={setBoard} />
            {stale && (
              <Notice
                kind="warning"
                actions={
                  <Button busy={detecting} onClick={() => void detectAgain()}>
                    Look again
                  </Button>
                }
              >
                The images were searched for another board size; look again for {board.columns} × {board.rows}{" "}
                inner corners.
              </Notice>
            )}
            <DropImages disabled={!read || waiting > 0} add={(files) => void addImages(files)} />
            {waiting > 0 && (
              <p class="row" role="status">
                <span class="spinner" /> {plural(waiting, "image")} to go
              </p>
            )}
            {sending
              .filter((entry) => entry.problem !== null)
              .map((entry) => (
                <Notice kind="problem" key={entry.name} title={entry.name}>
                  {entry.problem}
                </Notice>
              ))}
            {camera.images.length > 0 && (
              <>
                <p>
                  The board was found in <strong>{found}</strong> of {plural(camera.images.length, "image")}.{" "}
                  <span class="muted">{advice(found)}</span>
                </p>
                <ImageGrid images={camera.images} remove={(image) => void removeImage(image)} />
              </>
            )}
            <CalibrateForm
              surveyId={surveyId}
              usable={found}
              ready={read !== null && waiting === 0 && !stale}
              busy={jobId !== null}
              calibrate={(recipe) => void calibrate(recipe)}
            />
            {job && <JobProgress job={job} onCancel={() => void cancelJob(job.id).catch(setProblem)} />}
            {failed && <Notice kind="problem">{failed}</Notice>}
            <Problem error={problem} />
          </div>
        </section>
      )}
    </>
  );
}

/** A board lying on its side is the same board: the detector names columns and rows as it sees them. */
function sameBoard(image: CalibrationImage, board: Board): boolean {
  const flat = image.columns === board.columns && image.rows === board.rows;
  return flat || (image.columns === board.rows && image.rows === board.columns);
}

function advice(found: number): string {
  if (found < 3)
    return "At least three are needed; twelve to twenty from different sides give a good calibration.";
  if (found < 10)
    return "That will do; twelve to twenty, with the board tilted and in every corner of the picture, do better.";
  return "";
}

function firstBoard(camera: CameraDetail): TypedBoard {
  const image = camera.images.find((one) => !one.found) ?? camera.images[0];
  let square = "";
  try {
    square = localStorage.getItem("sightline.square_mm") ?? "";
  } catch {
    // nothing remembered
  }
  return { columns: String(image?.columns ?? 9), rows: String(image?.rows ?? 6), square: square || "25" };
}

function BoardFields({ board, change }: { board: TypedBoard; change: (board: TypedBoard) => void }) {
  const problems = problemsOf(board);
  const set = (part: Partial<TypedBoard>) => {
    const next = { ...board, ...part };
    change(next);
    try {
      if (part.square && !problemsOf(next).square) localStorage.setItem("sightline.square_mm", part.square);
    } catch {
      // it is only a convenience
    }
  };
  return (
    <div class="board">
      <div class="board__fields">
        <p class="board__lead">
          Count the <strong>inner corners</strong>: the points where four squares meet. A board of 10 by 7
          squares has 9 by 6.
        </p>
        <div class="board__inputs">
          <TextField
            label="Columns"
            numeric
            value={board.columns}
            onInput={(columns) => set({ columns })}
            problem={problems.columns}
          />
          <TextField
            label="Rows"
            numeric
            value={board.rows}
            onInput={(rows) => set({ rows })}
            problem={problems.rows}
          />
          <TextField
            label="Side of one square"
            numeric
            unit="mm"
            value={board.square}
            onInput={(square) => set({ square })}
            problem={problems.square}
          />
        </div>
        <p class="field__hint">
          Measure across ten squares with a ruler and divide by ten: printers rarely keep the size.
        </p>
      </div>
      <BoardDrawing
        columns={Number(board.columns) || 9}
        rows={Number(board.rows) || 6}
        square={board.square}
      />
    </div>
  );
}

function DropImages({ disabled, add }: { disabled: boolean; add: (files: File[]) => void }) {
  const [over, setOver] = useState(false);
  return (
    <label
      class={`drop${over ? " drop--over" : ""}`}
      onDragOver={(event) => {
        event.preventDefault();
        setOver(!disabled);
      }}
      onDragLeave={() => setOver(false)}
      onDrop={(event) => {
        event.preventDefault();
        setOver(false);
        if (!disabled) add([...(event.dataTransfer?.files ?? [])]);
      }}
    >
      <Icon name="upload" size={24} />
      <span class="grow">
        <strong>Drop pictures of the checkerboard here, or click to choose</strong>
        <span class="muted small drop__hint">
          Same camera, same zoom and focus. Tilt the board, bring it into every corner, keep it sharp.
        </span>
      </span>
      <input
        type="file"
        multiple
        accept="image/*"
        disabled={disabled}
        aria-label="Choose pictures of the checkerboard"
        onChange={(event) => {
          add([...(event.currentTarget.files ?? [])]);
          event.currentTarget.value = "";
        }}
      />
    </label>
  );
}

function ImportButton({ take }: { take: (file: File) => void }) {
  return (
    <label class="btn btn--file" title="OpenCV YAML or JSON, ROS camera_info, Kalibr, mrcal">
      <Icon name="upload" />
      Import a calibration file
      <input
        class="visually-hidden"
        type="file"
        aria-label="Import a calibration file"
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
