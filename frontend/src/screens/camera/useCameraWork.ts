import { useState } from "preact/hooks";
import { api } from "../../core/api";
import { useJobAction } from "../../core/jobs";
import { say } from "../../core/messages";
import { refreshSurvey } from "../../core/survey";
import { toast } from "../../core/toasts";
import type { CalibrationImage, CameraDetail } from "../../core/types";
import { useOneByOne } from "../../parts/uploads/oneByOne";
import type { Board } from "./board";
import type { Recipe } from "./CalibrateForm";

export function useCameraWork(
  camera: CameraDetail,
  board: Board | null,
  reload: () => Promise<void>,
  set: (change: (now: CameraDetail) => CameraDetail) => void,
) {
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

  /** The server looks for the board in each before it takes the next. */
  const sending = useOneByOne(async (body) => {
    if (!board) return;
    const where = { camera_id: camera.id, ...board };
    const added = await api.write("POST /cameras/{camera_id}/images", where, { body });
    set((now) => ({ ...now, images: [...now.images, added] }));
  });
  const addImages = async (files: File[]) => {
    if (!board) return;
    setProblem(null);
    await sending.add(files);
    await refreshSurvey();
  };

  return {
    waiting: sending.waiting,
    refused: sending.refused,
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
