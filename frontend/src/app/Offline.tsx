import { useEffect, useState } from "preact/hooks";
import { Button, Icon } from "../components";
import { connection, tryAgainNow } from "../core/api";
import { saveState } from "../core/save";
import { plural } from "../core/units";

/** Says that the server cannot be reached, what waits, and when it is tried again. */
export function Offline() {
  const { lost, nextTryAt } = connection.value;
  const [now, setNow] = useState(Date.now());
  useEffect(() => {
    if (!lost) return;
    setNow(Date.now());
    const timer = setInterval(() => setNow(Date.now()), 500);
    return () => clearInterval(timer);
  }, [lost]);
  if (!lost) return null;
  const seconds = nextTryAt === null ? 0 : Math.max(0, Math.ceil((nextTryAt - now) / 1000));
  const changes = saveState.value.waiting;
  return (
    <div class="offline" role="alert">
      <Icon name="warning" />
      <span class="grow">
        The server cannot be reached.{" "}
        {changes > 0 && `${plural(changes, "change")} will be saved when it is back; keep this page open. `}
        {seconds > 0 ? `Next try in ${seconds} s.` : "Trying again…"}
      </span>
      <Button small onClick={tryAgainNow}>
        Try now
      </Button>
    </div>
  );
}
