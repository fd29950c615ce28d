"""A name says what it is: `one` may stand for a thing over three lines, no longer."""

import ast
from collections.abc import Iterator
from pathlib import Path
from typing import TypeGuard

from tests.support.sources import parsed

PACKAGE = Path(__file__).resolve().parents[1] / "backend" / "sightline"
MOST_LINES = 3


def is_one(node: ast.AST) -> TypeGuard[ast.Name | ast.arg]:
    return getattr(node, "id", "") == "one" or (isinstance(node, ast.arg) and node.arg == "one")


def has_its_own(node: ast.AST) -> bool:
    """A function; a lambda or a comprehension that binds `one`."""
    if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
        return True
    binding: list[ast.AST] = [node.args] if isinstance(node, ast.Lambda) else []
    binding += [part.target for part in getattr(node, "generators", [])]
    return any(is_one(inner) for part in binding for inner in ast.walk(part))


def things_called_one(scope: ast.AST) -> Iterator[list[int]]:
    """The lines of each: it begins where it is bound and ends where the next is; a comprehension has one."""
    names: list[ast.Name | ast.arg] = []
    waiting = list(ast.iter_child_nodes(scope))
    while waiting:
        node = waiting.pop()
        if has_its_own(node):
            yield from things_called_one(node)
            continue
        if is_one(node):
            names.append(node)
        waiting += ast.iter_child_nodes(node)
    lines: list[int] = []
    for name in sorted(names, key=lambda name: (name.lineno, name.col_offset)):
        if isinstance(getattr(name, "ctx", None), ast.Store) and not hasattr(scope, "generators"):
            yield lines
            lines = []
        lines.append(name.lineno)
    yield lines


def test_nothing_is_called_one_for_long() -> None:
    long = [
        f"{path.relative_to(PACKAGE)}:{min(lines)} to {max(lines)}"
        for path in sorted(PACKAGE.rglob("*.py"))
        for lines in things_called_one(parsed(path))
        if lines and max(lines) - min(lines) >= MOST_LINES
    ]
    assert not long, "give these a name that says what they are: " + ", ".join(long)
