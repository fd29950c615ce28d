"""Planning a site: what heights will be worth, before anything is measured."""

from dataclasses import dataclass
from math import radians
from typing import Annotated

from fastapi import APIRouter, Depends, Query, Response

from sightline.cameras.planning.bodies import (
    LineFormBody,
    LinePlanBody,
    PlanBody,
    PlannedBoard,
    PlannedCamera,
    PlannedSite,
    PlannedTargetBody,
)
from sightline.cameras.planning.service import PlainCamera, plan_for_survey
from sightline.cameras.planning.sheet import sheet_pdf
from sightline.errors import BadInput
from sightline.geometry.camera import Camera
from sightline.geometry.plan import Plan
from sightline.geometry.site import BOARD_TOP_M, PLANNING_BOARD, Site
from sightline.infra.by_name import filled_from
from sightline.infra.web.deps import PathId, Reading, Viewer
from sightline.infra.web.named import CalibrationId
from sightline.linescan.exposure import ExposurePlan, LineCamera, plan_exposure
from sightline.linescan.planner import USUAL_LENGTH_M, USUAL_TIME_GAP_S, LinePlan, plan_lines
from sightline.messages import SOURCE, languages
from sightline.surveys.store import get_survey

router = APIRouter()

Number = Annotated[float, Query(allow_inf_nan=False)]
Optional = Annotated[float | None, Query(allow_inf_nan=False)]
Pixels = Annotated[int | None, Query(ge=0, le=2**31 - 1)]


@dataclass(frozen=True)
class Asked:
    """What is planned with."""

    camera: int | PlainCamera
    site: Site
    calibration_id: int | None
    direction_deg: float


def _read_asked_plan(
    camera_height_m: Number,
    distance_m: Number,
    board_distance_m: Optional = None,
    sigma_px: Number = 1.0,
    direction_deg: Number = 0.0,
    travel_m: Number = 2.0,
    calibration_id: Annotated[CalibrationId | None, Query()] = None,
    width_px: Pixels = None,
    height_px: Pixels = None,
    field_of_view_deg: Optional = None,
) -> Asked:
    """A calibration of the survey, or a plain camera of a picture size and a horizontal field of view."""
    site = Site(
        camera_height_m=camera_height_m,
        distance_m=distance_m,
        board_distance_m=board_distance_m,
        sigma_px=sigma_px,
        direction_rad=radians(direction_deg),
        travel_m=travel_m,
    )
    camera = _camera(calibration_id, width_px, height_px, field_of_view_deg)
    return Asked(camera, site, calibration_id, direction_deg)


AskedPlan = Annotated[Asked, Depends(_read_asked_plan)]


@router.get("/surveys/{survey_id}/plan")
def plan_survey(survey_id: PathId, who: Viewer, session: Reading, asked: AskedPlan) -> PlanBody:
    """What heights will be worth there; nothing is stored."""
    plan, used = plan_for_survey(session, survey_id, asked.camera, asked.site)
    return plan_body(plan, used, asked.calibration_id, asked.direction_deg)


@router.get("/surveys/{survey_id}/plan.pdf", response_class=Response)
def print_plan(
    survey_id: PathId,
    who: Viewer,
    session: Reading,
    asked: AskedPlan,
    language: Annotated[
        str, Query(max_length=20, description="One of the catalogue's, as en or fr.")
    ] = SOURCE,
) -> Response:
    """The set-up sheet: the drawing to scale, the numbers, exposure by speed, and a check list; one page."""
    if language not in languages():
        raise BadInput("planning-no-language", language=language, known=", ".join(languages()))
    survey = get_survey(session, survey_id)
    plan, used = plan_for_survey(session, survey_id, asked.camera, asked.site)
    plain = asked.camera.field_of_view_deg if isinstance(asked.camera, PlainCamera) else None
    made = sheet_pdf(plan, used, survey.name, survey.site, field_of_view_deg=plain, language=language)
    headers = {"Content-Disposition": 'inline; filename="sightline-set-up-sheet.pdf"'}
    return Response(made, media_type="application/pdf", headers=headers)


@router.get("/line-rate-plan")
def plan_line_rate(
    who: Viewer,
    speed_mps: Number,
    baseline_m: Number,
    error: Annotated[float, Query(allow_inf_nan=False, description="Share, 0.01 is 1 %.")],
    line_rate_hz: Optional = None,
    u_baseline_m: Number = 0.0,
    length_m: Number = USUAL_LENGTH_M,
    time_gap_s: Number = USUAL_TIME_GAP_S,
    pixel_width_um: Optional = None,
    pixel_height_um: Optional = None,
    focal_mm: Optional = None,
    distance_m: Optional = None,
    exposure_us: Annotated[
        float | None, Query(allow_inf_nan=False, description="Not given: the whole time of a line.")
    ] = None,
) -> LinePlanBody:
    """What speed, length and gaps will be known to, equation (2) of the line-scan paper, and what pixels and
    exposure make of a vehicle; nothing is stored.
    """
    plan = plan_lines(speed_mps, baseline_m, error, line_rate_hz, u_baseline_m, length_m, time_gap_s)
    if pixel_width_um is None or pixel_height_um is None or focal_mm is None or distance_m is None:
        return line_plan_body(plan, None)
    camera = LineCamera(pixel_width_um, pixel_height_um, focal_mm, distance_m, exposure_us)
    return line_plan_body(plan, plan_exposure(camera, speed_mps, plan.line_rate_hz, baseline_m))


def line_plan_body(plan: LinePlan, exposure: ExposurePlan | None) -> LinePlanBody:
    """A plan of a line rate as it goes out."""
    shared = {name: getattr(plan, name) for name in LinePlanBody.model_fields if hasattr(plan, name)}

    def form(rate_hz: float, error: float) -> LineFormBody:
        return LineFormBody(line_rate_hz=rate_hz, error=error, error_mps=error * plan.speed_mps)

    return LinePlanBody(
        **shared,
        exposure=exposure,
        lines=plan.expected.lines,
        printed=form(plan.wanted.printed_right_side_hz, plan.expected.printed_right_side),
        corrected=form(plan.wanted.corrected_hz, plan.expected.corrected),
        advice=list(plan.words),
    )


def _camera(
    calibration_id: int | None, width_px: int | None, height_px: int | None, field_of_view_deg: float | None
) -> int | PlainCamera:
    if calibration_id is not None:
        return calibration_id
    if width_px is None or height_px is None or field_of_view_deg is None:
        raise BadInput("cameras-no-image-size")
    return PlainCamera(width_px, height_px, field_of_view_deg)


def plan_body(plan: Plan, camera: Camera, calibration_id: int | None, direction_deg: float) -> PlanBody:
    """A plan as it goes out."""
    site = plan.site
    return filled_from(
        PlanBody,
        plan,
        camera=filled_from(
            PlannedCamera, camera, calibration_id=calibration_id, lens_known=camera.covariance is not None
        ),
        site=filled_from(PlannedSite, site, board_distance_m=site.board_m, direction_deg=direction_deg),
        board=filled_from(PlannedBoard, PLANNING_BOARD, top_m=BOARD_TOP_M),
        targets=[filled_from(PlannedTargetBody, one, one.result) for one in plan.targets],
        bias_over_camera_height=plan.bias_over_height,
    )
