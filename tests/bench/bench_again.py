"""How quick 10,000 heights are computed again, stored and undone: `python tests/bench/bench_again.py`;
of recordings, and of line scans.

CPU seconds of this process, for the machine may be busy, on a SQLite of its own; every height with its whole
budget, every revision with its event.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from time import process_time

import numpy as np
from sqlalchemy import insert, select

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from sightline.geometry.camera import Camera, project
from sightline.geometry.documents import camera_to_dict, pose_to_dict
from sightline.geometry.road_pose import BoardOnRoad, RoadPose
from sightline.infra.database.engine import SessionFactory, reading, writing
from sightline.infra.database.types import now
from sightline.measurements.again.query import get_computing
from sightline.measurements.tables import measurement_series, measurements
from sightline.poses.store import add_pose
from sightline.scans.again.service import AllAnswers, changes_to_come, compute_again, undo_computing
from sightline.scans.tables import scan_vehicles
from sightline.vehicles.tables import vehicles
from tests.bench.bench_storage import fresh
from tests.bench.goals import Row, report, row
from tests.support import samples, scans_samples
from tests.support.samples import Sample

HEIGHTS = 10_000
TARGETS = ("roof", "driver_eye", "taillight", "headlight")
GOAL_S = 20.0


def pose_of(height_m: float) -> RoadPose:
    """A camera of 640 x 480 px with some distortion, 3 m from the board, and all its uncertainties."""
    distortion = np.array([-0.1, 0.01, 1e-4, -1e-4, 0.0])
    camera = Camera("bench", 640, 480, "brown", 600.0, 600.0, 319.5, 239.5, distortion)
    rotation = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
    spread = np.concatenate([np.full(4, 0.5), np.full(5, 1e-3), np.full(6, 2e-4)]) ** 2
    board = BoardOnRoad(9, 6, 0.1, "top", 1.1, 0.003, 0.005, 3.0)
    centre = np.array([0.0, -6.4, height_m])
    return RoadPose(camera, rotation, -rotation @ centre, np.diag(spread), board, 10, 0.1)


def filled(factory: SessionFactory) -> Sample:
    """A survey with so many heights by a first pose, and a second pose in force."""
    pose = pose_of(1.5)
    scatter = np.random.default_rng(5).uniform(-0.3, 0.3, (HEIGHTS, 3))
    heights = np.array([1.55, 1.2, 0.85, 0.65])[np.arange(HEIGHTS) % 4]
    contact = project(pose.camera, pose.to_camera(scatter * [3.0, 1.0, 0.0]))
    seen = scatter * [3.0, 1.0, 0.0] + np.array([0.5, 0.1, 0.0]) + heights[:, None] * [0.0, 0.0, 1.0]
    target = project(pose.camera, pose.to_camera(seen))
    with writing(factory) as session:
        one = samples.sample(session)
        made = samples.measure(session, one)
        template = dict(
            session.execute(select(measurements).where(measurements.c.id == made.revision_id))
            .mappings()
            .one()
        )
        template.pop("id")
        place = {"survey_id": one.survey.id, "recording_id": one.recording.id}
        car = {"first_frame": 1, "last_frame": 40, "notes": "", "version": 1, "driver_side": "far"}
        car |= {"created_at": now(), "updated_at": now(), **place}
        session.execute(
            insert(vehicles), [{**car, "id": 10 + n, "number": 10 + n} for n in range(HEIGHTS // 4)]
        )
        series, revisions = [], []
        for n in range(HEIGHTS):
            series.append({**place, "id": 10 + n, "vehicle_id": 10 + n // 4, "client_key": f"bench {n}"})
            clicked = dict(zip(("contact_x_px", "contact_y_px"), contact[n].tolist(), strict=True))
            clicked |= dict(zip(("target_x_px", "target_y_px"), target[n].tolist(), strict=True))
            revisions.append({**template, **clicked, "series_id": 10 + n, "target": TARGETS[n % 4]})
        session.execute(insert(measurement_series), series)
        session.execute(insert(measurements), revisions)
        add_pose(
            session,
            one.recording.id,
            calibration_id=one.calibration.id,
            first_frame=0,
            last_frame=9,
            rms_px=0.2,
            distance_m=6.5,
            summary="Measured again.",
            document={**pose_to_dict(pose_of(1.51)), "camera": camera_to_dict(pose.camera)},
            warnings=[],
            expected=[],
            overlay={"grid": [], "iso_heights": [], "axes": None, "corners_px": []},
            actor=one.olga.id,
        )
    return one


def filled_lines(factory: SessionFactory) -> Sample:
    """A survey with so many heights in a line scan by a first calibration, and a second in force."""
    with writing(factory) as session:
        one = samples.sample(session, of=("Ada", "Ben"))
        made = scans_samples.measured(session, one)
        first = scans_samples.rod(session, one, made.scan_id)
        scans_samples.tall(session, one, made.vehicle_id, first)
        of_scan = scan_vehicles.c.scan_id == made.scan_id
        car = dict(session.execute(select(scan_vehicles).where(of_scan)).mappings().one())
        series = measurement_series.c.scan_vehicle_id == made.vehicle_id
        place = dict(session.execute(select(measurement_series).where(series)).mappings().one())
        of_car = measurements.c.series_id == place.pop("id")
        template = dict(session.execute(select(measurements).where(of_car)).mappings().one())
        ids = range(10 + made.vehicle_id, 10 + made.vehicle_id + HEIGHTS)
        session.execute(insert(scan_vehicles), [{**car, "id": id_, "number": id_} for id_ in ids])
        template.pop("id")
        row_px = template["contact_y_px"]
        of_cars = [{**place, "id": id_, "scan_vehicle_id": id_, "client_key": f"scan {id_}"} for id_ in ids]
        session.execute(insert(measurement_series), of_cars)
        revisions = [
            {**template, "series_id": id_, "contact_y_px": row_px + n * 1e-3} for n, id_ in enumerate(ids)
        ]
        session.execute(insert(measurements), revisions)
        scans_samples.rod(session, one, made.scan_id, 1)
    return one


def again(factory: SessionFactory, one: Sample) -> Iterator[Row]:
    answers, told, started = AllAnswers(), [], process_time()
    with reading(factory) as session:
        changes_to_come(session, one.survey.id, answers, tell=told.append)
    computed_s = process_time() - started
    with writing(factory) as session:
        made = compute_again(session, one.survey.id, answers=answers, actor=one.olga.id)
    spent_s = process_time() - started
    assert made is not None and made.heights >= HEIGHTS, made
    words = f"{HEIGHTS} heights computed again and stored <= {GOAL_S:.0f} s"
    yield row(
        words, "", f"{spent_s:.1f} s, {computed_s:.1f} s of them outside the transaction", spent_s <= GOAL_S
    )
    yield row(
        "with progress, a report <= every 0.5 s", "", f"{len(told)} reports", len(told) >= 2 * computed_s
    )
    started = process_time()
    with writing(factory) as session:
        undone = undo_computing(session, made.id, actor=one.olga.id)
    spent_s = process_time() - started
    yield row(f"undone as a whole <= {GOAL_S:.0f} s", "", f"{spent_s:.1f} s", spent_s <= GOAL_S)
    with reading(factory) as session:
        whole = get_computing(session, made.id).undone_by == undone.id and undone.heights == made.heights
    yield row("every height is back", "", f"{undone.heights} heights", whole)


def main(wanted: list[str]) -> int:
    with tempfile.TemporaryDirectory() as folder:
        factory = fresh(Path(folder))
        one = filled(factory)

        lines = filled_lines(factory)

        def computed_again() -> Iterator[Row]:
            yield from again(factory, one)

        def lines_computed_again() -> Iterator[Row]:
            yield from again(factory, lines)

        return report([computed_again, lines_computed_again], wanted)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
