"""Photographs of the set-up in an export: the files, a table that describes them, and back for the report."""

from __future__ import annotations

from sightline.infra.csv_package.columns import integer, key, moment, person, text
from sightline.infra.csv_package.files import Files, read_rows, read_whole, unsafe
from sightline.infra.csv_package.schema import Table
from sightline.surveys.photographs.records import Photograph, PhotographFile

FOLDER = "photographs/"


def photograph_path(photograph_id: int) -> str:
    return f"{FOLDER}photograph-{photograph_id}.jpg"


#: A photograph and its place in the order, from 1.
Placed = tuple[int, Photograph]

PHOTOGRAPHS: Table[Placed] = Table(
    "photographs",
    "Photographs of the set-up in the order of the report; made anew as JPEG, without what a camera wrote "
    "into the file.",
    (
        key("id", "photograph", lambda p: p[1].id),
        integer("position", "place in the order", lambda p: p[0], required=True, minimum=1),
        text("file", "the photograph, in this package", lambda p: photograph_path(p[1].id), required=True),
        text("name", "name of the uploaded file", lambda p: p[1].name, required=True),
        text("caption", "what it shows", lambda p: p[1].caption),
        integer("width_px", "width", lambda p: p[1].width_px, unit="px", required=True, minimum=1),
        integer("height_px", "height", lambda p: p[1].height_px, unit="px", required=True, minimum=1),
        integer(
            "size_bytes", "size of the file", lambda p: p[1].size_bytes, unit="B", required=True, minimum=1
        ),
        text("sha256", "SHA-256 of the file", lambda p: p[1].sha256, required=True),
        person("created_by_id", "who added it", lambda p: p[1].created_by),
        moment("created_at", "when it was added", lambda p: p[1].created_at),
    ),
    primary=("id",),
    foreign=((("created_by_id",), "people", ("id",)),),
)


def photos_in(files: Files) -> tuple[PhotographFile, ...]:
    """The photographs of a package for its report."""
    return tuple(
        PhotographFile(unsafe(row["caption"]) or unsafe(row["name"]), read_whole(files, row["file"]))
        for row in read_rows(files, PHOTOGRAPHS.key)
    )
