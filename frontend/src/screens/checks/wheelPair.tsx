/** Both tyres of one side, clicked on one frame: the first, then the second. */
import { computed, signal } from "@preact/signals";
import { say } from "../../core/messages";
import type { NewWheelPair } from "../../core/types";
import { InImage, Line, PointMark } from "../../viewer/Overlay";
import { type ImagePoint, pair } from "../../viewer/points";
import type { Reel } from "../../viewer/reel";
import type { FrameStage } from "../../viewer/stage";
import type { Tool } from "../../viewer/tool";

export type Clicks = Readonly<Omit<NewWheelPair, "seen">>;

export interface Traffic {
  readonly stage: FrameStage;
  readonly reel: Reel;
  mayClick(): boolean;
  /** The first click is made, or both are. */
  begun(): void;
  clicked(clicks: Clicks): void;
}

export class WheelPairTool implements Tool<ImagePoint> {
  private readonly clicked = signal<{ frame: number; at: ImagePoint } | null>(null);
  /** The first tyre, while the second is still to be clicked: on the same frame, for on the next the vehicle has moved. */
  readonly first = computed(() =>
    this.clicked.value?.frame === this.traffic.reel.seen.value ? this.clicked.value : null,
  );
  readonly placing = computed(() => this.traffic.mayClick());
  readonly hint = computed(() => {
    if (this.first.value) return say("checks-second-tyre");
    return this.placing.value ? say("checks-first-tyre") : null;
  });

  constructor(private readonly traffic: Traffic) {}

  place(at: ImagePoint): boolean {
    const { reel } = this.traffic;
    const frame = reel.seen.value;
    if (!this.placing.value || frame === null) return false;
    this.traffic.begun();
    if (this.first.value === null) this.clicked.value = { frame, at };
    else {
      const clicks = { frame, first: pair(this.first.value.at), second: pair(at) };
      const frame_crc32 = reel.player.value?.checksumOf(frame);
      this.traffic.clicked(frame_crc32 === undefined ? clicks : { ...clicks, frame_crc32 });
    }
    return true;
  }

  back(): boolean {
    const begun = this.first.value !== null;
    this.clicked.value = null;
    return begun;
  }

  cancel(): boolean {
    return this.back();
  }

  layers() {
    const { stage } = this.traffic;
    const first = this.first.value;
    if (!first) return null;
    return (
      <>
        {stage.pointer.value && (
          <InImage stage={stage}>
            <Line points={[pair(first.at), pair(stage.pointer.value)]} kind="guide" />
          </InImage>
        )}
        <PointMark stage={stage} at={first.at} kind="contact" text="1" selected />
      </>
    );
  }
}
