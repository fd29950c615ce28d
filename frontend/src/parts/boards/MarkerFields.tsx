/** Which kind of board, and the markers of one that has them. */
import { Segments, SelectField, TextField } from "../../components";
import { type BoardKind, DICTIONARIES, type TypedMarkers } from "./markers";
import "./markers.css";

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
      label="Kind of board"
      value={value.kind}
      options={[
        { value: "checkerboard", label: "Checkerboard" },
        { value: "charuco", label: "ChArUco" },
      ]}
      onChange={(kind) => change({ kind })}
      disabled={disabled}
    />
  );
}

export function MarkerFields({ value, unit, problem, change }: Props) {
  if (value.kind === "checkerboard") return null;
  return (
    <div class="markers">
      <SelectField
        label="Dictionary"
        value={value.dictionary}
        options={DICTIONARIES.map((name) => ({ value: name, label: name }))}
        onChange={(dictionary) => change({ dictionary })}
      />
      <TextField
        label="Marker’s side"
        numeric
        unit={unit}
        value={value.marker}
        onInput={(marker) => change({ marker })}
        problem={problem}
      />
    </div>
  );
}
