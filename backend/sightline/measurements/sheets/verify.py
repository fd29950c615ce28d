"""Holding the vehicles of a package against the audit chain."""

from __future__ import annotations

from sightline.errors import Damaged
from sightline.infra.csv_package.files import Files, read_columns
from sightline.infra.csv_package.replay import Replay, Replayed
from sightline.measurements.sheets.csv import VEHICLES
from sightline.recordings.csv import filmed_in, frames_s
from sightline.statistics.sampling import PassTime, counts_in_results, headways, is_in_sample
from sightline.surveys.csv import sampling_in

REPLAYED = Replayed(VEHICLES, "vehicle")


def check_vehicles(files: Files, replay: Replay) -> None:
    """Vehicles are what their events made of them, and in the sample where its rule says so; deleted ones
    are gone. Raises Damaged.
    """
    rule, behind, filmed = sampling_in(files), _headways(files), filmed_in(files)
    for row in replay.hold(files, REPLAYED):
        id_ = int(row["id"])
        taken = is_in_sample(rule, int(row["number"]), behind.get(id_))
        counts = counts_in_results(rule, taken, row["check_target"] == "true")
        says_so = (row["in_sample"], row.get("counts", str(counts).lower()))
        if says_so != (str(taken).lower(), str(counts).lower()):
            raise Damaged("measurements-sample-differs", id=id_)
        if row["filmed_at"] != filmed(row["recording_id"], int(row["first_frame"])):
            raise Damaged("measurements-vehicle-time", id=id_)


def _headways(files: Files) -> dict[int, float]:
    """As `vehicles.store.headways_of`, from the rows of a package."""
    seconds = frames_s(files)
    names = ("id", "recording_id", "direction", "first_frame", "discarded")
    return headways(
        PassTime(int(id_), int(of), direction or None, int(first) * seconds.get(of, 0.0), not discarded)
        for id_, of, direction, first, discarded in read_columns(files, "vehicles.csv", names)
    )
