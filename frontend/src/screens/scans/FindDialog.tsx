/** Which method looks for the vehicles, and whether those that are known are measured again. */
import { useState } from "preact/hooks";
import { choices, FormDialog, Segments } from "../../components";
import { say, wordsOf } from "../../core/messages";
import type { Scan, ScanMethod } from "../../core/types";
import type { ScanModel } from "./model";

export function FindDialog({ model, scan, onClose }: { model: ScanModel; scan: Scan; onClose: () => void }) {
  const [method, setMethod] = useState<ScanMethod>(scan.run?.method ?? "direct");
  const [search, setSearch] = useState<"search" | "again">("search");
  const known = scan.counts.vehicles > 0;
  const submit = async (): Promise<void> => {
    onClose();
    await model.search.find(method, search === "search");
  };
  return (
    <FormDialog
      says="scan-find-title"
      action={say(search === "search" ? "scan-find-and-measure" : "scan-find-again")}
      onClose={onClose}
      submit={submit}
    >
      <Segments
        says="scan-find-method"
        value={method}
        options={choices(wordsOf("scan-find-", "direct", "paper"))}
        onInput={setMethod}
      />
      <p class="small muted">{say(method === "direct" ? "scan-find-direct-what" : "scan-find-paper-what")}</p>
      {known && (
        <Segments
          says="scan-find-what"
          value={search}
          options={[
            { value: "search", label: say("scan-find-all") },
            { value: "again", label: say("scan-find-known") },
          ]}
          onInput={setSearch}
        />
      )}
      <p class="small muted">{say("scan-find-note")}</p>
    </FormDialog>
  );
}
