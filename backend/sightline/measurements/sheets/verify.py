"""Holding the vehicles of a package against the audit chain."""

from collections import defaultdict
from itertools import pairwise
from typing import cast

from sightline.enums import Lighting
from sightline.errors import Damaged
from sightline.infra.csv_package.files import Files, columns_lacking, read_columns
from sightline.infra.csv_package.recomputing import Recomputing
from sightline.infra.csv_package.replay import Replay, Replayed, Row
from sightline.measurements.csv import MEASUREMENTS
from sightline.measurements.sheets.csv import VEHICLES
from sightline.measurements.sheets.states import Standing, state_of
from sightline.measurements.verify import HEIGHTS
from sightline.recordings.csv import RECORDINGS, filmings_in, mean_frames_s
from sightline.recordings.frames.csv import FRAMES
from sightline.statistics.sampling import PassTime, counts_in_results, headways, is_in_sample
from sightline.surveys.csv import asked_in, sampling_in
from sightline.vehicles.records import NOT_VISIBLE

REPLAYED = Replayed(VEHICLES, "vehicle")


def check_vehicles(files: Files, replay: Replay, recomputing: Recomputing, program: str) -> None:
    """Vehicles are what their events made of them, in the sample where its rule says so, and in the state
    that their measurements give; deleted ones are gone. `program`: the version that made the package.

    Raises Damaged.
    """
    rule, filmings, begun_s = sampling_in(files), filmings_in(files), _begun_s(files)
    behind = _headways(files, begun_s)
    _hold_order(files)
    states = _States(files)
    for row in replay.hold(files, REPLAYED):
        id_ = int(row["id"])
        taken = is_in_sample(rule, int(row["number"]), behind.get(id_))
        counts = counts_in_results(rule, taken, row["check_target"] == "true")
        says_so = (row["in_sample"], row.get("counts", str(counts).lower()))
        if says_so != (str(taken).lower(), str(counts).lower()):
            raise Damaged("measurements-sample-differs", id=id_)
        filming, first_s = filmings.get(row["recording_id"]), begun_s.get(id_)
        if row["filmed_at"] != ("" if filming is None or first_s is None else filming.at(first_s)):
            raise Damaged("measurements-vehicle-time", id=id_)
        with recomputing.of(HEIGHTS, program):
            states.check(row)


class _States:
    """What the tables tell of the states of vehicles; they are held against the events on their own."""

    def __init__(self, files: Files) -> None:
        self._asked = asked_in(files)
        self._lit = dict(read_columns(files, RECORDINGS.key, ("id", "lighting")))
        self._standing: dict[str, list[Standing]] = defaultdict(list)
        names = ("vehicle_id", "withdrawn", "target", "status", "verdict")
        for of, withdrawn, target, status, verdict in read_columns(files, MEASUREMENTS.key, names):
            if withdrawn != "true":
                self._standing[of].append((target, status, verdict))

    def check(self, row: Row) -> None:
        """Raises Damaged."""
        light = cast(Lighting | None, row["lighting"] or self._lit.get(row["recording_id"]) or None)
        state = state_of(
            self._standing.get(row["id"], ()),
            self._asked.of(light),
            [target for target, name in NOT_VISIBLE.items() if row[name]],
            discarded=row["discarded"] != "",
            wanted="true" in (row["in_sample"], row["check_target"]),
        )
        if row["state"] != state:
            raise Damaged("measurements-state-differs", id=row["id"], told=row["state"], state=state)


def _begun_s(files: Files) -> dict[int, float]:
    """When the first frame of each pass was, seconds after its recording's, where that is known. Before the
    column, frames were taken to be as long as their recording's on average.
    """
    if "first_s" in columns_lacking(files, VEHICLES.key):
        each_s = mean_frames_s(files)
        columns = read_columns(files, VEHICLES.key, ("id", "recording_id", "first_frame"))
        return {int(id_): int(first) * each_s.get(of, 0.0) for id_, of, first in columns}
    return {int(id_): float(at) for id_, at in read_columns(files, VEHICLES.key, ("id", "first_s")) if at}


def _hold_order(files: Files) -> None:
    """The frames of a recording come one after another: those in which passes begin with those that were
    clicked on, whose times the chain vouches for. Raises Damaged.
    """
    names = (VEHICLES.key, "first_frame", "first_s"), (FRAMES.key, "frame", "time_s")
    frame_times = {
        (int(of), int(frame), float(at))
        for path, *both in names
        for of, frame, at in read_columns(files, path, ("recording_id", *both))
        if at
    }
    for (of, frame, at_s), (of_next, next_, next_s) in pairwise(sorted(frame_times)):
        if of == of_next and (next_s < at_s or next_ == frame):
            raise Damaged("measurements-frame-time", recording=of, frame=next_)


def _headways(files: Files, begun_s: dict[int, float]) -> dict[int, float]:
    """As `vehicles.store.headways_of`, from the rows of a package."""
    names = ("id", "recording_id", "direction", "discarded")
    return headways(
        PassTime(int(id_), int(of), direction or None, begun_s[int(id_)], not discarded)
        for id_, of, direction, discarded in read_columns(files, VEHICLES.key, names)
        if int(id_) in begun_s
    )
