/** The contact assistant: asks the server where the wheel at the pointer stands, and holds the proposal until it is taken or let go. */
import { computed, effect, signal } from "@preact/signals";
import { api, explain } from "../../../core/api";
import { say } from "../../../core/messages";
import { canWork } from "../../../core/session";
import type { ContactProposal } from "../../../core/types";
import { fromServer, type ImagePoint, screenDistance } from "../../../viewer/points";
import type { Tool } from "../../../viewer/tool";
import type { Desk } from "../desk";

/** A click this near to a proposal takes it, at exactly its place. */
const TAKE_PX = 12;

interface Asked {
  readonly recordingId: number;
  readonly frame: number;
}

interface Answered extends Asked {
  readonly pointer: ImagePoint;
  readonly answer: ContactProposal;
}

export class Assist implements Tool<ImagePoint> {
  private readonly answered = signal<Answered | null>(null);
  readonly waiting = signal(false);
  readonly problem = signal<string | null>(null);
  /** The answer for the frame that is seen; gone as soon as a contact stands. */
  readonly answer = computed<ContactProposal | null>(() => {
    const now = this.answered.value;
    const { reel, seenFrame, awaiting } = this.desk;
    const here = now?.recordingId === reel.player.value?.recordingId && now?.frame === seenFrame.value;
    return now && here && awaiting.value === "contact" ? now.answer : null;
  });
  readonly at = computed<ImagePoint | null>(() => {
    const contact = this.answer.value?.contact;
    return contact ? fromServer(contact) : null;
  });
  private readonly stop: () => void;

  constructor(private readonly desk: Desk) {
    this.stop = effect(() => {
      void desk.seenFrame.value;
      void desk.vehicleId.value;
      this.letGo();
    });
  }

  close(): void {
    this.stop();
  }

  /** Asks for a proposal at the pointer or the keyboard's cursor. Answers false where none can be used. */
  propose(): boolean {
    const { desk } = this;
    const recordingId = desk.reel.player.value?.recordingId;
    const pointer = desk.stage.cursor.value ?? desk.stage.pointer.value;
    if (!canWork.value || !desk.hasPose.value || recordingId === undefined) return false;
    if (desk.awaiting.value !== "contact") {
      this.problem.value =
        desk.vehicleId.value === null ? say("measure-proposal-no-pass") : say("measure-proposal-no-contact");
      return true;
    }
    if (!pointer) {
      this.problem.value = say("measure-proposal-no-pointer");
      return true;
    }
    void this.ask({ recordingId, frame: desk.seenFrame.value }, pointer);
    return true;
  }

  /** Enter: the proposal becomes a click at exactly its place. */
  confirm(): boolean {
    const at = this.at.value;
    return at !== null && canWork.value && this.take(at);
  }

  /** A click near to the proposal is one on it; any other is not meant for it. */
  place(point: ImagePoint): boolean {
    const at = this.at.value;
    const view = this.desk.stage.view.value;
    return at !== null && screenDistance(view.toScreen(at), view.toScreen(point)) <= TAKE_PX && this.take(at);
  }

  cancel(): boolean {
    return this.letGo();
  }

  private take(at: ImagePoint): boolean {
    const asked = this.answered.value;
    if (asked) this.desk.snapping.taken(asked.pointer, at);
    this.letGo();
    return this.desk.stage.place(at);
  }

  private letGo(): boolean {
    const had = this.answered.peek() !== null || this.problem.peek() !== null;
    this.answered.value = null;
    this.problem.value = null;
    return had;
  }

  private async ask(asked: Asked, pointer: ImagePoint): Promise<void> {
    this.letGo();
    this.waiting.value = true;
    try {
      const answer = await api.ask(
        "POST /recordings/{recording_id}/frames/{n}/contact",
        { recording_id: asked.recordingId, n: asked.frame },
        { body: { pointer: [pointer[0], pointer[1]], vehicle_id: this.desk.vehicleId.value }, retry: true },
      );
      this.answered.value = { ...asked, pointer, answer };
    } catch (error) {
      this.problem.value = explain(error);
    } finally {
      this.waiting.value = false;
    }
  }
}
