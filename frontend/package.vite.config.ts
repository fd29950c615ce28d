import { readFileSync } from "node:fs";
import { FluentParser, FluentSerializer, Resource } from "@fluent/syntax";
import { defineConfig, type Plugin } from "vite";

/** The page that every package carries, in one file: `package.html`, into which an export puts the package's tables. */
export default defineConfig({
  plugins: [messages(), oneFile()],
  publicDir: false,
  build: {
    target: "es2022",
    emptyOutDir: false,
    cssCodeSplit: false,
    modulePreload: false,
    rollupOptions: { input: "src/package/main.tsx" },
  },
});

const CATALOGUE = new URL("../backend/sightline/messages/en.ftl", import.meta.url);

/** The sentences of this page alone, out of the catalogue. */
function messages(): Plugin {
  const name = "virtual:opened-messages";
  return {
    name: "opened-messages",
    resolveId: (id) => (id === name ? `\0${name}` : null),
    load(id) {
      if (id !== `\0${name}`) return null;
      const { body } = new FluentParser().parse(readFileSync(CATALOGUE, "utf8"));
      const own = body.filter((one) => one.type === "Message" && one.id.name.startsWith("opened-"));
      return `export default ${JSON.stringify(new FluentSerializer().serialize(new Resource(own)))}`;
    },
  };
}

/** Script and style within the page. It may load pictures that lie beside it and nothing from any network. */
function oneFile(): Plugin {
  return {
    name: "one-file",
    enforce: "post",
    generateBundle(_options, bundle) {
      let [script, style] = ["", ""];
      for (const [file, one] of Object.entries(bundle)) {
        if (one.type === "chunk") script += one.code;
        else style += String(one.source);
        delete bundle[file];
      }
      this.emitFile({ type: "asset", fileName: "package.html", source: page(script, style) });
    },
  };
}

const POLICY =
  "default-src 'none'; script-src 'unsafe-inline' 'self' file:; style-src 'unsafe-inline'; img-src 'self' file:";

function page(script: string, style: string): string {
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="${POLICY}">
<title>Sightline</title>
<style>${style.replaceAll("</style", "<\\/style")}</style>
</head>
<body>
<div id="opened"></div>
<noscript>Sightline needs JavaScript; please switch it on for this page.</noscript>
<!--package-->
<script src="audit.js"></script>
<script type="module">${script.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--")}</script>
</body>
</html>
`;
}
