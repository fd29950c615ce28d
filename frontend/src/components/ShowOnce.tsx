import { useId } from "preact/hooks";
import { toast } from "../core/toasts";
import { Button } from "./Button";
import { Dialog } from "./Dialog";

interface Props {
  title: string;
  help: string;
  /** What the text is, and what is said when it was copied. */
  label: string;
  copied: string;
  text: string;
  close: () => void;
}

/** A text that is shown now and never again, to be copied and passed on by hand. */
export function ShowOnce({ title, help, label, copied, text, close }: Props) {
  const id = useId();
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(text);
      toast(copied);
    } catch {
      (document.getElementById(id) as HTMLInputElement | null)?.select();
    }
  };
  return (
    <Dialog
      title={title}
      onClose={close}
      actions={
        <>
          <Button says="show-once-done" onClick={close} />
          <Button says="show-once-copy" kind="primary" icon="copy" onClick={() => void copy()} />
        </>
      }
    >
      <div class="stack">
        <p>{help}</p>
        <input
          id={id}
          class="input"
          readOnly
          value={text}
          aria-label={label}
          onFocus={(event) => event.currentTarget.select()}
        />
      </div>
    </Dialog>
  );
}
