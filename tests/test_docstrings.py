"""What a public function of the pure rooms that takes or gives arrays says of itself: shape, failure, source.

A number that nobody can trace to an equation cannot be checked by one. So each of these functions names the
shape of every array, how it fails, and where its method comes from: a paper's equation, a standard, a book or
an article, a section of our own documents, or our own derivation, written out.
"""

import ast
import re
from collections.abc import Iterator, Set
from functools import cache
from pathlib import Path

import pytest

from tests.support.sources import parsed

ROOT = Path(__file__).resolve().parents[1]
PURE = ROOT / "backend" / "sightline"
ROOMS = ("adjustment", "detection", "geometry", "linescan", "proposals", "sightdistance", "statistics")

# Plain helpers, whose first sentence is all there is to say; their shapes are asked for like everybody's.
NEED_NO_SOURCE = {
    "adjustment": set[str](),
    "detection": set[str](),
    "geometry": {
        "board_points",
        "coverage",
        "coverage_ninths",
        "freeze_array",
        "is_covariance",
        "points",
        "polyline",
        "reach_px",
        "skew",
        "smooth_basis",
        "spacing_px",
    },
    "linescan": {"brightest_of", "median", "points_at"},
    "proposals": set[str](),
    "sightdistance": set[str](),
    "statistics": {"sorted_values", "codes_of", "compact"},
}

SIZE = r"\w+(?: [+*-] \w+)?"
SHAPE = rf"\((?:\.\.\.|{SIZE})(?:,|(?:, {SIZE})+)\)|any (?:one )?shape|same shape"
YEAR = r"(?:18|19|20)\d\d"
AUTHORS = re.compile(rf"(?<!\w)([A-Z][\w-]+)((?:(?:,| and| &) [A-Z][\w-]+)*(?: et al\.)?) ({YEAR})\b")
DOCUMENTED = (ast.FunctionDef, ast.ClassDef, ast.Module)
SOURCE = re.compile(
    "|".join(
        [
            r"CONVENTIONS\.md, [A-Z]",
            r"DECISIONS\.md \d",
            r"JCGM 10\d:\d{4}, [A-Z\d]",
            r"Dupuis et al\. 2019, (?:eqs?\. \(\d|sections? \d|Table \d|Figures? \d)",
            r"Douxchamps et al\., (?:eqs?\. \(\d|section [IV])",
            rf"(?!Dupuis){AUTHORS.pattern}",
            r"Own (?:derivation|method|readings?)[^:.]*: \S",
        ]
    )
)


def test_every_function_with_arrays_says_shapes_failure_and_source() -> None:
    functions = {room: list(public_functions(room)) for room in ROOMS}
    sourced = {f.name for found in functions.values() for _, f in found if SOURCE.search(doc_of(f))}
    found = [
        f"{path.relative_to(PURE)}:{function.lineno} {function.name}: {fault}"
        for room, known in functions.items()
        for path, function in known
        for fault in faults(function, array_types(), sourced, function.name in NEED_NO_SOURCE[room])
    ]
    assert found == []


def test_the_list_of_plain_helpers_names_functions_that_exist_and_have_no_source() -> None:
    for room, exempt in NEED_NO_SOURCE.items():
        plain = {f.name for _, f in public_functions(room) if not SOURCE.search(doc_of(f))}
        assert exempt <= plain, exempt - plain


def test_places_in_papers_and_documents_that_are_named_exist() -> None:
    conventions, decisions = ((ROOT / name).read_text() for name in ("CONVENTIONS.md", "DECISIONS.md"))
    headings = re.findall(r"^## (.+)$", conventions, re.MULTILINE)
    for room in ROOMS:
        for path in sorted((PURE / room).rglob("*.py")):
            text = " ".join(path.read_text().split())
            for named in re.findall(r"CONVENTIONS\.md, ((?!of )[^.;:)]+)", text):
                assert named.startswith(tuple(headings)), (path.name, named)
            for number in re.findall(r"DECISIONS\.md (\d+)", text):
                assert f"\n## {number}. " in decisions, (path.name, number)
            for paper, last in (("Dupuis et al. 2019", 18), ("Douxchamps et al.", 5)):
                for named in re.findall(rf"{paper}, eqs?\. ((?:\(\d+\)(?:, | to | and )?)+)", text):
                    assert all(1 <= int(n) <= last for n in re.findall(r"\d+", named)), (path.name, named)


def test_works_that_are_named_stand_in_the_list_of_sources() -> None:
    listed = (ROOT / "CONVENTIONS.md").read_text(encoding="utf-8").split("\n## Sources\n")[1]
    found = []
    for path in (path for room in ROOMS for path in sorted((PURE / room).rglob("*.py"))):
        nodes = [node for node in ast.walk(parsed(path)) if isinstance(node, DOCUMENTED)]
        for author, _, year in AUTHORS.findall(" ".join(map(doc_of, nodes))):
            if not re.search(rf"^- (?:[^\d\n]*\W)?{author}\b[^\d\n]* {year}, ", listed, re.MULTILINE):
                found.append(f"{path.relative_to(PURE)}: {author} {year}")
    assert found == []


def test_every_method_with_arrays_says_shapes_and_failure() -> None:
    """Its source stands with its class or module."""
    found = [
        f"{path.relative_to(PURE)}:{method.lineno} {method.name}: {fault}"
        for room in ROOMS
        for path, method in public_methods(room)
        for fault in faults(method, array_types(), set(), plain=True)
    ]
    assert found == []


PLANTED = '''
def planted(gray: Gray, points_px: NDArray[np.float64]) -> Floats | str:
    """Heights (N,) of points_px (N, 2), metres, or the reason why there is none (Zhang 2000); gray (H, W)."""
    if not len(gray):
        raise BadInput("Give a picture. Raises BadInput without one.")
    return points_px
'''


def planted_faults(old: str = "", new: str = "", sourced: frozenset[str] = frozenset()) -> list[str]:
    assert old in PLANTED
    (function,) = ast.parse(PLANTED.replace(old, new, 1)).body
    assert isinstance(function, ast.FunctionDef)
    return list(faults(function, {"Gray", "NDArray", "Floats"}, set(sourced), False))


RAISES = "(H, W)."
WITH_RAISES = "(H, W). Raises BadInput."


def test_a_planted_function_with_all_of_it_passes() -> None:
    assert planted_faults(RAISES, WITH_RAISES) == []


@pytest.mark.parametrize(
    ("old", "new", "fault"),
    [
        ("", "", "does not say that it raises BadInput"),
        ("gray (H, W)", "gray", "no shape of gray"),
        ("points_px (N, 2)", "points_px", "no shape of points_px"),
        ("Heights (N,)", "Heights", "no shape of what it returns"),
        ("(Zhang 2000)", "(Zhang)", "names no source"),
        ("(Zhang 2000)", "(as `other`)", "names no source"),
        ("(Zhang 2000)", "Own method.", "names no source"),
        ("(Zhang 2000)", "Dupuis et al. 2019", "names no source"),
        ("reason why there is none", "height", "does not say that it may give a reason"),
    ],
)
def test_a_planted_fault_is_found(old: str, new: str, fault: str) -> None:
    assert fault in planted_faults(old, new)


def test_a_function_as_another_has_the_others_source() -> None:
    assert "names no source" not in planted_faults("(Zhang 2000)", "(As `other`)", frozenset({"other"}))


def faults(function: ast.FunctionDef, arrays: Set[str], sourced: set[str], plain: bool) -> Iterator[str]:
    """What the docstring of a function leaves out. `sourced`: functions that "as `name`" may stand on."""
    doc = left = doc_of(function)
    for name in array_parameters(function, arrays):
        told = re.search(rf"\b{name}\b(?:(?!\. |;).){{0,60}}?(?:{SHAPE})", doc)
        if told is None:
            yield f"no shape of {name}"
        else:
            left = left.replace(told[0], "")
    if is_array(function.returns, arrays) and not re.search(SHAPE, left):
        yield "no shape of what it returns"
    if not (plain or SOURCE.search(doc) or set(re.findall(r"\b[Aa]s `(\w+)`", doc)) & sourced):
        yield "names no source"
    options = ast.unparse(function.returns).split(" | ") if function.returns else []
    if "str" in options and not re.search(r"reason|\b[Ww]hy\b|in words", doc):
        yield "does not say that it may give a reason"
    if "None" in options[1:] and "None" not in doc:
        yield "does not say that it may give None"
    for name in raised(function):
        if not re.search(rf"Raises\b[^.]*\b{name}\b", doc):
            yield f"does not say that it raises {name}"


def doc_of(node: ast.FunctionDef | ast.ClassDef | ast.Module) -> str:
    return " ".join((ast.get_docstring(node) or "").split())


def raised(function: ast.FunctionDef) -> set[str]:
    """The errors of a function's own `raise` statements."""
    errors = [node.exc for node in ast.walk(function) if isinstance(node, ast.Raise) and node.exc]
    called = [one.func if isinstance(one, ast.Call) else one for one in errors]
    return {ast.unparse(one) for one in called if ast.unparse(one)[0].isupper()}


def array_parameters(function: ast.FunctionDef, arrays: Set[str]) -> list[str]:
    given = function.args.posonlyargs + function.args.args + function.args.kwonlyargs
    return [one.arg for one in given if is_array(one.annotation, arrays)]


def is_array(annotation: ast.expr | None, arrays: Set[str]) -> bool:
    """Whether an annotation names an array type anywhere, as in `Sequence[Floats] | None`."""
    return annotation is not None and any(name in arrays for name in names_in(annotation))


def names_in(node: ast.expr) -> list[str]:
    inside = ast.walk(node)
    return [part.id if isinstance(part, ast.Name) else getattr(part, "attr", "") for part in inside]


@cache
def array_types() -> frozenset[str]:
    """NumPy's own and our names for them, such as `Floats = NDArray[np.float64]` in arrays.py."""
    known = {"NDArray", "ArrayLike", "ndarray"}
    rooms = (path for room in ROOMS for path in (PURE / room).rglob("*.py"))
    trees = [parsed(path) for path in (PURE / "arrays.py", *rooms)]
    given = [node for tree in trees for node in tree.body if isinstance(node, ast.Assign)]
    for _ in range(2):  # a name may stand for a name
        for node in given:
            names = [] if any(isinstance(n, ast.Call) for n in ast.walk(node.value)) else names_in(node.value)
            if known & set(names) and "Callable" not in names:
                known |= {target.id for target in node.targets if isinstance(target, ast.Name)}
    return frozenset(known)


def public_functions(room: str) -> Iterator[tuple[Path, ast.FunctionDef]]:
    """The public functions of a room that take or give arrays."""
    for path in sorted((PURE / room).rglob("*.py")):
        yield from ((path, one) for one in with_arrays(parsed(path).body))


def public_methods(room: str) -> Iterator[tuple[Path, ast.FunctionDef]]:
    for path in sorted((PURE / room).rglob("*.py")):
        classes = [node for node in parsed(path).body if isinstance(node, ast.ClassDef)]
        for one in classes:
            if not one.name.startswith("_"):
                yield from ((path, method) for method in with_arrays(one.body))


def with_arrays(body: list[ast.stmt]) -> list[ast.FunctionDef]:
    arrays = array_types()
    public = [n for n in body if isinstance(n, ast.FunctionDef) and not n.name.startswith("_")]
    return [one for one in public if array_parameters(one, arrays) or is_array(one.returns, arrays)]
