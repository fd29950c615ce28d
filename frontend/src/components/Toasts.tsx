import { say } from "../core/messages";
import { dismiss, toasts } from "../core/toasts";
import { Button, IconButton } from "./Button";

/** One live region for all of them, so that each is read once and the ones that stay are not read again. */
export function Toasts() {
  return (
    <div class="stack stack--tight toasts" role="status" aria-atomic="false">
      {toasts.value.map((toast) => (
        <div key={toast.id} class="toast">
          <span class="grow">{toast.text}</span>
          {toast.action && (
            <Button
              kind="quiet"
              small
              onClick={() => {
                toast.action?.run();
                dismiss(toast.id);
              }}
            >
              {toast.action.label}
            </Button>
          )}
          <IconButton icon="close" label={say("action-dismiss")} onClick={() => dismiss(toast.id)} />
        </div>
      ))}
    </div>
  );
}
