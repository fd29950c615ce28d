/** Days and hours of filming, by the clocks of the place: one form for figures, packages and motions. */

import { DateField, OptionalField } from "../../components";
import { say } from "../../core/messages";
import type { ExportPackage } from "../../core/types";

const DAYS = ["filmed_from", "filmed_to"] as const;
const HOURS = ["hour_from", "hour_to"] as const;
export type Filmed = Pick<ExportPackage["selection"], (typeof DAYS | typeof HOURS)[number]>;
const DAY_H = 24;

export function filmedOf(query: URLSearchParams): Filmed {
  const hour = (name: string) => (query.get(name) ? Number(query.get(name)) : null);
  return {
    filmed_from: query.get("filmed_from"),
    filmed_to: query.get("filmed_to"),
    hour_from: hour("hour_from"),
    hour_to: hour("hour_to"),
  };
}

export function FilmedFields({
  value,
  onChange,
}: {
  value: Filmed;
  onChange(change: Partial<Filmed>): void;
}) {
  return (
    <>
      {DAYS.map((name) => (
        <DateField
          key={name}
          says={`statistics-filter-${name}`}
          value={value[name] ?? ""}
          onChange={(day) => onChange({ [name]: day || null })}
        />
      ))}
      {HOURS.map((name, ends) => (
        <OptionalField
          key={name}
          says={`statistics-filter-${name}`}
          value={value[name] === null ? null : String(value[name])}
          none={say("statistics-filter-any")}
          options={Array.from({ length: DAY_H }, (_, hour) => ({
            value: String(hour + ends),
            label: clockHour(hour + ends),
          }))}
          onInput={(hour) => onChange({ [name]: hour === null ? null : Number(hour) })}
        />
      ))}
      {isOverMidnight(value) && <p class="field__hint across">{say("statistics-filter-over-midnight")}</p>}
    </>
  );
}

/** Whether midnight lies within the hours. */
export function isOverMidnight({ hour_from, hour_to }: Filmed): boolean {
  return (hour_from ?? 0) > (hour_to ?? DAY_H);
}

/** What clocks show at a full hour: "07:00". */
export function clockHour(hour: number): string {
  return `${String(hour).padStart(2, "0")}:00`;
}
