"""The heights of standards that a survey is read against, as a table of its package, and back."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict
from typing import Any

from sqlalchemy.orm import Session

from sightline.errors import Damaged
from sightline.infra.csv_package.files import Files, number, read_columns, unsafe
from sightline.infra.csv_package.schema import Column, Table
from sightline.results.standards_store import get_standards
from sightline.statistics.standards import Standard

_WHAT = ("driver_eye", "object")

STANDARDS = Table(
    "standards",
    "The heights of standards that the statistics are read against: shares of vehicles below each.",
    (
        Column("what", "string", "what the standard speaks of", required=True, enum=_WHAT),
        Column("name", "string", "the standard", required=True),
        Column("height_m", "number", "its height above the road", "m", required=True),
        Column("source", "string", "where the figure comes from"),
    ),
    primary=("what", "name"),
)


def standard_rows(session: Session, survey_id: int) -> Iterator[dict[str, Any]]:
    """The survey's table, in its order."""
    for one in get_standards(session, survey_id).standards:
        yield asdict(one)


def standards_in(files: Files) -> tuple[Standard, ...]:
    """The table of a package. Raises Damaged."""
    found = []
    for what, name, height, source in read_columns(
        files, STANDARDS.path, ("what", "name", "height_m", "source")
    ):
        height_m = number(height)
        if what not in _WHAT or height_m is None:
            raise Damaged(f"{STANDARDS.path}: {name} cannot be read; take the whole export again.")
        found.append(
            Standard(
                unsafe(name), "driver_eye" if what == "driver_eye" else "object", height_m, unsafe(source)
            )
        )
    return tuple(found)
