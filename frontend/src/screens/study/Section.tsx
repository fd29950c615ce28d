import type { ComponentChildren } from "preact";
import { Panel, TableScroll } from "../../components";
import { say } from "../../core/messages";

interface SectionProps {
  id: string;
  title: string;
  note?: string;
  children: ComponentChildren;
}

/** A table under its name. */
export function Section({ id, title, note, children }: SectionProps) {
  return (
    <Panel id={id} label={title} data-testid={id}>
      <TableScroll label={title}>{children}</TableScroll>
      {note && <p class="stat-notes small">{note}</p>}
    </Panel>
  );
}

/** A value with its interval below it. */
export function Bounded({ value, low, high }: { value: string; low: string | null; high: string | null }) {
  return (
    <td class="num">
      <strong>{value}</strong>
      {low !== null && high !== null && (
        <div class="stat-ci">{say("statistics-rule-interval", { low, high })}</div>
      )}
    </td>
  );
}
