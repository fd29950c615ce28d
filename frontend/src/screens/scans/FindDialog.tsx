/** Which method looks for the vehicles, and whether those that are known are measured again. */
import { useState } from "preact/hooks";
import { FormDialog, Segments } from "../../components";
import type { Scan, ScanMethod } from "../../core/types";
import type { ScanModel } from "./model";

interface Props {
  model: ScanModel;
  scan: Scan;
  onClose: () => void;
}

export function FindDialog({ model, scan, onClose }: Props) {
  const [method, setMethod] = useState<ScanMethod>(scan.run?.method ?? "direct");
  const [search, setSearch] = useState<"search" | "again">("search");
  const known = scan.counts.vehicles > 0;
  const submit = async (): Promise<void> => {
    onClose();
    await model.find(method, search === "search");
  };
  return (
    <FormDialog
      title="Find the vehicles"
      action={search === "search" ? "Find and measure" : "Measure again"}
      onClose={onClose}
      submit={submit}
    >
      <Segments
        label="Method"
        value={method}
        options={[
          { value: "direct", label: "Direct registration" },
          { value: "paper", label: "The paper’s method" },
        ]}
        onChange={setMethod}
      />
      <p class="small muted">
        {method === "direct"
          ? "Both strips of a vehicle are laid over each other as a whole: speed, acceleration and the cameras' misalignment in one fit. The default."
          : "Block matching and a linear regression, as Douxchamps, Macq and Chihara published it; to compare with."}
      </p>
      {known && (
        <Segments
          label="What"
          value={search}
          options={[
            { value: "search", label: "Look through the whole recording" },
            { value: "again", label: "Measure the known vehicles again" },
          ]}
          onChange={setSearch}
        />
      )}
      <p class="small muted">
        Boundaries that somebody placed stay, and so does what was taken out. Every result is a revision of
        its own; accepted ones that change are to be reviewed again.
      </p>
    </FormDialog>
  );
}
