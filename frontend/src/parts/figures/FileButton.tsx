import { Button } from "../../components";

interface Props {
  as: "svg" | "csv";
  title: string;
  save: () => void;
}

/** Saves what is shown as a file. */
export function FileButton({ as, title, save }: Props) {
  return (
    <Button says={`file-${as}`} small icon="download" class="stat-noprint" title={title} onClick={save} />
  );
}
