/** The measure page and its address: what a page that is opened shows first, and what a copied address will. */
import { effect } from "@preact/signals";
import { asked, query, setQuery } from "../../core/address";
import { say } from "../../core/messages";
import { toast } from "../../core/toasts";
import type { Recording, Vehicle } from "../../core/types";
import { bestFrame, firstOpen } from "../../parts/vehicles/passes";
import type { PassDesk } from "./desk";

export class PageAddress {
  private timer: ReturnType<typeof setTimeout> | undefined;
  private readonly stop: () => void;

  /** `enter` opens a pass on the frame that is there. */
  constructor(
    private readonly desk: PassDesk,
    private readonly enter: (vehicle: Vehicle) => void,
  ) {
    this.startFirstFrame();
    this.stop = effect(() => this.follow());
  }

  close(): void {
    this.stop();
    clearTimeout(this.timer);
  }

  private startFirstFrame(): void {
    const params = new URLSearchParams(location.search);
    const recordingId = Number(params.get("recording"));
    const frame = Number(params.get("frame"));
    if (params.has("frame") && recordingId > 0 && frame >= 0) this.desk.reel.show(recordingId, frame);
  }

  /**
   * The pass the address names, else the first with something to do: of the recording that it names, if it does. Where it
   * names one that is not here, that is said, and no other is opened in its place.
   */
  openFirst(): void {
    const now = this.desk.reel.player.value;
    const facts = this.desk.reel.recordings.value.find((one) => one.id === now?.recordingId);
    if (now && facts) now.describe(facts);
    else if (now) this.desk.reel.close();
    const [vehicleId, recordingId] = [asked("vehicle"), asked("recording")];
    const named = this.desk.vehicles.get(vehicleId);
    const recording = this.desk.reel.recordings.value.find((one) => one.id === recordingId);
    const missed = missedBy(vehicleId, named, recordingId, recording);
    if (missed) toast(say("address-elsewhere", { what: missed }), { kind: "problem" });
    const here = this.desk.reel.player.value;
    // what was pressed on the frame of the address, while the passes were still on their way, counts
    if (named && named.recording_id === here?.recordingId) this.enter(named);
    else if (named) this.desk.open(named, here?.frame.value ?? bestFrame(named));
    if (!this.desk.reel.player.value) this.openIn(recording, missed === null);
  }

  /** The first pass with something to do in a recording, or in any; without `pass` its first frame only. */
  private openIn(recording: Recording | undefined, pass: boolean): void {
    const wanted = ({ recording_id }: Vehicle) => !recording || recording_id === recording.id;
    const list = this.desk.list.value.filter(wanted);
    const next = firstOpen(list) ?? list[0] ?? this.desk.vehicles.list.value.find(wanted);
    const ready = this.desk.reel.recordings.value.find(
      (one) => one.state === "ready" && (!recording || one === recording),
    );
    if (next && pass) this.desk.open(next);
    else if (ready) this.desk.reel.show(ready.id, 0);
  }

  private follow(): void {
    const recording = this.desk.reel.player.value?.recordingId ?? null;
    // also after a link to this page took it out of the address
    void query.value;
    // the frame that is seen, so that a copied address shows what its sender saw
    const frame = this.desk.seenFrame.value;
    const vehicle = this.desk.vehicleId.value;
    if (frame < 0 || !this.desk.loaded.value || this.desk.reel.player.value?.playing.value) return;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => setQuery({ recording, frame, vehicle }), 250);
  }
}

/** What the address names and is not here; null where all of it is. */
function missedBy(
  vehicleId: number | null,
  vehicle: Vehicle | undefined,
  recordingId: number | null,
  recording: Recording | undefined,
): "vehicle" | "recording" | null {
  if (vehicle) return null;
  if (recordingId !== null && recording?.state !== "ready") return "recording";
  return vehicleId === null ? null : "vehicle";
}
