"""The catalogue of messages: every key that code names is there, with the values that its sentence takes."""

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest
from fluent.syntax import FluentParser
from fluent.syntax import ast as ftl
from fluent.syntax.visitor import Visitor

import sightline
from sightline import errors, messages

PACKAGE = Path(sightline.__file__).parent
SOURCE = PACKAGE / "messages/en.ftl"


class _Named(Visitor):  # type: ignore[misc]
    """The values and the other messages that a message names."""

    def __init__(self) -> None:
        self.values: set[str] = set()
        self.messages: set[str] = set()

    def visit_VariableReference(self, node: ftl.VariableReference) -> None:
        self.values.add(node.id.name)

    def visit_MessageReference(self, node: ftl.MessageReference) -> None:
        self.messages.add(node.id.name)


def named(text: str) -> dict[str, _Named]:
    """What each message names. Fails for what is no Fluent, and for a key that is there twice."""
    found: dict[str, _Named] = {}
    for entry in FluentParser().parse(text).body:
        assert not isinstance(entry, ftl.Junk), entry.content
        if isinstance(entry, ftl.Message):
            assert entry.id.name not in found, f"{entry.id.name} is there twice"
            found[entry.id.name] = _Named()
            found[entry.id.name].visit(entry)
    return found


def catalogue(text: str) -> dict[str, set[str]]:
    """The values that each message takes, those of the messages within it among them.

    Fails besides for a message within another that is not there.
    """
    found = named(text)

    def values(key: str) -> set[str]:
        assert key in found, f"en.ftl has no “{key}”, which another message names"
        return found[key].values.union(*map(values, found[key].messages))

    return {key: values(key) for key in found}


def error_classes(trees: list[ast.Module]) -> set[str]:
    """Names of the classes under SightlineError."""
    known = {"SightlineError"}
    for _ in range(4):  # as deep as they stand on each other
        known |= {
            one.name
            for tree in trees
            for one in ast.walk(tree)
            if isinstance(one, ast.ClassDef) and known & {_last_name(base) for base in one.bases}
        }
    return known


def raised(tree: ast.Module, classes: set[str]) -> Iterator[ast.Call]:
    for one in ast.walk(tree):
        if isinstance(one, ast.Call) and _last_name(one.func) in classes:
            yield one


def _last_name(node: ast.expr) -> str:
    return ast.unparse(node).split(".")[-1]


def complaint(call: ast.Call, known: dict[str, set[str]]) -> str | None:
    """What is wrong with an error's code or values; None for one whose code is another error's."""
    code = call.args[0] if call.args else None
    if not (isinstance(code, ast.Constant) and isinstance(code.value, str)):
        return None if isinstance(code, ast.Attribute | ast.Subscript) else "its code is not written out"
    if code.value not in known:
        return f"en.ftl has no “{code.value}”"
    given = {one.arg for one in call.keywords} - {"current"}  # a conflict's, no value
    return None if given == known[code.value] else f"“{code.value}” takes {sorted(known[code.value])}"


# Read when the first test asks: every worker imports this file, one or two run its tests.
@cache
def trees() -> dict[Path, ast.Module]:
    return {path: ast.parse(path.read_text("utf-8")) for path in sorted(PACKAGE.rglob("*.py"))}


@cache
def known() -> dict[str, set[str]]:
    return catalogue(SOURCE.read_text("utf-8"))


def test_every_error_is_in_the_catalogue_with_its_values() -> None:
    classes = error_classes(list(trees().values()))
    wrong = [
        f"{path.relative_to(PACKAGE)}:{call.lineno}: {why}"
        for path, tree in trees().items()
        for call in raised(tree, classes)
        if (why := complaint(call, known()))
    ]
    assert not wrong, "\n".join(wrong)


@pytest.mark.parametrize(
    ("written", "why"),
    [
        ('BadInput("There is no survey 3.")', "en.ftl has no"),
        ('BadInput(f"There is no survey {n}.")', "not written out"),
        ('BadInput("said")', "takes ['sentence']"),
        ('BadInput("said", sentence="x", more=1)', "takes ['sentence']"),
    ],
)
def test_a_planted_one_is_found(written: str, why: str) -> None:
    (call,) = raised(ast.parse(written), {"BadInput"})
    assert why in (complaint(call, known()) or "")


def test_a_message_within_another_has_to_be_there() -> None:
    assert catalogue("a = click { b }\nb = the { $roof }")["a"] == {"roof"}
    with pytest.raises(AssertionError, match="has no “b”"):
        catalogue("a = click { b }")


def test_each_language_says_the_same_keys_and_takes_no_other_values() -> None:
    for language in messages.languages():
        other = catalogue((PACKAGE / f"messages/{language}.ftl").read_text("utf-8"))
        assert set(other) <= set(known())
        assert all(values <= known()[key] for key, values in other.items())


def test_every_message_is_said_somewhere() -> None:
    root = PACKAGE.parents[1]
    pages = [path for path in (root / "frontend/src").rglob("*.ts*") if ".test." not in path.name]
    text = "\n".join(path.read_text("utf-8") for path in [*trees(), *pages])
    written = set(re.findall(r"[\"'`]([a-z][\w-]*)[\"'`]", text, re.IGNORECASE))
    written = written.union(*(one.messages for one in named(SOURCE.read_text("utf-8")).values()))
    begun = re.findall(r"`([a-z][\w-]*-)\$\{[^}]*\}([\w-]*)`", text)
    made = [re.compile(f"{first}{_slot(first, last)}{last}") for first, last in set(begun)]
    unused = [key for key in known() if key not in written and not any(one.fullmatch(key) for one in made)]
    assert not unused, unused


def _slot(first: str, last: str) -> str:
    """What a state's, a target's or a field's name looks like in a key; pages' names have hyphens."""
    return r"[\w-]+" if last or first.endswith("page-") else r"\w+"


def test_numbers_are_said_whole_and_ungrouped_unless_the_sentence_asks() -> None:
    assert messages.say("said", {"sentence": 123456}) == "123456"
    assert messages.say("said", {"sentence": 0.000125}) == "0.000125"


def test_a_value_that_is_missing_is_no_sentence() -> None:
    with pytest.raises(ValueError, match="sentence"):
        messages.say("said", {})
    with pytest.raises(KeyError):
        messages.say("no-such-key", {})


def test_an_error_tells_its_sentence_in_english() -> None:
    error = errors.BadInput("said", sentence=Path("a/b"))
    assert (str(error), error.values) == ("a/b", {"sentence": "a/b"})


def test_a_value_of_any_size_and_any_sign_stays_one_line() -> None:
    hostile = "\x00\n\u202e" + "x" * 5000
    said = errors.BadInput("said", sentence=hostile).message
    assert (
        said.startswith("\N{REPLACEMENT CHARACTER}" * 3 + "x") and said.endswith("x…") and len(said) <= 1000
    )
