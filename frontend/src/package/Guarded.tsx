import type { ComponentChildren } from "preact";
import { useErrorBoundary } from "preact/hooks";
import { say } from "./say";

/** What breaks in it leaves one sentence in its place, and no verdict. */
export function Guarded({ children }: { children: ComponentChildren }) {
  const [error] = useErrorBoundary();
  if (!error) return children;
  return (
    <p class="opened" role="alert">
      {say("opened-broken")}
    </p>
  );
}
