/** The mark of a vehicle that reached camera 2 first, beside its speed; most traffic has none. */
import { say } from "../core/messages";

export function OtherWay() {
  const words = say("scan-direction-of", { direction: "camera_2_first" });
  return (
    <>
      <span class="muted" aria-hidden="true" title={words}>
        {"← "}
      </span>
      <span class="visually-hidden">{words} </span>
    </>
  );
}
