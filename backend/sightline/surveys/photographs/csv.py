"""Photographs of the set-up in an export: the files, a table that describes them, and back for the report."""

from operator import itemgetter

from sightline.infra.csv_package.columns import columns_within, integer, key, moment, person, text
from sightline.infra.csv_package.files import Files, read_rows, read_whole, undo_safe_text
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
        *columns_within(itemgetter(1), key("id", "photograph")),
        integer("position", "place in the order", itemgetter(0), required=True, minimum=1),
        text("file", "the photograph, in this package", lambda p: photograph_path(p[1].id), required=True),
        *columns_within(
            itemgetter(1),
            text("name", "name of the uploaded file", required=True),
            text("caption", "what it shows"),
            integer("width_px", "width", unit="px", required=True, minimum=1),
            integer("height_px", "height", unit="px", required=True, minimum=1),
            integer("size_bytes", "size of the file", unit="B", required=True, minimum=1),
            text("sha256", "SHA-256 of the file", required=True),
            person("created_by_id", "who added it"),
            moment("created_at", "when it was added"),
        ),
    ),
    primary=("id",),
)


def photos_in(files: Files) -> tuple[PhotographFile, ...]:
    """The photographs of a package for its report."""
    return tuple(
        PhotographFile(
            undo_safe_text(row["caption"]) or undo_safe_text(row["name"]), read_whole(files, row["file"])
        )
        for row in read_rows(files, PHOTOGRAPHS.key)
    )
