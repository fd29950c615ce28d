/**
 * Thousands of rows: in blocks, so that a browser lays out and paints the few blocks in sight.
 * Block by block and not row by row, for the browser asks each of them at every frame whether it is in sight.
 */
import type { ComponentChildren, Ref, VNode } from "preact";

const BLOCK = 25;

export interface LongListProps<T> {
  rows: readonly T[];
  /** How high a row is about; where a block was once in sight, its own height counts. */
  row_px: number;
  class?: string;
  box?: Ref<HTMLDivElement>;
  row: (one: T) => VNode;
  /** What stands there where there is no row. */
  children?: ComponentChildren;
}

export function LongList<T>({ rows, row_px, class: className, box, row, children }: LongListProps<T>) {
  const blocks: (readonly T[])[] = [];
  for (let i = 0; i < rows.length; i += BLOCK) blocks.push(rows.slice(i, i + BLOCK));
  return (
    <div role="list" class={className} ref={box}>
      {blocks.map((some, i) => (
        <div
          key={i}
          class="long-list__block"
          role="presentation"
          style={{ containIntrinsicSize: `auto ${some.length * row_px}px` }}
        >
          {some.map(row)}
        </div>
      ))}
      {children}
    </div>
  );
}
