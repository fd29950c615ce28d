/** The models taken last, in this browser: one digit takes one, and the frame keeps the keys. */
import { api } from "../../core/api";
import { keyMap, showChord, useCommands } from "../../core/commands";
import { say } from "../../core/messages";
import { stored } from "../../core/stored";
import { telling, toast } from "../../core/toasts";
import type { CatalogueRow } from "../../core/types";

type RecentModel = Pick<CatalogueRow, "id" | "make" | "model">;

const KEYS = ["recentModel1", "recentModel2", "recentModel3", "recentModel4"] as const;

const recentModels = stored<readonly RecentModel[]>("models.recent", [], Array.isArray);

/** A model keeps its digit while it is among the last; a new one comes first. */
export function noteModel({ id, make, model }: CatalogueRow): void {
  const now = recentModels.value;
  if (now.some((one) => one.id === id)) return;
  recentModels.value = [{ id, make, model }, ...now].slice(0, KEYS.length);
}

interface Props {
  locked: boolean;
  onChoose(row: CatalogueRow): void;
  toMake(): void;
}

export function RecentModels({ locked, onChoose, toMake }: Props) {
  const rows = recentModels.value;
  // the sizes are those that the catalogue has now
  const choose = async ({ id, make, model }: RecentModel): Promise<void> => {
    const name = { model: `${make} ${model}` };
    await telling(async () => {
      const found = (await api.ask("GET /catalogue", { q: name.model })).find((one) => one.id === id);
      if (found) {
        onChoose(found);
        toast(say("recent-models-taken", name));
      } else {
        recentModels.value = recentModels.value.filter((one) => one.id !== id);
        toast(say("recent-models-gone", name), { kind: "problem" });
      }
    });
  };
  useCommands([
    { id: "record", run: toMake, enabled: () => !locked },
    ...KEYS.map((id, i) => {
      const row = rows[i];
      return { id, run: () => (row ? void choose(row) : false), enabled: () => !locked };
    }),
  ]);
  if (rows.length === 0) return null;
  return (
    <section class="which-model" aria-label={say("recent-models-title")}>
      <h4 class="row row--base">{say("recent-models-title")}</h4>
      {rows.map((row, i) => (
        <button
          key={row.id}
          type="button"
          class="which-model__row which-model__row--button"
          disabled={locked}
          onClick={(event) => {
            event.currentTarget.blur();
            void choose(row);
          }}
        >
          <kbd>{showChord(keyMap.value[KEYS[i] ?? "recentModel1"][0] ?? "")}</kbd>
          <span>
            <strong>{row.make}</strong> {row.model}
          </span>
        </button>
      ))}
    </section>
  );
}
