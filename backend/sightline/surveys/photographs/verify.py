"""Holding the photographs of an export against the audit chain."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sightline.errors import Damaged
from sightline.infra.csv_package.chain import stamp
from sightline.infra.csv_package.files import Files, read_rows
from sightline.infra.csv_package.schema import Cell, Written, cell_text
from sightline.surveys.photographs.csv import FOLDER, PHOTOGRAPHS, photograph_path

#: What the events say of each photograph, by number.
Replayed = Mapping[int, Mapping[str, Any]]


def check_photographs(files: Files, told: Replayed, written: Mapping[str, Written]) -> int:
    """Every photograph is the file that its audit event names, with the caption and in the order that the
    events give, and none is missing or put in; how many.
    """
    expected = _expected(told)
    rows = list(read_rows(files, PHOTOGRAPHS.path))
    if [row["id"] for row in rows] != [cell_text(PHOTOGRAPHS.columns[0], one["id"]) for one in expected]:
        raise Damaged("surveys-not-photographs-audit-events-changed", path=PHOTOGRAPHS.path)
    for row, one in zip(rows, expected, strict=True):
        for column in PHOTOGRAPHS.columns:
            if row[column.name] != cell_text(column, one[column.name]):
                raise Damaged(
                    "surveys-not-what-audit-events-say-changed",
                    path=PHOTOGRAPHS.path,
                    name=column.name,
                    id=row["id"],
                )
        if row["file"] not in written or written[row["file"]].sha256 != row["sha256"]:
            raise Damaged("surveys-not-photograph-audit-event-names-exchanged", file=row["file"])
    strange = {path for path in files.paths if path.startswith(FOLDER)} - {row["file"] for row in rows}
    if strange:
        raise Damaged("surveys-no-row-put", strange=min(strange), path=PHOTOGRAPHS.path)
    return len(rows)


def _expected(told: Replayed) -> list[dict[str, Cell]]:
    """The rows as the events tell them."""
    there: list[dict[str, Any]] = [
        {"id": id_, **one} for id_, one in told.items() if not one.get("deleted", False)
    ]
    there.sort(key=lambda one: (one["position"], one["id"]))
    return [
        {
            **one,
            "position": place,
            "file": photograph_path(one["id"]),
            "created_at": stamp(one["created_at"]),
        }
        for place, one in enumerate(there, start=1)
    ]
