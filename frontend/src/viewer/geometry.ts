/**
 * Asks the server for geometry while points move. Nothing is computed here.
 * Without a connection a question waits, as the banner says; it is answered when the server is back, and no other place says more.
 */
import { signal } from "@preact/signals";
import { api, explain } from "../core/api";
import { Latest } from "../core/latest";
import { sentenceOf } from "../core/messages";
import type {
  AxesAnswer,
  DriverSide,
  FollowedAnswer,
  HeightAnswer,
  SecondFrameAnswer,
  Target,
} from "../core/types";
import { formatHeight } from "../core/units";
import { STATE_WORDS } from "../core/words";
import { type ImagePoint, pair, samePoint } from "./points";
import { clickBody, type FramePoints, frameBody, type Inset, type Values } from "./values";

/** How long questions of the next target wait for the click before it to be stored. */
export const AFTER_CLICK_MS = 150;
/** After how long without an answer it is said that one is awaited. */
export const SLOW_MS = 250;

export interface AxesWish {
  readonly recordingId: number;
  readonly contact: ImagePoint;
  readonly target: Target;
  readonly inset: Inset | null;
  /** Whose driver's side counts for an eye. */
  readonly vehicleId?: number | null;
  /** Where that driver sits, as far as is known: another one asks anew. */
  readonly side?: DriverSide | null;
}

export interface HeightWish extends AxesWish {
  readonly point: ImagePoint;
  readonly frame: number;
  readonly sigma_px: number | null;
  readonly more?: readonly FramePoints[];
}

export interface Live {
  readonly wish: HeightWish;
  readonly answer: HeightAnswer | null;
  readonly problem: string | null;
}

export function heightOrReason(answer: HeightAnswer): string {
  if (answer.status === "ok") return formatHeight(answer.height_m, answer.U95_height_m);
  return answer.reason ? sentenceOf(answer.reason) : STATE_WORDS.not_measurable;
}

export class Geometry {
  /** Axes and ladder through the contact in use; old ones stay until new ones are here. */
  readonly axes = signal<AxesAnswer | null>(null);
  readonly problem = signal<string | null>(null);
  /** The height under the pointer, for the newest answer that came. */
  readonly live = signal<Live | null>(null);
  /** The contact whose axes are awaited, once that takes long. */
  readonly awaited = signal<ImagePoint | null>(null);
  private wished: AxesWish | null = null;
  private slow: ReturnType<typeof setTimeout> | undefined;
  private timer: ReturnType<typeof setTimeout> | undefined;

  private readonly axesAsker = new Latest<AxesWish, AxesAnswer>(
    askAxes,
    (answer, wish) => {
      if (wish === this.wished) this.arrived();
      this.axes.value = answer;
      this.problem.value = answer.reason && sentenceOf(answer.reason);
    },
    (error) => this.failed(error),
  );

  private readonly heightAsker = new Latest<HeightWish, HeightAnswer>(
    askHeight,
    (answer, wish) => {
      this.live.value = { wish, answer, problem: null };
    },
    (error) => {
      const wish = this.live.value?.wish;
      if (wish) this.live.value = { wish, answer: null, problem: explain(error) };
    },
  );

  showAxes(wish: AxesWish | null): void {
    if (wish !== null && sameAxes(wish, this.wished)) return;
    clearTimeout(this.timer);
    const before = this.wished;
    this.wished = wish;
    if (wish === null) {
      this.axesAsker.cancel();
      this.arrived();
      this.axes.value = null;
      this.problem.value = null;
    } else if (before && samePoint(before.contact, wish.contact)) {
      // only the target is another, most likely because a click is being stored: that goes first
      this.timer = setTimeout(() => this.axesAsker.want(wish), AFTER_CLICK_MS);
    } else {
      this.arrived();
      this.slow = setTimeout(() => {
        this.awaited.value = wish.contact;
      }, SLOW_MS);
      this.axesAsker.want(wish);
    }
  }

  private arrived(): void {
    clearTimeout(this.slow);
    this.awaited.value = null;
  }

  wantHeight(wish: HeightWish): void {
    this.heightAsker.want(wish);
  }

  forgetHeight(): void {
    this.heightAsker.cancel();
    this.live.value = null;
  }

  /** The live answer if it is for exactly this click: then it can be shown while the server stores. */
  answerFor(
    contact: ImagePoint,
    point: ImagePoint,
    target: Target,
    inset: Inset | null,
    more: readonly FramePoints[] = [],
  ): HeightAnswer | null {
    const live = this.live.value;
    if (!live || live.wish.target !== target) return null;
    if ((live.wish.more ?? []).length !== more.length) return null;
    if (live.wish.inset?.inset_m !== inset?.inset_m || live.wish.inset?.u_inset_m !== inset?.u_inset_m)
      return null;
    return samePoint(live.wish.point, point) && samePoint(live.wish.contact, contact) ? live.answer : null;
  }

  private failed(error: unknown): void {
    this.arrived();
    this.axes.value = null;
    this.problem.value = explain(error);
    this.wished = null;
  }
}

function askAxes({ recordingId, contact, target, inset, vehicleId }: AxesWish): Promise<AxesAnswer> {
  const body = { contact: pair(contact), target, ...(inset ?? {}), vehicle_id: vehicleId ?? null };
  return api.ask(
    "POST /recordings/{recording_id}/geometry/axes",
    { recording_id: recordingId },
    { body, retry: true },
  );
}

export function askHeight({
  recordingId,
  contact,
  point,
  target,
  frame,
  inset,
  sigma_px,
  more,
  vehicleId,
}: HeightWish): Promise<HeightAnswer> {
  const sigma = sigma_px === null ? {} : { sigma_px };
  const clicked = { target, ...frameBody({ frame, contact, point }) };
  const of = { vehicle_id: vehicleId ?? null };
  const body = { ...clicked, ...of, ...(inset ?? {}), ...sigma, more_frames: more?.map(frameBody) };
  return api.ask(
    "POST /recordings/{recording_id}/geometry/height",
    { recording_id: recordingId },
    { body, retry: true },
  );
}

/** The frame that would gain most beside those that are clicked, and that of others on the same frame and contact. */
export function askSecondFrame(
  recordingId: number,
  vehicleId: number,
  values: Values,
  others: readonly Values[] = [],
): Promise<SecondFrameAnswer> {
  const beside = others.map((one) => {
    const { frame: _frame, contact: _contact, follow: _follow, ...rest } = clickBody(one);
    return { ...rest, target: one.target };
  });
  const { follow: _follow, ...first } = clickBody(values);
  const body = { ...first, target: values.target, vehicle_id: vehicleId, others: beside };
  return api.ask(
    "POST /recordings/{recording_id}/geometry/second-frame",
    { recording_id: recordingId },
    { body, retry: true },
  );
}

/** The points of a measurement followed through the vehicle's pass; nothing is stored. */
export function askFollow(
  vehicle_id: number,
  values: Values,
  second: ImagePoint | null,
): Promise<FollowedAnswer> {
  const { frame, contact, point, target, inset, sigma_px } = values;
  const sigma = sigma_px === null ? {} : { sigma_px };
  const first = { target, ...frameBody({ frame, contact, point }), ...(inset ?? {}), ...sigma };
  const body = { ...first, second_contact: second ? pair(second) : null };
  return api.ask("POST /vehicles/{vehicle_id}/follow", { vehicle_id }, { body, retry: true });
}

function sameAxes(a: AxesWish, b: AxesWish | null): boolean {
  return (
    b !== null &&
    a.recordingId === b.recordingId &&
    a.target === b.target &&
    a.vehicleId === b.vehicleId &&
    a.side === b.side &&
    samePoint(a.contact, b.contact) &&
    a.inset?.inset_m === b.inset?.inset_m &&
    a.inset?.u_inset_m === b.inset?.u_inset_m
  );
}
