/** Every kind of thing that the outbox sends. A page brings its own; of what an earlier page left, the others come then, so
 *  that it is sent whichever page is open. */
import { learn } from "../core/messages";
import { outbox } from "../core/outbox";

export function loadKinds(): Promise<unknown> {
  return Promise.all([
    learn("measure", "scans", "checks", "review", "repeats"),
    import("../screens/measure/kinds"),
    import("../screens/measure/passes/kinds"),
    import("../screens/scans/kinds"),
    import("../screens/checks/kinds"),
    import("../screens/review/kinds"),
    import("../viewer/repeats"),
  ]);
}

outbox.bringKinds = loadKinds;
