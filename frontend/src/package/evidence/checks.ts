/** What the page checks of its own file: hashes always, the signature where the browser has Ed25519. */
import { canonical, type Json } from "../canonical";
import { handedOn, holds } from "../chain";
import { say } from "../say";
import { sha256 } from "../sha256";
import { type Check, check, leftOpen } from "../verdict";
import type { AuditEvent, Evidence, Held } from "./document";

const SIGNS_OF_KEY = 16;

export async function checked(file: Held): Promise<Check[]> {
  return [
    ofText(file),
    ofPictures(file),
    ofEvents(file.evidence),
    ofMeasurement(file.evidence),
    await ofSignature(file),
  ];
}

function ofText({ text, plain }: Held): Check {
  const same = canonical(plain).replaceAll("<", "\\u003c") === text;
  return check("text", same, same ? say("opened-evidence-text-fine") : say("opened-evidence-text-wrong"));
}

function ofPictures({ evidence, pictures }: Held): Check {
  const wrong = evidence.pictures
    .filter((one) => sha256(bytesOf(pictures.get(one.name) ?? "")) !== one.sha256)
    .map((one) => one.name);
  const whole = wrong.length === 0 && evidence.pictures.length === 2 && pictures.size === 2;
  return check(
    "pictures",
    whole,
    whole
      ? say("opened-evidence-pictures-fine")
      : say("opened-evidence-pictures-wrong", { named: wrong.join(", ") }),
  );
}

function bytesOf(base64: string): Uint8Array {
  return Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
}

function ofEvents({ audit }: Evidence): Check {
  const wrong = audit.events.filter((one) => !isHashed(one) || one.chain !== audit.chain);
  const count = audit.events.length;
  if (wrong.length === 0) return check("events", true, say("opened-evidence-events-fine", { count }));
  const named = wrong.map((one) => one.number).join(", ");
  return check("events", false, say("opened-evidence-events-wrong", { named }));
}

function isHashed({ previous_hash, hash, ...content }: AuditEvent): boolean {
  return hash === sha256(previous_hash + sha256(canonical(content as Json)));
}

/** The motion is the one that its audit event tells. */
function ofMeasurement({ audit, measurement }: Evidence): Check {
  const own = audit.events.find(
    (one) => one.entity === "scan_measurement" && one.entity_id === measurement.id,
  );
  const told = JSON.parse(own?.after ?? "{}") as Record<string, Json>;
  const values = measurement as unknown as Record<string, Json>;
  const named = Object.keys(told).filter(
    (name) => name in values && canonical(told[name] ?? null) !== canonical(values[name] ?? null),
  );
  if (own && named.length === 0) return check("measurement", true, say("opened-evidence-event-fine"));
  return check("measurement", false, say("opened-evidence-event-wrong", { named: named.join(", ") }));
}

async function ofSignature({ plain, evidence, signature }: Held): Promise<Check> {
  const key = evidence.key.slice(0, SIGNS_OF_KEY);
  try {
    const own = await holds(plain, Object.keys(plain), evidence.key, signature);
    const fine = own && (await handedOn(evidence.keys, evidence.key));
    const words = fine
      ? say("opened-evidence-signature-holds", { key })
      : say("opened-evidence-signature-wrong", { key });
    return check("signature", fine, words);
  } catch {
    return leftOpen("signature", say("opened-evidence-signature-unknown"));
  }
}
