import { Button, Dialog } from "../../components";
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
      toast("The link is on the clipboard.");
    } catch {
      document.querySelector<HTMLInputElement>("#sign-in-link")?.select();
    }
  };
  return (
    <Dialog
      title={`Sign-in link for ${invitation.name}`}
      onClose={close}
      actions={
        <>
          <Button onClick={close}>Done</Button>
          <Button kind="primary" icon="copy" onClick={() => void copy()}>
            Copy the link
          </Button>
        </>
      }
    >
      <div class="stack">
        <p>Pass this on to {invitation.name}. It works once, for seven days, and is shown only now.</p>
        <input
          id="sign-in-link"
          class="input"
          readOnly
          value={link}
          aria-label="Sign-in link"
          onFocus={(event) => event.currentTarget.select()}
        />
      </div>
    </Dialog>
  );
}
