"""The heights of standards that a survey is read against, as a table of its package, and back."""

from __future__ import annotations

from typing import get_args

from sightline.enums import StandardHeight
from sightline.errors import Damaged
from sightline.infra.csv_package.columns import metres, text
from sightline.infra.csv_package.files import Files, number, read_columns, unsafe
from sightline.infra.csv_package.schema import Table
from sightline.statistics.standards import Standard

STANDARDS: Table[Standard] = Table(
    "standards",
    "The heights of standards that the statistics are read against: shares of vehicles below each.",
    (
        text(
            "what",
            "what the standard speaks of",
            lambda s: s.what,
            required=True,
            enum=get_args(StandardHeight),
        ),
        text("name", "the standard", lambda s: s.name, required=True),
        metres("height_m", "its height above the road", lambda s: s.height_m, required=True),
        text("source", "where the figure comes from", lambda s: s.source),
    ),
    primary=("what", "name"),
)


def standards_in(files: Files) -> tuple[Standard, ...]:
    """The table of a package. Raises Damaged."""
    found = []
    for what, name, height, source in read_columns(
        files, STANDARDS.path, ("what", "name", "height_m", "source")
    ):
        height_m = number(height)
        if what not in get_args(StandardHeight) or height_m is None:
            raise Damaged("results-cannot-read-take-whole-export-again", path=STANDARDS.path, name=name)
        found.append(
            Standard(
                unsafe(name), "driver_eye" if what == "driver_eye" else "object", height_m, unsafe(source)
            )
        )
    return tuple(found)
