import { readdirSync, readFileSync } from "node:fs";
import { FluentParser, FluentSerializer, Resource } from "@fluent/syntax";
import { defineConfig, type Plugin } from "vite";

/** A page that stands alone: what it is made of, what a page may load, and where its data come in. */
interface Alone {
  readonly input: string;
  readonly file: string;
  readonly policy: string;
  readonly data: string;
}

const CATALOGUES = new URL("../backend/sightline/messages/", import.meta.url);
/** The languages that a page speaks, the source first. */
const LANGUAGES = ["en", ...readdirSync(CATALOGUES).flatMap((name) => /^(?!en\b)(\w+)\.ftl$/.exec(name)?.[1] ?? [])];

const NOTHING = "default-src 'none'; style-src 'unsafe-inline';";
/** The page that every package carries, into which an export puts the package's tables. It may load pictures and a script
 *  that lie beside it, and nothing from any network. */
const PACKAGE: Alone = {
  input: "src/package/main.tsx",
  file: "package.html",
  policy: `${NOTHING} script-src 'unsafe-inline' 'self' file:; img-src 'self' file:`,
  data: '<!--package-->\n<script src="audit.js"></script>',
};
/** The evidence file of one vehicle, which holds all that it shows. */
const EVIDENCE: Alone = {
  input: "src/package/evidence/main.tsx",
  file: "evidence.html",
  policy: `${NOTHING} script-src 'unsafe-inline'; img-src data:`,
  data: "<!--evidence-->",
};

/** One page a build: `vite build --config package.vite.config.ts`, and again with `--mode evidence`. */
export default defineConfig(({ mode }) => {
  const alone = mode === "evidence" ? EVIDENCE : PACKAGE;
  return {
    plugins: [messages(), oneFile(alone)],
    publicDir: false,
    build: {
      target: "es2022",
      emptyOutDir: false,
      cssCodeSplit: false,
      modulePreload: false,
      rollupOptions: { input: alone.input },
    },
  };
});

/** The sentences of these pages alone, out of the catalogues. */
function messages(): Plugin {
  const name = "virtual:opened-messages";
  return {
    name: "opened-messages",
    resolveId: (id) => (id === name ? `\0${name}` : null),
    load(id) {
      if (id !== `\0${name}`) return null;
      return `export default ${JSON.stringify(Object.fromEntries(LANGUAGES.map((one) => [one, own(one)])))}`;
    },
  };
}

function own(language: string): string {
  const { body } = new FluentParser().parse(readFileSync(new URL(`${language}.ftl`, CATALOGUES), "utf8"));
  const found = body.filter((one) => one.type === "Message" && one.id.name.startsWith("opened-"));
  return new FluentSerializer().serialize(new Resource(found));
}

/** Script and style within the page. */
function oneFile(alone: Alone): Plugin {
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
      this.emitFile({ type: "asset", fileName: alone.file, source: page(alone, script, style) });
    },
  };
}

function page({ policy, data }: Alone, script: string, style: string): string {
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<title>Sightline</title>
<style>${style.replaceAll("</style", "<\\/style")}</style>
</head>
<body style="background: var(--paper)">
<div id="opened"></div>
<noscript>Sightline needs JavaScript; enable it for this page.</noscript>
${data}
<script type="module">${script.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--")}</script>
</body>
</html>
`;
}
