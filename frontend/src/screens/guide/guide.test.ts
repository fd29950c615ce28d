import { describe, expect, it } from "vitest";
import { ACTIONS } from "../../core/commands";
import { GUIDE_OF, guideAddress } from "../../core/guide";
import { match } from "../../core/places";
import { GUIDE_PAGES, isGuidePage, readPage } from "./pages";

/** What an address of the guide leads to: its page and section, or why it leads nowhere. */
async function wrong(address: string): Promise<string | null> {
  const asked = new URLSearchParams(address.split("?")[1]);
  const page = asked.get("page") ?? "";
  const section = asked.get("section");
  if (!isGuidePage(page)) return `the guide has no page ${page}`;
  const { sections } = await readPage(page);
  return section === null || sections.includes(section) ? null : `${page} has no section ${section}`;
}

describe("the guide", () => {
  it("has a place for every page of the app", async () => {
    for (const place of Object.values(GUIDE_OF)) expect(await wrong(guideAddress(place))).toBeNull();
    expect(await wrong("/guide?page=operator&section=nowhere")).toBe("operator has no section nowhere");
  });

  it("leads nowhere that is not there", async () => {
    for (const name of GUIDE_PAGES) {
      const { html } = await readPage(name);
      for (const [, href = ""] of html.matchAll(/href="(\/[^"]*)"/g)) {
        expect(match(href.split("?")[0] ?? ""), href).not.toBeNull();
        if (href.startsWith("/guide?")) expect(await wrong(href.replaceAll("&amp;", "&")), href).toBeNull();
      }
    }
  });

  it("names keys that there are", async () => {
    const keys = new Set<string>(Object.values(ACTIONS).flatMap((one) => one.keys as readonly string[]));
    for (const name of ["first-survey", "operator", "reviewer"] as const) {
      const { html } = await readPage(name);
      for (const [, key = ""] of html.matchAll(/<code>([A-Z0-9?]|Ctrl\+\w+)<\/code>/g)) {
        expect(keys, `${name}: ${key}`).toContain(key);
      }
    }
  });
});
