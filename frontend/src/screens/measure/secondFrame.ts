/**
 * The same two points on a further frame: proposed by the server, clicked by the operator, stored as one more revision.
 * Until both are clicked nothing is changed, and Esc leaves it so.
 */
import { computed, signal } from "@preact/signals";
import { explain } from "../../core/api";
import { say, sentenceOf } from "../../core/messages";
import { toast } from "../../core/toasts";
import type { FrameForTarget, SecondFrameAnswer, Target } from "../../core/types";
import { TARGET_WORDS } from "../../core/words";
import { askSecondFrame } from "../../viewer/geometry";
import { type ImagePoint, samePoint } from "../../viewer/points";
import { framesOf, ofFrames, pointsOn, type Values } from "../../viewer/values";
import type { ClickTool, Desk } from "./desk";
import type { Role } from "./flow";
import type { Entry } from "./records";

export interface Going {
  readonly key: string;
  readonly target: Target;
  readonly offer: FrameForTarget;
  readonly answer: SecondFrameAnswer;
}

/** Stores a change of a measurement, as a step. */
export type Revise = (key: string, to: Partial<Values>, label: string, preview: Entry["preview"]) => void;

export class SecondFrame implements ClickTool {
  /** The measurement that gets a further frame; null while nothing of the kind is going on. */
  readonly now = signal<Going | null>(null);
  readonly looking = signal(false);
  /** The measurement that was stored or looked at last: the one that the key is meant for. */
  last: string | null = null;
  private readonly clicked = signal<{ frame: number; contact: ImagePoint } | null>(null);
  /** The frames of those that are still to be clicked, by their keys. */
  private readonly offers = new Map<string, FrameForTarget>();
  private asked = 0;
  readonly active = computed(() => this.now.value !== null);

  /** The contact on the frame that is seen: clicked, or that of another measurement on the same tyre. */
  readonly contact = computed<ImagePoint | null>(() => {
    const frame = this.desk.seenFrame.value;
    const clicked = this.clicked.value;
    if (clicked?.frame === frame) return clicked.contact;
    return this.entry ? this.shared(this.entry.values, frame) : null;
  });

  readonly awaiting = computed<Role | null>(() => {
    const entry = this.now.value && this.entry;
    if (!entry || pointsOn(entry.values, this.desk.seenFrame.value)) return null;
    return this.contact.value ? "point" : "contact";
  });

  readonly spots = computed(() =>
    (this.now.value?.offer.spots ?? []).filter((spot) => spot.frame === this.desk.seenFrame.value),
  );

  readonly hint = computed<string | null>(() => {
    const going = this.now.value;
    if (!going) return this.looking.value ? say("measure-second-looking") : null;
    const values = this.entry?.values;
    const nth = 1 + (values ? framesOf(values).length : 1);
    if (this.awaiting.value === null) return say("measure-second-hint", { nth, what: "elsewhere" });
    const what = this.awaiting.value === "contact" ? "contact" : going.target;
    const hint = say("measure-second-hint", { nth, what });
    if (going.answer.source !== "assumed") return hint;
    return say("measure-second-hint-care", { hint, care: sentenceOf(going.answer.words) ?? "" });
  });

  constructor(
    private readonly desk: Desk,
    private readonly revise: Revise,
  ) {}

  private get entry(): Entry | undefined {
    const going = this.now.value;
    return going ? this.desk.entries.value.find((entry) => entry.key === going.key) : undefined;
  }

  /**
   * Looks for the frame that gains most beside those clicked, one for all of the vehicle where one shows them all,
   * and goes there. A target that no frame helps is said to have none, and is not asked for.
   */
  async start(key = this.meant()): Promise<void> {
    const entry = key === null ? undefined : this.desk.records.find(key);
    const recordingId = this.desk.reel.player.value?.recordingId;
    if (!entry || recordingId === undefined) {
      toast(say("measure-second-nothing-yet"));
      return;
    }
    this.leave();
    this.asked += 1;
    const turn = this.asked;
    this.looking.value = true;
    const others = this.fewer(entry, framesOf(entry.values).length + 1);
    const values = others.map((other) => other.values);
    try {
      const answer = await askSecondFrame(recordingId, entry.vehicleId, entry.values, values);
      if (turn !== this.asked || this.desk.vehicleId.value !== entry.vehicleId) return;
      const offers = [entry, ...others].map(({ key }, i) => ({ key, offer: [answer, ...answer.others][i] }));
      for (const { key, offer } of offers) if (offer?.ok) this.offers.set(key, offer);
      const none = offers.flatMap(({ offer }) => (offer && !offer.ok ? [noFrame(offer)] : []));
      if (none.length > 0) toast(none.join(" "));
      this.goOn(answer, entry);
    } catch (error) {
      if (turn === this.asked) toast(explain(error), { kind: "problem" });
    } finally {
      if (turn === this.asked) this.looking.value = false;
    }
  }

  /** The next to be clicked: `entry` itself, else those on the frame that is seen, in their order. */
  private goOn(answer: SecondFrameAnswer, entry: Entry, stay = false): void {
    const seen = this.desk.seenFrame.value;
    const left = [entry, ...this.together(entry)].filter(({ key }) => this.offers.has(key));
    const frameOf = (key: string): number | null => {
      const offer = this.offers.get(key);
      return stay && offer?.spots.some((spot) => spot.frame === seen) ? seen : (offer?.frame ?? null);
    };
    const next = left.find(({ key }) => key === entry.key || frameOf(key) === seen) ?? left[0];
    const offer = next && this.offers.get(next.key);
    const frame = next && frameOf(next.key);
    if (!next || !offer || frame === null || frame === undefined) {
      this.offers.clear();
      this.clicked.value = null;
      return;
    }
    this.desk.dispatch({ type: "select", selection: null });
    this.now.value = { key: next.key, target: next.values.target, offer, answer };
    if (frame === seen) return;
    this.desk.geometry.forgetHeight();
    this.desk.reel.player.value?.stop();
    this.desk.reel.player.value?.go(frame);
    this.desk.stage.focus();
  }

  leave(): void {
    this.asked += 1;
    this.looking.value = false;
    this.offers.clear();
    if (!this.now.value) return;
    const first = this.entry?.values.frame;
    this.now.value = null;
    this.clicked.value = null;
    this.desk.geometry.forgetHeight();
    if (first !== undefined) this.desk.reel.player.value?.go(first);
  }

  forget(): void {
    this.now.value = null;
    this.clicked.value = null;
    this.looking.value = false;
    this.offers.clear();
    this.last = null;
    this.asked += 1;
  }

  /** Esc: nothing has happened. */
  cancel(): boolean {
    if (!this.now.value) return false;
    this.leave();
    return true;
  }

  /** Ctrl+Z before both are clicked. False if nothing of this is going on. */
  back(): boolean {
    if (!this.now.value) return false;
    if (this.clicked.value) this.clicked.value = null;
    else this.leave();
    return true;
  }

  /** A click on the frame. False if it is not meant for a further frame. */
  place(point: ImagePoint): boolean {
    const going = this.now.value;
    const entry = this.entry;
    if (!going || !entry) return false;
    const frame = this.desk.seenFrame.value;
    const contact = this.contact.value;
    if (this.awaiting.value === null) toast(say("measure-second-clicked-already"));
    else if (!contact) this.clicked.value = { frame, contact: point };
    else this.store(entry, frame, contact, point);
    return true;
  }

  /** The height with all frames, under the pointer. False if nothing of this is going on. */
  hover(point: ImagePoint | null): boolean {
    const going = this.now.value;
    if (!going) return false;
    const { geometry, reel, seenFrame } = this.desk;
    const values = this.entry?.values;
    const contact = this.contact.value;
    const recordingId = reel.player.value?.recordingId;
    const atPoint = point && this.awaiting.value === "point" && !this.desk.snapping.isAtContact(point);
    if (!atPoint || !values || !contact || recordingId === undefined) {
      geometry.forgetHeight();
      return true;
    }
    const more = [...values.more, { frame: seenFrame.value, contact, point }];
    geometry.wantHeight({ recordingId, vehicleId: this.desk.vehicleId.value, ...values, more });
    return true;
  }

  private store(entry: Entry, frame: number, contact: ImagePoint, point: ImagePoint): void {
    const more = [...entry.values.more, { frame, contact, point }];
    const live = this.desk.geometry.live.value;
    const fits = live && samePoint(live.wish.more?.at(-1)?.point ?? null, point);
    const going = this.now.value;
    this.now.value = null;
    this.desk.geometry.forgetHeight();
    this.revise(
      entry.key,
      // a further frame is clicked on its own: what was followed goes
      { more, follow: undefined },
      say("measure-step-frame", { nth: more.length + 1 }),
      fits ? (live.answer ?? null) : null,
    );
    this.last = entry.key;
    this.offers.delete(entry.key);
    // on the frame of the one before the contact stands, so that the next is one click; a frame that somebody
    // chose by hand is gone on with where it shows the next too
    if (going) this.goOn(going.answer, entry, frame !== going.offer.frame);
  }

  /** The others that stand on the same tyre contact and on fewer frames than so many. */
  private fewer(entry: Entry, frames: number): Entry[] {
    return this.together(entry).filter(
      ({ key, values }) => key !== entry.key && framesOf(values).length < frames,
    );
  }

  /** The measurements on the same frame and tyre contact, itself among them, in the order in which they are asked for. */
  private together(entry: Entry): Entry[] {
    const asked = this.desk.asked();
    const place = ({ values }: Entry) => {
      const at = asked.indexOf(values.target);
      return at < 0 ? asked.length : at;
    };
    return this.desk.entries.value
      .filter(
        ({ key, values, state }) =>
          key === entry.key ||
          (state !== "conflict" &&
            !values.withdrawn &&
            values.frame === entry.values.frame &&
            samePoint(values.contact, entry.values.contact)),
      )
      .sort((a, b) => place(a) - place(b));
  }

  /** Takes one frame away from a measurement; the next one becomes its first where that goes. */
  remove(key: string, frame: number): void {
    const entry = this.desk.records.find(key);
    const rest = entry ? framesOf(entry.values).filter((one) => one.frame !== frame) : [];
    if (!entry || rest.length === 0) return;
    const gone = { frame: String(frame) };
    this.revise(key, ofFrames(rest), say("measure-step-frame-removal", gone), null);
    toast(say("measure-frame-removed", { ...gone, count: rest.length }));
  }

  /** Del on a point of a further frame. False where the measurement stands on the frame that is seen. */
  removeHere(key: string): boolean {
    const entry = this.desk.records.find(key);
    const frame = this.desk.seenFrame.value;
    if (!entry?.values.more.some((one) => one.frame === frame)) return false;
    this.desk.dispatch({ type: "select", selection: null });
    this.remove(key, frame);
    return true;
  }

  /** Of those on fewest frames that go with the selected measurement, or the last: the selected one, else the first. */
  private meant(): string | null {
    const { flow, entries } = this.desk;
    const standing = entries.value.filter((entry) => !entry.values.withdrawn);
    const known = (key: string | null | undefined) => standing.find((entry) => entry.key === key);
    const selected = known(flow.value.selection?.key);
    const from = selected ?? known(this.last) ?? standing.at(-1);
    if (!from) return null;
    const all = this.together(from);
    const fewest = Math.min(...all.map((entry) => framesOf(entry.values).length));
    const few = all.filter((entry) => framesOf(entry.values).length === fewest);
    return (few.find((entry) => entry === selected) ?? few[0] ?? from).key;
  }

  /** A contact on this frame of a measurement that stands on the same tyre contact in the first frame. */
  private shared(values: Values, frame: number): ImagePoint | null {
    for (const other of this.desk.entries.value) {
      if (other.values.withdrawn || other.values.frame !== values.frame) continue;
      if (!samePoint(other.values.contact, values.contact)) continue;
      const there = other.values.more.find((one) => one.frame === frame);
      if (there) return there.contact;
    }
    return null;
  }
}

function noFrame({ target, reason }: FrameForTarget): string {
  return say("measure-second-none", {
    target: TARGET_WORDS[target],
    reason: reason ? sentenceOf(reason) : say("measure-second-no-use"),
  });
}
