/** The points of a measurement moved by its reviewer: dragged, or chosen and nudged; Enter saves them, Esc leaves them. */
import { computed, signal } from "@preact/signals";
import { keyMap, showChord } from "../../core/commands";
import { say } from "../../core/messages";
import { toast } from "../../core/toasts";
import type { Measurement } from "../../core/types";
import { fromServer, type ImagePoint, imagePoint, samePoint } from "../../viewer/points";
import type { DragPhase, Handle, Tool } from "../../viewer/tool";
import { insetOf, valuesOf } from "../../viewer/values";

export interface Fix {
  readonly contact: ImagePoint;
  readonly point: ImagePoint;
  readonly selected: "contact" | "point";
}

type Role = Fix["selected"];

export interface FixHost {
  differs(fix: Fix): boolean;
  /** The points are others now, or there is no fix any more. */
  moved(fix: Fix | null): void;
  save(): void;
}

export class FixTool implements Tool<ImagePoint> {
  readonly fix = signal<Fix | null>(null);
  readonly hint = computed(() => (this.fix.value ? fixHint() : null));
  readonly handles = computed<readonly Handle<ImagePoint>[]>(() => {
    const fix = this.fix.value;
    if (!fix) return [];
    return [
      { id: "point", at: fix.point },
      { id: "contact", at: fix.contact },
    ];
  });
  private beforeDrag: Fix | null = null;

  constructor(private readonly host: FixHost) {}

  begin(contact: ImagePoint, point: ImagePoint): void {
    this.fix.value = { contact, point, selected: "point" };
  }

  leave(): void {
    this.beforeDrag = null;
    this.fix.value = null;
  }

  pick(handle: string): void {
    const fix = this.fix.value;
    if (fix) this.fix.value = { ...fix, selected: handle as Role };
  }

  selectNext(): boolean {
    const fix = this.fix.value;
    if (fix) this.pick(fix.selected === "point" ? "contact" : "point");
    return fix !== null;
  }

  drag(handle: string, at: ImagePoint, phase: DragPhase): void {
    const fix = this.fix.value;
    if (!fix) return;
    this.beforeDrag ??= fix;
    if (phase === "cancel") this.put(this.beforeDrag);
    else this.move(handle as Role, at);
    if (phase !== "move") this.beforeDrag = null;
  }

  nudge(dx: number, dy: number): boolean {
    const fix = this.fix.value;
    if (!fix) return false;
    const at = fix[fix.selected];
    this.move(fix.selected, imagePoint(at[0] + dx, at[1] + dy));
    return true;
  }

  /** A fix that changes nothing is none: it would be a new revision, and its verdict would say that something was wrong. */
  readonly differs = computed(() => this.fix.value !== null && this.host.differs(this.fix.value));

  confirm(): boolean {
    if (!this.fix.value) return false;
    if (this.differs.value) this.host.save();
    else toast(say("review-fix-nothing"));
    return true;
  }

  cancel(): boolean {
    if (!this.fix.value) return false;
    this.leave();
    this.host.moved(null);
    return true;
  }

  private move(role: Role, to: ImagePoint): void {
    const fix = this.fix.value;
    if (fix) this.put({ ...fix, [role]: to, selected: role });
  }

  private put(fix: Fix): void {
    this.fix.value = fix;
    this.host.moved(fix);
  }
}

/** The key is the one that the map has now. */
function fixHint(): string {
  return say("review-fix-hint", { key: showChord(keyMap.value.selectNext[0] ?? "Tab") });
}

/** Whether a fix puts the points elsewhere than they stand. */
export function isMoved(m: Measurement, { contact, point }: Fix): boolean {
  return !samePoint(contact, fromServer(m.contact)) || !samePoint(point, fromServer(m.target_point));
}

/** The clicks whose height is asked for: those of a measurement, with the points of a fix. */
export function clicksOf(m: Measurement, { contact, point }: Fix) {
  const { recording_id: recordingId, vehicle_id: vehicleId, target, frame, sigma_px } = m;
  const { more } = valuesOf(m);
  return { recordingId, vehicleId, target, frame, contact, point, inset: insetOf(m), sigma_px, more };
}
