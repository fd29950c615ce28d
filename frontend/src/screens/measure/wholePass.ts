/**
 * A vehicle followed through its whole pass from the points of a measurement: asked of the server, shown on the frames,
 * and stored as one more revision once a person keeps it. Until then nothing is changed, and Esc leaves it so.
 */
import { computed, signal } from "@preact/signals";
import { explain } from "../../core/api";
import { say, sentenceOf } from "../../core/messages";
import { toast } from "../../core/toasts";
import type { FollowedAnswer } from "../../core/types";
import { askFollow } from "../../viewer/geometry";
import type { ImagePoint } from "../../viewer/points";
import type { Values } from "../../viewer/values";
import type { Desk } from "./desk";
import type { Entry } from "./records";
import type { Revise, SecondFrame } from "./secondFrame";

export interface Followed {
  readonly key: string;
  /** What was followed from: other points are another pass. */
  readonly values: Values;
  readonly answer: FollowedAnswer;
}

const APART_PX = 20;

export class WholePass {
  /** What is shown and may be kept; null while nothing is. */
  readonly now = signal<Followed | null>(null);
  readonly looking = signal(false);
  private asked = 0;

  /** The points on the frame that is seen; on the first one those that were clicked are drawn already. */
  readonly here = computed(() => {
    const now = this.now.value;
    const frame = this.desk.seenFrame.value;
    return now && frame !== now.values.frame ? now.answer.points.filter((one) => one.frame === frame) : [];
  });

  /** Every frame of the pass, and whether contact and target were followed to it. */
  readonly frames = computed(() => {
    const { points = [], dropped = [] } = this.now.value?.answer ?? {};
    const used = (frame: number, point: string) =>
      points.some((one) => one.frame === frame && one.point === point);
    const numbers = new Set([...points, ...dropped].map((one) => one.frame));
    return [...numbers]
      .sort((a, b) => a - b)
      .map((frame) => ({ frame, whole: used(frame, "contact") && used(frame, "target") }));
  });

  constructor(
    private readonly desk: Desk,
    private readonly beside: SecondFrame,
    private readonly revise: Revise,
  ) {}

  async start(key = this.meant()): Promise<void> {
    const entry = key === null ? undefined : this.desk.records.find(key);
    if (!entry) {
      toast(say("measure-whole-nothing-yet"));
      return;
    }
    this.asked += 1;
    const turn = this.asked;
    this.now.value = null;
    this.looking.value = true;
    try {
      const answer = await askFollow(entry.vehicleId, entry.values, this.second(entry));
      if (turn !== this.asked || this.desk.vehicleId.value !== entry.vehicleId) return;
      if (answer.reason !== null) toast(sentenceOf(answer.reason));
      else this.now.value = { key: entry.key, values: entry.values, answer };
    } catch (error) {
      if (turn === this.asked) toast(explain(error), { kind: "problem" });
    } finally {
      if (turn === this.asked) this.looking.value = false;
    }
  }

  /** Stores the measurement as one of the whole pass; the server follows it again and keeps what it finds. */
  keep(): void {
    const now = this.now.value;
    const entry = now && this.desk.records.find(now.key);
    if (!now || !entry || now.answer.height?.status !== "ok") return;
    const change = { follow: { second: this.second(entry) }, more: [] };
    this.revise(entry.key, change, say("measure-step-pass"), now.answer.height);
    this.forget();
  }

  forget(): void {
    this.asked += 1;
    this.looking.value = false;
    this.now.value = null;
  }

  /** Esc: nothing has happened. */
  cancel(): boolean {
    if (!this.now.value && !this.looking.value) return false;
    this.forget();
    return true;
  }

  /** The other tyre, where another measurement of the vehicle stands on it on the same frame. */
  private second(entry: Entry): ImagePoint | null {
    const { frame, contact } = entry.values;
    const others = this.desk.entries.value.filter(
      ({ values }) =>
        !values.withdrawn &&
        values.frame === frame &&
        Math.hypot(values.contact[0] - contact[0], values.contact[1] - contact[1]) > APART_PX,
    );
    return others[0]?.values.contact ?? null;
  }

  private meant(): string | null {
    const { flow, entries } = this.desk;
    const standing = entries.value.filter((entry) => !entry.values.withdrawn);
    const selected = flow.value.selection?.key ?? this.beside.last;
    return (standing.find((entry) => entry.key === selected) ?? standing.at(-1))?.key ?? null;
  }
}
