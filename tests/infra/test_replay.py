"""A row is what its events say: each way in which a table may differ from them is found and named."""

import io
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from sightline.errors import Damaged
from sightline.infra.csv_package.columns import columns_within, flag, key, metres, number, text
from sightline.infra.csv_package.files import FolderFiles, TableWriter
from sightline.infra.csv_package.replay import Digests, Replay, Replayed, hold, hold_all, values_of
from sightline.infra.csv_package.schema import Column, Table

CARS: Table[Any] = Table(
    "cars",
    "Cars.",
    (
        key("id", "car"),
        text("name", "its name"),
        metres("height_m", "its height"),
        number("speed_mps", "its speed", "m/s"),
        flag("seen", "whether somebody saw it"),
        Column("created_at", "datetime", "when"),
    ),
    primary=("id",),
)
FIRST = {
    **{"id": 1, "name": "=A", "height_m": 3, "speed_mps": 2, "seen": True},
    "created_at": "2026-01-01T00:00:00+00:00",
}
SECOND = {**FIRST, "id": 2, "name": None, "seen": False}
ROWS = ("1,'=A,3.000000,2.0,true,2026-01-01T00:00:00Z", "2,,3.000000,2.0,false,2026-01-01T00:00:00Z")


@pytest.fixture
def files(tmp_path: Path) -> Callable[..., FolderFiles]:
    def written(*rows: str, header: str = ",".join(CARS.header)) -> FolderFiles:
        place = tmp_path / CARS.path
        place.parent.mkdir(exist_ok=True)
        place.write_text("\n".join([header, *rows, ""]))
        return FolderFiles(tmp_path)

    return written


def test_rows_as_their_events_say_hold(files: Callable[..., FolderFiles]) -> None:
    held = list(hold(files(*ROWS), CARS, [SECOND, FIRST]))
    assert [row["id"] for row in held] == ["1", "2"]
    hold_all(files(*ROWS), CARS, [FIRST, SECOND], in_order=True)


@pytest.mark.parametrize(
    ("rows", "said"),
    [
        ((ROWS[0].replace("=A", "=B"), ROWS[1]), "cars.csv: name of row 1 differs"),
        ((ROWS[0].replace("3.0", "3.1"), ROWS[1]), "height_m of row 1 differs"),
        ((ROWS[0].replace("2.0", "2.1"), ROWS[1]), "speed_mps of row 1 differs"),
        ((ROWS[0], ROWS[1].replace("false", "true")), "seen of row 2 differs"),
        ((ROWS[0], ROWS[1].replace("2026", "2025")), "created_at of row 2 differs"),
        ((ROWS[0], ROWS[1].replace("2,,", "2,C,")), "name of row 2 differs"),
        ((ROWS[0],), "row 2 is missing, although"),
        ((*ROWS, ROWS[1].replace("2,,", "3,,")), "row 3 has no audit event"),
        ((*ROWS, ROWS[1]), "row 2 has no audit event"),
    ],
)
def test_what_was_changed_is_named(
    files: Callable[..., FolderFiles], rows: tuple[str, ...], said: str
) -> None:
    with pytest.raises(Damaged, match=said):
        hold_all(files(*rows), CARS, [FIRST, SECOND])


def test_where_the_order_is_told_it_holds(files: Callable[..., FolderFiles]) -> None:
    with pytest.raises(Damaged, match="of row 2 differs"):
        hold_all(files(*reversed(ROWS)), CARS, [FIRST, SECOND], in_order=True)


def test_a_column_that_a_package_lacks_is_not_compared(files: Callable[..., FolderFiles]) -> None:
    hold_all(files("1,'=A", header="id,name"), CARS, [FIRST])


CAR = {"id": 1, "name": "A", "height_m": 3.0, "speed_mps": 2.0, "seen": True, "created_at": "today"}
CELLS = {"id": "1", "name": "A", "height_m": "3.000000", "speed_mps": "2.0", "seen": "true"}


def digests(*, header: tuple[str, ...] = tuple(CELLS)) -> Digests:
    told = Digests(CARS, header)
    told.tell((1, 1), SimpleNamespace(**{**CAR, "name": "B"}))
    told.tell((1, 1), SimpleNamespace(**CAR))
    told.tell((2, 1), SimpleNamespace(**CAR))
    return told


def test_a_million_rows_are_held_by_their_digests() -> None:
    told = digests()
    told.hold((1, 1), {**CELLS, "created_at": "another column"})
    with pytest.raises(Damaged, match=r"cars\.csv: row 1 1 has no audit event"):
        told.hold((1, 1), CELLS)
    with pytest.raises(Damaged, match=r"cars\.csv: row 2 1 is missing, although"):
        told.require_none_left(lambda number: number == 1)
    told.require_none_left(lambda number: number == 2)
    for name in CELLS:
        with pytest.raises(Damaged, match=r"cars\.csv: row 1 1 differs from its audit event"):
            digests().hold((1, 1), {**CELLS, name: "another"})
    assert not digests().are_told((1, 1), CELLS, CELLS) and not digests().are_told((1, 1))
    digests(header=("id",)).hold((1, 1), {"id": "1", "name": "what the package does not have"})


def test_only_words_whose_codes_the_table_has_are_left_out() -> None:
    """A column of codes that somebody puts into a package frees no other column."""
    digests(header=(*CELLS, "name_code")).hold((1, 1), CELLS)
    with pytest.raises(Damaged, match="row 1 1 differs"):
        digests(header=(*CELLS, "name_code")).hold((1, 1), {**CELLS, "name": "another", "name_code": ""})
    table = replace(CARS, columns=(*CARS.columns, text("name_code", "its name by code")))
    for header, is_held in ((("id", "name", "name_code"), False), (("id", "name"), True)):
        told = Digests(table, header)
        told.tell((1,), SimpleNamespace(**CAR, name_code="[]"))
        assert told.are_told((1,), {"id": "1", "name": "another", "name_code": "[]"}) != is_held


def event(number: int, entity: str, entity_id: int, actor: str = "7") -> dict[str, str]:
    return {"number": str(number), "entity": entity, "entity_id": str(entity_id), "actor_id": actor}


def test_events_of_one_row_are_told_together_and_go_with_what_they_are_part_of() -> None:
    replay = Replay({"wheel": ("car_id", "car")})
    replay.add(event(1, "car", 1), {"name": "A"})
    replay.add(event(2, "wheel", 5), {"car_id": 1})
    replay.add(event(3, "car", 1, "8"), {"name": "B"})
    (car,) = replay.standing("car")
    assert (car["name"], car["created_by_id"], car["actor_id"], car["event"]) == ("B", 7, 8, 3)
    assert [told["id"] for told in replay.standing("wheel")] == [5]
    replay.add(event(4, "car", 1), {"deleted": True})
    assert not list(replay.standing("car")) and not list(replay.standing("wheel"))
    assert replay.is_gone("wheel", 5) and not replay.is_gone("wheel", 6)
    replay.add(event(5, "car", 1), {"deleted": False})
    assert len(list(replay.standing("wheel"))) == 1


def test_a_table_says_how_its_rows_follow(files: Callable[..., FolderFiles]) -> None:
    replay = Replay({})
    replay.add(event(1, "car", 1, ""), {"called": "=A"})
    told = Replayed(CARS, "car", cells=lambda told: {**told, "name": told["called"]})
    assert [row["name"] for row in replay.hold(files("1,'=A,,,,"), told)] == ["'=A"]
    with pytest.raises(Damaged, match="name of row 1"):
        list(replay.hold(files("1,B,,,,"), told))


def test_values_are_those_of_the_columns_getters() -> None:
    table: Table[dict[str, Any]] = Table("t", "T.", (key("id", "car", lambda one: one["number"]),))
    assert values_of(table, {"number": 3}) == {"id": 3}


def test_a_column_without_a_getter_is_what_the_record_has_by_its_name() -> None:
    """As an attribute or as a mapping's value; of a part of the record within it, or nothing."""
    columns: tuple[Column[Any], ...] = (
        key("id", "car"),
        *columns_within("driver", text("name", "its driver")),
    )
    table: Table[Any] = Table("t", "T.", columns)
    alone, driven = (
        SimpleNamespace(id=n, driver=who) for n, who in ((1, None), (2, SimpleNamespace(name="B")))
    )
    assert values_of(table, driven) == {"id": 2, "name": "B"}
    out = io.BytesIO()
    writer = TableWriter(out, table)
    for one in (alone, driven):
        writer.add(one)
    of_mappings = TableWriter(out, Table[Any]("m", "M.", (key("id", "car"), text("name", "its name"))))
    of_mappings.add({"id": 3})
    assert out.getvalue() == b"id,name\n1,\n2,B\nid,name\n3,\n"
