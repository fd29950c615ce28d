"""The demonstration survey: made once, as one job that ends in one transaction, so it is whole or not there.

Its files were rendered from a known scene and come with the program; lens, road poses and heights are what
this program finds in them.
"""

from collections.abc import Mapping
from datetime import UTC, datetime
from typing import Any

from sightline.cameras.calibrations.calibrating import DetectedView, document_of, summary_of, view_rows
from sightline.cameras.calibrations.images import detection_of
from sightline.cameras.calibrations.store import add_calibration
from sightline.cameras.store import add_calibration_image, create_camera
from sightline.demo.clicks import TARGETS, Pass, judge, measure, with_fates
from sightline.demo.made import SceneTruth, catalogue, truth
from sightline.demo.parts import Film, LabPicture, Parts, make_parts
from sightline.demo.repeats import click_again
from sightline.demo.scan import store_scan
from sightline.demo.wheels import click_wheels
from sightline.enums import Lighting, Role
from sightline.errors import Away
from sightline.geometry.sides import TrafficFacts
from sightline.infra.database import Session
from sightline.infra.jobs import registry
from sightline.infra.web.person import Person
from sightline.messages.said import Said
from sightline.people.store import create_person, person_by_email, update_person
from sightline.poses.store import add_pose
from sightline.recordings.drift_request import request_if_posed
from sightline.recordings.filming import Filming
from sightline.recordings.ingest_job import facts_of
from sightline.recordings.records import RecordingChanges
from sightline.recordings.store import create_recording, list_recordings, note_ingested, update_recording
from sightline.surveys.place import Place
from sightline.surveys.records import Asked
from sightline.surveys.store import create_survey, demo_survey_id
from sightline.vehicles.catalogue.store import import_catalogue_rows
from sightline.vehicles.records import VehicleChanges
from sightline.vehicles.store import create_vehicle

NAME = "Demonstration: Corvane Road"
SITE = "an invented road, two lanes"
DESCRIPTION = (
    "Rendered from a known scene, so the true heights are known: 9 vehicles of invented makes in daylight, "
    "7 in low light. 14 of them are measured: most are accepted, 1 has a rejected height and is to be "
    "measured again. That one and the other 2 are for you to try. A line scan shows 9 more vehicles with "
    "speed, length and gaps. So few vehicles give no verdict on a standard; the surveys of the simulated "
    "study have enough."
)
TRAFFIC = TrafficFacts(traffic_side="right", steering_side="left", camera_place="verge")
PLACE = Place(
    road_class="single carriageway, rural",
    lane="both lanes",
    speed_limit_mps=80 / 3.6,
    street_lamps="present",
    time_zone="Europe/Paris",
)
# Invented, as all of it: when each scene was filmed, in what weather, whether lamps were lit.
FILMED: dict[Lighting, RecordingChanges] = {
    "daytime": {
        "filming": Filming(datetime(2025, 5, 14, 6, 10, tzinfo=UTC), "Europe/Paris"),
        "weather": "some cloud",
        "street_lighting": "off",
    },
    "low_light": {
        "filming": Filming(datetime(2025, 5, 14, 19, 40, tzinfo=UTC), "Europe/Paris"),
        "weather": "clear",
        "street_lighting": "on",
    },
}
OPERATOR = ("Demonstration operator", "demonstration-operator@sightline.invalid")
REVIEWER = ("Demonstration reviewer", "demonstration-reviewer@sightline.invalid")


def make(context: registry.JobContext) -> registry.Outcome:
    """Make all parts, then store the survey in the transaction that ends the job."""
    services = context.services
    with services.reading() as session:
        known = demo_survey_id(session)
    if known is not None:
        return {"survey_id": known}
    parts = make_parts(services, context.progress)
    context.progress(0.95, Said("job-demo-saving"))

    def store(session: Session) -> Mapping[str, Any]:
        for key in parts.keys:
            if not services.media.exists(key):  # it went with an earlier one: all is made again
                raise Away("store-file-lost", key=key)
        survey_id = build(session, parts)
        for recording in list_recordings(session, survey_id):
            request_if_posed(session, recording.id, actor=None)
        return {"survey_id": survey_id}

    return store


def build(session: Session, parts: Parts) -> int:
    """Store everything; the survey's id."""
    operator, reviewer = (
        demo_person(session, *OPERATOR, "operator"),
        demo_person(session, *REVIEWER, "reviewer"),
    )
    import_catalogue_rows(session, catalogue(), actor=None)
    survey = create_survey(
        session,
        name=NAME,
        site=SITE,
        description=DESCRIPTION,
        traffic=TRAFFIC,
        place=PLACE,
        asked=Asked(TARGETS, TARGETS),
        is_demo=True,
        simulated=True,
        open_to_all=True,
        actor=None,
    )
    camera_id, calibration_id = _camera(session, survey.id, parts)
    chosen: list[Pass] = []
    for number, (video, solved) in enumerate(zip(parts.videos, parts.poses, strict=True)):
        facts: RecordingChanges = {**FILMED[video.truth.lighting], "lighting": video.truth.lighting}
        recording_id = add_film(session, survey.id, camera_id, video, facts)
        add_pose(
            session,
            recording_id,
            calibration_id=calibration_id,
            first_frame=0,
            last_frame=video.truth.board.last_frame,
            **solved,
            actor=None,
        )
        passes = _vehicles(session, recording_id, number, video.truth, operator.id)
        # the last one is left to try with; those by day show faults too
        chosen += with_fates(passes[:-1], faults=video.truth.lighting == "daytime")
    stored = measure(session, chosen, actor=operator.id)
    click_again(session, chosen, stored, operator=operator.id, reviewer=reviewer.id)
    judge(session, chosen, stored, actor=reviewer.id)
    click_wheels(session, chosen, actor=operator.id)
    store_scan(session, survey.id, parts.scan, operator=operator.id, reviewer=reviewer.id)
    return survey.id


def demo_person(session: Session, name: str, email: str, role: Role) -> Person:
    """Somebody whose name stands at the work; switched off, without password or link: nobody can be them."""
    known = person_by_email(session, email) or create_person(
        session, name=name, email=email, role=role, actor=None
    )
    return update_person(session, known.id, name=name, role=role, active=False, actor=None)


def _camera(session: Session, survey_id: int, parts: Parts) -> tuple[int, int]:
    """The camera with its lab pictures and the calibration that was made from them."""
    notes = "Rendered: 640 x 480 px, wide lens with barrel distortion."
    setting = {"lens": "wide angle, invented", "zoom": "fixed", "focus": "fixed, all in focus"}
    camera = create_camera(session, survey_id, name="Roadside camera", notes=notes, **setting, actor=None)
    views = [_lab_image(session, camera.id, one) for one in parts.lab]
    checked = parts.calibration
    result = checked.result
    calibration = add_calibration(
        session,
        camera.id,
        source="images",
        document={**document_of(result.camera, checked), "name": camera.name},
        trusted=result.trusted,
        warnings=list(result.warnings),
        coverage=result.coverage.astype(int).tolist(),
        views=view_rows(views, result),
        summary=summary_of(result.camera, len(result.corners), len(views)),
        actor=None,
    )
    return camera.id, calibration.id


def _lab_image(session: Session, camera_id: int, picture: LabPicture) -> DetectedView:
    view = picture.seen
    image = add_calibration_image(
        session,
        camera_id,
        name=view.name,
        media_key=picture.media_key,
        width_px=view.size[0],
        height_px=view.size[1],
        actor=None,
        detection=detection_of(view.corners, truth().lab),
    )
    return DetectedView(view.name, view.corners, view.size, image_id=image.id)


def add_film(session: Session, survey_id: int, camera_id: int, film: Film, facts: RecordingChanges) -> int:
    """A film as a recording that is ready, with what a person says of it; its id."""
    recording = create_recording(
        session,
        survey_id,
        name=film.name,
        media_key=film.media_key,
        sha256=film.sha256,
        size_bytes=film.size_bytes,
        camera_id=camera_id,
        actor=None,
    )
    note_ingested(session, recording.id, facts_of(film.found, None), film.found.frames, actor=None)
    update_recording(session, recording.id, facts, actor=None)
    return recording.id


def _vehicles(session: Session, recording_id: int, video: int, scene: SceneTruth, actor: int) -> list[Pass]:
    """The passes with what an operator would write down of each vehicle."""
    passes = []
    for number, pass_truth in enumerate(scene.passes):
        fields: VehicleChanges = {
            "first_frame": pass_truth.first_frame,
            "last_frame": pass_truth.last_frame,
            "best_frame": pass_truth.best_frame,
            "make": pass_truth.make,
            "model": pass_truth.model,
            "year": pass_truth.year,
            "category": pass_truth.category,
            "manufacturer_height_m": pass_truth.manufacturer_height_m,
            "u_manufacturer_height_m": 0.01,
            "height_source": "catalogue of the demonstration (invented)",
            "lighting": scene.lighting,
            "direction": "right" if pass_truth.direction > 0 else "left",
        }
        vehicle = create_vehicle(session, recording_id, fields, actor=actor)
        passes.append(Pass(vehicle, pass_truth, scene.fps, (video, number)))
    return passes
