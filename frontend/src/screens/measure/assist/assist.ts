/** The contact assistant: asks the server where the wheel at the pointer stands, and holds the proposal until it is taken or let go. */
import { computed, effect, signal } from "@preact/signals";
import { api, explain } from "../../../core/api";
import { canWork } from "../../../core/session";
import type { ContactProposal } from "../../../core/types";
import { fromServer, type ImagePoint, screenDistance } from "../../../viewer/points";
import type { MeasureModel } from "../model";

/** A click this near to a proposal takes it, at exactly its place. */
const TAKE_PX = 12;

interface Asked {
  readonly recordingId: number;
  readonly frame: number;
}

interface Answered extends Asked {
  readonly answer: ContactProposal;
}

export class Assist {
  private readonly answered = signal<Answered | null>(null);
  readonly waiting = signal(false);
  readonly problem = signal<string | null>(null);
  /** The answer for the frame that is seen; gone as soon as a contact stands. */
  readonly answer = computed<ContactProposal | null>(() => {
    const now = this.answered.value;
    const { player, seenFrame, awaiting } = this.model;
    const here = now?.recordingId === player.value?.recordingId && now?.frame === seenFrame.value;
    return now && here && awaiting.value === "contact" ? now.answer : null;
  });
  readonly at = computed<ImagePoint | null>(() => {
    const contact = this.answer.value?.contact;
    return contact ? fromServer(contact) : null;
  });
  private readonly stop: () => void;

  constructor(private readonly model: MeasureModel) {
    this.stop = effect(() => {
      void model.seenFrame.value;
      void model.vehicleId.value;
      this.letGo();
    });
  }

  close(): void {
    this.stop();
  }

  /** Asks for a proposal at the pointer or the keyboard's cursor. Answers false where none can be used. */
  propose(): boolean {
    const { model } = this;
    const recordingId = model.player.value?.recordingId;
    const pointer = model.points.cursor.value ?? model.stage.pointer.value;
    if (!canWork.value || !model.hasPose.value || recordingId === undefined) return false;
    if (model.awaiting.value !== "contact") {
      this.problem.value =
        model.vehicleId.value === null
          ? "Choose a pass first; then a contact can be proposed."
          : "No contact is awaited here; begin a new one with the key for a new contact point.";
      return true;
    }
    if (!pointer) {
      this.problem.value = "Point at where the tyre meets the road, then ask for a proposal.";
      return true;
    }
    void this.ask({ recordingId, frame: model.seenFrame.value }, pointer);
    return true;
  }

  /** Enter: the proposal becomes a click at exactly its place. */
  take(): boolean {
    const at = this.at.value;
    if (!at || !canWork.value) return false;
    this.letGo();
    this.model.points.place(at);
    return true;
  }

  /** Where a click lands: on the proposal if it is near to it, else where it was made. */
  snapped(point: ImagePoint): ImagePoint {
    const at = this.at.value;
    const view = this.model.stage.viewport.value;
    return at && screenDistance(view.toScreen(at), view.toScreen(point)) <= TAKE_PX ? at : point;
  }

  letGo(): boolean {
    const had = this.answered.peek() !== null || this.problem.peek() !== null;
    this.answered.value = null;
    this.problem.value = null;
    return had;
  }

  private async ask(asked: Asked, pointer: ImagePoint): Promise<void> {
    this.letGo();
    this.waiting.value = true;
    try {
      const answer = await api.post<ContactProposal>(
        `/recordings/${asked.recordingId}/frames/${asked.frame}/contact`,
        { pointer: [pointer[0], pointer[1]] },
        { retry: true },
      );
      this.answered.value = { ...asked, answer };
    } catch (error) {
      this.problem.value = explain(error);
    } finally {
      this.waiting.value = false;
    }
  }
}
