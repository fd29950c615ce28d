/** Errors against heights that were known before, a row a target, its lightings and classes below; check targets. */
import { DataTable, Panel } from "../../components";
import { say, sentenceOf, withUnit, wordsOf } from "../../core/messages";
import type { KnownErrorsBody } from "../../core/types";
import { formatCount, smallScale } from "../../core/units";
import { HEIGHT_WORDS } from "../../core/words";
import { Figure } from "../../parts/figures/FigureCell";
import { NONE, range } from "../../parts/figures/numbers";
import { groupWord, isThere } from "./model";

type KnownGroup = KnownErrorsBody["groups"][number];

const FIGURES = ["bias_m", "mae_m", "rmse_m", "sd_m"] as const;
const HEADS = wordsOf("statistics-error-", ...FIGURES);

export function KnownErrorsTable({ found }: { found: readonly KnownErrorsBody[] }) {
  const [factor, unit] = smallScale();
  return (
    <Panel says="statistics-known-title">
      {found.length === 0 ? (
        <p class="stat-notes small">{say("statistics-known-none")}</p>
      ) : (
        <DataTable
          label={say("statistics-known-title")}
          class="stat-errors"
          data-testid="known-errors"
          rows={found.flatMap(rowsOf)}
          keyOf={({ id }) => id}
          rowAttributes={({ id }) => ({ "data-testid": id })}
          columns={({ num, rowHead, across }) => [
            rowHead(say("statistics-known-target"), nameOf),
            num("n", ({ group }) => formatCount(group.n)),
            ...FIGURES.map((key) => ({
              ...num(withUnit(HEADS[key], unit), ({ group }: Row) => (
                <Figure figure={group.figures[key]} factor={factor} digits={unit === "in" ? 2 : 1} />
              )),
              cellTitle: ({ group }: Row) =>
                group.words ? say("statistics-known-holds", { words: sentenceOf(group.words) }) : undefined,
            })),
            ...across(
              ({ inside }) => (inside && !isThere(inside) ? sentenceOf(inside.reason) : undefined),
              undefined,
              num(say("statistics-known-inside"), ({ inside }) => inside && <Inside inside={inside} />),
            ),
          ]}
        />
      )}
      {found.length > 0 && <p class="stat-notes small">{say("statistics-known-help")}</p>}
    </Panel>
  );
}

interface Row {
  id: string;
  group: KnownGroup;
  /** Of the row of a target: how many of its errors their uncertainty holds. */
  inside?: KnownErrorsBody["inside"];
  one: KnownErrorsBody;
}

function rowsOf(one: KnownErrorsBody): Row[] {
  const [all, ...parts] = one.groups;
  if (!all) return [];
  const id = `known-${one.target}${one.check_target ? "-check" : ""}`;
  const telling = parts.filter((part) => part.n < all.n); // a group of all of them says nothing more
  return [
    { id, group: all, inside: one.inside, one },
    ...telling.map((group) => ({ id: `${id}-${group.group}`, group, one })),
  ];
}

function nameOf({ group, inside, one }: Row) {
  const target = HEIGHT_WORDS[one.target];
  const reason = sentenceOf(group.reason) ?? undefined;
  if (!inside)
    return (
      <span class="stat-part muted" title={reason}>
        {groupWord(group.grouping, group.group)}
      </span>
    );
  return (
    <>
      {one.check_target ? say("statistics-known-check", { target }) : target}
      {reason && <div class="stat-ci">{reason}</div>}
    </>
  );
}

function Inside({ inside }: { inside: KnownErrorsBody["inside"] }) {
  if (!isThere(inside)) return null;
  return (
    <>
      {say("statistics-known-inside-of", { inside: inside.inside, n: inside.n })}
      <div class="stat-ci">{range(inside, 100, 0) ?? NONE} %</div>
    </>
  );
}
