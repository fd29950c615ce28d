/// <reference types="vitest/config" />
import { readFileSync } from "node:fs";
import { readFile, writeFile } from "node:fs/promises";
import { basename, dirname, join } from "node:path";
import { promisify } from "node:util";
import { brotliCompress } from "node:zlib";
import GithubSlugger from "github-slugger";
import { Marked, type Token } from "marked";
import { defineConfig, type Plugin } from "vite";
import { words, wordsName } from "./tools/words.ts";

/** Where `npm run dev` finds the server; the built front end is served by the server itself. */
const server = `http://127.0.0.1:${process.env.SIGHTLINE_PORT ?? "8000"}`;

/** The stage, and what stands about it: its tools, undo, and the lists beside it. */
const STAGE =
  /[\\/]src[\\/](viewer[\\/]|core[\\/](history|latest|shape)|components[\\/](undoTools|CommandButton|oneTabStop|inSight))/;

export default defineConfig({
  plugins: [guide(), licences(), words(), compressed()],
  // the catalogue of messages lies beside the server's code, the guide in docs/
  server: {
    fs: { allow: [".", "../backend/sightline/messages", "../docs", "../CONVENTIONS.md"] },
    proxy: { "/api": server, "/openapi.json": server },
  },
  build: {
    target: "es2022",
    sourcemap: false,
    modulePreload: { polyfill: false }, // every browser of this target has it
    rollupOptions: {
      checks: { pluginTimings: false }, // what is compressed at its best takes its time
      // of what `components` lists as one, a page takes what it shows
      treeshake: { moduleSideEffects: [{ test: /[\\/]src[\\/]components[\\/]/, sideEffects: false }] },
      output: {
        chunkFileNames: ({ moduleIds }) => `assets/${wordsName(moduleIds) ?? "[name]"}-[hash].js`,
        // what every page loads is one file, and so are the stage of the pages with frames and how clicks are sent: many
        // small ones are a tenth more
        codeSplitting: {
          groups: [
            { name: "base", tags: ["$initial"], priority: 1 },
            { name: "frames", test: STAGE, minShareCount: 3 },
            { name: "clicks", test: /[\\/]measure[\\/].*(kinds|fields|sizes)\.ts/, minShareCount: 2 },
          ],
        },
      },
    },
  },
  test: {
    environment: "happy-dom",
    include: ["src/**/*.test.{ts,tsx}"],
    setupFiles: ["testing/window.ts"],
    restoreMocks: true,
    reporters: "minimal",
    testTimeout: 120_000,
    // a thread for each file would load happy-dom for each; of two threads, each makes a window with modules of its own
    // for a file (one thread alone would run all files in one window)
    pool: "vmThreads",
    maxWorkers: 2,
  },
});

/** A Markdown file of the guide as a module: its sections and its HTML, made when the pages are built. */
function guide(): Plugin {
  return {
    name: "guide",
    enforce: "pre",
    transform(code, id) {
      if (!id.endsWith(".md")) return null;
      const name = basename(id, ".md");
      const english = /[\\/]docs[\\/]guide[\\/]/.test(id) ? join(dirname(id), "..", "en", `${name}.md`) : id;
      if (english !== id) this.addWatchFile(english);
      const ids = headingIds(english === id ? code : readFileSync(english, "utf8"));
      if (headingIds(code).length !== ids.length) this.error(`${id} has other headings than ${english}`);
      return { code: moduleOf(rendered(code, name, ids)), map: null };
    },
  };
}

/** The packages that go into the pages, with the licences that they state, out of the lock file. */
function licences(): Plugin {
  const name = "virtual:licences";
  return {
    name: "licences",
    resolveId: (id) => (id === name ? `\0${name}` : null),
    load(id) {
      if (id !== `\0${name}`) return null;
      const lock = JSON.parse(readFileSync(new URL("package-lock.json", import.meta.url), "utf8"));
      const found = (Object.entries(lock.packages) as [string, Locked][])
        .filter(([folder, one]) => folder && !one.dev && !one.link)
        .map(([folder, one]) => ({
          name: folder.slice(folder.lastIndexOf("node_modules/") + "node_modules/".length),
          version: one.version,
          licence: one.license ?? null,
        }));
      return `export default ${JSON.stringify(found)}`;
    },
  };
}

/** Beside each script and sheet the same as Brotli has it, once and for all at its best: an eighth less than gzip as it
 *  is sent. `infra/web/pages.py` sends it to whoever takes it. */
function compressed(): Plugin {
  return {
    name: "compressed",
    apply: "build",
    async writeBundle({ dir = "" }, bundle) {
      const files = Object.keys(bundle).filter((file) => /\.(js|css)$/.test(file));
      const pack = async (path: string) => writeFile(`${path}.br`, await promisify(brotliCompress)(await readFile(path)));
      await Promise.all(files.map((file) => pack(join(dir, file))));
    },
  };
}

interface Locked {
  version: string;
  license?: string;
  dev?: boolean;
  link?: boolean;
}

/** The ids of a page's headings: those of its English, so that an address leads to its place in every language. */
function headingIds(english: string): string[] {
  const slugs = new GithubSlugger();
  const words = (token: Token) => (token.type === "heading" ? [token.text as string] : []);
  return new Marked()
    .lexer(english)
    .flatMap(words)
    .map((text) => slugs.slug(text));
}

interface Rendered {
  sections: string[];
  /** With `@picture-0@` and so on where the address of a picture goes. */
  html: string;
  pictures: string[];
}

/** A page as a module, which imports its pictures, so that they are built with the pages. */
function moduleOf({ sections, html, pictures }: Rendered): string {
  const imports = pictures.map((file, at) => `import picture${at} from ${JSON.stringify(`./${file}`)};\n`);
  const text = JSON.stringify(html).replace(/@picture-(\d+)@/g, '" + picture$1 + "');
  return `${imports.join("")}export default { sections: ${JSON.stringify(sections)}, html: ${text} };`;
}

function rendered(text: string, name: string, ids: string[]): Rendered {
  const sections: string[] = [];
  const pictures: string[] = [];
  const marked = new Marked();
  let heading = 0;
  marked.use({
    renderer: {
      heading({ tokens, depth }) {
        const id = ids[heading++] ?? "";
        if (depth === 1) return ""; // the page's own
        sections.push(id);
        return `<h${depth} id="guide-${id}">${this.parser.parseInline(tokens)}</h${depth}>\n`;
      },
      link({ href, tokens }) {
        const words = this.parser.parseInline(tokens);
        const [file = "", section] = href.split("#");
        if (file && !file.endsWith(".md")) return `<a href="${href}">${words}</a>`;
        const page = `/guide?page=${file ? basename(file, ".md") : name}`;
        return `<a href="${page}${section ? `&amp;section=${section}` : ""}">${words}</a>`;
      },
      image({ href, text }) {
        const at = pictures.push(href) - 1;
        const words = text.replaceAll("&", "&amp;").replaceAll('"', "&quot;");
        return `<img src="@picture-${at}@" alt="${words}" width="1280" height="800" loading="lazy" />`;
      },
      table(token) {
        const row = (cells: typeof token.header, tag: string) =>
          `<tr>${cells.map((cell) => `<${tag}>${this.parser.parseInline(cell.tokens)}</${tag}>`).join("")}</tr>`;
        const body = token.rows.map((cells) => row(cells, "td")).join("");
        const head = `<thead>${row(token.header, "th")}</thead>`;
        // a wide table scrolls by itself, by keyboard too
        return `<div class="guide__table" tabindex="0" role="group"><table>${head}<tbody>${body}</tbody></table></div>\n`;
      },
    },
  });
  return { html: marked.parse(text, { async: false }), sections, pictures };
}
