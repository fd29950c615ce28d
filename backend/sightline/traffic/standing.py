"""Rows of an archive for the rule of all recordings on who stood when one ended (`find_who_stood`)."""

from collections.abc import Mapping, Sequence
from typing import Any

from sightline.linescan.parts import front_seen
from sightline.linescan.traffic import USUAL_DIRECTION, Stream
from sightline.messages.said import Said
from sightline.recordings.filming import Filming
from sightline.scans.statistics.service import VehicleMotion
from sightline.scans.statistics.traffic import Watched, seen_in_each

Row = Mapping[str, Any]


def watched_of(row: Row, site: str = "", number: int = 0) -> Watched:
    """A recording of an archive, where a lane of a site is one place."""
    first = row["first"]
    return Watched(
        scan_id=number,
        name=f"{site}: {first['recording']}",
        clock=Filming(first["start_at"], first["zone"]),
        watched_s=row["watched_s"],
        site=site,
        lanes=frozenset(row["lanes"]) - {""},
    )


def find_marks(
    recordings: Sequence[Row], vehicles: Sequence[Row]
) -> tuple[list[tuple[str, str]], list[tuple[str, int]]]:
    """Of recordings of a site: in which lanes of them one may stand as they begin, by their hashes, and which
    vehicles are told of the one before, by hash and number.

    `vehicles`: those in view at line 0, those with a motion and those that rested; of those alike the last.
    """
    places = {row["recording_sha256"]: at for at, row in enumerate(recordings)}
    seen = seen_in_each(
        [watched_of(row, number=at) for at, row in enumerate(recordings)],
        [_motion_of(row, places[row["recording_sha256"]]) for row in vehicles],
    )
    streams: dict[str | None, set[Stream]] = {}
    for stream in {one for each in seen for one in each.streams}:
        streams.setdefault(stream[1], set()).add(stream)
    stood, told = list[tuple[str, str]](), list[tuple[str, int]]()
    for each, row in zip(seen, recordings, strict=True):
        key = row["recording_sha256"]
        told += [(key, car.number) for car in each.vehicles if car.told_before]
        stood += [
            (key, lane)
            for lane in (row["lanes"] if each.stood else ())
            for of_lane in [streams.get(lane or None, {(USUAL_DIRECTION, lane or None)})]
            if any(one.may_stand_in(stream) for one in each.stood for stream in of_lane)
        ]
    return stood, told


def _motion_of(row: Row, scan_id: int) -> VehicleMotion:
    return VehicleMotion(
        vehicle_id=row["number"],
        scan_id=scan_id,
        number=row["number"],
        state="",
        measured=row["measured"],
        lighting="",
        reason=Said.read(row["reason"]) if row["reason"] else None,
        since_s=row["rear_s"],
        occupied_s=0.0,
        front_seen=front_seen(row["reason"], row["front_line_1"]),
        direction=row["direction"] or USUAL_DIRECTION,
        lane=row["lane"] or None,
    )
