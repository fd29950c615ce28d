import { render } from "preact";
import "./style/tokens.css";
import "./style/base.css";
import "./style/components.css";
import "./style/forms.css";
import "./style/layers.css";
import "./style/shell.css";
import { App } from "./app";
import { current } from "./router";

// the screen's code comes while the server is still asked who this is; a failure is told when the screen is shown
current.value?.route.load().catch(() => undefined);

const root = document.getElementById("app");
if (root) render(<App />, root);
