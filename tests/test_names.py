"""Functions are named by what they do or give: no bare participle, none of the names that say nothing."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

from tests.support.sources import parsed

PACKAGE = Path(__file__).resolve().parents[1] / "backend" / "sightline"

#: One word that ends so, or one of these, and no verb or noun with it (`held`, `chosen`, `alike`).
BARE = re.compile(
    r"[a-z]+(?<!e)ed|(un)?(said|told|seen|drawn|held|shown|laid|made|kept|found|known|spoken|frozen|done|gone|given)"
    r"|chosen|written|stood|thought|left|lost|upright|alike|alone|apart|beside|together|blind|exact|foremost|densest"
    r"|silent|harmless|always|anybody|off|within|again|un(safe|usable|likely)|settable|outgoing|present|whole"
)
#: An expanded uncertainty is what the field calls it, and other programs import it (`sightline.expanded`).
RIGHT = {"coverage.py expanded"}
#: Each of these once stood for a dozen different things.
EMPTY = re.compile("_(told|rows|read|text|words|seen|plain|found|same|moved|beside|alike|said|stored)")


def functions(path: Path) -> Iterator[tuple[str, bool]]:
    """The names of a file's functions and methods, and whether each stands by itself in the module."""
    tree = parsed(path)
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            # a route's name is its operation's in the API, which other programs know
            route = any(ast.unparse(one).startswith("router.") for one in node.decorator_list)
            yield node.name, node in tree.body and not route


def test_no_function_is_named_by_a_participle_or_by_an_empty_word() -> None:
    found = {
        f"{path.relative_to(PACKAGE)} {name}"
        for path in PACKAGE.rglob("*.py")
        for name, alone in functions(path)
        if (alone and BARE.fullmatch(name)) or EMPTY.fullmatch(name)
    }
    assert found == RIGHT
