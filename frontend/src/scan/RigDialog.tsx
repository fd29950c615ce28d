/** The rig's values can be corrected; results keep those that they were made with until they are measured again. */
import { useState } from "preact/hooks";
import { api } from "../api";
import { FormDialog, TextField } from "../components";
import { toast } from "../state/toasts";
import type { Scan } from "../types";
import type { ScanModel } from "./model";
import { RigFields } from "./RigFields";
import { isValues, type RigTyped, typedOf, valuesOf } from "./rig";

interface Props {
  model: ScanModel;
  scan: Scan;
  onClose: () => void;
}

export function RigDialog({ model, scan, onClose }: Props) {
  const [typed, setTyped] = useState<RigTyped>(() => typedOf(scan));
  const [name, setName] = useState(scan.name);
  const [problems, setProblems] = useState<Partial<Record<keyof RigTyped, string>>>({});
  const submit = (): Promise<void> | null => {
    const values = valuesOf(typed);
    if (!isValues(values)) {
      setProblems(values);
      return null;
    }
    return store({ ...values, ...(name.trim() ? { name: name.trim() } : {}) });
  };
  const store = async (values: object): Promise<void> => {
    const changed = await api.patch<Scan>(`/scans/${scan.id}`, { ...values, version: scan.version });
    model.take(changed);
    await model.refresh();
    onClose();
    if (changed.counts.older > 0)
      toast("The rig has other values now; find the vehicles again to bring the results up.");
  };
  return (
    <FormDialog title="The rig" action="Store" onClose={onClose} submit={submit}>
      <TextField label="Name" value={name} onInput={setName} />
      <RigFields
        typed={typed}
        problems={problems}
        noRate={scan.source === "video"}
        change={(part) => {
          setTyped({ ...typed, ...part });
          setProblems({});
        }}
      />
      <p class="small muted">
        What was measured keeps the values that it was measured with, and says so, until it is measured again.
      </p>
    </FormDialog>
  );
}
