"""The table of heights computed again in the package."""

from typing import Any, get_args

from sightline.enums import ComputingCause
from sightline.infra.csv_package.columns import (
    columns_for,
    integer,
    join_sentences,
    key,
    moment,
    person,
    text,
)
from sightline.infra.csv_package.schema import Column, Table
from sightline.measurements.again.records import Computing

_CAUSES: tuple[tuple[ComputingCause, str], ...] = (
    ("pose", "heights that followed from another road pose, or another calibration of a line camera"),
    ("inset", "heights that followed from another inset"),
    ("side", "heights that followed from another side of the driver"),
    ("program", "heights that another version of the program came to"),
)
assert {cause for cause, _ in _CAUSES} == set(get_args(ComputingCause))


def out_of_date(pose: str) -> Column[Any]:
    """Why a height, a record with `out_of_date`, is so; `pose`: what its pose is called here."""
    return text(
        "out_of_date",
        "why the height is out of date, separated by semicolons: pose, inset or side where it follows from "
        f"another {pose}, another usual inset or another side of the driver than holds now in this package; "
        "empty: it is not. Compute the heights again in the survey and export it anew",
        lambda record: join_sentences(record.out_of_date) or None,
    )


def _of_cause(cause: ComputingCause, meaning: str) -> Column[Computing]:
    return integer(f"by_{cause}", meaning, lambda c: c.causes.get(cause, 0), required=True, minimum=0)


COMPUTINGS: Table[Computing] = Table(
    "computings",
    "Each time that heights of the survey were computed again together; the revisions that this made name it "
    "in revisions.csv and in line_heights.csv, and the height before stands in the revision before.",
    (
        key("id", "the computing"),
        *columns_for(Computing, "kind undoes"),
        *columns_for(Computing, "heights to_review kept", minimum=0),
        *columns_for(Computing, "largest_m"),
        *(_of_cause(cause, meaning) for cause, meaning in _CAUSES),
        text("code_version", "version of the program", required=True),
        person("created_by_id", "who asked for it"),
        moment("created_at", "when"),
    ),
    primary=("id",),
)
