"""The audit trail is read by people: what the server writes there has a word in the catalogue of messages."""

import ast
from pathlib import Path

SOURCE = Path(__file__).parents[2] / "backend" / "sightline"
ENGLISH = SOURCE / "messages" / "en.ftl"


def _written() -> set[str]:
    """Keys of the actions and entities that stand as plain text in a call of the trail."""
    keys: set[str] = set()
    for path in SOURCE.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Call) and ast.unparse(node.func) in ("trail.record", "trail.record_many"):
                for kind, given in zip(("action", "entity"), node.args[2:4], strict=True):
                    if isinstance(given, ast.Constant) and isinstance(given.value, str):
                        keys.add(f"audit-{kind}-{given.value}")
    return keys


def test_what_the_trail_says_has_words() -> None:
    written = _written()
    assert "audit-entity-measurement" in written
    said = {line.split(" = ")[0] for line in ENGLISH.read_text().splitlines() if " = " in line}
    assert sorted(written - said) == []
