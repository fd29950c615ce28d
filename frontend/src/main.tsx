import { render } from "preact";
import "./style/tokens.css";
import "./style/base.css";
import "./style/components.css";
import "./style/forms.css";
import "./style/layers.css";
import "./app/shell.css";
import { App } from "./app/App";
import { loadScreen } from "./app/screens";
import { current } from "./core/address";
import { preferredLanguage, speak } from "./core/messages";

// the screen's code comes while the server is still asked who this is; a failure is told when the screen is shown
if (current.value) loadScreen(current.value.place.name).catch(() => undefined);

await speak(preferredLanguage());
const root = document.getElementById("app");
if (root) render(<App />, root);
