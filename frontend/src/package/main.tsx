import { effect } from "@preact/signals";
import { render } from "preact";
import "../style/tokens.css";
import "./package.css";
import "./theme";
import { Guarded } from "./Guarded";
import { done, open } from "./opened";
import { Page } from "./Page";

const root = document.getElementById("opened");
if (root) {
  render(
    <Guarded>
      <Page />
    </Guarded>,
    root,
  );
}
effect(() => {
  document.documentElement.dataset.checked = String(done.value);
});
await open();
