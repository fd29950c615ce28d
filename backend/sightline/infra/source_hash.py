"""What a result is computed by: the hash of a module's source and of every module of the program it imports.

The imports are read from the source, so no list is kept by hand, and nothing that a result rests on is left
out: imports within functions count, those for type checkers alone do not. Other people's libraries are named
by their versions instead.
"""

import ast
import hashlib
from collections.abc import Collection, Iterator
from functools import cache
from pathlib import Path
from typing import TypeGuard

PROGRAM = __name__.partition(".")[0]
ROOT = Path(__file__).resolve().parents[2]
_STATEMENTS = ("body", "orelse", "finalbody", "handlers", "cases")


@cache
def source_hash(*modules: str, texts: tuple[str, ...] = ()) -> str:
    """16 hexadecimal digits over the source of modules and all that they import, by the paths in the program.

    texts: endings of other files that count where they lie beside one of these modules, such as ".ftl".
    """
    digest = hashlib.sha256()
    for path in sorted(_with_texts(import_closure(*modules), texts)):
        digest.update(path.relative_to(ROOT).as_posix().encode() + b"\0" + path.read_bytes() + b"\0")
    return digest.hexdigest()[:16]


def import_closure(*modules: str) -> frozenset[Path]:
    """The files of modules, of all modules of the program that they import, directly or not, and of the
    packages that hold them. Raises ModuleNotFoundError for a module without a file.
    """
    paths: dict[str, Path] = {}
    waiting = list(modules)
    while waiting:
        name = waiting.pop()
        if name in paths:
            continue
        path = _file_of(name)
        if path is None:
            raise ModuleNotFoundError(name)
        paths[name] = path
        waiting += [one for one in {*_holders(name), *_imports(name)} if _file_of(one) is not None]
    return frozenset(paths.values())


def _with_texts(files: Collection[Path], texts: tuple[str, ...]) -> Iterator[Path]:
    yield from files
    for folder in {path.parent for path in files}:
        yield from (path for path in folder.iterdir() if path.suffix in texts)


def _holders(name: str) -> list[str]:
    """The packages that are imported with a module."""
    parts = name.split(".")
    return [".".join(parts[:n]) for n in range(1, len(parts))]


@cache
def _file_of(name: str) -> Path | None:
    if name.partition(".")[0] != PROGRAM:
        return None
    place = ROOT.joinpath(*name.split("."))
    return next((one for one in (place.with_suffix(".py"), place / "__init__.py") if one.is_file()), None)


@cache
def _imports(name: str) -> frozenset[str]:
    """What a module names in imports: modules, and names in modules, which may be modules too."""
    path = _file_of(name)
    assert path is not None
    names: set[str] = set()
    waiting: list[ast.AST] = [ast.parse(path.read_bytes())]
    while waiting:
        node = waiting.pop()
        if isinstance(node, ast.Import):
            names.update(one.name for one in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            names.add(node.module)
            names.update(f"{node.module}.{one.name}" for one in node.names)
        elif _is_for_type_checkers(node):
            waiting += node.orelse
        else:
            # imports are statements: expressions, most of a file's tree, are left out
            waiting += [one for part in _STATEMENTS for one in getattr(node, part, ())]
    return frozenset(names)


def _is_for_type_checkers(node: ast.AST) -> TypeGuard[ast.If]:
    match node:
        case ast.If(test=ast.Name(id="TYPE_CHECKING") | ast.Attribute(attr="TYPE_CHECKING")):
            return True
    return False
