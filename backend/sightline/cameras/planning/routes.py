"""Planning a site: what heights will be worth, before anything is measured."""

from dataclasses import asdict
from math import radians
from typing import Annotated

from fastapi import APIRouter, Query

from sightline.cameras.planning.bodies import LineFormBody, LinePlanBody, PlanBody, PlannedTargetBody
from sightline.cameras.planning.service import PlainCamera, plan_for_survey
from sightline.errors import BadInput
from sightline.geometry.camera import Camera
from sightline.geometry.plan import Plan
from sightline.geometry.plan_targets import PlannedTarget
from sightline.geometry.site import BOARD_TOP_M, PLANNING_BOARD, Site
from sightline.infra.web.deps import PathId, Reading, Viewer
from sightline.linescan.planner import LinePlan, plan_lines

router = APIRouter()

Number = Annotated[float, Query(allow_inf_nan=False)]
Optional = Annotated[float | None, Query(allow_inf_nan=False)]
Pixels = Annotated[int | None, Query(ge=0, le=2**31 - 1)]
Calibration = Annotated[int | None, Query(ge=1, le=2**31 - 1)]


@router.get("/surveys/{survey_id}/plan")
def plan_survey(
    survey_id: PathId,
    who: Viewer,
    session: Reading,
    camera_height_m: Number,
    distance_m: Number,
    board_distance_m: Optional = None,
    sigma_px: Number = 1.0,
    direction_deg: Number = 0.0,
    travel_m: Number = 2.0,
    calibration_id: Calibration = None,
    width_px: Pixels = None,
    height_px: Pixels = None,
    field_of_view_deg: Optional = None,
) -> PlanBody:
    """The plan for a calibration of the survey, or for a plain camera of a picture size and a horizontal
    field of view; nothing is stored.
    """
    camera = _camera(calibration_id, width_px, height_px, field_of_view_deg)
    site = Site(
        camera_height_m=camera_height_m,
        distance_m=distance_m,
        board_distance_m=board_distance_m,
        sigma_px=sigma_px,
        direction_rad=radians(direction_deg),
        travel_m=travel_m,
    )
    plan, used = plan_for_survey(session, survey_id, camera, site)
    return plan_body(plan, used, calibration_id, direction_deg)


@router.get("/line-rate-plan")
def plan_line_rate(
    who: Viewer,
    speed_mps: Number,
    baseline_m: Number,
    error: Annotated[float, Query(allow_inf_nan=False, description="Share, 0.01 is 1 %.")],
    line_rate_hz: Optional = None,
    u_baseline_m: Number = 0.0,
) -> LinePlanBody:
    """Equation (2) of the line-scan paper as printed and corrected; nothing is stored."""
    try:
        return line_plan_body(plan_lines(speed_mps, baseline_m, error, line_rate_hz, u_baseline_m))
    except (ValueError, OverflowError) as refused:
        raise BadInput("said", sentence=refused) from refused


def line_plan_body(plan: LinePlan) -> LinePlanBody:
    """A plan of a line rate as it goes out."""
    shared = {name: getattr(plan, name) for name in LinePlanBody.model_fields if hasattr(plan, name)}

    def form(rate_hz: float, error: float) -> LineFormBody:
        return LineFormBody(line_rate_hz=rate_hz, error=error, error_mps=error * plan.speed_mps)

    return LinePlanBody(
        **shared,
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
        raise BadInput("cameras-choose-calibration-give-pictures-width-height")
    return PlainCamera(width_px, height_px, field_of_view_deg)


def plan_body(plan: Plan, camera: Camera, calibration_id: int | None, direction_deg: float) -> PlanBody:
    """A plan as it goes out."""
    site = plan.site
    return PlanBody.model_validate(
        {
            "camera": {
                "name": camera.name,
                "width_px": camera.width_px,
                "height_px": camera.height_px,
                "calibration_id": calibration_id,
                "lens_known": camera.covariance is not None,
            },
            "site": {**asdict(site), "board_distance_m": site.board_m, "direction_deg": direction_deg},
            "board": {**asdict(PLANNING_BOARD), "top_m": BOARD_TOP_M},
            "targets": [_target(one) for one in plan.targets],
            "advice": plan.advice,
            "U95_over_distance": plan.U95_over_distance,
            "bias_over_camera_height": plan.bias_over_height,
            "outlook": plan.outlook,
            "tilt_rad": plan.tilt_rad,
            "track_shown_m": plan.track_shown_m,
        }
    )


def _target(one: PlannedTarget) -> PlannedTargetBody:
    result = asdict(one.result)
    chosen = ("status", "reason", "u_height_m", "U95_height_m", "budget", "flags")
    planned = {name: getattr(one, name) for name in ("target", "height_m", "inset_m", "u_inset_m")}
    return PlannedTargetBody.model_validate(
        {
            **planned,
            **{name: result[name] for name in chosen},
            "bias_if_ignored_m": one.bias_if_ignored_m,
            "two_frames": asdict(one.two_frames),
        }
    )
