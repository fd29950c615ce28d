"""The table of vehicles in the package."""

from typing import get_args

from sightline.enums import (
    AskedTarget,
    Category,
    Direction,
    Discarded,
    DriverSide,
    KnownTarget,
    Lighting,
    ModelChosenBy,
    NotVisible,
)
from sightline.infra.csv_package.columns import flag, integer, key, metres, number, text
from sightline.infra.csv_package.files import Files, read_rows
from sightline.infra.csv_package.schema import Column, Table, ids_of
from sightline.measurements.records import VehicleSheet
from sightline.vehicles.records import KNOWN, NOT_VISIBLE


def _not_visible(target: AskedTarget) -> Column[VehicleSheet]:
    words = f"why the {target.replace('_', ' ')} cannot be measured of this vehicle; empty where it can"
    return text(NOT_VISIBLE[target], words, lambda v: v.not_visible.get(target), enum=get_args(NotVisible))


def _known_height_columns(target: KnownTarget) -> tuple[Column[VehicleSheet], ...]:
    names, what = KNOWN[target], "mark" if target == "other" else target.replace("_", " ")
    return (
        metres(names.height, f"height of its {what} that was known before it was measured"),
        metres(names.u, "standard uncertainty of that height (k = 1)"),
        text(names.source, "where that height comes from"),
    )


VEHICLES: Table[VehicleSheet] = Table(
    "vehicles",
    "The passes and what is known of each vehicle.",
    (
        key("id", "vehicle"),
        key("number", "its number within the survey"),
        key("recording_id", "recording it passes in"),
        integer("first_frame", "first frame of the pass", minimum=0),
        integer("last_frame", "last frame of the pass", minimum=0),
        integer("best_frame", "frame proposed for measuring", minimum=0),
        text("make", "manufacturer"),
        text("model", "model"),
        integer("year", "model year"),
        text("model_chosen_by", "column-vehicles-model-chosen-by", enum=get_args(ModelChosenBy)),
        text("model_sizes", "of a model chosen by size: by which sizes, a space between them"),
        text("category", "body type", enum=get_args(Category)),
        metres("manufacturer_height_m", "manufacturer's overall height"),
        metres("u_manufacturer_height_m", "standard uncertainty of that height (k = 1)"),
        text("height_source", "where that height comes from"),
        *(column for target in get_args(KnownTarget) for column in _known_height_columns(target)),
        flag("check_target", "column-vehicles-check-target", required=True),
        text("lighting", "light at the time of the pass", enum=get_args(Lighting)),
        text("direction", "travel direction in the image", enum=get_args(Direction)),
        text("driver_side", "column-vehicles-driver-side", enum=get_args(DriverSide)),
        *(_not_visible(target) for target in NOT_VISIBLE),
        number("first_s", "column-vehicles-first-s", "s"),
        Column("filmed_at", "datetime", "column-vehicles-filmed-at"),
        flag("in_sample", "whether the rule of sampling.csv selects it", required=True),
        flag("counts", "column-vehicles-counts", required=True),
        text("discarded", "column-vehicles-discarded", enum=get_args(Discarded)),
        text("notes", "remarks"),
        text("state", "how far the work on it has come, given what the survey asks for", required=True),
    ),
    primary=("id",),
    foreign=ids_of(recording_id="recordings"),
)


def counting_in(files: Files) -> dict[str, bool]:
    """Whether each vehicle of a package counts in results, by number; before the column, all traffic."""
    return {
        row["id"]: row["check_target"] != "true" and row.get("counts", "true") == "true"
        for row in read_rows(files, VEHICLES.key)
    }
