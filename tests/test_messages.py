"""The catalogue of messages: every key that code names is there, with the values that its sentence takes."""

import ast
import re
from collections.abc import Iterator
from datetime import date, datetime
from functools import cache
from pathlib import Path
from typing import Annotated, Any, Literal, get_args

import pytest
from fluent.syntax import FluentParser
from fluent.syntax import ast as ftl
from fluent.syntax.visitor import Visitor
from pydantic import BaseModel, ConfigDict, Field, ValidationError

import sightline
from sightline import errors, messages
from sightline.app import describe
from sightline.enums import Target
from sightline.export.package_tables import tables_of
from sightline.export.page import tables_of_page
from sightline.geometry.insets import USUAL_INSETS
from sightline.infra.web.error_handlers import _complaint
from sightline.measurements.again.csv import COMPUTINGS
from sightline.messages import Value
from sightline.messages.recognised import COLUMNS, IN_UTC, TOLD, translate_text, translated_meaning
from sightline.messages.said import Said
from sightline.results.usual_standards import STANDARDS
from sightline.statistics.standards import Standard
from tests.support import sources

PACKAGE = Path(sightline.__file__).parent
SOURCE = PACKAGE / "messages/en.ftl"
OWN = Standard("own value", "eye_car", 1.0, "entered on the page", code="own")  # a reader's own limit
#: Said by no code; runs and packages of earlier versions hold them.
STORED_BY_EARLIER = {"scan-run-stood-in-front"}
#: What standards are called and cited by in every language.
TITLES = {
    "A Policy on Geometric Design of Highways and Streets",
    "Austroads, Guide to Road Design Part 3",
    "Capaldo, Procedia Social and Behavioral Sciences 53, 2012",
    "Dupuis et al., Sensors 2019",
    "France",
    "ICTAAL",
    "Rogers, Highway Engineering, 2003",
}


class _Named(Visitor):  # type: ignore[misc]
    """The values and the other messages that a message names."""

    def __init__(self) -> None:
        self.values: set[str] = set()
        self.messages: set[str] = set()

    def visit_VariableReference(self, node: ftl.VariableReference) -> None:
        self.values.add(node.id.name)

    def visit_MessageReference(self, node: ftl.MessageReference) -> None:
        self.messages.add(node.id.name)


@cache
def parsed(text: str) -> ftl.Resource:
    return FluentParser().parse(text)


@cache
def named(text: str) -> dict[str, _Named]:
    """What each message names. Fails for what is no Fluent, and for a key that is there twice."""
    found: dict[str, _Named] = {}
    for entry in parsed(text).body:
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
    classes = [one for tree in trees for one in ast.walk(tree) if isinstance(one, ast.ClassDef)]
    for _ in range(4):  # as deep as they stand on each other
        known |= {one.name for one in classes if known & {_last_name(base) for base in one.bases}}
    return known


def raised(tree: ast.Module, classes: set[str]) -> Iterator[ast.Call]:
    for one in ast.walk(tree):
        if isinstance(one, ast.Call) and _last_name(one.func) in classes:
            yield one


def _last_name(node: ast.expr) -> str:
    match node:
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return name
    return ""


def complaint(call: ast.Call, known: dict[str, set[str]]) -> str | None:
    """What is wrong with an error's code or values; None for one whose code is another error's."""
    code = call.args[0] if call.args else None
    if not (isinstance(code, ast.Constant) and isinstance(code.value, str)):
        return None if isinstance(code, ast.Attribute | ast.Subscript) else "its code is not written out"
    if code.value not in known:
        return f"en.ftl has no “{code.value}”"
    given = {one.arg for one in call.keywords} - {"current", "retry_after_s"}  # no values
    return None if given == known[code.value] else f"“{code.value}” takes {sorted(known[code.value])}"


# Read when the first test asks: every worker imports this file, one or two run its tests.
@cache
def trees() -> dict[Path, ast.Module]:
    return {path: sources.parsed(path) for path in sorted(PACKAGE.rglob("*.py"))}


@cache
def known() -> dict[str, set[str]]:
    return catalogue(SOURCE.read_text("utf-8"))


def test_every_error_and_reason_is_in_the_catalogue_with_its_values() -> None:
    classes = error_classes(list(trees().values())) | {"Said"}
    wrong = [
        f"{path.relative_to(PACKAGE)}:{call.lineno}: {why}"
        for path, tree in trees().items()
        if path != PACKAGE / "errors.py"  # where an error makes of its code what is said
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


def test_each_language_says_every_key_and_takes_no_other_values() -> None:
    """Without that a screen would speak two languages; what is not translated yet fails here."""
    for language in messages.languages():
        other = catalogue((PACKAGE / f"messages/{language}.ftl").read_text("utf-8"))
        assert set(known()) - set(other) == set() == set(other) - set(known()), language
        assert [key for key, values in other.items() if values != known()[key]] == []


def marks(text: str) -> dict[str, set[str]]:
    """The marked parts of each message, as `<link>`."""
    return {
        one.id.name: set(re.findall(r"</?[a-z]+>", text[one.span.start : one.span.end]))
        for one in parsed(text).body
        if isinstance(one, ftl.Message) and one.span
    }


def test_each_language_marks_the_same_parts() -> None:
    """A part that is not marked is no link, and one of another name is shown as it is written."""
    source = marks(SOURCE.read_text("utf-8"))
    for language in messages.languages():
        other = marks((PACKAGE / f"messages/{language}.ftl").read_text("utf-8"))
        assert [key for key, parts in other.items() if parts != source[key]] == [], language


def test_no_sentence_takes_a_new_target_for_an_old_one() -> None:
    for language in ("en", "fr"):
        defaults = re.findall(
            r"^ *\*\[(\w+)\]", (PACKAGE / f"messages/{language}.ftl").read_text(), re.MULTILINE
        )
        assert not set(defaults) & (set(get_args(Target)) - {"other"})


@pytest.mark.parametrize("language", messages.languages())
def test_what_only_earlier_versions_said_is_still_a_sentence(language: str) -> None:
    for code in STORED_BY_EARLIER:
        said = Said.read({"code": code, "values": {}}).sentence(language)
        assert said != code and said.endswith(".")


def test_every_message_is_said_somewhere() -> None:
    root = PACKAGE.parents[1]
    pages = [path for path in (root / "frontend/src").rglob("*.ts*") if ".test." not in path.name]
    text = "\n".join(path.read_text("utf-8") for path in [*trees(), *pages, *PACKAGE.rglob("*.typ")])
    written = set(re.findall(r"[\"'`]([a-z][\w-]*)[\"'`]", text, re.IGNORECASE))
    written = written.union(*(one.messages for one in named(SOURCE.read_text("utf-8")).values()))
    begun = re.findall(r"`([a-z][\w-]*-)\$\{[^}]*\}([\w-]*)`", text)
    made = [re.compile(f"{first}{_slot(first, last)}{last}") for first, last in set(begun)]
    for first, names in re.findall(r'(?:wordsOf|[Cc]alled)\(\s*"([\w-]+-)"((?:,\s*"[\w-]+")*)', text):
        made += [re.compile(f"{first}{name}") for name in re.findall(r'"([\w-]+)"', names) or [r"\w+"]]
    found_again = (TOLD, "budget-of-", COLUMNS)  # by its text
    unused = [
        key
        for key in known()
        if key not in written | STORED_BY_EARLIER
        and not any(one.fullmatch(key) for one in made)
        and not key.startswith(found_again)
    ]
    assert not unused, unused


def _slot(first: str, last: str) -> str:
    """What a state's, a target's or a field's name looks like in a key; pages' names have hyphens."""
    return r"[\w-]+" if last or first.endswith("page-") else r"\w+"


def after_plus_minus(pattern: ftl.Pattern) -> list[str]:
    """The names of the values that a sentence puts right after "±", and what else stands there."""
    parts = pattern.elements
    found = []
    for one, following in zip(parts, [*parts[1:], None], strict=True):
        if not isinstance(one, ftl.TextElement):
            continue
        *within, last = one.value.split("±")
        found += ["text"] * max(len(within) - 1 + bool(last.strip()), 0) if within else []
        if within and not last.strip() and isinstance(following, ftl.Placeable):
            named = _Named()
            named.visit(following)
            found += sorted(named.values)
    return found


class _Patterns(Visitor):  # type: ignore[misc]
    """Every sentence of a catalogue, those within a choice among them."""

    def __init__(self) -> None:
        self.all: list[ftl.Pattern] = []

    def visit_Pattern(self, node: ftl.Pattern) -> None:
        self.all.append(node)
        self.generic_visit(node)


def not_expanded(text: str) -> list[str]:
    patterns = _Patterns()
    patterns.visit(parsed(text))
    return [name for one in patterns.all for name in after_plus_minus(one) if not name.startswith("U95")]


def test_only_an_expanded_uncertainty_follows_plus_minus() -> None:
    for language in messages.languages():
        assert not_expanded((PACKAGE / f"messages/{language}.ftl").read_text("utf-8")) == []


@pytest.mark.parametrize(
    ("sentence", "wrong"),
    [
        ("{ $height_m } ± { $U95_m } m", []),
        ("{ $height_m } ± { $u_m } m", ["u_m"]),
        ("{ $n -> *[other] { $inset } ± { $u_inset } }", ["u_inset"]),
        ("{ $height } ± 3 mm", ["text"]),
    ],
)
def test_plus_minus_before_something_else_is_found(sentence: str, wrong: list[str]) -> None:
    text = sentence.replace("-> *[other] ", "->\n   *[other] ").replace("} }", "}\n }")
    assert not_expanded(f"a = {text}\n") == wrong


def no_value_of_u(tree: ast.Module) -> list[str]:
    """What code puts after "±": the values whose names say no U95, in f-strings."""
    wrong = []
    for one in ast.walk(tree):
        if isinstance(one, ast.JoinedStr):
            for before, after in zip(one.values, one.values[1:], strict=False):
                ends = isinstance(before, ast.Constant) and str(before.value).rstrip().endswith("±")
                if ends and not re.search("u95|expanded", ast.unparse(after), re.IGNORECASE):
                    wrong.append(ast.unparse(after))
    return wrong


def test_code_puts_only_an_expanded_uncertainty_after_plus_minus() -> None:
    wrong = [(path.name, *found) for path, tree in trees().items() if (found := no_value_of_u(tree))]
    assert not wrong
    assert no_value_of_u(ast.parse('f"{height} ± {u}"')) and not no_value_of_u(ast.parse('f"±{U95_m}"'))


def test_the_report_puts_only_an_expanded_uncertainty_after_plus_minus() -> None:
    """In Typst a standard uncertainty is named u, or u_ of something."""
    said = re.compile(r"±[~ ]*#[\w.]*\bu(_\w+)?\b")
    assert said.search("[#size.ratio ± #size.u_ratio]") and not said.search("± #at~#unit.height")
    wrong = [path.name for path in sorted(PACKAGE.rglob("*.typ")) if said.search(path.read_text("utf-8"))]
    assert not wrong


def test_pages_give_only_an_expanded_uncertainty_to_what_writes_plus_minus() -> None:
    """These functions of the pages write their second value after "±"."""
    given = re.compile(r"\bformat(?:Height|Measured|Speed|Acceleration)\([^(),]*,[^(),]*\bu_\w+")
    assert given.search("formatHeight(one.inset_m, one.u_inset_m, 2)")
    assert not given.search("formatSpeed(one.u_speed_mps, null, 2)")
    pages = (PACKAGE.parents[1] / "frontend/src").rglob("*.ts*")
    assert not [path.name for path in pages if given.search(path.read_text("utf-8"))]


def test_what_is_being_loaded_is_a_thing() -> None:
    """The pages put "Loading" before it and "…" behind it."""
    pages = PACKAGE.parents[1] / "frontend/src"
    told = {
        key
        for page in pages.rglob("*.tsx")
        for key in re.findall(r'<Load(?:ing|ed of=\{\w+\}) what=\{say\("([\w-]+)"', page.read_text())
    }
    assert len(told) > 40
    for language in messages.languages():
        for key in sorted(told):
            said = messages.say(key, {"page": "-"}, language)
            assert not re.search(r"\.$|…$|^(?:Loading|Computing|Chargement|Calcul)\b", said), (
                language,
                key,
                said,
            )


def test_numbers_are_said_whole_and_ungrouped_unless_they_are_counts() -> None:
    assert messages.say("said", {"sentence": 123456}) == "123456"
    assert messages.say("said", {"sentence": 0.000125}) == "0.000125"


@pytest.mark.parametrize("language", messages.languages())
def test_counts_of_five_digits_stand_apart_by_a_narrow_space(language: str) -> None:
    counted = {"count": 12345, "all": 1234567}
    told = messages.say("overview-scans-accepted", counted, language)
    assert re.findall("[0-9\u202f]+[0-9]", told) == ["12\u202f345", "1\u202f234\u202f567"]
    few = messages.say("overview-scans-accepted", {"count": 1234, "all": 9999}, language)
    assert re.findall("[0-9]+", few) == ["1234", "9999"]
    # a frame is no count
    assert "12345" in messages.say("video-frame-changed", {"n": 12345}, language)
    assert "12345" in messages.say("video-frame-outside", {"n": 20000, "last": 12345}, language)
    ended = {"chain": "survey/1", "number": 12345}
    assert "12345" in messages.say("audit-chain-ends-elsewhere", ended, language)
    gap = messages.say("stream-clock-set", {"jump_s": 12345.5, "lines": 10000}, language)
    assert re.search("12\u202f345[.,]5 ", gap) and " 10000" in gap
    assert (messages.write_count(9999), messages.write_count(10000)) == ("9999", "10\u202f000")


@pytest.mark.parametrize("language", messages.languages())
def test_every_sentence_asks_for_its_count_with_NUMBER(language: str) -> None:
    bare = re.compile(r"\{\s*\$count\s*\}")
    text = SOURCE.with_name(f"{language}.ftl").read_text("utf-8")
    assert not [key for key, entry in messages.entries(text).items() if bare.search(entry)]


@pytest.mark.parametrize("language", messages.languages())
@pytest.mark.parametrize(
    ("key", "counts"),
    [
        ("stat-percentile-needs-alike", "needed count like"),
        ("height-pass-most-excluded", "dropped points"),
        ("strips-frames-changed", "count count_2"),
        ("vehicles-frames-changed", "count count_2"),
        ("video-other-count", "claimed count"),
        ("video-truncated", "missing count"),
        ("scan-vehicles-found", "found added revised"),
        ("passes-were-found-again", "found new known"),
        ("scan-run-swapped", "reversed found"),
        ("report-accepted-count", "n all"),
        ("report-concluded-of", "measurements vehicles"),
        ("report-joined-of", "surveys sites heights vehicles"),
    ],
)
def test_counts_beside_each_other_are_written_alike(key: str, counts: str, language: str) -> None:
    counted = dict.fromkeys(counts.split(), 12345)
    told = messages.say(key, {"percent": 10, "name": "a", "span_s": 1.0, **counted}, language)
    assert told.count("12\u202f345") == len(counted) and "12345" not in told


@pytest.mark.parametrize(
    ("key", "counted"),
    [
        ("report-concluded-of", {"measurements": 0, "vehicles": 0}),
        ("export-described-otherwise", {"count": 0, "names": "title"}),
        ("opened-evidence-events-fine", {"count": 0}),
    ],
)
def test_none_is_not_said_to_be_one_in_french_whose_singular_holds_for_0(
    key: str, counted: dict[str, str | int]
) -> None:
    told = messages.say(key, counted, "fr")
    assert "0" in told
    assert not re.search(r"\b1\b|\bune?\b", told)


@pytest.mark.parametrize("language", messages.languages())
def test_halves_are_rounded_as_tables_and_pages_round_them(language: str) -> None:
    told = [messages.say("sheet-metres", {"metres": one}, language) for one in (0.125, 2.675, -0.125)]
    sign = messages.decimal_sign(language)
    assert told == [f"{one} m".replace(".", sign) for one in ("0.13", "2.68", "-0.13")]
    share: dict[str, Value] = {"share": 4, "camera_sd_m": 0.0125}
    assert "13 mm" in messages.say("stat-reference-explains", share, language)


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


def templates() -> set[str]:
    """The sentences that code writes itself, each value a mark."""
    return {text for tree in trees().values() for one in ast.walk(tree) if (text := _template(one))}


def _template(node: ast.AST) -> str:
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return re.sub(r"\{\w+[^}]*\}", "\0", node.value).strip()
    if isinstance(node, ast.JoinedStr):
        parts = [one.value if isinstance(one, ast.Constant) else "\0" for one in node.values]
        return "".join(map(str, parts)).strip()
    return ""


class _Asked(BaseModel):
    """A request with every kind of value that ours have."""

    model_config = ConfigDict(extra="forbid")
    whole: int
    number: float
    text: str
    yes: bool
    each: list[int]
    named: dict[str, int]
    above: Annotated[float, Field(gt=0)]
    least: Annotated[int, Field(ge=1)]
    below: Annotated[float, Field(lt=3)]
    most: Annotated[int, Field(le=2)]
    one_of: Literal["a", "b"]
    short: Annotated[str, Field(max_length=3)]
    long: Annotated[str, Field(min_length=2)]
    some: Annotated[str, Field(min_length=1)]
    finite: Annotated[float, Field(allow_inf_nan=False)]
    formed: Annotated[str, Field(pattern="^a$")]
    moment: datetime
    day: date
    few: Annotated[list[int], Field(max_length=2)]
    any: Annotated[list[int], Field(min_length=1)]


def of_the_framework() -> dict[str, Said | str]:
    """What is said of each kind of complaint of Pydantic."""
    words = dict.fromkeys(_Asked.model_fields, "x") | {"long": "a", "some": "", "short": "abcd", "odd": 1}
    limits = {
        "above": 0,
        "least": 0,
        "below": 3,
        "most": 3,
        "finite": float("inf"),
        "few": [1, 2, 3],
        "any": [],
    }
    others = {"whole": 1.5, "text": 1, "number": None, "yes": None, "each": 1, "named": 1, "formed": "b"}
    found = {}
    for values in (words, words | limits, words | others, {}, words | {"whole": None, "named": None}):
        with pytest.raises(ValidationError) as refused:
            _Asked.model_validate(values)
        found |= {one["type"]: _complaint(one) for one in refused.value.errors()}
    return found


def test_what_the_framework_says_of_a_request_is_said_in_every_language() -> None:
    found = of_the_framework()
    assert len(found) > 20
    for kind, one in found.items():
        assert isinstance(one, Said) and " " in str(one), kind
        for language in set(messages.languages()) - {"en"}:
            assert one.sentence(language) not in (str(one), one.code), (kind, language)


def test_what_code_says_in_english_is_said_in_every_language() -> None:
    """A sentence that code writes otherwise than the catalogue would stay English on a French screen."""
    written = "\n".join(templates())
    assert [key for key, text in told().items() if text not in written] == []


#: Stored words that packages hold and audit events bind; pages and reports say them otherwise.
SAID_ANEW = {
    *(
        f"standard-cited-{code}"
        for code in (
            *("usa_eye_truck", "australia_eye_car", "germany_eye_car", "germany_eye_truck"),
            *("israel_eye_car", "israel_object_low"),
        )
    ),
    *(f"standard-source-{code}" for code in ("usa_eye_car", "usa_object_stopping", "usa_1920_eye_car")),
    "standard-class-france_object_stopping",
}


def test_the_words_of_the_program_s_standards_and_insets_stand_in_the_catalogue() -> None:
    """Each key is a standard's or an inset's and says its English, or better; titles have none."""
    kinds = ("name", "class", "source", "cited")
    words = {
        f"standard-{kind}-{one.code}": word
        for one in (*STANDARDS, OWN)
        for kind, word in zip(kinds, one.words, strict=True)
    }
    words |= {f"inset-note-{name}": note for name, (_, _, note) in USUAL_INSETS.items()}
    keys = [key for key in known() if key.startswith(("inset-note-", *(f"standard-{one}-" for one in kinds)))]
    said = {key: messages.say(key, {}) for key in keys}
    assert {key: text for key, text in said.items() if key not in SAID_ANEW} == {
        key: words[key] for key in keys if key not in SAID_ANEW
    }
    assert {key for key in keys if said[key] != words[key]} == SAID_ANEW
    english = {key for key in words if words[key] and key not in keys}
    assert {words[key] for key in english} == TITLES


def told() -> dict[str, str]:
    """The keys of what is found again by its text, with their English."""
    lines = SOURCE.read_text("utf-8").splitlines()
    return dict(line.split(" = ", 1) for line in lines if line.startswith(TOLD))  # type: ignore[misc]


def test_each_part_of_a_budget_that_has_words_is_one_of_code() -> None:
    keys = {key for key in known() if key.startswith("budget-of-")}
    assert len(keys) > 20
    assert keys <= {"budget-of-" + re.sub("[^a-z]+", "-", text) for text in templates()}
    assert messages.name_of("budget-of", "click, target", "fr") == "Pointé de la cible"
    assert messages.name_of("budget-of", "width 0.6", "fr") == "width 0.6"


def test_what_is_told_in_english_is_said_by_its_text() -> None:
    assert translate_text("catalogue row", "en") == "catalogue row"
    assert translate_text("catalogue row", "fr") == "ligne du catalogue"
    for key, text in told().items():
        assert translate_text(text, "fr") == messages.say(key, {}, "fr"), key


def test_every_column_that_a_package_s_page_explains_is_explained_in_every_language() -> None:
    shown = [one for table in tables_of_page(tables_of(12)) for one in table.columns]
    meanings = {one.meaning.removesuffix(IN_UTC) for one in shown}
    lines = SOURCE.read_text("utf-8").splitlines()
    known = [one.split(" = ", 1)[1] for one in lines if one.startswith(COLUMNS)]
    patterns = [r"\d+".join(map(re.escape, re.split(r"\{ \$\w+ \}", one))) for one in known]
    assert [one for one in meanings if not any(re.fullmatch(pattern, one) for pattern in patterns)] == []
    assert [one for one in patterns if not any(re.fullmatch(one, meaning) for meaning in meanings)] == []
    same = {"description", "verdict"}  # words that are the same in a language
    told = {one: translated_meaning(one, "fr") for one in meanings}
    assert {one for one, said in told.items() if one == said} <= same
    columns = [one for table in tables_of(12) for one in table.columns]
    assert [one.name for one in columns if not one.meaning or one.meaning.startswith(COLUMNS)] == []
    at = "when it was reviewed (ISO 8601, UTC)"
    assert {one.meaning for one in shown if one.name == "reviewed_at"} == {at}
    assert translated_meaning(at, "fr") == "quand la vérification a eu lieu (ISO 8601, UTC)"
    frame = "the same tyre contact on frame 11 of the measurement, x"
    assert told[frame] == "le même contact du pneu sur l’image 11 de la mesure, x"
    assert translate_text("group", "fr") == "group"  # which somebody may have typed


@pytest.fixture(scope="module")
def description() -> dict[str, Any]:
    """The schemas of the API; made once: it takes seconds."""
    schemas: dict[str, Any] = describe()["components"]["schemas"]
    return schemas


def test_the_api_says_of_a_field_what_the_package_says_of_its_column(description: dict[str, Any]) -> None:
    vehicle, computing = (description[name]["properties"] for name in ("VehicleBody", "Computing"))
    assert vehicle["roof_not_visible"]["description"] == (
        "Why the roof cannot be measured of this vehicle; none where it can."
    )
    assert vehicle["model_chosen_by"]["description"].startswith("size: ")
    meanings = {one.name: one.meaning for one in COMPUTINGS.columns}
    assert meanings["kept"] == "of an undo: how many were changed since, and stay as they are"
    assert (
        computing["kept"]["description"] == "Of an undo: how many were changed since, and stay as they are."
    )


@pytest.mark.parametrize(
    ("schema", "field", "said"),
    [
        ("VehicleBody", "in_sample", "Whether the survey's rule takes it into the sample."),
        ("VehicleBody", "counts", "unless the survey counts others too."),
        ("VehicleBody", "check_target", "counts in no distribution, quota or response."),
        (
            "MeasurementBody",
            "made",
            "snapped: the contact went from a click to the tyre found there, the target",
        ),
        ("MeasurementBody", "inset_m", "Inset: distance from the vertical plane"),
        ("MeasurementBody", "created_at", "When the revision was stored."),
        ("ScanMotionBody", "tyres_px", "none where it was not looked for."),
        ("ScanMotionBody", "lane", "or the rig has none."),
    ],
)
def test_the_api_speaks_of_its_answers_and_the_package_of_its_tables(
    description: dict[str, Any], schema: str, field: str, said: str
) -> None:
    """A field with both meanings has the catalogue's in the package, and its own in the API."""
    assert said in description[schema]["properties"][field]["description"]
    meanings = {f"{table.name} {one.name}": one.meaning for table in tables_of(2) for one in table.columns}
    assert meanings["vehicles in_sample"] == "whether the rule of sampling.csv selects it"
    assert meanings["measurements made"].startswith("how the points on `frame` were set")


def test_no_french_sign_begins_a_line() -> None:
    lines = SOURCE.with_name("fr.ftl").read_text("utf-8").splitlines()
    assert [one for one in lines if not one.startswith("#") and re.search("« | [;:?!%»]", one)] == []


@pytest.mark.parametrize("text", ["Corvane Berlan", "Smith and Sons", "", "1.2.3", "a note of mine"])
def test_what_somebody_typed_stays_as_it_is(text: str) -> None:
    assert translate_text(text, "fr") == text
