import { signal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useId, useRef } from "preact/hooks";
import { say } from "../core/messages";
import { Button } from "./Button";

interface DialogProps {
  title: string;
  onClose: () => void;
  /** What Esc does instead of closing. */
  onEscape?: () => void;
  children: ComponentChildren;
  /** Buttons, the one that does it last. */
  actions?: ComponentChildren;
  wide?: boolean;
}

/** A modal dialog: focus stays inside, Esc closes, focus goes back to where it was. */
export function Dialog({ title, onClose, onEscape = onClose, children, actions, wide }: DialogProps) {
  const ref = useRef<HTMLDialogElement>(null);
  const id = useId();
  useEffect(() => {
    const before = document.activeElement;
    const dialog = ref.current;
    dialog?.showModal();
    dialog
      ?.querySelector<HTMLElement>(
        "[autofocus], .dialog__body input, .dialog__body select, .dialog__body textarea",
      )
      ?.focus();
    return () => {
      dialog?.close();
      if (before instanceof HTMLElement && before.isConnected) before.focus();
    };
  }, []);
  return (
    <dialog
      ref={ref}
      class={`dialog${wide ? " dialog--wide" : ""}`}
      aria-labelledby={id}
      onCancel={(event) => {
        event.preventDefault();
        onEscape();
      }}
    >
      <header class="row row--apart dialog__head">
        <h2 id={id}>{title}</h2>
        <Button kind="quiet" icon="close" label={say("action-close")} onClick={onClose} />
      </header>
      <div class="dialog__body">{children}</div>
      {actions && <footer class="dialog__foot">{actions}</footer>}
    </dialog>
  );
}

interface Question {
  title: string;
  body: ComponentChildren;
  action: string;
  answer: (yes: boolean) => void;
}

const question = signal<Question | null>(null);

/** Asks before something that cannot be taken back. */
export function ask(options: Omit<Question, "answer">): Promise<boolean> {
  return new Promise((resolve) => {
    question.value = {
      ...options,
      answer: (yes) => {
        question.value = null;
        resolve(yes);
      },
    };
  });
}

/** Shown once by the shell. */
export function AskDialog() {
  const q = question.value;
  if (!q) return null;
  return (
    <Dialog
      title={q.title}
      onClose={() => q.answer(false)}
      actions={
        <>
          <Button says="action-cancel" onClick={() => q.answer(false)} />
          <Button kind="primary" onClick={() => q.answer(true)}>
            {q.action}
          </Button>
        </>
      }
    >
      {q.body}
    </Dialog>
  );
}
