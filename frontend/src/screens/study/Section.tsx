import type { ComponentChildren } from "preact";
import { Panel, TableScroll } from "../../components";

interface SectionProps {
  id: string;
  title: string;
  note?: string;
  children: ComponentChildren;
}

export function Section({ id, title, note, children }: SectionProps) {
  return (
    <Panel id={id} label={title} data-testid={id}>
      <TableScroll label={title}>{children}</TableScroll>
      {note && <p class="stat-notes small">{note}</p>}
    </Panel>
  );
}
