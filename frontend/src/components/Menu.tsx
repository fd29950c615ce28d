import type { ComponentChildren } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";

interface MenuProps {
  button: ComponentChildren;
  label: string;
  class?: string;
  left?: boolean;
  children: ComponentChildren;
}

/** A button that opens a short list of links and buttons (`.menu__item`). Esc, a click elsewhere or a choice closes it. */
export function Menu({ button, label, class: className, left, children }: MenuProps) {
  const [open, setOpen] = useState(false);
  const box = useRef<HTMLDivElement>(null);
  const opener = useRef<HTMLButtonElement>(null);
  useEffect(() => {
    if (!open) return;
    const elsewhere = (event: Event) => {
      if (!box.current?.contains(event.target as Node)) setOpen(false);
    };
    document.addEventListener("pointerdown", elsewhere);
    box.current?.querySelector<HTMLElement>(".menu__item")?.focus();
    return () => document.removeEventListener("pointerdown", elsewhere);
  }, [open]);
  const onKeyDown = (event: KeyboardEvent) => {
    if (!open) return;
    const items = [...(box.current?.querySelectorAll<HTMLElement>(".menu__item") ?? [])];
    const at = items.indexOf(document.activeElement as HTMLElement);
    if (event.key === "Escape") {
      setOpen(false);
      opener.current?.focus();
    } else if (event.key === "ArrowDown") items[(at + 1) % items.length]?.focus();
    else if (event.key === "ArrowUp") items[(at - 1 + items.length) % items.length]?.focus();
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: the keys are those of the buttons inside
    <div class={`menu${left ? " menu--left" : ""}`} ref={box} onKeyDown={onKeyDown}>
      <button
        type="button"
        ref={opener}
        class={className ?? "btn btn--quiet"}
        aria-label={label}
        aria-expanded={open}
        title={label}
        onClick={() => setOpen(!open)}
      >
        {button}
      </button>
      {open && (
        // biome-ignore lint/a11y/noStaticElementInteractions: closes after a choice of a button or link inside
        // biome-ignore lint/a11y/useKeyWithClickEvents: Enter on those is a click
        <div
          class="menu__list"
          onClick={(event) => (event.target as Element).closest(".menu__item") && setOpen(false)}
        >
          {children}
        </div>
      )}
    </div>
  );
}
