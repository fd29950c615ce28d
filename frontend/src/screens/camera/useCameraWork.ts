import { useState } from "preact/hooks";
import { api, explain } from "../../core/api";
import { useJobAction } from "../../core/jobs";
import { say } from "../../core/messages";
import { refreshSurvey } from "../../core/survey";
import { toast } from "../../core/toasts";
import type { CalibrationImage, CameraDetail } from "../../core/types";
import type { Board } from "./board";
import type { Recipe } from "./CalibrateForm";

export interface Sending {
  name: string;
  problem: string | null;
}

export function useCameraWork(
  camera: CameraDetail,
  board: Board | null,
  reload: () => Promise<void>,
  set: (change: (now: CameraDetail) => CameraDetail) => void,
) {
  const [sending, setSending] = useState<Sending[]>([]);
  const [shownId, setShownId] = useState<number | null>(
    camera.current_calibration_id ?? camera.calibrations.at(-1)?.id ?? null,
  );

  const refresh = async () => {
    await reload();
    await refreshSurvey();
  };
  const show = async (calibrationId: number) => {
    setShownId(calibrationId);
    document.getElementById("main")?.scrollTo({ top: 0, behavior: "smooth" });
    await refresh();
  };

  const { job, busy, underWay, problem, setProblem, run, start, cancel } = useJobAction({
    known: camera.calibrating?.id ?? null,
    stopped: say("camera-failed"),
    over: (ended) => {
      const made = ended.result?.["calibration_id"];
      return typeof made === "number" ? show(made) : refresh();
    },
  });

  /** One after the other: the server looks for the board in each before it takes the next. */
  const addImages = async (files: File[]) => {
    if (!board) return;
    const refused: Sending[] = [];
    setProblem(null);
    setSending(files.map(waiting));
    for (const [index, file] of files.entries()) {
      const sent = await sendImage(camera.id, board, file);
      if (typeof sent === "string") refused.push({ name: file.name, problem: sent });
      else set((now) => ({ ...now, images: [...now.images, sent] }));
      setSending([...refused, ...files.slice(index + 1).map(waiting)]);
    }
    await refreshSurvey();
  };

  return {
    sending,
    waiting: sending.filter((entry) => entry.problem === null).length,
    busy,
    problem,
    job,
    calibrating: underWay,
    shownId,
    setShownId,
    cancel,
    addImages,
    detectAgain: () =>
      run(async () => {
        if (!board) return;
        const images = await api.write(
          "POST /cameras/{camera_id}/images/detect",
          { camera_id: camera.id },
          { body: board },
        );
        set((now) => ({ ...now, images }));
      }),
    removeImage: (image: CalibrationImage) =>
      run(async () => {
        await api.write("DELETE /calibration-images/{image_id}", { image_id: image.id });
        set((now) => ({ ...now, images: now.images.filter((other) => other.id !== image.id) }));
      }),
    calibrate: async (recipe: Recipe) => {
      const where = { camera_id: camera.id };
      if (board)
        await start(() =>
          api.write("POST /cameras/{camera_id}/calibrations", where, { body: { ...board, ...recipe } }),
        );
    },
    importFile: (file: File) =>
      run(async () => {
        const made = await api.write(
          "POST /cameras/{camera_id}/calibrations/import",
          { camera_id: camera.id },
          { body: file },
        );
        toast(say("camera-imported", { file: file.name }));
        await show(made.id);
      }),
    makeCurrent: (calibrationId: number) =>
      run(async () => {
        await api.write(
          "PUT /cameras/{camera_id}/current-calibration",
          { camera_id: camera.id },
          { body: { calibration_id: calibrationId } },
        );
        await refresh();
      }),
  };
}

export type CameraWork = ReturnType<typeof useCameraWork>;

function waiting(file: File): Sending {
  return { name: file.name, problem: null };
}

async function sendImage(cameraId: number, board: Board, file: File): Promise<CalibrationImage | string> {
  try {
    return await api.write(
      "POST /cameras/{camera_id}/images",
      { camera_id: cameraId, ...board },
      { body: file },
    );
  } catch (error) {
    return explain(error);
  }
}
