/** The pages of the guide, in the order of their list, each fetched when it is first read. */
export interface GuidePage {
  /** The ids of its sections, without "guide-". */
  sections: string[];
  html: string;
}

type Loader = () => Promise<{ default: GuidePage }>;

const SOURCE = "en";
// beside those written for the guide, some that stand in the repository for everybody, in English
const OTHERS: Record<string, Loader> = {
  formats: () => import("../../../../docs/formats.md"),
  studies: () => import("../../../../docs/studies.md"),
  CONVENTIONS: () => import("../../../../CONVENTIONS.md"),
};
const WRITTEN = import.meta.glob<{ default: GuidePage }>("../../../../docs/guide/*/*.md");

export const GUIDE_PAGES = [
  "first-survey",
  "field-protocol",
  "operator",
  "reviewer",
  "standards-engineer",
  "administrator",
  "access",
  "studies",
  "CONVENTIONS",
  "formats",
  "glossary",
] as const;

export type GuidePageName = (typeof GUIDE_PAGES)[number];

export const isGuidePage = (name: string): name is GuidePageName =>
  (GUIDE_PAGES as readonly string[]).includes(name);

/** A page in the language asked for, else in English; its code is in the app, so only a broken connection fails. */
export async function readPage(
  name: GuidePageName,
  language: string,
): Promise<GuidePage & { language: string }> {
  const written = (one: string) => WRITTEN[`../../../../docs/guide/${one}/${name}.md`];
  const translated = written(language);
  const load = translated ?? OTHERS[name] ?? written(SOURCE);
  if (!load) throw new Error(`the guide has no ${name}`);
  return { ...(await load()).default, language: translated ? language : SOURCE };
}
