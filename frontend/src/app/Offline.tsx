import { useEffect, useState } from "preact/hooks";
import { Button, Icon } from "../components";
import { connection, explain, tryAgainNow } from "../core/api";
import { say } from "../core/messages";
import { outbox } from "../core/outbox";
import { saveState } from "../core/save";

/** Says that the server cannot be reached, or what it says is away, what waits, and when it is tried again. */
export function Offline() {
  const { lost, nextTryAt, away } = connection.value;
  const [now, setNow] = useState(Date.now());
  useEffect(() => {
    if (!lost) return;
    setNow(Date.now());
    const timer = setInterval(() => setNow(Date.now()), 500);
    return () => clearInterval(timer);
  }, [lost]);
  if (!lost) return null;
  const seconds = nextTryAt === null ? 0 : Math.max(0, Math.ceil((nextTryAt - now) / 1000));
  const { kept, queued } = outbox.counts.value;
  const others = saveState.value.waiting - (kept - queued);
  return (
    <div class="row row--far offline" role="alert">
      <Icon name="warning" />
      <span class="grow">
        {away ? explain(away) : say("problem-offline")}{" "}
        {kept > 0 && `${say("offline-kept", { count: kept })} `}
        {others > 0 && `${say("offline-changes", { count: others })} `}
        {seconds > 0 ? say("offline-next", { seconds }) : say("offline-now")}
      </span>
      <Button says="offline-try" small onClick={tryAgainNow} />
    </div>
  );
}
