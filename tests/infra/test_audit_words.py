"""The audit trail is read by people: what the server writes there has a word in the catalogue of messages."""

import ast
from pathlib import Path

from tests.support.sources import parsed

SOURCE = Path(__file__).parents[2] / "backend" / "sightline"
ENGLISH = SOURCE / "messages" / "en.ftl"


#: Calls that write an event for their caller, each with the action in the fourth place.
FOR_OTHERS = ("written_once", "_note", "_write")


def _name(function: ast.expr) -> str:
    match function:
        case ast.Name(id=name):
            return name
        case ast.Attribute(value=ast.Name(id=of), attr=name):
            return f"{of}.{name}"
    return ""


def _written() -> set[str]:
    """Keys of actions and entities that stand as plain text in a call of the trail, or of what calls it."""
    keys: set[str] = set()
    for path in SOURCE.rglob("*.py"):
        for node in (one for one in ast.walk(parsed(path)) if isinstance(one, ast.Call)):
            called, said = _name(node.func), list[tuple[str, ast.expr]]()
            if called in ("trail.record", "trail.record_many"):
                said = list(zip(("action", "entity"), node.args[2:4], strict=True))
            elif called in FOR_OTHERS and len(node.args) > 3:
                said = [("action", node.args[3])]
            elif called in ("table_written_once", "table_changed_by_events"):
                said = [("entity", node.args[1])]
            for kind, given in said:
                words = (one.value for one in ast.walk(given) if isinstance(one, ast.Constant))
                keys |= {f"audit-{kind}-{word}" for word in words if isinstance(word, str)}
    return keys


def test_what_the_trail_says_has_words() -> None:
    written = _written()
    assert "audit-entity-measurement" in written
    said = {line.split(" = ")[0] for line in ENGLISH.read_text().splitlines() if " = " in line}
    assert sorted(written - said) == []
