import { ShowOnce } from "../../components";
import { say } from "../../core/messages";

export interface Invitation {
  name: string;
  link: string;
}

export function ShowLink({ invitation, close }: { invitation: Invitation; close: () => void }) {
  return (
    <ShowOnce
      title={say("people-link-title", { person: invitation.name })}
      help={say("people-link-help", { person: invitation.name })}
      label={say("people-link")}
      copied={say("people-link-copied")}
      text={new URL(invitation.link, location.origin).href}
      close={close}
    />
  );
}
