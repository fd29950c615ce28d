"""The rules of the house that no other tool keeps: records by name, clean locks, no machine paths, papers."""

import ast
import re
import subprocess
from pathlib import Path
from typing import get_args

import pytest

from sightline import enums
from tests.support.sources import parsed

ROOT = Path(__file__).resolve().parents[1]


def tracked(*patterns: str) -> list[Path]:
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard", *patterns],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    return [ROOT / name for name in listed.stdout.splitlines() if (ROOT / name).is_file()]


@pytest.mark.parametrize("lock", ["requirements.lock", "requirements-dev.lock", "frontend/package-lock.json"])
def test_locks_have_hashes_and_name_no_registry(lock: str) -> None:
    text = (ROOT / lock).read_text()
    assert "sha256:" in text or '"integrity"' in text
    assert '"resolved": "http' not in text
    assert "index-url" not in text
    assert lock.endswith(".json") or "://" not in text


def test_no_file_carries_a_path_of_one_machine() -> None:
    # Spelled in pieces, so that this file does not find itself; the slash first, which is quick to look for.
    homes = [f"/{name}/" + rf"(?<![\w.]/{name}/)" for name in ("work", "root")]
    banned = re.compile("|".join([*homes, "/tmp/" + r"[a-z]+_"]))
    found = [
        f"{path.relative_to(ROOT)}:{number}"
        for path in tracked()
        if path.suffix not in {".png", ".lock"}
        and path.name != "package-lock.json"
        and banned.search(text := path.read_text(encoding="utf-8", errors="replace"))
        for number, line in enumerate(text.splitlines(), 1)
        if banned.search(line)
    ]
    assert not found


#: Who reads CSV: `given_csv` what people bring, the others what this program wrote itself, byte for byte.
READ_CSV = {
    "infra/given_csv.py",
    "infra/csv_package/files.py",
    "infra/csv_package/forms.py",
    "export/seal.py",
}


def test_what_people_bring_has_one_reader_of_tables() -> None:
    reads = re.compile(r"\bcsv\.(reader|DictReader)\b|\b(np|numpy|pd|pandas)\.\w*(txt|csv)\(|read_csv_auto")
    package = ROOT / "backend" / "sightline"
    found = {
        str(path.relative_to(package)) for path in package.rglob("*.py") if reads.search(path.read_text())
    }
    assert found == READ_CSV


STYLES = ROOT / "frontend" / "src"


def selectors(style: str) -> list[str]:
    """The selectors of a sheet, one by one; those inside a media query too."""
    rules = re.findall(r"([^{};]+)\{", re.sub(r"/\*.*?\*/", "", style, flags=re.DOTALL))
    return [
        selector.strip()
        for rule in rules
        if not rule.lstrip().startswith("@")
        for selector in re.split(r",(?![^(]*\))", rule)
    ]


def blocks_by_file(styles: dict[str, str]) -> dict[str, set[str]]:
    """The files that declare each class block: `name` owns `name__part` and `name--kind`.

    The first class of a selector says whose rule it is; what follows it is where the rule applies, so that
    `.facts-form .input` is a rule of `facts-form` and does not declare `input`.
    """
    files: dict[str, set[str]] = {}
    for file, style in styles.items():
        for selector in selectors(style):
            if name := re.search(r"\.([A-Za-z][\w-]*)", selector):
                files.setdefault(re.split("__|--", name[1])[0], set()).add(file)
    return files


def our_styles() -> dict[str, str]:
    return {str(path.relative_to(STYLES)): path.read_text(encoding="utf-8") for path in STYLES.rglob("*.css")}


def test_a_class_block_is_declared_in_one_file() -> None:
    """A screen's sheet stays when another screen is opened: a name in two of them breaks the second."""
    styles = our_styles()
    assert len(styles) > 20
    assert {name: files for name, files in blocks_by_file(styles).items() if len(files) > 1} == {}


def test_a_planted_second_declaration_is_found() -> None:
    styles = {
        "a.css": ".card { gap: 0 } .card__name, .card--wide:has(.list, .row) { gap: 0 }",
        "b.css": "@media (max-width: 1px) { .list .card { gap: 0 } h2.card__name { gap: 0 } }",
    }
    assert blocks_by_file(styles) == {"card": {"a.css", "b.css"}, "list": {"b.css"}}


def test_sheets_of_screens_style_nothing_but_their_own_classes() -> None:
    bare = [
        f"{file}: {selector}"
        for file, style in our_styles().items()
        if not file.startswith(("style/", "app/"))
        for selector in selectors(style)
        if "." not in selector
    ]
    assert bare == []


def test_the_papers_are_there_and_name_the_two_commands() -> None:
    for paper in ("CONVENTIONS.md", "DECISIONS.md", "CHANGELOG.md", "CONTRIBUTING.md", "LICENSE"):
        assert (ROOT / paper).stat().st_size > 200, paper
    readme = (ROOT / "README.md").read_text()
    assert "make run" in readme and "make test" in readme
    for picture in re.findall(r"!\[[^\]]*\]\(([^)]+)\)", readme):
        assert (ROOT / picture).is_file(), picture


def test_ci_runs_make_test_and_prepares_nothing_else() -> None:
    commands = (ROOT / ".ci/run").read_text()
    assert "make test" in commands
    assert not re.search(r"\b(pip|npm|apt|apt-get|install)\b", commands)


MOST_BY_POSITION = 5


def test_no_record_is_filled_by_position() -> None:
    """Two neighbouring floats exchanged are a wrong number that looks right. Rows of a table that a module
    writes out at its top level are exempt: there the eye compares columns.
    """
    backend = ROOT / "backend"
    trees = {path: parsed(path) for path in tracked("backend/*.py")}
    records_of = {
        path: {
            node.name: f"{_module(path, backend)}.{node.name}"
            for node in tree.body
            if isinstance(node, ast.ClassDef) and any("dataclass" in ast.dump(d) for d in node.decorator_list)
        }
        for path, tree in trees.items()
    }
    records = {name for of_module in records_of.values() for name in of_module.values()}
    found = []
    for path, tree in trees.items():
        known = dict(records_of[path])
        for node in ast.walk(tree):
            if isinstance(node, ast.ImportFrom):
                known |= {one.asname or one.name: f"{node.module}.{one.name}" for one in node.names}
        outer = [*tree.body, *(one for node in tree.body for one in getattr(node, "body", []))]
        for function in (node for node in outer if isinstance(node, ast.FunctionDef)):
            for call in (node for node in ast.walk(function) if isinstance(node, ast.Call)):
                name = call.func.id if isinstance(call.func, ast.Name) else None
                if name and len(call.args) > MOST_BY_POSITION and known.get(name) in records:
                    found.append(f"{path.relative_to(ROOT)}:{call.lineno} {name}")
    assert sorted(set(found)) == []


def _module(path: Path, root: Path) -> str:
    return ".".join(path.relative_to(root).with_suffix("").parts)


WORD_LISTS = {
    name: frozenset(words)
    for name, alias in vars(enums).items()
    if len(words := get_args(alias)) > 1 and all(isinstance(word, str) for word in words)
}


def _words_of(node: ast.AST) -> frozenset[str]:
    """The words of a display, or of a dictionary's keys, that holds nothing else."""
    parts = node.keys if isinstance(node, ast.Dict) else getattr(node, "elts", [])
    words = [part.value for part in parts if isinstance(part, ast.Constant) and isinstance(part.value, str)]
    return frozenset(words) if len(words) == len(parts) else frozenset()


def retyped_lists(tree: ast.Module) -> list[str]:
    """Where a module writes down one of the lists of `enums.py`, or a list of words as a type of its own.

    A dictionary that says whose keys it has (`dict[Target, ...]`) declares nothing: mypy holds its keys.
    """
    found = []
    nodes = list(ast.walk(tree))
    tables = {node.value: node.annotation for node in nodes if isinstance(node, ast.AnnAssign)}
    for node in nodes:
        if isinstance(node, ast.Subscript) and getattr(node.value, "id", None) == "Literal":
            words = _words_of(node.slice)
            if len(words) > 1 and any(word == word.lower() for word in words):  # capitals are PyAV's
                found.append(f"{node.lineno} Literal")
        elif isinstance(node, ast.Tuple | ast.List | ast.Set | ast.Dict):
            mine = _words_of(node)
            names = [name for name, words in WORD_LISTS.items() if words == mine]
            table = ast.unparse(tables[node]) if names and node in tables else ""
            if names and not any(table.startswith(f"dict[{name}, ") for name in names):
                found.append(f"{node.lineno} {names[0]}")
    return found


def test_lists_of_words_are_declared_in_enums_alone() -> None:
    assert len(WORD_LISTS) > 30
    modules = [path for path in tracked("backend/*.py") if path.name != "enums.py"]
    assert len(modules) > 300
    assert [f"{path.name}:{line}" for path in modules for line in retyped_lists(parsed(path))] == []


@pytest.mark.parametrize(
    "planted",
    [
        'Status = Literal["ok", "not_measurable"]',
        'own: Literal["here", "there"]',
        'choice = click.Choice(["direct", "paper"])',
        'enum = ("found", "person")',
        'if word in {"low_light", "daytime"}: pass',
        '_RANK = {"viewer": 0, "operator": 1, "reviewer": 2, "admin": 3}',
        '_RANK: dict[str, int] = {"viewer": 0, "operator": 1, "reviewer": 2, "admin": 3}',
    ],
)
def test_a_planted_list_of_words_is_found(planted: str) -> None:
    assert retyped_lists(ast.parse(planted))


def test_a_table_by_the_words_of_a_list_is_not_a_second_list() -> None:
    table = 'RANK: dict[Role, int] = {"viewer": 0, "operator": 1, "reviewer": 2, "admin": 3}'
    for planted in (table, 'NEEDED: tuple[Target, ...] = ("roof", "taillight")'):
        assert retyped_lists(ast.parse(planted)) == []


MOST_PLACES = 7


def declares(source: str, name: str) -> bool:
    """Whether a module writes a field's name down: as a field, a text or a keyword; reading it is free."""
    for node in ast.walk(ast.parse(source)):
        match node:
            case ast.AnnAssign(target=ast.Name(id=said)) | ast.Constant(value=said) | ast.keyword(arg=said):
                if said == name:
                    return True
    return False


def test_a_result_of_a_measurement_is_written_down_in_seven_places_at_most() -> None:
    """Record, computation, table, migration, package, and the statistics of a database and of a package."""
    name = "uncorrected_height_m"
    modules = tracked("backend/*.py", "migrations/*.py")
    places = [
        str(path.relative_to(ROOT))
        for path in modules
        if name in (text := path.read_text()) and declares(text, name)
    ]
    assert "backend/sightline/measurements/records.py" in places
    assert len(places) <= MOST_PLACES, places


@pytest.mark.parametrize("planted", ["class A:\n    x_m: float", 'Column("x_m", Float)', "made(x_m=1.0)"])
def test_a_planted_place_is_counted(planted: str) -> None:
    assert declares(planted, "x_m")
    assert not declares("height = record.x_m\nx_mm = 1", "x_m")
