/** Heights of measurements while their points move: asked of the server, shown until the points rest. */
import { Latest } from "../../core/latest";
import type { HeightAnswer } from "../../core/types";
import { askHeight, type HeightWish } from "../../viewer/geometry";
import type { Desk } from "./desk";

type Preview = { key: string; wish: HeightWish };

export class Previews {
  private readonly asker = new Latest<readonly Preview[], [string, HeightAnswer][]>(
    (wishes) =>
      Promise.all(
        wishes.map(async ({ key, wish }) => [key, await askHeight(wish)] as [string, HeightAnswer]),
      ),
    (answers) => {
      for (const [key, preview] of answers) {
        if (this.desk.records.find(key)?.state === "moving") this.desk.records.show(key, {}, preview);
      }
    },
  );

  constructor(private readonly desk: Desk) {}

  want(keys: Iterable<string>): void {
    const recordingId = this.desk.reel.player.value?.recordingId;
    if (recordingId === undefined || !this.desk.hasPose.value) return;
    const wishes = [...keys].flatMap((key): Preview[] => {
      const values = this.desk.records.find(key)?.values;
      return values ? [{ key, wish: { recordingId, vehicleId: this.desk.vehicleId.value, ...values } }] : [];
    });
    if (wishes.length > 0) this.asker.want(wishes);
  }
}
