import { render } from "preact";
import "../../style/tokens.css";
import "../package.css";
import "./evidence.css";
import "../theme";
import { Guarded } from "../Guarded";
import { say } from "../say";
import { type Held, held } from "./document";
import { Page } from "./Page";

const root = document.getElementById("opened");

function read(): Held | null {
  try {
    return held();
  } catch {
    return null;
  }
}

if (root) {
  const file = read();
  render(
    <Guarded>
      {file ? <Page file={file} /> : <p class="opened">{say("opened-evidence-unreadable")}</p>}
    </Guarded>,
    root,
  );
}
