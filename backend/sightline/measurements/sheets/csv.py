"""The table of vehicles in the package."""

from typing import get_args

from sightline.enums import KnownTarget
from sightline.infra.csv_package.columns import columns_for, metres, text
from sightline.infra.csv_package.files import Files, read_rows
from sightline.infra.csv_package.schema import Column, Table, ids_of
from sightline.measurements.records import VehicleSheet
from sightline.vehicles.records import KNOWN, NOT_VISIBLE


def _known_height_columns(target: KnownTarget) -> tuple[Column[VehicleSheet], ...]:
    names = KNOWN[target]
    return (
        *columns_for(VehicleSheet, names.height),
        metres(names.u, "column-vehicles-u-manufacturer-height-m"),
        text(names.source, "column-vehicles-height-source"),
    )


VEHICLES: Table[VehicleSheet] = Table(
    "vehicles",
    "The passes and what is known of each vehicle.",
    (
        *columns_for(VehicleSheet, "id number recording_id"),
        *columns_for(VehicleSheet, "first_frame last_frame best_frame", minimum=0),
        *columns_for(VehicleSheet, "make model year model_chosen_by model_sizes category"),
        *columns_for(VehicleSheet, "manufacturer_height_m u_manufacturer_height_m height_source"),
        *(column for target in get_args(KnownTarget) for column in _known_height_columns(target)),
        *columns_for(VehicleSheet, "check_target lighting direction driver_side"),
        *columns_for(VehicleSheet, " ".join(NOT_VISIBLE.values())),
        *columns_for(VehicleSheet, "first_s"),
        Column("filmed_at", "datetime", "column-vehicles-filmed-at"),
        *columns_for(VehicleSheet, "in_sample counts discarded notes state"),
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
