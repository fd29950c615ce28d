import type { ComponentChildren } from "preact";
import { useState } from "preact/hooks";
import { Icon } from "./Icon";

interface DropFilesProps {
  label: string;
  title: string;
  hint: ComponentChildren;
  accept: string;
  disabled?: boolean;
  add: (files: File[]) => void;
}

export function DropFiles({ label, title, hint, accept, disabled, add }: DropFilesProps) {
  const [over, setOver] = useState(false);
  const take = (files: FileList | null | undefined) => {
    if (!disabled && files?.length) add([...files]);
  };
  return (
    <label
      class={`drop${over ? " drop--over" : ""}`}
      onDragOver={(event) => {
        event.preventDefault();
        setOver(!disabled);
      }}
      onDragLeave={() => setOver(false)}
      onDrop={(event) => {
        event.preventDefault();
        setOver(false);
        take(event.dataTransfer?.files);
      }}
    >
      <Icon name="upload" size={24} />
      <span class="grow">
        <strong>{title}</strong>
        <span class="muted small drop__hint">{hint}</span>
      </span>
      <input
        type="file"
        multiple
        accept={accept}
        disabled={disabled}
        aria-label={label}
        onChange={(event) => {
          take(event.currentTarget.files);
          event.currentTarget.value = "";
        }}
      />
    </label>
  );
}
