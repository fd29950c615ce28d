/** Tabs of one browser tell each other what they edit; a record changed in another tab is read again here. */
import { useSignalEffect } from "@preact/signals";
import { useEffect, useMemo } from "preact/hooks";
import { say } from "../../core/messages";
import { toast } from "../../core/toasts";
import type { MeasureModel } from "./model";

interface News {
  readonly survey: number;
  readonly vehicle: number;
  readonly kind: "opened" | "here-too" | "stored";
}

export function useTabs(model: MeasureModel): void {
  const channel = useMemo(
    () => (typeof BroadcastChannel === "undefined" ? null : new BroadcastChannel("sightline.vehicles")),
    [model],
  );
  const tell = (kind: News["kind"], vehicle: number): void => {
    channel?.postMessage({ survey: model.surveyId, vehicle, kind } satisfies News);
  };
  useEffect(() => {
    if (!channel) return;
    channel.onmessage = ({ data }: MessageEvent<News>) => {
      if (data.survey !== model.surveyId) return;
      if (data.kind === "stored") void model.reading.one(data.vehicle);
      if (data.vehicle !== model.vehicleId.peek() || data.kind === "stored") return;
      if (data.kind === "opened") tell("here-too", data.vehicle);
      toast(say("measure-other-tab"));
    };
    model.onStored = (vehicle) => tell("stored", vehicle);
    return () => channel.close();
  }, [channel]);
  useSignalEffect(() => {
    const vehicle = model.vehicleId.value;
    if (vehicle !== null) tell("opened", vehicle);
  });
  useEffect(() => {
    // another person may have worked meanwhile: read the open vehicle again when the window comes back
    const back = (): void => {
      const vehicle = model.vehicleId.peek();
      if (document.visibilityState === "visible" && vehicle !== null) void model.reading.one(vehicle);
    };
    document.addEventListener("visibilitychange", back);
    return () => document.removeEventListener("visibilitychange", back);
  }, [model]);
}
