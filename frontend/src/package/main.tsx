import { effect } from "@preact/signals";
import { render } from "preact";
import "../style/tokens.css";
import "./package.css";
import "./theme";
import { done, open } from "./opened";
import { Page } from "./Page";

const root = document.getElementById("opened");
if (root) render(<Page />, root);
effect(() => {
  document.documentElement.dataset.checked = String(done.value);
});
await open();
