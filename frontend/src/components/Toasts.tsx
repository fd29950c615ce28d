import { dismiss, toasts } from "../core/toasts";
import { Button } from "./Button";

export function Toasts() {
  return (
    <div class="toasts" role="status" aria-live="polite">
      {toasts.value.map((toast) => (
        <div key={toast.id} class="toast" role={toast.kind === "problem" ? "alert" : undefined}>
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
          <Button kind="quiet" small icon="close" label="Dismiss" onClick={() => dismiss(toast.id)} />
        </div>
      ))}
    </div>
  );
}
