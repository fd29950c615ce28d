import { describe, expect, it } from "vitest";
import { ACTIONS } from "../../core/commands";
import { guideAddress, match, PLACES } from "../../core/places";
import { GUIDE_PAGES, isGuidePage, readPage } from "./pages";

const TRANSLATED = GUIDE_PAGES.filter((name) => !["studies", "CONVENTIONS", "formats"].includes(name));

/** What an address of the guide leads to: its page and section, or why it leads nowhere. */
async function wrong(address: string, language = "en"): Promise<string | null> {
  const asked = new URLSearchParams(address.split("?")[1]);
  const page = asked.get("page") ?? "";
  const section = asked.get("section");
  if (!isGuidePage(page)) return `the guide has no page ${page}`;
  const { sections } = await readPage(page, language);
  return section === null || sections.includes(section) ? null : `${page} has no section ${section}`;
}

describe.each(["en", "fr"])("the guide in %s", (language) => {
  it("has a place for every page of the app", async () => {
    for (const { guide } of PLACES) {
      expect(await wrong(guideAddress(guide), language)).toBeNull();
    }
    expect(await wrong("/guide?page=operator&section=nowhere", language)).toBe(
      "operator has no section nowhere",
    );
  });

  it("leads nowhere that is not there", async () => {
    for (const name of GUIDE_PAGES) {
      const { html } = await readPage(name, language);
      for (const [, href = ""] of html.matchAll(/href="(\/[^"]*)"/g)) {
        expect(match(href.split("?")[0] ?? ""), href).not.toBeNull();
        if (!href.startsWith("/guide?")) continue;
        expect(await wrong(href.replaceAll("&amp;", "&"), language), href).toBeNull();
      }
      expect(html, name).not.toContain('href="#');
    }
  });

  it("names keys that there are", async () => {
    const keys = new Set<string>(Object.values(ACTIONS).flatMap((one) => one.keys as readonly string[]));
    for (const name of ["first-survey", "operator", "reviewer"] as const) {
      const { html } = await readPage(name, language);
      for (const [, key = ""] of html.matchAll(/<code>([A-Z0-9?]|Ctrl\+\w+)<\/code>/g)) {
        expect(keys, `${name}: ${key}`).toContain(key);
      }
    }
  });
});

describe("the guide in French", () => {
  it("has the sections of the English, by the same addresses", async () => {
    for (const name of TRANSLATED) {
      const [english, french] = [await readPage(name, "en"), await readPage(name, "fr")];
      expect(french.language).toBe("fr");
      expect(french.sections).toEqual(english.sections);
      expect(french.html).not.toBe(english.html);
    }
    const { html } = await readPage("operator", "fr");
    expect(html).toContain('<h2 id="guide-road">Route</h2>');
    expect(html).toContain('<a href="/guide?page=reviewer&amp;section=lots">par lots</a>');
  });

  it("leaves to English what is in no other language", async () => {
    expect(await readPage("formats", "fr")).toEqual(await readPage("formats", "en"));
    expect((await readPage("formats", "fr")).language).toBe("en");
    expect((await readPage("operator", "xx")).language).toBe("en");
  });
});
