/** The recordings of a survey and the player of the one that is open: which frame is asked for, and which is seen. */
import { computed, signal } from "@preact/signals";
import type { Recording } from "../core/types";
import { Player } from "./player";

export class Reel {
  readonly recordings = signal<readonly Recording[]>([]);
  readonly player = signal<Player | null>(null);
  readonly recording = computed(() =>
    this.recordings.value.find(({ id }) => id === this.player.value?.recordingId),
  );
  /** The frame that is seen: clicks, contacts and marks belong to it. Null until one is here. */
  readonly seen = computed(() => this.player.value?.shown.value?.frame ?? null);

  /** Opens a recording at a frame, or goes to that frame of the recording that is open. */
  show(recordingId: number, frame: number): Player {
    const now = this.player.value;
    if (now?.recordingId === recordingId) {
      now.openAt(frame);
      return now;
    }
    now?.close();
    const player = new Player(recordingId, frame);
    const facts = this.recordings.value.find(({ id }) => id === recordingId);
    if (facts) player.describe(facts);
    this.player.value = player;
    return player;
  }

  close(): void {
    this.player.value?.close();
    this.player.value = null;
  }
}
