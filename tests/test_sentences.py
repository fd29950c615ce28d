"""Every sentence that the server's code writes itself and a page may show is found again in the catalogue.

What is raised by its key is held in `test_messages.py`; here are the reasons, notes and progress that code
writes in English and that are said in another language by their text (`messages/recognised.py`).
"""

import ast
import re
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path

import pytest

from sightline.messages.recognised import TOLD
from tests.test_messages import PACKAGE, SOURCE, _last_name, _template, trees

#: What people who read a page do not see: the terminal's, a package's own English, the demonstration's data.
ELSEWHERE = (
    *("cli.py", "commands/", "demo/", "export/contents.py", "export/exclusions.py", "export/verify/"),
    *("infra/web/openapi.py", "infra/web/pictures.py", "media/lines/"),
)
#: Calls whose words describe columns, options and fields, go to the log, or tell a programmer of a mistake.
DESCRIBING = re.compile(
    r"(?:Column|Table|statistics_table|study_table|Other|Doc|Field|text|whole|number|column|flag|moment|option|argument|echo|log\w*|debug"
    r"|info|warning|error|exception|ValueError|RuntimeError|TypeError|KeyError|LookupError|AssertionError)$"
)
#: Texts beside fields of answers, which the description of the interface alone shows.
IN_ANNOTATIONS = ("scans/bodies.py", "scans/statistics/routes.py")
SENTENCE = re.compile(r"[A-Z0-9\0].*[a-z]{2,} [a-z]{2,}.*[.:!?]", re.DOTALL)


def not_said(tree: ast.Module) -> set[int]:
    """The nodes of docstrings, of descriptions, and of pieces within an f-string."""
    found: set[int] = set()
    for one in ast.walk(tree):
        if isinstance(one, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
            if one.body and isinstance(one.body[0], ast.Expr):
                found.add(id(one.body[0].value))
        elif isinstance(one, ast.JoinedStr):
            found |= {id(part) for part in ast.walk(one)} - {id(one)}
        elif isinstance(one, ast.Call):
            described = one if DESCRIBING.fullmatch(_last_name(one.func)) else None
            named = [key.value for key in one.keywords if key.arg in ("description", "help", "meaning")]
            for part in [*([described] if described else []), *named]:
                found |= {id(inner) for inner in ast.walk(part)}
    return found


def sentences(tree: ast.Module) -> Iterator[tuple[int, str]]:
    """(line, sentence with a mark for each value) of what code may say."""
    apart = not_said(tree)
    for one in ast.walk(tree):
        text = "" if id(one) in apart else _template(one)
        if "\n" not in text and SENTENCE.fullmatch(text):
            yield getattr(one, "lineno", 0), text


@cache
def known() -> tuple[list[str], ...]:
    """What is found again by its text, as the words around its values."""
    lines = [
        line.partition(" = ")[2] for line in SOURCE.read_text("utf-8").splitlines() if line.startswith(TOLD)
    ]
    split = (re.split(r"\{ \$\w+ \}", line) for line in lines if re.search("[A-Za-z]{3}", line))
    return tuple(one for one in split if any(re.search("[A-Za-z]{2} [A-Za-z]{2}", part) for part in one))


def in_order(words: Sequence[str], text: str) -> bool:
    at = 0
    for word in words:
        found = text.find(word, at)
        if found < 0:
            return False
        at = found + len(word)
    return True


def is_known(text: str) -> bool:
    """Whether one message has all words of it in their order, or makes it of a value's."""
    words = [part.strip() for part in text.split("\0") if re.search("[A-Za-z]{3}", part)]
    return any(
        in_order(words, "\0".join(one))
        or (text.startswith(one[0]) and text.endswith(one[-1]) and len(one) > 1 and in_order(one, text))
        for one in known()
    )


def test_what_pages_show_of_code_is_said_in_every_language() -> None:
    unsaid = []
    for path, tree in trees().items():
        place = path.relative_to(PACKAGE).as_posix()
        if not place.startswith((*ELSEWHERE, *IN_ANNOTATIONS)):
            unsaid += [f"{place}:{line}: {text!r}" for line, text in sentences(tree) if not is_known(text)]
    assert not unsaid, "\n".join(unsaid)


def test_every_place_that_is_passed_over_is_there() -> None:
    for place in (*ELSEWHERE, *IN_ANNOTATIONS):
        assert Path(PACKAGE / place).exists(), place


@pytest.mark.parametrize(
    "code",
    [
        'REASON = "The camera flew away, so nothing is there."',
        'reason = f"Only {count} vehicles flew over the road."',
        'job.tell("Teaching the vehicles to fly.")',
    ],
)
def test_a_planted_sentence_is_found(code: str) -> None:
    ((_, text),) = sentences(ast.parse(code))
    assert not is_known(text)
