import { Button, Dialog } from "../../components";
import { say } from "../../core/messages";
import { toast } from "../../core/toasts";

export interface Invitation {
  name: string;
  link: string;
}

/** The one-time link of a person, to be passed on by hand. */
export function ShowLink({ invitation, close }: { invitation: Invitation; close: () => void }) {
  const link = new URL(invitation.link, location.origin).href;
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(link);
      toast(say("people-link-copied"));
    } catch {
      document.querySelector<HTMLInputElement>("#sign-in-link")?.select();
    }
  };
  return (
    <Dialog
      title={say("people-link-title", { person: invitation.name })}
      onClose={close}
      actions={
        <>
          <Button onClick={close}>{say("people-link-done")}</Button>
          <Button kind="primary" icon="copy" onClick={() => void copy()}>
            {say("people-link-copy")}
          </Button>
        </>
      }
    >
      <div class="stack">
        <p>{say("people-link-help", { person: invitation.name })}</p>
        <input
          id="sign-in-link"
          class="input"
          readOnly
          value={link}
          aria-label={say("people-link")}
          onFocus={(event) => event.currentTarget.select()}
        />
      </div>
    </Dialog>
  );
}
