import { afterEach, beforeEach, describe, expect, it } from "vitest";
import { current, isOurs, navigate, query, setQuery } from "./address";
import { speak } from "./messages";
import { addressCalled, match, PLACES, titleOf } from "./places";
import { safeNext } from "./session";

beforeEach(() => navigate("/"));

describe("match", () => {
  it("finds every place, with and without a trailing slash", () => {
    for (const place of PLACES) {
      const path = place.pattern.replace(":id", "42");
      expect(match(path)?.place.name).toBe(place.name);
      if (path !== "/") expect(match(`${path}/`)?.place.name).toBe(place.name);
    }
  });

  it("reads the survey's id", () => {
    expect(match("/surveys/42/camera")?.surveyId).toBe(42);
    expect(match("/people")?.surveyId).toBe(0);
  });

  it.each([
    "/surveys/0",
    "/surveys/x",
    "/surveys/1/nothing",
    "/surveys",
    "/api/surveys",
    "/surveys/1/camera/x",
  ])("knows no %s", (path) => {
    expect(match(path)).toBeNull();
  });
});

describe("an address made of a page's name", () => {
  afterEach(() => speak("en"));

  const leadsTo = (path: string) => match(addressCalled(path)?.split("?")[0] ?? "")?.place.name;
  const own = (pattern: string) => pattern.includes(":id");

  it.each([
    ["/surveys/42/results", "/statistics?survey=42"],
    ["/surveys/42/Results/", "/statistics?survey=42"],
    ["/surveys/42/sight-distance", "/sight-distance?survey=42"],
    ["/surveys/42/plan-the-site", "/surveys/42/planning"],
    ["/surveys/42/motion", "/surveys/42/scans/results"],
    ["/surveys", "/"],
    ["/results", "/statistics"],
  ])("%s leads to %s", (path, address) => {
    expect(addressCalled(path)).toBe(address);
  });

  it.each(["en", "fr"])("leads to each page by its title in %s", async (language) => {
    await speak(language);
    for (const { name, pattern } of PLACES) {
      const title = encodeURIComponent(titleOf(name));
      expect(leadsTo(own(pattern) ? `/surveys/42/${title}` : `/${title}`), title).toBe(name);
    }
  });

  it("is known in English too by who speaks French, and with accents or without", async () => {
    await speak("fr");
    expect(addressCalled("/surveys/42/results")).toBe("/statistics?survey=42");
    expect(addressCalled("/surveys/42/resultats")).toBe("/statistics?survey=42");
    expect(addressCalled("/surveys/42/vue-d-ensemble")).toBe("/surveys/42");
  });

  it.each(["/surveys/42/people", "/road", "/surveys/0/results", "/surveys/42/nothing", "/surveys/42/%", "/"])(
    "is not %s",
    (path) => {
      expect(addressCalled(path)).toBeNull();
    },
  );
});

describe("going about", () => {
  it("changes the route and keeps the way back", () => {
    const before = history.length;
    navigate("/surveys/3/recordings");
    expect(current.value?.place.name).toBe("recordings");
    expect(history.length).toBe(before + 1);
  });

  it("changes the query in place", () => {
    navigate("/surveys/3/measure?recording=1&frame=5");
    const before = history.length;
    setQuery({ frame: 6, vehicle: 2, recording: null });
    expect(query.value.toString()).toBe("frame=6&vehicle=2");
    expect(history.length).toBe(before);
  });
});

describe("links", () => {
  const link = (href: string, attributes: Record<string, string> = {}) => {
    const anchor = document.createElement("a");
    anchor.href = href;
    for (const [name, value] of Object.entries(attributes)) anchor.setAttribute(name, value);
    return anchor;
  };

  it("to screens are taken, others are left to the browser", () => {
    const click = new MouseEvent("click");
    expect(isOurs(link("/surveys/1"), click)).toBe(true);
    expect(isOurs(link("/api/exports/1.zip"), click)).toBe(false);
    expect(isOurs(link("/surveys/1", { download: "" }), click)).toBe(false);
    expect(isOurs(link("/surveys/1", { target: "_blank" }), click)).toBe(false);
    expect(isOurs(link("https://example.org/surveys/1"), click)).toBe(false);
    expect(isOurs(link("/surveys/1"), new MouseEvent("click", { ctrlKey: true }))).toBe(false);
  });
});

describe("the page after signing in", () => {
  it.each([
    "//evil.example",
    "/\\evil.example",
    "https://evil.example",
    "javascript:alert(1)",
    "/sign-in?next=/",
    "",
    null,
  ])("is never %j", (next) => {
    expect(safeNext(next)).toBe("/");
  });

  it("is the one that was asked for", () => {
    expect(safeNext("/surveys/1/measure?frame=3")).toBe("/surveys/1/measure?frame=3");
  });
});
