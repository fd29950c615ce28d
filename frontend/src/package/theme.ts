/** Dark where the machine is, and light on paper. */
const dark = matchMedia("(prefers-color-scheme: dark)");

function show(theme: "light" | "dark"): void {
  document.documentElement.dataset["theme"] = theme;
}

const follow = () => show(dark.matches ? "dark" : "light");
dark.addEventListener("change", follow);
addEventListener("beforeprint", () => show("light"));
addEventListener("afterprint", follow);
follow();
