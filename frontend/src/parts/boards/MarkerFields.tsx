/** Which kind of board, and the markers of one that has them. */
import { choices, Segments, SelectField, TextField } from "../../components";
import { wordsOf } from "../../core/messages";
import { type BoardKind, DICTIONARIES, type TypedMarkers } from "./markers";
import "./markers.css";
import { fieldsOf } from "../../core/form";

interface Props {
  value: TypedMarkers;
  unit: string;
  problem: string | null;
  change: (part: Partial<TypedMarkers>) => void;
  disabled?: boolean;
}

export function KindField({ value, change, disabled }: Pick<Props, "value" | "change" | "disabled">) {
  return (
    <Segments<BoardKind>
      says="board-kind"
      value={value.kind}
      options={choices(wordsOf("board-", "checkerboard", "charuco"))}
      onInput={(kind) => change({ kind })}
      disabled={disabled}
    />
  );
}

export function MarkerFields({ value, unit, problem, change }: Props) {
  if (value.kind === "checkerboard") return null;
  const field = fieldsOf(value, change);
  return (
    <div class="grid markers">
      <SelectField
        says="board-dictionary"
        {...field("dictionary")}
        options={DICTIONARIES.map((name) => ({ value: name, label: name }))}
      />
      <TextField says="board-marker" unit={unit} {...field("marker")} problem={problem} />
    </div>
  );
}
