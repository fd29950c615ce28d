import { useState } from "preact/hooks";
import { choices, FormDialog, OptionalField, TextField } from "../../components";
import { api } from "../../core/api";
import { fieldsOf, useForm } from "../../core/form";
import { say } from "../../core/messages";
import type { CatalogueRow } from "../../core/types";
import {
  keptLength,
  keptSmall,
  lengthText,
  lengthUnit,
  parseLength,
  parseSmall,
  smallScale,
  smallText,
} from "../../core/units";
import { CATEGORY_WORDS } from "../../core/words";
import { bodyOf, type ModelIn, SIZE_WORDS, SIZES, type Size } from "./model";

interface Props {
  row: CatalogueRow | null;
  close: () => void;
  saved: () => void;
}

type Typed = Record<Size, { size: string; u: string; source: string }>;

export function ModelDialog({ row, close, saved }: Props) {
  const form = useForm({
    make: row?.make ?? "",
    model: row?.model ?? "",
    from: yearText(row?.year_from),
    to: yearText(row?.year_to),
    category: row?.category ?? null,
    source: row?.source ?? "",
  });
  const { make, model, from, to, category, source } = form.values;
  const [typed, setTyped] = useState<Typed>(() => typedOf(row));
  const [tried, setTried] = useState(false);
  const sizes = read(typed, row);
  const years = [from, to].map(yearOf);
  const wrong = !make.trim() || !model.trim() || sizes === null || years.includes(undefined);
  const submit = async () => {
    setTried(true);
    if (wrong || sizes === null) return;
    const body = {
      ...(row ? bodyOf(row) : {}),
      ...sizes,
      make,
      model,
      source,
      year_from: years[0] ?? null,
      year_to: years[1] ?? null,
      category,
    };
    if (row) {
      const full = { ...body, version: row.version };
      await api.write("PUT /catalogue/{entry_id}", { entry_id: row.id }, { body: full });
    } else await api.write("POST /catalogue", {}, { body });
    saved();
  };
  const empty = (text: string) => (tried && !text.trim() ? say("catalogue-needed") : null);
  const year = (text: string) => (tried && yearOf(text) === undefined ? say("catalogue-year-problem") : null);
  return (
    <FormDialog
      says={row ? "catalogue-correct-title" : "catalogue-add-title"}
      action={say(row ? "catalogue-correct-save" : "catalogue-add-save")}
      onClose={close}
      submit={submit}
    >
      <div class="grid">
        <TextField says="catalogue-make" {...form.field("make")} problem={empty(make)} />
        <TextField says="catalogue-model-name" {...form.field("model")} problem={empty(model)} />
        <TextField says="catalogue-year-from" {...form.field("from")} problem={year(from)} />
        <TextField says="catalogue-year-to" {...form.field("to")} problem={year(to)} />
        <OptionalField
          says="catalogue-category"
          {...form.field("category")}
          none={say("catalogue-category-unknown")}
          options={choices(CATEGORY_WORDS)}
        />
        <TextField says="catalogue-source" {...form.field("source")} />
      </div>
      {SIZES.map((size) => (
        <SizeFields
          key={size}
          size={size}
          typed={typed[size]}
          tried={tried}
          change={(part) => setTyped({ ...typed, [size]: { ...typed[size], ...part } })}
        />
      ))}
    </FormDialog>
  );
}

interface SizeProps {
  size: Size;
  typed: Typed[Size];
  tried: boolean;
  change: (part: Partial<Typed[Size]>) => void;
}

function SizeFields({ size, typed, tried, change }: SizeProps) {
  const name = SIZE_WORDS[size];
  const wrong = (text: string, parsed: number | null) =>
    tried && text.trim() && parsed === null ? say("catalogue-number-problem") : null;
  const field = fieldsOf(typed, change);
  return (
    <div class="grid grid--3">
      <TextField
        label={name}
        unit={lengthUnit.value}
        {...field("size")}
        problem={wrong(typed.size, parseLength(typed.size))}
      />
      <TextField
        label={say("catalogue-u-of", { size: name })}
        unit={smallScale()[1]}
        {...field("u")}
        problem={wrong(typed.u, parseSmall(typed.u))}
      />
      <TextField label={say("catalogue-source-of", { size: name })} {...field("source")} />
    </div>
  );
}

export function typedOf(row: CatalogueRow | null): Typed {
  const one = (size: Size) => ({
    size: lengthText(row?.[`${size}_m`]),
    u: smallText(row?.[`u_${size}_m`]),
    source: row?.[`${size}_source`] ?? "",
  });
  return Object.fromEntries(SIZES.map((size) => [size, one(size)])) as Typed;
}

/** The typed sizes in metres, those of the row that nobody typed as they are; null where one is no number. */
export function read(typed: Typed, row: CatalogueRow | null): Partial<ModelIn> | null {
  const values: Record<string, number | string | null> = {};
  for (const size of SIZES) {
    const { size: length, u, source } = typed[size];
    const metres = length.trim() ? keptLength(length, row?.[`${size}_m`]) : null;
    const uncertainty = u.trim() ? keptSmall(u, row?.[`u_${size}_m`]) : null;
    if ((length.trim() && metres === null) || (u.trim() && uncertainty === null)) return null;
    values[`${size}_m`] = metres;
    values[`u_${size}_m`] = uncertainty;
    values[`${size}_source`] = source.trim() || null;
  }
  return values as Partial<ModelIn>;
}

const yearText = (year: number | null | undefined) => (year ? String(year) : "");

/** Null where nothing is typed, undefined where it is no year. */
function yearOf(text: string): number | null | undefined {
  if (!text.trim()) return null;
  return /^\d{4}$/.test(text.trim()) ? Number(text) : undefined;
}
