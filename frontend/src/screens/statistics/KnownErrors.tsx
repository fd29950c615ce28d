/** Errors against heights that were known before, a row a target, its lightings and classes below; check targets. */
import type { ComponentChildren } from "preact";
import { num, Panel, Table } from "../../components";
import { say, sentenceOf, wordsOf } from "../../core/messages";
import { formatCount, smallScale } from "../../core/units";
import { HEIGHT_WORDS } from "../../core/words";
import { FigureCell } from "../../parts/figures/FigureCell";
import { NONE, range } from "../../parts/figures/numbers";
import { groupWord, isThere, type KnownErrors } from "./model";

type KnownGroup = KnownErrors["groups"][number];

const FIGURES = ["bias_m", "mae_m", "rmse_m", "sd_m"] as const;
const HEADS = wordsOf("statistics-error-", ...FIGURES);

export function KnownErrorsTable({ found }: { found: readonly KnownErrors[] }) {
  const unit = smallScale()[1];
  return (
    <Panel says="statistics-known-title">
      {found.length === 0 ? (
        <p class="stat-notes small">{say("statistics-known-none")}</p>
      ) : (
        <Table
          label={say("statistics-known-title")}
          class="stat-errors"
          data-testid="known-errors"
          heads={[
            say("statistics-known-target"),
            num("n"),
            ...FIGURES.map((key) => num(say("with-unit", { name: HEADS[key], unit }))),
            num(say("statistics-known-inside")),
          ]}
        >
          {found.map((one) => (
            <Rows key={`${one.target}-${one.check_target}`} one={one} />
          ))}
        </Table>
      )}
      {found.length > 0 && <p class="stat-notes small">{say("statistics-known-help")}</p>}
    </Panel>
  );
}

function Rows({ one }: { one: KnownErrors }) {
  const [all, ...parts] = one.groups;
  if (!all) return null;
  const id = `known-${one.target}${one.check_target ? "-check" : ""}`;
  const target = HEIGHT_WORDS[one.target];
  return (
    <>
      <Row
        id={id}
        name={one.check_target ? say("statistics-known-check", { target }) : target}
        group={all}
        inside={<Inside one={one} />}
      />
      {parts
        .filter((part) => part.n < all.n) // a group of all of them says nothing more
        .map((part) => (
          <Row
            key={part.group}
            id={`${id}-${part.group}`}
            name={
              <span class="stat-part muted" title={sentenceOf(part.reason) ?? undefined}>
                {groupWord(part.grouping, part.group)}
              </span>
            }
            group={{ ...part, reason: null }}
            inside={<td />}
          />
        ))}
    </>
  );
}

interface RowProps {
  id: string;
  name: ComponentChildren;
  group: KnownGroup;
  inside: ComponentChildren;
}

function Row({ id, name, group, inside }: RowProps) {
  const [factor, unit] = smallScale();
  return (
    <tr data-testid={id}>
      <th scope="row">
        {name}
        {group.reason && <div class="stat-ci">{sentenceOf(group.reason)}</div>}
      </th>
      <td class="num">{formatCount(group.n)}</td>
      {FIGURES.map((key) => (
        <FigureCell
          key={key}
          figure={group.figures[key]}
          factor={factor}
          digits={unit === "in" ? 2 : 1}
          title={group.words ? say("statistics-known-holds", { words: sentenceOf(group.words) }) : undefined}
        />
      ))}
      {inside}
    </tr>
  );
}

function Inside({ one: { inside } }: { one: KnownErrors }) {
  if (!isThere(inside)) return <td class="small muted">{sentenceOf(inside.reason)}</td>;
  return (
    <td class="num">
      {say("statistics-known-inside-of", { inside: inside.inside, n: inside.n })}
      <div class="stat-ci">{range(inside, 100, 0) ?? NONE} %</div>
    </td>
  );
}
