import { useEffect, useState } from "preact/hooks";
import { Checked } from "../Checked";
import { Languages } from "../Languages";
import { language } from "../language";
import { say } from "../say";
import type { Check } from "../verdict";
import { ByHand } from "./ByHand";
import { checked } from "./checks";
import type { Evidence, Held } from "./document";
import { Audit, Budget, Decision, Motion, Rig, Times } from "./Parts";

export function Page({ file }: { file: Held }) {
  const { evidence } = file;
  return (
    <main class="opened">
      <header class="opened__head">
        <Languages />
        <h1 class="opened__title">
          {say("opened-evidence-title", { number: evidence.vehicle.number, scan: evidence.scan.name })}
        </h1>
        <p class="opened__quiet">
          {[evidence.survey.name, evidence.survey.site, vehicleWords(evidence)].filter(Boolean).join(". ")}
        </p>
        <p class="opened__quiet">
          {say("opened-evidence-made", {
            at: evidence.made_at.slice(0, 19).replace("T", " "),
            by: evidence.made_by?.name ?? say("opened-evidence-nobody"),
            version: evidence.program,
          })}
        </p>
      </header>
      <Checks file={file} />
      <Decision evidence={evidence} />
      <ByHand file={file} />
      <Motion evidence={evidence} />
      <Budget measured={evidence.measurement} />
      <Times evidence={evidence} />
      <Rig evidence={evidence} />
      <Audit evidence={evidence} />
      <section class="opened__section">
        <details class="opened__table">
          <summary>{say("opened-evidence-data")}</summary>
          <pre class="evidence__data">{JSON.stringify(file.plain, null, 2)}</pre>
        </details>
      </section>
    </main>
  );
}

function vehicleWords({ vehicle }: Evidence): string {
  return [vehicle.make, vehicle.model].filter(Boolean).join(" ");
}

function Checks({ file }: { file: Held }) {
  const [checks, setChecks] = useState<readonly Check[] | null>(null);
  const spoken = language.value; // what a check says is made when it is checked
  useEffect(() => {
    checked(file)
      .catch((error: unknown) => [failed(error)])
      .then((found) => {
        setChecks(found);
        document.documentElement.dataset["checked"] = "true";
      });
  }, [file, spoken]);
  return (
    <Checked
      checks={checks ?? []}
      ended={checks !== null}
      verdicts={{
        open: say("opened-evidence-checking"),
        wrong: say("opened-evidence-is-wrong"),
        fine: say("opened-evidence-is-fine"),
      }}
    >
      <p>{say("opened-evidence-proves")}</p>
      <details class="opened__about">
        <summary>{say("opened-what-title")}</summary>
        <p>{say("opened-evidence-what-here")}</p>
        <p>{say("opened-evidence-what-verify")}</p>
        <p>{say("opened-evidence-what-page")}</p>
      </details>
    </Checked>
  );
}

function failed(error: unknown): Check {
  const words = error instanceof Error ? error.message : String(error);
  return { name: "failed", state: "wrong", words: say("opened-evidence-failed", { words }) };
}
