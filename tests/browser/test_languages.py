"""Every screen in French and in a made-up language: no English left over, nothing cut, nothing overlapping.

The made-up language is English with accents, a third longer, each text in brackets. What stands on a screen
outside brackets is in no catalogue, whatever the language: a sentence that code wrote.
"""

import re
import subprocess
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from fluent.syntax import FluentParser, FluentSerializer
from fluent.syntax import ast as ftl
from fluent.syntax.visitor import Transformer, Visitor
from playwright.sync_api import Browser, Page, Response, Route, StorageState, ViewportSize

from sightline import messages

from .server import Server
from .test_screens import (
    ALL_ROWS,
    ALL_RULES,
    AXE,
    ROWS,
    RULES_OF_A_LOOK,
    SCREENS,
    SIZES,
    findings,
    look_at,
    note,
    open_screen,
    places,
    settle,
)

__all__ = ["places"]  # a fixture of every screen's

FOLDER = Path(messages.__file__).parent
FRONTEND = Path(__file__).resolve().parents[2] / "frontend"
LEAST_SAID = 9  # letters of a sentence of the server's own, which tell it from any words
ANY = "\x00"  # stands for a value in a sentence
TAG = re.compile(r"(</?[a-z]+>)")
OPEN, CLOSE = "⟦", "⟧"
PLAIN, ACCENTED = "aeioucnyAEIOUCNY", "áéíóúçñýÁÉÍÓÚÇÑÝ"
#: Of an answer: what people typed or what things are called, which is not translated.
NAMES = {
    "name", "names", "display_name", "account_name", "file_name", "make", "model", "title", "place", "site",
    "comment", "label", "text", "timezone", "version", "path", "source", "url", "email", "command",
    "camera_name", "survey_name", "recording_name", "by", "who", "made_by", "country", "edition",
    "description", "lens", "zoom", "focus", "weather", "taken_from", "road_class", "lane", "travel_direction",
    "notes", "cited_by",
}  # fmt: skip
#: Names of what is outside: quoted documents, product names, units.
OUTSIDE = re.compile(r"\bet\b|Europe/Paris|[0-9a-f]{32,}|Sightline|OpenCV|ChArUco|km/h|English|français")


class _Texts(Visitor):  # type: ignore[misc]
    """Every text of a message with a mark where its values stand; one for each choice."""

    def __init__(self) -> None:
        self.all: list[str] = []

    def visit_Pattern(self, node: ftl.Pattern) -> None:
        self.all.append(
            "".join(one.value if isinstance(one, ftl.TextElement) else ANY for one in node.elements)
        )
        self.generic_visit(node)


@cache
def texts(language: str) -> dict[str, set[str]]:
    found = {}
    for entry in FluentParser().parse((FOLDER / f"{language}.ftl").read_text("utf-8")).body:
        if isinstance(entry, ftl.Message):
            seen = _Texts()
            seen.visit(entry)
            found[entry.id.name] = {spaced(one).strip() for text in seen.all for one in TAG.split(text)[::2]}
    return found


def spaced(text: str) -> str:
    """With plain spaces: pages keep numbers and units together, which catalogues and server do not."""
    return text.replace("\u00a0", " ")


class Said:
    """The texts of a catalogue, which words on a screen are held against: only what has a word in it."""

    def __init__(self, texts: set[str]) -> None:
        worded = {text for text in texts if re.search(r"[^\W\d_]{3}", text)}
        self._exact = {text for text in worded if ANY not in text}
        open_ones = sorted(worded - self._exact, key=lambda text: -len(text.replace(ANY, "")))
        self._open = [(text.split(ANY), _with_values(text)) for text in open_ones]
        self._known: dict[str, int] = {}

    def letters(self, text: str) -> int:
        """How many letters of the longest text that it may be are the catalogue's; 0 for none."""
        if text not in self._known:
            self._known[text] = max(
                len(text) if text in self._exact else 0, self._letters_around_values(text)
            )
        return self._known[text]

    def _letters_around_values(self, text: str) -> int:
        for parts, pattern in self._open:
            # almost every text is told by its ends alone, at a hundredth of a pattern's cost
            if text.startswith(parts[0]) and text.endswith(parts[-1]) and pattern.fullmatch(text):
                return sum(map(len, parts))
        return 0


def _with_values(text: str) -> re.Pattern[str]:
    return re.compile(".+?".join(map(re.escape, text.split(ANY))), re.DOTALL)


class Catalogues:
    """Tells a text that is still English from one that is French."""

    def __init__(self, language: str) -> None:
        english, other = texts("en"), texts(language)
        self.english = Said({t for key, said in english.items() for t in said - other[key]})
        self.other = Said({t for said in other.values() for t in said})

    def is_english(self, text: str) -> bool:
        return self.english.letters(text) > self.other.letters(text)

    def is_other(self, text: str) -> bool:
        """Whether it stands so in the other language, from its first letter to its last."""
        return self.other.letters(text) == len(text)


class _Bracketed(Transformer):  # type: ignore[misc]
    def visit_TextElement(self, node: ftl.TextElement) -> ftl.TextElement:
        parts = TAG.split(node.value)
        node.value = "".join(part if n % 2 else _made_up(part) for n, part in enumerate(parts))
        return node


def _made_up(text: str) -> str:
    if not re.search(r"[^\W\d_]", text):
        return text
    longer = text.rstrip() + "~" * (len(text) // 3) + text[len(text.rstrip()) :]
    return OPEN + longer.translate(str.maketrans(PLAIN, ACCENTED)) + CLOSE


@cache
def made_up_language() -> str:
    """en.ftl with accents and longer, each text in brackets."""
    parsed = FluentParser().parse((FOLDER / "en.ftl").read_text("utf-8"))
    return str(FluentSerializer().serialize(_Bracketed().visit(parsed)))


@cache
def made_up_words() -> str:
    """The made-up language as the pages fetch words: each message's pattern, read by Fluent itself."""
    node = ["node", "--input-type=module", "--eval", _READ]
    read = subprocess.run(
        node, input=made_up_language(), cwd=FRONTEND, text=True, capture_output=True, check=True
    )
    return f"export default {read.stdout};"


_READ = """
import { FluentResource } from "@fluent/bundle";
import { readFileSync } from "node:fs";
const { body } = new FluentResource(readFileSync(0, "utf8"));
process.stdout.write(JSON.stringify(Object.fromEntries(body.map(({ id, value }) => [id, value]))));
"""


def speak_made_up(route: Route) -> None:
    """In the place of the French files, which the pages ask for by themselves."""
    route.fulfill(body=made_up_words(), content_type="text/javascript")


# -- what stands on a screen --

SHOWN = """() => {
  const seen = new Set();
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const holder = node.parentElement;
    if (!holder || holder.closest('script, style, code, kbd, pre, [translate=no], textarea')) continue;
    if (holder.checkVisibility()) seen.add(node.textContent.trim());
  }
  for (const name of ['title', 'aria-label', 'placeholder', 'alt'])
    for (const one of document.querySelectorAll(`[${name}]`))
      if (!one.closest('[translate=no]')) seen.add(one.getAttribute(name).trim());
  seen.add(document.title);
  return [...seen].filter(text => /\\p{L}{2}/u.test(text));
}"""

CUT = """() => [...document.querySelectorAll('body *')].flatMap(e => {
  if (!e.checkVisibility() || e.closest('.visually-hidden, svg, pre, [title]')) return [];
  const own = [...e.childNodes].some(n => n.nodeType === 3 && n.textContent.trim());
  if (!own && e.tagName !== 'BUTTON') return [];
  const style = getComputedStyle(e), words = `${e.tagName}.${e.className}: ${e.textContent.slice(0, 60)}`;
  const hides = /hidden|clip/.test(style.overflowX) && style.clipPath !== 'inset(50%)';
  if (hides && e.scrollWidth > e.clientWidth + 1) return [`cut: ${words}`];
  if (e.clientWidth > 0 && e.scrollWidth > e.clientWidth + 1 && !hides && style.overflowX === 'visible')
    return [`runs over its place: ${words}`];
  if (!e.matches('.btn')) return [];
  const range = document.createRange();
  const wraps = [...e.childNodes].some(n => {
    if (n.nodeType !== 3 || !n.textContent.trim()) return false;
    range.selectNodeContents(n);
    return new Set([...range.getClientRects()].map(r => Math.round(r.top / 4))).size > 1;
  });
  return wraps ? [`wraps in its button: ${words}`] : [];
})"""

OVERLAPS = """() => {
  const wrong = [];
  const boxes = (list) => [...list].filter(e => e.checkVisibility() && e.textContent.trim())
    .map(e => [e, e.getBoundingClientRect()]).filter(([, b]) => b.width > 0);
  const crossing = (a, b) => Math.min(Math.min(a.right, b.right) - Math.max(a.left, b.left),
                                      Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top));
  for (const drawing of document.querySelectorAll('svg')) {
    const all = boxes(drawing.querySelectorAll('text'));
    const edge = drawing.getBoundingClientRect();
    for (const [e, b] of all)
      if (getComputedStyle(drawing).overflow !== 'visible'
          && (b.left < edge.left - 2 || b.right > edge.right + 2))
        wrong.push(`runs out of its figure: ${e.textContent}`);
    all.forEach(([e, a], n) => all.slice(n + 1).forEach(([f, b]) => {
      // two lines of one label come closer than their boxes are high
      if (crossing(a, b) > Math.min(a.height, b.height) / 3)
        wrong.push(`overlap: ${e.textContent} | ${f.textContent}`);
    }));
  }
  for (const row of document.querySelectorAll('thead tr')) {
    const seen = [...row.cells].filter(c => c.textContent.trim() && !c.querySelector('.visually-hidden'));
    const all = seen.map(c => {
      const range = document.createRange(); range.selectNodeContents(c);
      return [c, range.getBoundingClientRect()];
    });
    all.forEach(([e, a], n) => all.slice(n + 1).forEach(([f, b]) => {
      if (crossing(a, b) > 1) wrong.push(`heads overlap: ${e.textContent} | ${f.textContent}`);
    }));
  }
  return wrong.slice(0, 8);
}"""


class Answers:
    """What the server answered since a page was opened: its names are nobody's to translate.

    Its sentences come in French, whatever the pages make of the French file.
    """

    def __init__(self, page: Page) -> None:
        self.names: set[str] = set()
        # reasons of failed jobs among them, which earlier tests leave
        self._french = Said({one for said in texts("fr").values() for one in said})
        page.on("response", self._note)

    def _note(self, response: Response) -> None:
        if "/api/" in response.url and "json" in response.headers.get("content-type", ""):
            try:
                self._gather(response.json(), False)
            except Exception:
                return

    def _gather(self, value: Any, named: bool) -> None:
        if isinstance(value, str):
            value = spaced(value)
            said = [value, *re.split(r"(?<=[.!?]) ", value)]
            self.names |= {
                one for one in said if len(one) > 1 and (named or self._french.letters(one) > LEAST_SAID)
            }
        elif isinstance(value, list):
            for one in value:
                self._gather(one, named)
        elif isinstance(value, dict):
            for key, one in value.items():
                self._gather(one, key in NAMES)

    def left(self, page: Page) -> list[tuple[str, str]]:
        """What stands on the page, and the same without what the server called it, the longest first."""
        names = sorted(self.names, key=len, reverse=True)
        return [(text, self._without(text, names)) for text in map(spaced, page.evaluate(SHOWN))]

    @staticmethod
    def _without(text: str, names: list[str]) -> str:
        for name in names:
            if name in text:
                text = text.replace(name, "·")
        return text


def outside_the_catalogue(text: str) -> bool:
    left = re.sub(f"{OPEN}[^{CLOSE}]*{CLOSE}", " ", text)
    return bool(re.search(r"[A-Za-z]{2,}[ ,]+[a-z]{2,}", OUTSIDE.sub("", left)))


@pytest.fixture
def french(
    browser: Browser, demonstration: Server, admin_state: StorageState
) -> Iterator[tuple[Page, list[str]]]:
    """A signed-in page of a browser that asks for French, without the CSP that would keep axe out."""
    context = browser.new_context(
        base_url=demonstration.url,
        storage_state=admin_state,
        locale="fr-FR",
        bypass_csp=True,
        reduced_motion="reduce",
    )
    context.add_init_script(path=AXE)
    page = context.new_page()
    complaints: list[str] = []
    page.on("pageerror", lambda error: complaints.append(f"page error: {error}"))
    page.on("console", lambda message: note(message, complaints))
    yield page, complaints
    context.close()


# What words decide, by what they say and by the room that they take; no language changes the document and its
# colours, which decide the rest.
RULES_OF_WORDS = (
    *(rule for rule in RULES_OF_A_LOOK if rule != "color-contrast"),
    "html-has-lang", "html-lang-valid", "valid-lang", "document-title", "button-name", "link-name", "label",
    "image-alt", "aria-input-field-name", "aria-toggle-field-name",
)  # fmt: skip


@pytest.mark.parametrize(
    ("rules", "rows", "sizes", "every"),
    [
        (RULES_OF_WORDS, ROWS, SIZES[1:], 2),
        pytest.param(ALL_RULES, ALL_ROWS, SIZES, 1, marks=pytest.mark.proof),
    ],
    ids=["words", "all"],
)
def test_every_screen_speaks_french(
    french: tuple[Page, list[str]],
    places: dict[str, int],
    screenshots: Path,
    rules: Sequence[str],
    rows: int,
    sizes: Sequence[ViewportSize],
    every: int,
) -> None:
    """Every second screen in few of axe's rules; in `make proofs` every one in all of them."""
    page, wrong = french
    known, answers = Catalogues("fr"), Answers(page)
    for name, (address, sign) in list(SCREENS.items())[::every]:
        open_screen(page, address.format(**places), sign)
        assert page.locator("html").get_attribute("lang") == "fr"
        for size in sizes:
            page.set_viewport_size(size)
            wrong += look_at(page, name, f"fr-{size['width']}", screenshots)
            wrong += [
                f"{name} {size['width']}: {one}" for one in page.evaluate(CUT) + page.evaluate(OVERLAPS)
            ]
        wrong += [f"{name}: axe {one}" for one in findings(page, rules, rows)]
        left = [
            one
            for one, unnamed in answers.left(page)
            if known.is_english(unnamed) and not known.is_other(one)
        ]
        wrong += [f"{name}: English: {one}" for one in left]
    assert not wrong, "\n".join(wrong)


# Sentences that code writes are looked for in all of it besides (`frontend/tools/sentences.mjs`).
@pytest.mark.parametrize("every", [4, pytest.param(1, marks=pytest.mark.proof)])
def test_nothing_is_said_outside_the_catalogue(
    browser: Browser, demonstration: Server, admin_state: StorageState, places: dict[str, int], every: int
) -> None:
    context = browser.new_context(
        base_url=demonstration.url,
        storage_state=admin_state,
        locale="fr-FR",
        bypass_csp=True,
        reduced_motion="reduce",
    )
    context.route(re.compile(r"/assets/words-fr-[^/]*\.js$"), speak_made_up)
    page = context.new_page()
    answers, wrong = Answers(page), []
    for name, (address, sign) in list(SCREENS.items())[::every]:
        open_screen(page, address.format(**places), sign)
        settle(page)
        left = [one for one, unnamed in answers.left(page) if outside_the_catalogue(unnamed)]
        wrong += [f"{name}: {one}" for one in left]
        assert OPEN in page.locator("body").inner_text(), name
    context.close()
    assert not wrong, "\n".join(wrong)


def test_what_the_checks_call_english_and_what_not() -> None:
    known = Catalogues("fr")
    said = texts("en")["menu-language"] | texts("en")["action-cancel"]
    assert all(known.is_english(one) for one in said)
    assert not any(known.is_english(one) for one in texts("fr")["menu-language"])
    assert outside_the_catalogue("a sentence of code") and not outside_the_catalogue(_made_up("a sentence"))
    assert outside_the_catalogue(f"{_made_up('It says:')} too few vehicles") and not outside_the_catalogue(
        "3 m"
    )
