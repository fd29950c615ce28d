"""A small line scan beside the sample survey, made through the public write functions only."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from sqlalchemy.orm import Session

from sightline.enums import InsetSource, Target
from sightline.linescan.line_pose import solve_line_pose
from sightline.linescan.parts import Rig
from sightline.measurements.records import Clicks
from sightline.messages.said import Said
from sightline.scans.heights.pose_store import append_line_pose
from sightline.scans.heights.poses import Mark, Rod, pose_of, solved_values
from sightline.scans.heights.service import answer, height_values
from sightline.scans.heights.store import append_scan_height, withdraw_scan_height
from sightline.scans.records import (
    LiveSource,
    RunSummary,
    Scan,
    ScanRunValues,
    ScanValues,
    StripFacts,
    StripSource,
)
from sightline.scans.references.records import ReferenceValues
from sightline.scans.references.store import append_scan_reference, withdraw_scan_reference
from sightline.scans.rig.calibrating import Given, store_rig_calibration
from sightline.scans.rig.store import append_rig_calibration
from sightline.scans.store import (
    create_scan,
    note_reading_failed,
    note_scan_read,
    note_scan_recorded,
    remove_scan,
    restart_reading,
    rig_columns,
    swap_scan_cameras,
    update_scan,
)
from sightline.scans.vehicles.measurement_store import append_scan_measurement, append_scan_measurements
from sightline.scans.vehicles.review_store import add_scan_review
from sightline.scans.vehicles.run_store import add_scan_run
from sightline.scans.vehicles.store import (
    change_scan_vehicle,
    create_scan_vehicle,
    create_scan_vehicles,
    remove_scan_vehicle,
    restore_scan_vehicle,
)
from tests.support.samples import Sample

SOURCE = (StripSource("a.tif", "aa/a.tif", "aa" * 32), StripSource("b.tif", "bb/b.tif", "bb" * 32))
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
            direction="camera_1_first",
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
            axle_lines=[1300.25, 1950.5],
            axles_by="machine",
            lane=None,
            lane_by=None,
            tyres_px=None,
            u_boundaries_m=0.002,
            status="ok",
            reason=None,
            budget=[{"source": "fit", "u_speed_mps": 0.01, "u_acceleration_mps2": 0.09, "u_length_m": 0.006}],
            profile={"line_1": [1100.5], "speed_mps": [19.3], "fitted_mps": [19.31], "used": [True]},
            warnings=[],
            code_version="0.1.0",
        ),
        **changed,
    )


def facts(lines: int = 50_000_000) -> StripFacts:
    """What the reading of two strips of some three hours says."""
    keys = {"first_key": "aa/1.strip.tif", "second_key": "bb/2.strip.tif"}
    hashes = {"first_sha256": "a1" * 32, "second_sha256": "b2" * 32}
    return StripFacts(**keys, **hashes, rows_px=256, lines=lines, bits=8, notes=["Some lines lost."])


def scan(session: Session, one: Sample) -> Scan:
    """A scan of two strips, yet to be read."""
    return create_scan(
        session, one.survey.id, name="Gate", source=SOURCE, time_axis="width", rig=RIG, actor=one.olga.id
    )


def live(session: Session, one: Sample) -> Scan:
    """A scan whose lines still come."""
    return create_scan(
        session,
        one.survey.id,
        name="Gate",
        source=LiveSource(),
        time_axis="width",
        rig=RIG,
        actor=one.olga.id,
    )


def ready(session: Session, one: Sample) -> Scan:
    """A scan that was read."""
    return note_scan_read(session, scan(session, one).id, facts(), actor=None)


def vehicle(session: Session, one: Sample) -> Any:
    """A found vehicle, not measured yet."""
    return create_scan_vehicle(session, ready(session, one).id, origin="found", actor=one.olga.id)


def measured(session: Session, one: Sample, **changed: Any) -> Any:
    """A measurement of a found vehicle."""
    made = vehicle(session, one)
    return append_scan_measurement(session, made.id, values(**changed), actor=one.olga.id)


def run(session: Session, one: Sample, scan_id: int) -> Any:
    """A run that found one vehicle."""
    found = ScanRunValues("direct", rig_columns(RIG), 1, 1, RunSummary(misalignment_px=0.4), [], "0.1.0")
    return add_scan_run(session, scan_id, found, actor=one.olga.id)


def removed(session: Session, one: Sample) -> Any:
    """A vehicle that was taken out."""
    return remove_scan_vehicle(session, vehicle(session, one).id, version=1, actor=one.olga.id)


def reference(session: Session, one: Sample, vehicle_id: int, seen_revision: int = 0, **changed: Any) -> Any:
    """What a radar says of a vehicle: 19.4 m/s."""
    told = replace(ReferenceValues("speed", "radar", value=19.4, u=0.1, device="Gun 2"), **changed)
    return append_scan_reference(session, vehicle_id, told, seen_revision=seen_revision, actor=one.olga.id)


def rod(session: Session, one: Sample, scan_id: int, seen_revision: int = 0) -> Any:
    """A calibration of the line camera with a rod at 2 and 5 m: 1.1 m above the road, 900 px, level."""
    stands = [(distance, height) for distance in (2.0, 5.0) for height in (0.0, 0.5, 1.0, 1.5)]
    rows = [500.0 - 900.0 * (height - 1.1) / distance for distance, height in stands]
    found = solve_line_pose(*zip(*stands, strict=True), rows, sigma_px=0.5)
    marks = [
        Mark(distance, height, row, 300.0 * distance)
        for (distance, height), row in zip(stands, rows, strict=True)
    ]
    told = solved_values(found, Rod(tuple(marks), sigma_px=0.5))
    return append_line_pose(session, scan_id, told, seen_revision=seen_revision, actor=one.olga.id)


def calibrated_rig(session: Session, one: Sample, scan_id: int, version: int = 1) -> Any:
    """A calibration of the rig by a staff and a board at 3 and 9 m, put in force: 0.593 m, 1 mrad wider."""
    spans = [(3.0, 0.5962), (3.0, 0.5957), (9.0, 0.6022), (9.0, 0.6017)]
    rows = [f"n{n},{away},0,{span},0.001,,,,,," for n, (away, span) in enumerate(spans)]
    header = "pass,distance_m,position_1_m,position_2_m,u_position_m," + ",".join(
        ("width_m", "u_width_m", "front_line_1", "rear_line_1", "front_line_2", "rear_line_2")
    )
    board = "board,3.0,,,,0.8,0.0005,100,2100,1590,3590"
    table = "\n".join([header, *rows, board, "bad,far" + "," * 9]).encode()
    return store_rig_calibration(
        session,
        scan_id,
        table,
        "passes.csv",
        Given(u_tape_ratio=1e-4, distance_m=5.0),
        version=version,
        actor=one.olga.id,
    )


def tall(
    session: Session,
    one: Sample,
    vehicle_id: int,
    pose: Any,
    seen_revision: int = 0,
    target: Target = "roof",
) -> Any:
    """A height 1.4 m above a contact at 3 m: of a target 0.3 m behind it, a roof's usual inset."""
    row = 500.0 - 900.0 * 0.3 / 3.3
    inset_from: InsetSource = "usual" if target == "roof" else "own"
    inset: dict[str, Any] = {"inset_m": 0.3, "u_inset_m": 0.1, "inset_from": inset_from}
    contact, point = (1300.0, 830.0), (1500.0, row)
    clicks = Clicks(target=target, contact=contact, target_point=point, sigma_px=1.0, **inset)
    told = height_values(pose.id, clicks, answer(pose_of(pose.values), clicks), [])
    return append_scan_height(session, vehicle_id, told, seen_revision=seen_revision, actor=one.olga.id)


Write = Callable[[Session, Sample], Any]


def _calibrated(session: Session, one: Sample) -> Any:
    made = vehicle(session, one)
    return made, rod(session, one, made.scan_id)


def _rig_calibrated(session: Session, one: Sample) -> Any:
    return calibrated_rig(session, one, ready(session, one).id)


def _tall(session: Session, one: Sample) -> Any:
    made, pose = _calibrated(session, one)
    return tall(session, one, made.id, pose)


# name -> (what must be there first, the write itself); for the test that every write leaves one event
WRITES: dict[str, tuple[Write, Callable[[Session, Sample, Any], Any]]] = {
    "create_scan": (lambda s, o: None, lambda s, o, _: scan(s, o)),
    "note_scan_recorded": (
        live,
        lambda s, o, made: note_scan_recorded(s, made.id, SOURCE, actor=o.olga.id),
    ),
    "note_scan_read": (
        scan,
        lambda s, o, made: note_scan_read(s, made.id, facts(lines=5_000_000_000), actor=None),
    ),
    "note_reading_failed": (
        scan,
        lambda s, o, made: note_reading_failed(s, made.id, Said("scans-import-cancelled"), actor=None),
    ),
    "restart_reading": (
        scan,
        lambda s, o, made: restart_reading(s, made.id, actor=o.olga.id),
    ),
    "update_scan": (
        ready,
        lambda s, o, made: update_scan(s, made.id, {"baseline_m": 0.594}, version=1, actor=o.olga.id),
    ),
    "swap_scan_cameras": (
        ready,
        lambda s, o, made: swap_scan_cameras(s, made.id, version=1, actor=o.olga.id),
    ),
    "remove_scan": (ready, lambda s, o, made: remove_scan(s, made.id, actor=o.olga.id)),
    "add_scan_run": (ready, lambda s, o, made: run(s, o, made.id)),
    "create_scan_vehicle": (
        ready,
        lambda s, o, made: create_scan_vehicle(s, made.id, actor=o.olga.id),
    ),
    "create_scan_vehicles": (
        ready,
        lambda s, o, made: create_scan_vehicles(s, made.id, 1, origin="found", actor=o.olga.id),
    ),
    "change_scan_vehicle": (
        vehicle,
        lambda s, o, made: change_scan_vehicle(
            s, made.id, {"true_length_m": 4.447}, version=1, actor=o.olga.id
        ),
    ),
    "remove_scan_vehicle": (
        vehicle,
        lambda s, o, made: remove_scan_vehicle(s, made.id, version=1, actor=o.olga.id),
    ),
    "restore_scan_vehicle": (
        removed,
        lambda s, o, made: restore_scan_vehicle(s, made.id, actor=o.olga.id),
    ),
    "append_scan_measurements": (
        vehicle,
        lambda s, o, made: append_scan_measurements(s, made.scan_id, [(made.id, values())], actor=o.olga.id),
    ),
    "append_scan_measurement": (
        vehicle,
        lambda s, o, made: append_scan_measurement(s, made.id, values(), version=1, actor=o.olga.id),
    ),
    "add_scan_review": (
        measured,
        lambda s, o, made: add_scan_review(s, made.id, verdict="accepted", actor=o.rene.id),
    ),
    "append_scan_reference": (vehicle, lambda s, o, made: reference(s, o, made.id)),
    "withdraw_scan_reference": (
        lambda s, o: reference(s, o, vehicle(s, o).id),
        lambda s, o, made: withdraw_scan_reference(
            s, made.vehicle_id, "speed", "radar", seen_revision=1, actor=o.olga.id
        ),
    ),
    "append_rig_calibration": (
        _rig_calibrated,
        lambda s, o, made: append_rig_calibration(s, made.scan_id, made.values, actor=o.olga.id),
    ),
    "append_line_pose": (ready, lambda s, o, made: rod(s, o, made.id)),
    "append_scan_height": (
        _calibrated,
        lambda s, o, made: tall(s, o, made[0].id, made[1]),
    ),
    "withdraw_scan_height": (
        _tall,
        lambda s, o, made: withdraw_scan_height(s, made.vehicle_id, "roof", seen_revision=1, actor=o.olga.id),
    ),
}
