"""A small line scan beside the sample survey, made through the public write functions only."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from sqlalchemy.orm import Session

from backend.linescan.line_pose import solve_line_pose
from backend.linescan.parts import Rig
from backend.storage import (
    line_heights,
    line_poses,
    scans,
    scans_measurements,
    scans_reviews,
    scans_runs,
    scans_swap,
    scans_vehicles,
)
from backend.storage.scans import rig_columns
from backend.storage.scans_records import Scan, ScanRunValues, ScanValues, StripFacts, StripSource
from backend.work.line_heights import RowClicks, height_values
from backend.work.line_poses import solved_values
from tests.storage.samples import Sample

RIG = Rig(baseline_m=0.593, line_rate_hz=4882.8, u_baseline_m=0.0003)


def values(**changed: Any) -> ScanValues:
    """The content of a measured vehicle."""
    return replace(
        ScanValues(
            cause="found",
            placed_by=None,
            run_id=None,
            method="direct",
            rig=rig_columns(RIG),
            front_line_1=1000.25,
            rear_line_1=2200.5,
            front_line_2=1150.125,
            rear_line_2=2351.0,
            speed_mps=19.31415,
            u_speed_mps=0.011,
            acceleration_mps2=0.4,
            u_acceleration_mps2=0.09,
            length_m=4.7421,
            u_length_m=0.008,
            fit_error_percent=0.3,
            misalignment_px=0.41,
            u_misalignment_px=0.02,
            gain=1.04,
            correlation=-0.8,
            front_wheel_line=None,
            rear_wheel_line=None,
            wheelbase_m=None,
            u_wheelbase_m=None,
            status="ok",
            reason=None,
            budget=[{"source": "fit", "u_speed_mps": 0.01, "u_acceleration_mps2": 0.09, "u_length_m": 0.006}],
            profile={"line_1": [1100.5], "speed_mps": [19.3], "fitted_mps": [19.31], "used": [True]},
            warnings=[],
            code_version="0.1.0",
        ),
        **changed,
    )


def facts() -> StripFacts:
    """What the reading of two small strips says."""
    keys = {"first_key": "aa/1.strip.tif", "second_key": "bb/2.strip.tif"}
    hashes = {"first_sha256": "a1" * 32, "second_sha256": "b2" * 32}
    return StripFacts(**keys, **hashes, rows_px=256, lines=5_000_000_000, bits=8, notes=["Some lines lost."])


def scan(session: Session, one: Sample) -> Scan:
    """A scan of two strips, yet to be read."""
    source = (StripSource("a.tif", "aa/a.tif", "aa" * 32), StripSource("b.tif", "bb/b.tif", "bb" * 32))
    return scans.create(
        session, one.survey.id, name="Gate", source=source, time_axis="width", rig=RIG, actor=one.olga.id
    )


def ready(session: Session, one: Sample) -> Scan:
    """A scan that was read."""
    return scans.was_read(session, scan(session, one).id, facts(), actor=None)


def vehicle(session: Session, one: Sample) -> Any:
    """A found vehicle, not measured yet."""
    return scans_vehicles.create(session, ready(session, one).id, origin="found", actor=one.olga.id)


def measured(session: Session, one: Sample, **changed: Any) -> Any:
    """A measurement of a found vehicle."""
    made = vehicle(session, one)
    return scans_measurements.append(session, made.id, values(**changed), actor=one.olga.id)


def run(session: Session, one: Sample, scan_id: int) -> Any:
    """A run that found one vehicle."""
    found = ScanRunValues("direct", rig_columns(RIG), 1, 1, {"misalignment_px": 0.4}, [], "0.1.0")
    return scans_runs.add(session, scan_id, found, actor=one.olga.id)


def removed(session: Session, one: Sample) -> Any:
    """A vehicle that was taken out."""
    return scans_vehicles.remove(session, vehicle(session, one).id, version=1, actor=one.olga.id)


def rod(session: Session, one: Sample, scan_id: int, seen_revision: int = 0) -> Any:
    """A calibration of the line camera with a rod at 2 and 5 m: 1.1 m above the road, 900 px, level."""
    stands = [(distance, height) for distance in (2.0, 5.0) for height in (0.0, 0.5, 1.0, 1.5)]
    rows = [500.0 - 900.0 * (height - 1.1) / distance for distance, height in stands]
    found = solve_line_pose(*zip(*stands, strict=True), rows, sigma_px=0.5)
    marks = [
        {"distance_m": distance, "height_m": height, "row_px": row, "line": 300.0 * distance}
        for (distance, height), row in zip(stands, rows, strict=True)
    ]
    given: dict[str, Any] = {"sigma_px": 0.5, "u_distance_m": 0.0, "u_lean_rad": 0.0}
    told = solved_values(found, marks, **given)
    return line_poses.append(session, scan_id, told, seen_revision=seen_revision, actor=one.olga.id)


def tall(session: Session, one: Sample, vehicle_id: int, pose: Any, seen_revision: int = 0) -> Any:
    """A roof 1.4 m above a contact at 3 m: the row of a target 0.3 m behind it."""
    clicks = RowClicks("roof", (1300.0, 830.0), (1500.0, 500.0 - 900.0 * 0.3 / 3.3), 1.0, 0.3, 0.1)
    told = height_values(pose, clicks, [])
    return line_heights.append(session, vehicle_id, told, seen_revision=seen_revision, actor=one.olga.id)


Write = Callable[[Session, Sample], Any]


def _calibrated(session: Session, one: Sample) -> Any:
    made = vehicle(session, one)
    return made, rod(session, one, made.scan_id)


def _tall(session: Session, one: Sample) -> Any:
    made, pose = _calibrated(session, one)
    return tall(session, one, made.id, pose)


# name -> (what must be there first, the write itself); for the test that every write leaves one event
WRITES: dict[str, tuple[Write, Callable[[Session, Sample, Any], Any]]] = {
    "scans.create": (lambda s, o: None, lambda s, o, _: scan(s, o)),
    "scans.was_read": (scan, lambda s, o, made: scans.was_read(s, made.id, facts(), actor=None)),
    "scans.reading_failed": (
        scan,
        lambda s, o, made: scans.reading_failed(s, made.id, "It is no picture.", actor=None),
    ),
    "scans.restart_reading": (
        scan,
        lambda s, o, made: scans.restart_reading(s, made.id, actor=o.olga.id),
    ),
    "scans.update": (
        ready,
        lambda s, o, made: scans.update(s, made.id, {"baseline_m": 0.594}, version=1, actor=o.olga.id),
    ),
    "scans_swap.swap_cameras": (
        ready,
        lambda s, o, made: scans_swap.swap_cameras(s, made.id, version=1, actor=o.olga.id),
    ),
    "scans.remove": (ready, lambda s, o, made: scans.remove(s, made.id, actor=o.olga.id)),
    "scans_runs.add": (ready, lambda s, o, made: run(s, o, made.id)),
    "scans_vehicles.create": (
        ready,
        lambda s, o, made: scans_vehicles.create(s, made.id, {"make": "Fiat"}, actor=o.olga.id),
    ),
    "scans_vehicles.create_many": (
        ready,
        lambda s, o, made: scans_vehicles.create_many(s, made.id, 1, origin="found", actor=o.olga.id),
    ),
    "scans_vehicles.change_facts": (
        vehicle,
        lambda s, o, made: scans_vehicles.change_facts(
            s, made.id, {"true_length_m": 4.447}, version=1, actor=o.olga.id
        ),
    ),
    "scans_vehicles.remove": (
        vehicle,
        lambda s, o, made: scans_vehicles.remove(s, made.id, version=1, actor=o.olga.id),
    ),
    "scans_vehicles.restore": (
        removed,
        lambda s, o, made: scans_vehicles.restore(s, made.id, actor=o.olga.id),
    ),
    "scans_measurements.append_many": (
        vehicle,
        lambda s, o, made: scans_measurements.append_many(
            s, made.scan_id, [(made.id, values())], actor=o.olga.id
        ),
    ),
    "scans_measurements.append": (
        vehicle,
        lambda s, o, made: scans_measurements.append(s, made.id, values(), version=1, actor=o.olga.id),
    ),
    "scans_reviews.add": (
        measured,
        lambda s, o, made: scans_reviews.add(s, made.id, verdict="accepted", actor=o.rene.id),
    ),
    "line_poses.append": (ready, lambda s, o, made: rod(s, o, made.id)),
    "line_heights.append": (
        _calibrated,
        lambda s, o, made: tall(s, o, made[0].id, made[1]),
    ),
    "line_heights.withdraw": (
        _tall,
        lambda s, o, made: line_heights.withdraw(
            s, made.vehicle_id, "roof", seen_revision=1, actor=o.olga.id
        ),
    ),
}
