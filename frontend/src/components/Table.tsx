/** Tables: their heads as a list and, where each row says the same of its thing, the columns as data. */
import type { ComponentChildren, HTMLAttributes } from "preact";
import { TableScroll } from "./TableScroll";

interface HeadProps {
  head: ComponentChildren;
  figures?: boolean;
  class?: string;
  title?: string;
}
type Head = ComponentChildren | HeadProps;

type Cell<R> = (row: R, index: number) => ComponentChildren;

export function num(head: ComponentChildren): HeadProps {
  return { head, figures: true };
}

/** Said in the place of so many columns, in rows of which there is something to say. */
interface Across<R> {
  why: (row: R) => ComponentChildren;
  columns: number;
  class?: string | undefined;
}

export interface Column<R> extends HeadProps {
  cell: Cell<R>;
  cellClass?: string;
  cellTitle?: (row: R) => string | undefined;
  rowHead?: boolean;
  /** In place of it and of those behind it, the first that says something. */
  across?: readonly Across<R>[];
}

/** What columns are made with: of words, of figures, the one that says which row it is, and what can be done with it. */
export class Columns<R> {
  col = (head: ComponentChildren, cell: Cell<R>, cellClass?: string): Column<R> => ({
    head,
    cell,
    cellClass,
  });
  num = (head: ComponentChildren, cell: Cell<R>, cellClass?: string): Column<R> => ({
    ...num(head),
    cell,
    cellClass,
  });
  rowHead = (head: ComponentChildren, cell: Cell<R>): Column<R> => ({ head, cell, rowHead: true });
  /** What can be done with the row: the head is only read aloud. */
  actions = (head: string, cell: Cell<R>, cellClass?: string): Column<R> =>
    this.col(<span class="visually-hidden">{head}</span>, cell, cellClass);
  /** Columns of what some rows have not: those say why, in their place; undefined: it is there. */
  across = (why: Across<R>["why"], cellClass: string | undefined, ...columns: Column<R>[]): Column<R>[] =>
    columns.map((one, at) => {
      const said = { why, columns: columns.length, class: cellClass };
      return at === 0 ? { ...one, across: [said, ...(one.across ?? [])] } : one;
    });
}

interface Shell extends Omit<HTMLAttributes<HTMLTableElement>, "label" | "rows"> {
  /** Of the place in which a wide table scrolls; without it the table stands as it is. */
  label?: string;
  scroll?: string;
  caption?: ComponentChildren;
  "data-testid"?: string;
}

export function Table({
  label,
  scroll,
  caption,
  class: more,
  heads,
  children,
  ...rest
}: Shell & { heads: readonly Head[] }) {
  const table = (
    <table {...rest} class={more ? `table ${more}` : "table"}>
      {caption && <caption>{caption}</caption>}
      <thead>
        <tr>
          {heads.map((one, i) => {
            const { head, figures, ...how } = isProps(one) ? one : { head: one };
            return (
              <th key={i} {...how} class={classes(figures && "num", how.class)}>
                {head}
              </th>
            );
          })}
        </tr>
      </thead>
      <tbody>{children}</tbody>
    </table>
  );
  if (label === undefined) return table;
  return (
    <TableScroll label={label} class={scroll}>
      {table}
    </TableScroll>
  );
}

type RowAttributes = HTMLAttributes<HTMLTableRowElement> & { [data: `data-${string}`]: string | number };

interface DataProps<R> extends Shell {
  rows: readonly R[];
  keyOf: (row: R, index: number) => string | number;
  rowAttributes?: (row: R, index: number) => RowAttributes;
  columns: (made: Columns<R>) => Column<R>[];
}

export function DataTable<R>({ rows, keyOf, rowAttributes, columns: columnsOf, ...shell }: DataProps<R>) {
  const columns = columnsOf(new Columns<R>());
  const heads = columns.map(({ head, figures, class: more, title }) => ({
    head,
    figures,
    class: more,
    title,
  }));
  return (
    <Table {...shell} heads={heads}>
      {rows.map((row, index) => (
        <tr key={keyOf(row, index)} {...rowAttributes?.(row, index)}>
          {cellsOf(columns, row, index)}
        </tr>
      ))}
    </Table>
  );
}

function cellsOf<R>(columns: readonly Column<R>[], row: R, index: number): ComponentChildren[] {
  let covered = 0;
  return columns.map(({ figures, rowHead: known, cellClass, cellTitle, cell, across }, i) => {
    if (i < covered) return null;
    const said = across?.find((one) => one.why(row) !== undefined);
    if (said) {
      covered = i + said.columns;
      return (
        <td
          key={i}
          colSpan={said.columns > 1 ? said.columns : undefined}
          class={said.class ? `small muted ${said.class}` : "small muted"}
        >
          {said.why(row)}
        </td>
      );
    }
    const Cell = known ? "th" : "td";
    const name = classes(figures && "num", cellClass);
    return (
      <Cell key={i} scope={known ? "row" : undefined} class={name} title={cellTitle?.(row)}>
        {cell(row, index)}
      </Cell>
    );
  });
}

function isProps(head: Head): head is HeadProps {
  return typeof head === "object" && head !== null && "head" in head;
}

function classes(...names: (string | false | undefined)[]): string | undefined {
  return names.filter(Boolean).join(" ") || undefined;
}
