/** What a person changes of the vehicles of a line scan, each as a step that can be taken back. */
import type { Ledger } from "../../core/history";
import { say } from "../../core/messages";
import { outbox } from "../../core/outbox";
import { newKey } from "../../core/random";
import { may } from "../../core/session";
import { toast } from "../../core/toasts";
import type { ScanVehicle } from "../../core/types";
import { fixed } from "../../core/units";
import type { Strips } from "./bench";
import { ADDED } from "./kinds";
import type { Part, ScannedVehicles } from "./scanned";
import type { Facts, ScannedWanted } from "./wanted";

const STEPS = { hubs: "scan-step-wheels", axles: "scan-step-axles", lane: "scan-step-lane" } as const;

export class VehicleEdits {
  constructor(
    private readonly bench: Strips,
    private readonly scanned: ScannedVehicles,
  ) {}

  /** A part of what a person says of the chosen vehicle; null: as the program finds it. */
  async store<P extends Part>(part: P, said: ScannedWanted[P] | null): Promise<void> {
    const vehicle = this.bench.chosen.value;
    if (!vehicle?.measurement) return;
    await this.bench.change(say(STEPS[part as Part], { vehicle: String(vehicle.number) }), (changes) =>
      changes.write(this.scanned.parts[part], vehicle.id, said),
    );
  }

  async fillIn(facts: Facts): Promise<void> {
    const vehicle = this.bench.chosen.value;
    if (!vehicle) return;
    await this.bench.change(say("scan-step-known", { vehicle: String(vehicle.number) }), async (changes) => {
      changes.touch(this.scanned.facts, { id: vehicle.id, names: Object.keys(facts) as (keyof Facts)[] });
      await this.scanned.want(vehicle.id, { facts });
    });
  }

  async remove(): Promise<void> {
    const vehicle = this.bench.chosen.value;
    if (!vehicle || !may("operator")) return;
    const named = { vehicle: String(vehicle.number) };
    await this.bench.change(say("scan-step-take-out", named), async (changes) => {
      await changes.write(this.presence, vehicle.id, false);
      toast(say("scan-taken-out", named));
    });
  }

  async addVehicle(front: number, rear: number): Promise<void> {
    const before = this.bench.chosenId.value;
    await this.bench.tell(async () => {
      const added = await outbox.store<ScanVehicle, unknown, { scanId: number }>({
        key: newKey(),
        kind: ADDED,
        lane: `scan.${this.bench.id}`,
        about: { scanId: this.bench.id },
        what: say("scan-wish-a-vehicle"),
        mine: say("scan-wish-lines", { front: fixed(front, 1), rear: fixed(rear, 1) }),
        page: this.bench.page(),
        saved: null,
        want: { front_line_1: front, rear_line_1: rear },
      });
      const made = added?.saved;
      if (!made) toast(say("scan-kept-vehicle"));
      else
        await this.bench.history.run(
          say("scan-step-vehicle", { vehicle: String(made.number) }),
          async (changes) => {
            changes.touch(this.presence, made.id);
            await this.scanned.load();
            this.chooseUnless(made.id, before);
          },
        );
    });
  }

  private readonly presence: Ledger<number, boolean> = {
    read: (id) => this.scanned.all.value.some((one) => one.id === id),
    write: (id, there) => this.putThere(id, there),
  };

  private async putThere(id: number, there: boolean): Promise<void> {
    const before = this.bench.chosenId.value;
    await this.scanned.want(id, { there });
    if (there && this.scanned.numberOf(id) > 0) this.chooseUnless(id, before);
    else if (this.bench.chosenId.value === id) this.bench.choose(null);
  }

  /** What was chosen or taken up while something was stored stays. */
  private chooseUnless(id: number, before: number | null): void {
    if (this.bench.chosenId.value === before && this.bench.mode.value === "look") this.bench.choose(id);
  }
}
