/** What can be done with the pass that is open: confirm, split, join, discard. By menu and by key. */
import { Icon, Menu } from "../../../components";
import { hint, useKeys } from "../../../core/commands";
import { canWork } from "../../../core/session";
import { isUnconfirmed, lightingProposed } from "../../../parts/vehicles/passes";
import type { MeasureModel } from "../model";
import { confirmPass, joinPass, splitPass } from "./actions";

export function PassMenu({ model }: { model: MeasureModel }) {
  const may = (work: () => void) => () => {
    if (canWork.value) work();
  };
  useKeys({
    passSplit: may(() => void splitPass(model)),
    passJoin: may(() => void joinPass(model)),
    passDiscard: may(() => void model.removePass()),
  });
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
      <button type="button" class="menu__item" onClick={() => void splitPass(model)}>
        Split before this frame{hint("passSplit")}
      </button>
      <button type="button" class="menu__item" onClick={() => void joinPass(model)}>
        Join with the next pass{hint("passJoin")}
      </button>
      <button type="button" class="menu__item" onClick={() => void model.removePass()}>
        Discard the pass{hint("passDiscard")}
      </button>
    </Menu>
  );
}
