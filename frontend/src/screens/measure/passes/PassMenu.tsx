/** What can be done with the pass that is open: confirm, split, join, discard. By menu and by key. */
import { Icon, Menu } from "../../../components";
import { type ButtonCommand, CommandItem } from "../../../components/CommandButton";
import { useCommands } from "../../../core/commands";
import { say } from "../../../core/messages";
import { canWork } from "../../../core/session";
import { isUnconfirmed, lightingProposed } from "../../../parts/vehicles/passes";
import type { MeasureModel } from "../model";
import { confirmPass, joinPass, splitPass } from "./actions";

export function PassMenu({ model }: { model: MeasureModel }) {
  const enabled = (): boolean => canWork.value;
  const commands: ButtonCommand[] = [
    { id: "passSplit", label: say("measure-pass-split"), run: () => void splitPass(model), enabled },
    { id: "passJoin", label: say("measure-pass-join"), run: () => void joinPass(model), enabled },
    { id: "passDiscard", run: () => void model.passes.remove(), enabled },
  ];
  useCommands(commands);
  const vehicle = model.vehicle.value;
  if (!vehicle) return null;
  const proposed = isUnconfirmed(vehicle) ? lightingProposed(vehicle) : null;
  return (
    <Menu
      button={<Icon name="chevron" />}
      label={say("measure-pass-menu", { vehicle: String(vehicle.number) })}
      class="btn btn--quiet btn--small pass-menu"
    >
      {proposed && (
        <button type="button" class="row menu__item" onClick={() => confirmPass(model)}>
          {say("measure-pass-confirm", { lighting: proposed })}
        </button>
      )}
      {commands.map((command) => (
        <CommandItem key={command.id} command={command} />
      ))}
    </Menu>
  );
}
