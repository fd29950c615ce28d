"""The demonstration study: four invented sites, measured and reviewed, so that results look like results.

Nothing is filmed: vehicles are drawn from known fleets, their points are projected through each site's true
camera, clicked 0.7 px beside it, and measured with a road pose that is off as its covariance states. The
program computes every height as for everybody. Names, descriptions and each picture say that it is simulated.
"""

import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import UTC, date, datetime, time
from pathlib import Path
from uuid import UUID, uuid5

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.cameras.calibrations.store import add_calibration
from sightline.cameras.store import create_camera
from sightline.demo.build import OPERATOR, PLACE, REVIEWER, TRAFFIC, add_film, demo_person
from sightline.demo.clicks import CLICK_NOISE_PX, scatter_click
from sightline.demo.made import Model, truth
from sightline.demo.parts import Film, store_film
from sightline.enums import AskedTarget, Lighting, LotGrouping
from sightline.geometry.camera import Camera, project
from sightline.geometry.documents import camera_to_dict
from sightline.geometry.insets import USUAL_INSETS, inset_name
from sightline.geometry.road_pose import RoadPose
from sightline.infra.database import Session
from sightline.infra.jobs import registry
from sightline.infra.services import Services
from sightline.measurements.bulk_service import NewHeight, store_measurements
from sightline.measurements.records import Clicks
from sightline.media.video.writer import write_mp4
from sightline.messages.said import Said
from sightline.poses.service import describe_pose
from sightline.poses.store import add_pose
from sightline.recordings.filming import Filming
from sightline.recordings.records import RecordingChanges
from sightline.reviews.lots.query import get_lot, waiting_measurements
from sightline.reviews.lots.service import accept_lot, draw_lots, lots_with_items, planned_lots
from sightline.reviews.plan_store import choose_review_plan
from sightline.reviews.store import add_review
from sightline.statistics.acceptance import USUAL_RISKS
from sightline.studies.records import StudyFacts, StudySurvey
from sightline.studies.store import create_study, list_studies, newest_result, simulated_study
from sightline.studies.study_job import result_of
from sightline.surveys.records import Asked
from sightline.surveys.store import create_survey, survey_names
from sightline.vehicles.records import VehicleChanges
from sightline.vehicles.store import create_vehicle

Rng = np.random.Generator

BEGIN = "Simulated study: "
DESCRIPTION = (
    "Simulated, not filmed: vehicles drawn from a known fleet, clicks with 0.7 px of noise, camera poses "
    "with errors drawn from their stated uncertainty. An example of statistics, standards, sight distance "
    "and report; no value describes a real road."
)
JOINED = "Simulated study of four invented sites"
#: What the fleet is said to be; its few lorries, whose roofs no camera here sees whole, do not count.
FLEET_CSV = "category,share\nhatchback,0.38\nsaloon,0.16\nestate,0.11\nsuv,0.28\nvan,0.07\nlorry,0\n"
FPS = 25
WIDTH_PX, HEIGHT_PX, FOCAL_PX = 640, 360, 450.0
# u of the lens and of the road pose, in the order of the pose's parameters: px, radians, metres.
_U_FOCAL_PX, _U_CENTRE_PX, _U_TURN, _U_MOVE_M = 0.4, 0.2, 0.0008, 0.002
_TARGETS: dict[Lighting, tuple[AskedTarget, ...]] = {
    "daytime": ("roof", "driver_eye"),
    "low_light": ("roof", "taillight"),
}
_WORDS: dict[Lighting, str] = {"daytime": "daytime", "low_light": "low light"}
_SPREAD_M = {"roof": 0.012, "driver_eye": 0.035, "taillight": 0.010}  # of vehicles of one model
_OPEN_ONE_IN = 25  # vehicles that still wait for their review
_NAMESPACE = UUID("0c4e1f66-20b1-4a53-9a30-6d7c3a9b1c52")


@dataclass(frozen=True)
class Site:
    """An invented site: where its camera stands, how many vehicles by lighting, and its fleet by class."""

    name: str
    seed: int
    day: date
    daytime: int
    low_light: int
    height_m: float
    distance_m: float
    fleet: dict[str, float]

    def count(self, lighting: Lighting) -> int:
        """Vehicles of one lighting."""
        return self.daytime if lighting == "daytime" else self.low_light


SITES = (
    Site(
        name="Invented road A, two lanes",
        seed=1,
        day=date(2025, 5, 13),
        daytime=100,
        low_light=63,
        height_m=1.45,
        distance_m=4.2,
        fleet={"hatchback": 0.40, "saloon": 0.18, "estate": 0.12, "suv": 0.24, "van": 0.06},
    ),
    Site(
        name="Invented road B, two lanes",
        seed=2,
        day=date(2025, 5, 14),
        daytime=100,
        low_light=63,
        height_m=1.60,
        distance_m=5.0,
        fleet={"hatchback": 0.30, "saloon": 0.15, "estate": 0.12, "suv": 0.33, "van": 0.08, "lorry": 0.02},
    ),
    Site(
        name="Invented street C",
        seed=3,
        day=date(2025, 5, 15),
        daytime=100,
        low_light=62,
        height_m=1.35,
        distance_m=3.8,
        fleet={"hatchback": 0.46, "saloon": 0.14, "estate": 0.10, "suv": 0.22, "van": 0.08},
    ),
    Site(
        name="Invented bypass D",
        seed=4,
        day=date(2025, 5, 20),
        daytime=100,
        low_light=62,
        height_m=1.50,
        distance_m=4.6,
        fleet={"hatchback": 0.28, "saloon": 0.22, "estate": 0.16, "suv": 0.26, "van": 0.05, "lorry": 0.03},
    ),
)


def make(context: registry.JobContext) -> registry.Outcome:
    """Each site in a transaction of its own, so that others may write between; what is there stays."""
    services = context.services
    with services.reading() as session:
        there = {name for name, _ in survey_names(session).values()}
    count = 0
    for n, site in enumerate(SITES):
        if BEGIN + site.name in there:
            continue
        context.progress(n / len(SITES), Said("job-demo-site"))
        make_site(services, site)
        count += 1
    with services.writing() as session:
        study_id = join(session)
    if study_id is None:
        return {"surveys": count}
    store = result_of(context, study_id)
    return lambda session: {"surveys": count, **store(session)}


def make_site(services: Services, site: Site) -> int:
    """The survey of one site, whole; its id."""
    films = {lighting: _film(services, site, lighting) for lighting in _TARGETS}
    with services.writing() as session:
        return store_site(session, site, films)


def join(session: Session) -> int | None:
    """The sites as a study, weighted to an invented fleet; None where it was removed or computed before."""
    if (made := simulated_study(session)) is not None:
        is_due = any(one.id == made for one in list_studies(session)) and newest_result(session, made) is None
        return made if is_due else None
    by_name = {name: survey_id for survey_id, (name, _) in survey_names(session).items()}
    facts = StudyFacts(
        name=JOINED,
        description=DESCRIPTION,
        surveys=tuple(
            StudySurvey(by_name[BEGIN + site.name], site.name, year=site.day.year) for site in SITES
        ),
        fleet_csv=FLEET_CSV,
    )
    return create_study(session, facts, simulated=True, actor=None).id


def store_site(session: Session, site: Site, films: dict[Lighting, Film]) -> int:
    """A whole survey of one site; its id."""
    rng = np.random.default_rng([2026, site.seed])
    operator = demo_person(session, *OPERATOR, "operator").id
    reviewer = demo_person(session, *REVIEWER, "reviewer").id
    survey = create_survey(
        session,
        name=BEGIN + site.name,
        site=site.name,
        description=DESCRIPTION,
        traffic=TRAFFIC,
        place=PLACE,
        asked=Asked(**_TARGETS),
        open_to_all=True,
        simulated=True,
        actor=None,
    )
    choose_review_plan(session, survey.id, blind_one_in=0, version=0, actor=None)
    true = true_pose(site)
    camera = create_camera(session, survey.id, name="Simulated camera", notes="Simulated.", actor=None)
    lens = add_calibration(
        session,
        camera.id,
        source="import",
        document={**camera_to_dict(true.camera), "name": camera.name},
        trusted=True,
        warnings=[],
        coverage=[],
        views=[],
        summary=Said("pose-simulated"),
        actor=None,
    )
    for lighting, film in films.items():
        facts: RecordingChanges = {
            "lighting": lighting,
            "weather": "clear, simulated",
            **_filmed(site, lighting),
        }
        recording_id = add_film(session, survey.id, camera.id, film, facts)
        found = describe_pose(disturb_pose(true, rng), np.zeros((0, 2)))
        found |= {"rms_px": None, "distance_m": site.distance_m}
        found["summary"].insert(0, Said("pose-simulated"))
        add_pose(
            session, recording_id, calibration_id=lens.id, first_frame=0, last_frame=0, actor=None, **found
        )
        fresh = [
            one
            for n in range(site.count(lighting))
            for one in _vehicle(session, recording_id, true, n, _model(site, rng), lighting, rng, operator)
        ]
        waiting = [one for one in fresh if one.clicks.frame % _OPEN_ONE_IN == 0]
        others = [one for one in fresh if one.clicks.frame % _OPEN_ONE_IN]
        store_measurements(session, survey.id, others, actor=operator)
        _review_by_lots(session, survey.id, reviewer)
        store_measurements(session, survey.id, waiting, actor=operator)
    return survey.id


def _review_by_lots(session: Session, survey_id: int, reviewer: int) -> None:
    """Each target's heights are a lot, accepted by its sample; a lot too small for that one by one."""
    by: tuple[LotGrouping, ...] = ("target", "lighting")
    saves = any(one.saves for one in planned_lots(session, survey_id, by, USUAL_RISKS))
    drawn = draw_lots(session, survey_id, by, USUAL_RISKS, actor=reviewer) if saves else ()
    for lot, items in lots_with_items(session, [get_lot(session, lot_id) for lot_id in drawn]):
        for item in items:
            if item.role == "sample":
                add_review(
                    session,
                    item.measurement_id,
                    seen_revision=item.revision,
                    verdict="accepted",
                    actor=reviewer,
                )
        accept_lot(session, lot.id, actor=reviewer)
    for left in waiting_measurements(session, survey_id):
        add_review(session, left.series_id, seen_revision=left.revision, verdict="accepted", actor=reviewer)


def true_pose(site: Site) -> RoadPose:
    """Where the camera of a site really stands: looks across the road, a little down and along."""
    rng = np.random.default_rng(site.seed)
    lens = Camera(
        name="simulated",
        width_px=WIDTH_PX,
        height_px=HEIGHT_PX,
        model="brown",
        fx_px=FOCAL_PX,
        fy_px=FOCAL_PX,
        cx_px=(WIDTH_PX - 1) / 2,
        cy_px=(HEIGHT_PX - 1) / 2,
        distortion=np.array([-0.08, 0.01, 0.0, 0.0, 0.0]),
    )
    yaw, pitch = rng.uniform(-0.08, 0.08), 0.06
    level = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
    turned = _rotation(np.array([pitch, yaw, 0.0])) @ level
    centre = np.array([0.0, -site.distance_m, site.height_m])
    return RoadPose(lens, turned, -turned @ centre, _covariance(lens))


def disturb_pose(true: RoadPose, rng: Rng) -> RoadPose:
    """The pose as it was found: the true one with an error that its covariance states."""
    step = rng.normal(0.0, [_U_TURN] * 3 + [_U_MOVE_M] * 3)
    turn = _rotation(step[:3])
    moved = turn @ true.translation_m + step[3:]
    return RoadPose(true.camera, turn @ true.rotation, moved, true.covariance)


def _covariance(lens: Camera) -> Floats:
    """Lens and pose known apart; the lens's distortion is known here, and its focal length not quite."""
    u = [_U_FOCAL_PX, _U_FOCAL_PX, _U_CENTRE_PX, _U_CENTRE_PX] + [0.0] * (len(lens.parameters) - 4)
    return np.diag(np.square([*u, *[_U_TURN] * 3, *[_U_MOVE_M] * 3]))


def _rotation(turn: Floats) -> Floats:
    return np.asarray(cv2.Rodrigues(turn)[0], dtype=np.float64)


def _model(site: Site, rng: Rng) -> Model:
    classes = list(site.fleet)
    category = classes[int(rng.choice(len(classes), p=list(site.fleet.values())))]
    known = [one for one in truth().models if one.category == category]
    return known[int(rng.integers(len(known)))]


def _vehicle(
    session: Session,
    recording_id: int,
    true: RoadPose,
    n: int,
    model: Model,
    lighting: Lighting,
    rng: Rng,
    operator: int,
) -> list[NewHeight]:
    """A vehicle on frame n, and the clicks on it."""
    right = bool(rng.random() < 0.55)
    fields: VehicleChanges = {
        "first_frame": n,
        "last_frame": n,
        "best_frame": n,
        "make": model.make,
        "model": model.model,
        "year": int(rng.integers(model.year_from, model.year_to + 1)),
        "category": model.category,
        "manufacturer_height_m": model.height_m,
        "u_manufacturer_height_m": 0.012,
        "height_source": "catalogue of the demonstration (invented)",
        "lighting": lighting,
        "direction": "right" if right else "left",
    }
    vehicle = create_vehicle(session, recording_id, fields, actor=operator)
    return [
        NewHeight(
            vehicle_id=vehicle.id,
            client_key=str(uuid5(_NAMESPACE, f"{vehicle.id} {clicks.target}")),
            clicks=clicks,
        )
        for clicks in _clicks(true, n, model, right, lighting, rng)
    ]


def _clicks(
    true: RoadPose, n: int, model: Model, right: bool, lighting: Lighting, rng: Rng
) -> Iterator[Clicks]:
    """Where an operator clicks: the tyre nearest to the camera's middle, and each target above it."""
    side_m = rng.uniform(-0.1, 0.5) if right else rng.uniform(2.6, 3.2)
    along_m = rng.uniform(-1.2, 1.2)
    heights = {"roof": model.height_m, "driver_eye": model.eye_height_m, "taillight": model.tail_lamp_m}
    for target in _TARGETS[lighting]:
        name = inset_name(target, "far" if right else "near", model.category)
        assert name is not None
        usual, u, _ = USUAL_INSETS[name]
        inset_m = rng.normal(usual, u)
        height_m = heights[target] + rng.normal(0.0, _SPREAD_M[target])
        there = np.array([[along_m, side_m, 0.0], [along_m + 0.3, side_m + inset_m, height_m]])
        contact, point = project(true.camera, true.to_camera(there)).tolist()
        if not (0 < point[1] < HEIGHT_PX - 1 and 0 < contact[1] < HEIGHT_PX - 1):
            continue  # a lorry's roof, above the picture
        yield Clicks(
            target=target,
            frame=n,
            contact=scatter_click(contact, rng),
            target_point=scatter_click(point, rng),
            sigma_px=CLICK_NOISE_PX,
        )


def _filmed(site: Site, lighting: Lighting) -> RecordingChanges:
    """Half past nine in the morning, or in the evening with lamps lit, on the site's invented day."""
    by_day = lighting == "daytime"
    at = datetime.combine(site.day, time(7 if by_day else 19, 30), UTC)
    return {"filming": Filming(at, "Europe/Paris"), "street_lighting": "off" if by_day else "on"}


def _film(services: Services, site: Site, lighting: Lighting) -> Film:
    """One labelled picture for each vehicle as a video, read as an upload would be, in the media store."""
    name = f"simulated-{site.seed}-{lighting.replace('_', '-')}.mp4"
    with tempfile.TemporaryDirectory(prefix="study-", dir=services.scratch) as folder:
        path = Path(folder) / name
        write_mp4(path, _pictures(site, lighting), FPS)
        return store_film(services, path, Path(folder))


def _pictures(site: Site, lighting: Lighting) -> Iterator[NDArray[np.uint8]]:
    ground = 150 if lighting == "daytime" else 40
    picture = np.full((HEIGHT_PX, WIDTH_PX, 3), ground, np.uint8)
    picture[: HEIGHT_PX // 2] = ground + 40
    for text, y in (("SIMULATED: NO CAMERA WAS HERE", 60), (f"{site.name}, {_WORDS[lighting]}", 95)):
        cv2.putText(picture, text, (30, y), cv2.FONT_HERSHEY_SIMPLEX, 0.7, (255, 255, 255), 2, cv2.LINE_AA)
    for n in range(site.count(lighting)):
        labelled = picture.copy()
        cv2.putText(
            labelled,
            f"vehicle {n + 1}",
            (30, 130),
            cv2.FONT_HERSHEY_SIMPLEX,
            0.6,
            (255, 255, 255),
            1,
            cv2.LINE_AA,
        )
        yield labelled
