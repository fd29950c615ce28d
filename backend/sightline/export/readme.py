"""README.txt of a package: what came out, what the package holds, and how it is checked, as plain text.

Its first part is the conclusion that the report opens with; the package's own page shows it from here.
"""

import textwrap
from collections.abc import Iterable, Iterator

from sightline.export.report.conclusion import conclusion
from sightline.export.report.facts import ReportFacts
from sightline.export.report.said import sentence_of_key

README = "README.txt"
_WIDE = 100
_CONTENTS = (
    ("index.html", "report-readme-page"),
    ("report.pdf", "report-readme-report"),
    ("statistics/", "report-readme-statistics"),
    ("tables/", "report-readme-tables"),
    ("crops/ figures/ poses/ calibrations/ parquet/", "report-readme-files"),
    ("audit.csv checkpoint.json", "report-readme-audit"),
)


def readme(facts: ReportFacts) -> bytes:
    """The text, in the language that is spoken: a title, then parts of a heading and items."""
    concluded = conclusion(facts)
    title = _flatten_text(", ".join(part for part in (facts.survey, facts.site) if part))
    lines = [
        title,
        "=" * min(len(title), _WIDE),
        *_part(sentence_of_key("report-conclusion"), concluded.found),
        *_part(sentence_of_key("report-not-covered"), concluded.not_covered),
        *_part(
            sentence_of_key("report-readme-contents"),
            (f"{path}: {sentence_of_key(key)}" for path, key in _CONTENTS),
        ),
        "",
        *_wrapped(sentence_of_key("report-readme-check"), ""),
    ]
    return ("\n".join(lines) + "\n").encode()


def _part(heading: str, items: Iterable[str]) -> Iterator[str]:
    yield from ("", heading, "-" * len(heading))
    for item in items:
        yield from _wrapped(item, "- ")


def _wrapped(text: str, mark: str) -> list[str]:
    blank = " " * len(mark)
    return textwrap.wrap(
        mark + _flatten_text(text),
        _WIDE,
        subsequent_indent=blank,
        break_long_words=False,
        break_on_hyphens=False,
    )


def _flatten_text(text: str) -> str:
    """In one line; blanks that hold a number and its unit together stay."""
    return " ".join(text.split(" ")).replace("\n", " ").replace("\r", " ").replace("\t", " ").strip()
