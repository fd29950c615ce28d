"""Photographs of the set-up in an export: the files, a table that describes them, and back for the report."""

from __future__ import annotations

from collections.abc import Iterable

from sightline.infra.csv_package.files import Files, read_rows, read_whole, unsafe
from sightline.infra.csv_package.schema import Cells, Column, Table, when
from sightline.surveys.photographs.records import Photograph, PhotographFile

FOLDER = "photographs/"

PHOTOGRAPHS = Table(
    "photographs",
    "Photographs of the set-up in the order of the report; made anew as JPEG, without what a camera wrote "
    "into the file.",
    (
        Column("id", "integer", "photograph", required=True),
        Column("position", "integer", "place in the order", required=True, minimum=1),
        Column("file", "string", "the photograph, in this package", required=True),
        Column("name", "string", "name of the file that was given", required=True),
        Column("caption", "string", "what it shows"),
        Column("width_px", "integer", "width", "px", required=True, minimum=1),
        Column("height_px", "integer", "height", "px", required=True, minimum=1),
        Column("size_bytes", "integer", "size of the file", "B", required=True, minimum=1),
        Column("sha256", "string", "SHA-256 of the file", required=True),
        Column("created_by_id", "integer", "who added it"),
        Column("created_at", "datetime", "when it was added (ISO 8601, UTC)"),
    ),
    primary=("id",),
    foreign=((("created_by_id",), "people", ("id",)),),
)


def photograph_path(photograph_id: int) -> str:
    return f"{FOLDER}photograph-{photograph_id}.jpg"


def photograph_rows(photographs: Iterable[Photograph]) -> list[Cells]:
    """One row for each, in their order."""
    same = ("id", "name", "caption", "width_px", "height_px", "size_bytes", "sha256")
    return [
        {
            **{name: getattr(one, name) for name in same},
            "position": place,
            "file": photograph_path(one.id),
            "created_by_id": None if one.created_by is None else one.created_by.id,
            "created_at": when(one.created_at),
        }
        for place, one in enumerate(photographs, start=1)
    ]


def photos_in(files: Files) -> tuple[PhotographFile, ...]:
    """The photographs of a package for its report."""
    return tuple(
        PhotographFile(unsafe(row["caption"]) or unsafe(row["name"]), read_whole(files, row["file"]))
        for row in read_rows(files, PHOTOGRAPHS.path)
    )
