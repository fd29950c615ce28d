/** What can be done with the pass that is open: confirm, split, join, discard. By menu and by key. */
import { Icon, Menu } from "../../../components";
import { type ButtonCommand, CommandItem } from "../../../components/CommandButton";
import { useCommands } from "../../../core/commands";
import { canWork } from "../../../core/session";
import { isUnconfirmed, lightingProposed } from "../../../parts/vehicles/passes";
import type { MeasureModel } from "../model";
import { confirmPass, joinPass, splitPass } from "./actions";

export function PassMenu({ model }: { model: MeasureModel }) {
  const enabled = (): boolean => canWork.value;
  const commands: ButtonCommand[] = [
    { id: "passSplit", label: "Split before this frame", run: () => void splitPass(model), enabled },
    { id: "passJoin", label: "Join with the next pass", run: () => void joinPass(model), enabled },
    { id: "passDiscard", run: () => void model.removePass(), enabled },
  ];
  useCommands(commands);
  const vehicle = model.vehicle.value;
  if (!vehicle) return null;
  const proposed = isUnconfirmed(vehicle) ? lightingProposed(vehicle) : null;
  return (
    <Menu
      button={<Icon name="chevron" />}
      label={`Vehicle ${vehicle.number}: split, join, discard`}
      class="btn btn--quiet btn--small pass-menu"
    >
      {proposed && (
        <button type="button" class="menu__item" onClick={() => confirmPass(model)}>
          Confirm: {proposed === "daytime" ? "daytime" : "low light"}
        </button>
      )}
      {commands.map((command) => (
        <CommandItem key={command.id} command={command} />
      ))}
    </Menu>
  );
}
