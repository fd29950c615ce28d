/// <reference types="vitest/config" />
import { basename } from "node:path";
import GithubSlugger from "github-slugger";
import { Marked } from "marked";
import { defineConfig, type Plugin } from "vite";

/** Where `npm run dev` finds the server; the built front end is served by the server itself. */
const server = `http://127.0.0.1:${process.env.SIGHTLINE_PORT ?? "8000"}`;

export default defineConfig({
  plugins: [guide()],
  // the catalogue of messages lies beside the server's code, the guide in docs/
  server: {
    fs: { allow: [".", "../backend/sightline/messages", "../docs", "../CONVENTIONS.md"] },
    proxy: { "/api": server, "/openapi.json": server },
  },
  build: { target: "es2022", sourcemap: false, reportCompressedSize: true },
  test: {
    environment: "happy-dom",
    include: ["src/**/*.test.{ts,tsx}"],
    restoreMocks: true,
  },
});

/** A Markdown file of the guide as a module: its sections and its HTML, made when the pages are built. */
function guide(): Plugin {
  return {
    name: "guide",
    enforce: "pre",
    transform(code, id) {
      if (!id.endsWith(".md")) return null;
      const page = rendered(code);
      return { code: `export default ${JSON.stringify(page)}`, map: null };
    },
  };
}

function rendered(text: string): { sections: string[]; html: string } {
  const slugs = new GithubSlugger();
  const sections: string[] = [];
  const marked = new Marked();
  marked.use({
    renderer: {
      heading({ tokens, depth, text: words }) {
        const id = slugs.slug(words);
        if (depth === 1) return ""; // the page's own
        sections.push(id);
        return `<h${depth} id="guide-${id}">${this.parser.parseInline(tokens)}</h${depth}>\n`;
      },
      link({ href, tokens }) {
        const words = this.parser.parseInline(tokens);
        const [file = "", section] = href.split("#");
        if (!/\.md$/.test(file)) return `<a href="${href}">${words}</a>`;
        const page = `/guide?page=${basename(file, ".md")}`;
        return `<a href="${page}${section ? `&amp;section=${section}` : ""}">${words}</a>`;
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
  return { html: marked.parse(text, { async: false }), sections };
}
