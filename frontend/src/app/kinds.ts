/** Every kind of thing that the outbox sends, so that what an earlier page left is sent whichever page is open. */
import "../screens/measure/kinds";
import "../screens/measure/passes/kinds";
import "../screens/scans/kinds";
import "../screens/checks/kinds";
import "../screens/review/kinds";
import "../viewer/repeats";
