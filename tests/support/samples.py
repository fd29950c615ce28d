"""A small survey, made through the public write functions only."""

from dataclasses import dataclass, replace
from hashlib import sha256
from pathlib import Path
from tempfile import NamedTemporaryFile
from typing import Any

import numpy as np
from sqlalchemy import insert
from sqlalchemy.orm import Session

from sightline.cameras.calibrations.records import Calibration
from sightline.cameras.calibrations.store import add_calibration
from sightline.cameras.records import Camera
from sightline.cameras.store import create_camera
from sightline.enums import Role, Target
from sightline.infra.audit import trail
from sightline.infra.database.engine import SessionFactory, writing
from sightline.infra.database.types import now
from sightline.infra.services import Services
from sightline.infra.web.person import Person
from sightline.measurements.records import Measurement, MeasurementValues
from sightline.measurements.store import add_measurement
from sightline.measurements.tables import measurement_series
from sightline.measurements.tables import measurements as revision_rows
from sightline.measurements.tables import reviews as review_rows
from sightline.media.store.local import key_of
from sightline.media.video.frame_table import FrameTable
from sightline.messages.said import Said
from sightline.people.store import create_person
from sightline.poses.records import Pose
from sightline.poses.store import add_pose
from sightline.recordings.records import Facts, Recording
from sightline.recordings.store import create_recording, get_recording, note_ingested
from sightline.reviews.lots.query import get_lot
from sightline.reviews.lots.records import Lot
from sightline.reviews.lots.store import add_lot
from sightline.statistics.acceptance import USUAL_RISKS, SamplingPlan
from sightline.studies.members_store import add_study_member
from sightline.studies.records import StoredStudy, StudyFacts, StudyResult, StudySurvey
from sightline.studies.store import add_study_result, create_study
from sightline.surveys.photographs.records import Photograph
from sightline.surveys.photographs.store import add_photograph
from sightline.surveys.records import Survey
from sightline.surveys.store import create_survey
from sightline.vehicles.records import Vehicle
from sightline.vehicles.store import create_vehicle
from sightline.vehicles.tables import vehicles as vehicle_rows

KEY = "00000000-0000-4000-8000-{:012d}"


def put_bytes(services: Services, content: bytes, suffix: str) -> str:
    """Bytes in the media store that no row names; their key."""
    key = key_of(sha256(content).hexdigest(), suffix)
    with NamedTemporaryFile(dir=services.scratch) as file:
        file.write(content)
        file.flush()
        services.media.put_file(key, Path(file.name))
    return key


def frame_table(count: int = 100) -> FrameTable:
    """Frames 40 ms apart, a key frame every 12, with checksums beyond 31 bits."""
    n = np.arange(count)
    crc32 = ((n * 2654435761 + 4_000_000_000) % 2**32).astype(np.uint32)
    return FrameTable(n.astype(np.int64) * 512, n * 0.04, n % 12 == 0, crc32)


def facts(**changed: Any) -> Facts:
    """What an ingest says of a small video."""
    return replace(Facts(640, 480, 4.0, "h264", "mov,mp4", False, [], {"tool": "test"}, [0, 50]), **changed)


def person(session: Session, name: str = "Olga", role: Role = "operator") -> Person:
    """Somebody with this role."""
    return create_person(session, name=name, email=f"{name.lower()}@example.org", role=role, actor=None)


@dataclass(frozen=True, eq=False)
class Sample:
    """One of everything that a measurement needs."""

    olga: Person
    rene: Person
    survey: Survey
    camera: Camera
    calibration: Calibration
    recording: Recording
    pose: Pose
    vehicle: Vehicle


def sample(session: Session, *, open_to_all: bool = True, of: tuple[str, str] = ("Olga", "René")) -> Sample:
    """Two people, a survey with a calibrated camera, a posed recording and one vehicle."""
    olga, rene = person(session, of[0]), person(session, of[1], "reviewer")
    survey = create_survey(session, name="Rouen south", site="lane 1", open_to_all=open_to_all, actor=olga.id)
    camera = create_camera(session, survey.id, name="Left", actor=olga.id)
    lens = calibration(session, camera.id, olga.id)
    recording = add_recording(session, survey.id, olga.id)
    pose = road_pose(session, recording.id, lens.id, olga.id)
    span = {"first_frame": 10, "last_frame": 40}
    vehicle = create_vehicle(session, recording.id, {**span, "make": "Peugeot"}, actor=olga.id)  # type: ignore[typeddict-item]
    recording = get_recording(session, recording.id)
    return Sample(olga, rene, survey, camera, lens, recording, pose, vehicle)


def calibration(session: Session, camera_id: int, actor: int | None) -> Calibration:
    """A trusted calibration from images."""
    return add_calibration(
        session,
        camera_id,
        source="images",
        document={"format": "sightline-camera-1", "fx_px": 812.25, "distortion": [-0.1, 1e-9]},
        trusted=True,
        warnings=[],
        coverage=[[0] * 16] * 12,
        views=[{"file": "a.png", "used": True}],
        summary=Said("said", sentence="12 views, 0.21 px."),
        actor=actor,
    )


def add_recording(session: Session, survey_id: int, actor: int | None, count: int = 100) -> Recording:
    """An ingested recording."""
    made = create_recording(
        session,
        survey_id,
        name="day.mp4",
        media_key="ab/cdef.mp4",
        sha256="ab" * 32,
        size_bytes=5 * 2**31,
        actor=actor,
    )
    return note_ingested(session, made.id, facts(), frame_table(count), actor=actor)


def photograph(session: Session, one: Sample, name: str = "rig.jpg") -> Photograph:
    """A photograph of the set-up whose file is nowhere."""
    file: dict[str, Any] = {"name": name, "media_key": "p", "sha256": "0" * 64, "size_bytes": 9}
    return add_photograph(session, one.survey.id, **file, width_px=640, height_px=480, actor=one.olga.id)


def road_pose(session: Session, recording_id: int, calibration_id: int, actor: int | None) -> Pose:
    """A road pose of that recording."""
    return add_pose(
        session,
        recording_id,
        calibration_id=calibration_id,
        first_frame=0,
        last_frame=9,
        rms_px=0.2,
        distance_m=6.5,
        summary=[Said("said", sentence="Good to 12 mm at 2 m.")],
        document={"format": "sightline-pose-1", "rms_px": 0.2},
        warnings=[],
        expected=[{"distance_m": 2, "u_height_m": 0.006}],
        overlay={"grid": []},
        actor=actor,
    )


def values(one: Sample, **changed: Any) -> MeasurementValues:
    """The content of a measurement on frame 20."""
    found = frame_table()
    return replace(
        MeasurementValues(
            target="roof",
            frame=20,
            pts=int(found.pts[20]),
            time_s=float(found.time_s[20]),
            frame_crc32=int(found.crc32[20]),
            contact=(301.5, 400.0),
            target_point=(310.25, 180.125),
            sigma_px=1,
            made="clicked",
            pose_id=one.pose.id,
            calibration_id=one.calibration.id,
            inset_m=0.3,
            u_inset_m=0.1,
            inset_from="usual",
            side=None,
            side_from=None,
            x_m=0.5,
            y_m=0.25,
            height_m=1.6180339887,
            uncorrected_height_m=1.7,
            u_height_m=0.0066,
            U95_height_m=0.013,
            distance_m=7.25,
            status="ok",
            reason=None,
            flags=[],
            budget=[{"source": "clicks", "u_m": 0.004}],
            code_version="0.1.0",
        ),
        **changed,
    )


def measure(session: Session, one: Sample, target: Target = "roof", key: int = 1) -> Measurement:
    """A measurement of the sample's vehicle, by Olga."""
    content = values(one, target=target)
    return add_measurement(
        session, one.vehicle.id, client_key=KEY.format(key), values=content, actor=one.olga.id
    )


def lot(session: Session, one: Sample) -> Lot:
    """A lot of the measurement that was made first, drawn by Rene."""
    return lot_of(session, one, 1)


def lot_of(session: Session, one: Sample, measurement_id: int) -> Lot:
    """A lot of one measurement, drawn by Rene."""
    plan, items = SamplingPlan(1, 1, 0, 0.0, 0.0), [(measurement_id, 1)]
    return get_lot(session, add_lot(session, one.survey.id, {}, items, plan, USUAL_RISKS, actor=one.rene.id))


def fill(factory: SessionFactory, count: int) -> Sample:
    """`count` vehicles with three measurements each, a third of them reviewed, every fifth revised."""
    with writing(factory) as session:
        one = sample(session)
        measured = measure(session, one)
        revision = revision_rows.select().where(revision_rows.c.id == measured.revision_id)
        row = session.execute(revision).mappings().one()
        template = {key: value for key, value in row.items() if key != "id"}
        span = {"first_frame": 1, "last_frame": 2, "notes": "", "version": 1}
        stamps = {"created_at": now(), "updated_at": now(), "created_by": one.olga.id}
        place = {"survey_id": one.survey.id, "recording_id": one.recording.id}
        rows = [{"id": n, "number": n, **span, **stamps, **place} for n in range(2, count + 1)]
        session.execute(insert(vehicle_rows), rows)
        series, revisions, verdicts = [], [], []
        for n, target in ((n, target) for n in range(2, count + 1) for target in range(3)):
            number = n * 3 + target
            series.append({"id": number, **place, "vehicle_id": n, "client_key": str(number)})
            name = ("roof", "driver_eye", "taillight")[target]
            content = {**template, "series_id": number, "target": name, "revision": 1}
            revisions += [content, {**content, "revision": 2}] if number % 5 == 0 else [content]
            verdict = {"series_id": number, "verdict": "accepted", "created_at": now()}
            if number % 3 == 0:
                verdicts.append({**verdict, "revision": 1, "result_revision": 1, "created_by": one.rene.id})
        session.execute(insert(measurement_series), series)
        session.execute(insert(revision_rows), revisions)
        session.execute(insert(review_rows), verdicts)
    return one


def study(session: Session, one: Sample) -> StoredStudy:
    """A study of the survey."""
    facts = StudyFacts("Hills", surveys=(StudySurvey(one.survey.id, "Hill", "rural", 2026),))
    return create_study(session, facts, actor=one.olga.id)


def study_with_member(session: Session, one: Sample) -> StoredStudy:
    """A study that the reviewer belongs to."""
    made = study(session, one)
    add_study_member(session, made.id, one.rene.id, actor=one.olga.id)
    return made


def result_of_study(session: Session, one: Sample, of: StoredStudy) -> StudyResult:
    """What a computing of it might have found."""
    files: dict[str, Any] = {"media_key": "z", "size_bytes": 1, "sha256": "0" * 64}
    files |= {"report_key": "p", "report_sha256": "0" * 64}
    heads = {one.survey.id: trail.head(session, one.survey.id).hash}
    return add_study_result(session, of, heads=heads, document={"heights": 0.1}, **files, actor=one.olga.id)


def study_result(session: Session, one: Sample) -> StudyResult:
    """A study with its result."""
    return result_of_study(session, one, study(session, one))
