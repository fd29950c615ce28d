"""Cameras of a survey and their calibration images."""

from dataclasses import dataclass
from typing import Annotated

from fastapi import APIRouter, Query, Request, Response, UploadFile
from pydantic import Field

from sightline.cameras import store, taking
from sightline.cameras.board_bodies import BoardIn
from sightline.cameras.calibrations import images as calibration_images
from sightline.cameras.calibrations.calibrating import under_way
from sightline.cameras.calibrations.records import CalibrationImage, ImageFacts
from sightline.cameras.records import Camera, CameraFacts, CameraWords
from sightline.infra.by_name import filled_from
from sightline.infra.jobs.records import Job
from sightline.infra.web.bodies import In, JobBody, Name, Text
from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Wired, Writing
from sightline.infra.web.named import CalibrationId
from sightline.infra.web.pictures import JPEG, jpeg_once
from sightline.infra.web.uploaded import clean_name, whole_file

router = APIRouter()

MOST_IMAGE_BYTES = 64_000_000


@dataclass(frozen=True, slots=True, kw_only=True)
class CalibrationImageBody(ImageFacts):
    """A picture of the board with its address."""

    url: str


@dataclass(frozen=True, slots=True, kw_only=True)
class CameraDetail(CameraFacts):
    """A camera with its images in place of their number, and the calibration that is under way."""

    images: list[CalibrationImageBody]
    calibrating: Annotated[
        JobBody | None, Field(description="A calibration that waits or runs, to be followed.")
    ]


class UsualBoard(BoardIn):
    columns: int = Field(default=9, ge=2, le=100, description="Inner corners.")
    rows: int = Field(default=6, ge=2, le=100, description="Inner corners.")


class NewCamera(In):
    name: Name
    notes: Text = ""
    lens: Annotated[str, Field(max_length=200)] = ""
    zoom: Annotated[str, Field(max_length=100)] = ""
    focus: Annotated[str, Field(max_length=100)] = ""


class CameraChange(NewCamera):
    """Any subset; what is left out stays."""

    name: Name = Field(default="", validate_default=False)


class Choice(In):
    calibration_id: CalibrationId


@router.get("/surveys/{survey_id}/cameras")
def list_cameras(survey_id: PathId, who: Viewer, session: Reading) -> list[Camera]:
    """The cameras of a survey with their calibrations in short."""
    return list(store.list_cameras(session, survey_id))


@router.post("/surveys/{survey_id}/cameras", status_code=201)
def add_camera(survey_id: PathId, body: NewCamera, who: Operator, session: Writing) -> Camera:
    """A new camera: a body and lens at one setting."""
    return store.create_camera(session, survey_id, **body.model_dump(), actor=who.id)


@router.post("/surveys/{survey_id}/cameras/from/{camera_id}", status_code=201)
def take_camera(survey_id: PathId, camera_id: PathId, who: Operator, session: Writing) -> Camera:
    """A camera of another survey, with its current calibration and the pictures that was made of."""
    return taking.take_camera(session, survey_id, camera_id, actor=who.id)


@router.put("/cameras/{camera_id}")
def change_camera(camera_id: PathId, body: CameraChange, who: Operator, session: Writing) -> Camera:
    """Change what is said of a camera: name, notes, lens, zoom, focus."""
    changes = CameraWords(**body.model_dump(exclude_unset=True))  # type: ignore[typeddict-item]
    return store.update_camera(session, camera_id, changes, actor=who.id)


@router.get("/cameras/{camera_id}")
def get_camera(camera_id: PathId, who: Viewer, session: Reading) -> CameraDetail:
    """One camera with its images."""
    job = under_way(session, camera_id)
    return camera_detail(
        store.get_camera(session, camera_id), store.list_calibration_images(session, camera_id), job
    )


@router.post("/cameras/{camera_id}/images", status_code=201)
def add_image(
    camera_id: PathId, file: UploadFile, who: Operator, services: Wired, asked: Annotated[UsualBoard, Query()]
) -> CalibrationImageBody:
    """One picture of the board; the answer says at once whether the board was found in it."""
    name = clean_name(file.filename or "picture")
    content = whole_file(file, MOST_IMAGE_BYTES, name)
    made = calibration_images.add_image(services, camera_id, name, content, asked.board, who.id)
    return image_body(made)


@router.post("/cameras/{camera_id}/images/detect")
def detect_again(
    camera_id: PathId, body: BoardIn, who: Operator, services: Wired
) -> list[CalibrationImageBody]:
    """The board is of another size or kind: look in every image again."""
    images = calibration_images.detect_again(services, camera_id, body.board, who.id)
    return [image_body(one) for one in images]


@router.get("/calibration-images/{image_id}.jpg", response_class=Response, responses=JPEG)
def calibration_image(image_id: PathId, who: Viewer, services: Wired, request: Request) -> Response:
    """The picture at its own size, as JPEG."""
    with services.reading() as session:
        image = store.get_calibration_image(session, image_id)
    etag = f'"{image.media_key.rpartition("/")[2][:32]}"'
    return jpeg_once(request, etag, lambda: calibration_images.as_jpeg(services, image))


@router.delete("/calibration-images/{image_id}", status_code=204)
def remove_image(image_id: PathId, who: Operator, services: Wired) -> None:
    """Take a picture out; calibrations made from it stay as they are."""
    calibration_images.remove_image(services, image_id, who.id)


@router.put("/cameras/{camera_id}/current-calibration")
def choose_calibration(camera_id: PathId, body: Choice, who: Operator, session: Writing) -> Camera:
    """Choose which calibration new road poses use."""
    return store.choose_calibration(session, camera_id, body.calibration_id, actor=who.id)


def image_body(image: CalibrationImage) -> CalibrationImageBody:
    """An image as it goes out, with its address."""
    return filled_from(CalibrationImageBody, image, url=f"/api/calibration-images/{image.id}.jpg")


def camera_detail(camera: Camera, images: tuple[CalibrationImage, ...], job: Job | None) -> CameraDetail:
    """A camera with its images, and the calibration that is under way."""
    calibrating = None if job is None else JobBody.model_validate(job)
    return filled_from(
        CameraDetail, camera, images=[image_body(one) for one in images], calibrating=calibrating
    )
