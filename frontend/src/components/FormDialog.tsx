import type { ComponentChildren } from "preact";
import { useId, useState } from "preact/hooks";
import { useAction } from "../core/action";
import { say } from "../core/messages";
import { Button } from "./Button";
import { ask, Dialog } from "./Dialog";
import { Problem } from "./Feedback";
import { type Named, nameOf } from "./named";

type FormDialogProps = Named<string> & {
  action: string;
  onClose: () => void;
  /** Does it, and closes the dialog when it is done; what it throws is shown and the dialog stays, as it does where
   *  something that was entered is wrong, and its field says so. */
  submit: () => Promise<unknown>;
  disabled?: boolean;
  wide?: boolean;
  children: ComponentChildren;
};

/** A dialog that asks for a few things and sends them once: Enter or the button. */
export function FormDialog(props: FormDialogProps) {
  const { action, onClose, submit, disabled, wide, children } = props;
  const id = useId();
  const { busy, problem, run } = useAction();
  const [touched, setTouched] = useState(false);
  /** Esc is pressed by mistake, Cancel is not: what was entered is lost only when that is wanted. */
  const leave = async () => {
    const question = { title: say("dialog-discard-title"), body: say("dialog-discard-body") };
    if (!touched || (await ask({ ...question, action: say("dialog-discard") }))) onClose();
  };
  const send = async (event: Event) => {
    event.preventDefault();
    if (!busy && !disabled) await run(submit);
  };
  return (
    <Dialog
      title={nameOf<string>(props)}
      wide={wide}
      onClose={onClose}
      onEscape={() => void leave()}
      actions={
        <>
          <Button says="action-cancel" onClick={onClose} />
          <Button type="submit" form={id} kind="primary" busy={busy} disabled={disabled}>
            {action}
          </Button>
        </>
      }
    >
      <form id={id} class="stack" onSubmit={send} onInput={() => setTouched(true)} noValidate>
        {children}
        <Problem error={problem} />
      </form>
    </Dialog>
  );
}
