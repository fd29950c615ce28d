"""The command plan: what heights, or a line scan's speeds, will be worth, before going out."""

from dataclasses import asdict
from pathlib import Path
from typing import Any

import click
import numpy as np

from sightline.commands.geometry_input import parse_size, read_camera_file
from sightline.commands.height import height_to_dict
from sightline.commands.options import FILE, json_option, number_option, tell
from sightline.enums import PlannedQuantity
from sightline.errors import BadInput
from sightline.geometry.camera import Camera
from sightline.geometry.plan import Curve, Plan, plan_site
from sightline.geometry.site import Site, plain_camera
from sightline.linescan.planner import LinePlan, plan_lines
from sightline.messages import write_fixed

_OF_LINES = ("speed_mps", "error", "line_rate_hz", "u_baseline_m", "length_m", "time_gap_s")


@click.command()
@click.option("--camera", "camera_file", type=FILE, help="camera.json of the camera.")
@click.option("--size", "size_text", metavar="WxH", help="Image size, instead of --camera ...")
@number_option("--field-of-view", metavar="DEGREES", help="... with the horizontal field of view, degrees.")
@number_option("--camera-height", "camera_height_m", help="Camera height above the road, metres.")
@number_option("--distance", "distance_m", help="Distance across the road to the wheel path, metres.")
@number_option(
    "--board-distance", "board_distance_m", help="Distance to the board, metres (default: the wheel path)."
)
@number_option("--sigma", "sigma_px", default=1.0, help="u of each click coordinate, pixels.")
@number_option("--direction", default=0.0, help="Yaw from the perpendicular to the road, degrees.")
@number_option("--travel", "travel_m", default=2.0, help="Travel of a vehicle between two frames, metres.")
@number_option("--baseline", "baseline_m", help="Plan a line scan instead: baseline, metres ...")
@number_option("--speed", "speed_mps", help="... speed of the fastest vehicle, m/s ...")
@number_option("--speed-error", "error", help="... allowed relative U95 of its speed (0.01: 1 %) ...")
@number_option(
    "--line-rate", "line_rate_hz", help="... line rate, Hz (default: lines 10 mm apart on the vehicle) ..."
)
@number_option("--u-baseline", "u_baseline_m", help="... and u of the baseline, metres.")
@number_option("--length", "length_m", help="Length of the vehicle of a line scan, metres (default 4.5) ...")
@number_option(
    "--time-gap", "time_gap_s", help="... and its time gap to the vehicle in front, seconds (default 1.5)."
)
@json_option
def plan(
    camera_file: Path | None,
    size_text: str | None,
    field_of_view: float | None,
    direction: float,
    baseline_m: float | None,
    as_json: bool,
    **given: float | None,
) -> None:
    """Predict the uncertainty per target before you record; with --baseline, that of line-scan speeds."""
    of_lines = {name: value for name in _OF_LINES if (value := given.pop(name)) is not None}
    named = (given["camera_height_m"], given["distance_m"], given["board_distance_m"])
    if baseline_m is not None:
        if any(one is not None for one in (camera_file, size_text, field_of_view, *named)):
            raise BadInput("commands-plan-without-camera")
        if not {"speed_mps", "error"} <= of_lines.keys():
            raise BadInput("commands-plan-without-speed")
        lines = plan_lines(**of_lines, baseline_m=baseline_m)
        tell(as_json, _lines_to_dict(lines), _lines_text(lines))
        return
    if of_lines:
        raise BadInput("commands-options-without-baseline")
    if named[0] is None or named[1] is None:
        raise BadInput("commands-plan-incomplete")
    camera = _camera(camera_file, size_text, field_of_view)
    site: dict[str, Any] = {**given, "direction_rad": float(np.deg2rad(direction))}
    planned = plan_site(camera, Site(**site))
    tell(as_json, _plan_to_dict(planned), _plan_text(planned))


def _lines_to_dict(plan: LinePlan) -> dict[str, Any]:
    said = asdict(plan)
    said["advice"] = said.pop("words")
    return said


_WORDS: dict[PlannedQuantity, str] = {
    "speed": "speed, m/s",
    "length": "length, m",
    "time_gap": "time gap, s",
    "distance_gap": "gap, m",
}


def _lines_text(plan: LinePlan) -> str:
    wanted, expected = plan.wanted, plan.expected
    return "\n".join(
        [
            f"{write_fixed(expected.lines, 1)} lines from camera 1 to camera 2 "
            f"at {write_fixed(plan.line_rate_hz, 0)} Hz",
            f"equation (2)              Hz for {100 * plan.error:g} %   speed off by",
            f"as printed, 2 / (n + 2)  {write_fixed(wanted.printed_right_side_hz, 0):>12}   "
            f"{100 * expected.printed_right_side:.3g} %",
            f"corrected, 2 / n         {write_fixed(wanted.corrected_hz, 0):>12}   "
            f"{100 * expected.corrected:.3g} %",
            f"u of the speed, registering and baseline: {plan.u_speed_mps:.4f} m/s",
            *(f"{_WORDS[one.quantity]:<13}{one.value:9.3f} {one.u:8.4f} (u)" for one in plan.values),
            *map(str, plan.words),
        ]
    )


def _camera(camera_file: Path | None, size_text: str | None, field_of_view: float | None) -> Camera:
    size = parse_size(size_text)
    if camera_file is not None and size is None and field_of_view is None:
        return read_camera_file(camera_file)
    if camera_file is None and size is not None and field_of_view is not None:
        return plain_camera(*size, float(np.deg2rad(field_of_view)))
    raise BadInput("commands-camera-or-size")


def _plan_to_dict(planned: Plan) -> dict[str, Any]:
    return {
        **asdict(planned.site),
        "board_distance_m": planned.site.board_m,
        "tilt_rad": planned.tilt_rad,
        "track_shown_m": planned.track_shown_m,
        "targets": [
            {
                "target": t.target,
                "bias_if_ignored_m": t.bias_if_ignored_m,
                **height_to_dict(t.result),
                "height_m": t.height_m,
                "two_frames": asdict(t.two_frames),
            }
            for t in planned.targets
        ],
        "U95_over_distance": [_curve(c, "distance_m", "U95_height_m") for c in planned.U95_over_distance],
        "bias_over_camera_height": [
            _curve(c, "camera_height_m", "bias_if_ignored_m") for c in planned.bias_over_height
        ],
        "advice": list(planned.advice),
    }


def _curve(curve: Curve, at: str, value: str) -> dict[str, Any]:
    points = zip(curve.at_m, curve.value_m, strict=True)
    return {"target": curve.target, "points": [{at: x, value: y} for x, y in points]}


def _plan_text(planned: Plan) -> str:
    lines = ["target          height m  inset m            U95 mm  two frames mm  bias if inset ignored, mm"]
    for t in planned.targets:
        one_frame, two_frames = _mm(t.result.U95_height_m), _mm(t.two_frames.U95_height_m)
        inset = f"{write_fixed(t.inset_m, 2)} (u = {write_fixed(t.u_inset_m, 2)})"
        lines.append(
            f"{t.target:<16}{write_fixed(t.height_m, 2):>8}  {inset}   {one_frame:>7}  {two_frames:>13}  "
            f"{float(write_fixed(1000 * t.bias_if_ignored_m, 0)):+z.0f}"
        )
    eye = next(t for t in planned.targets if t.target == "driver_eye")
    if eye.result.status == "ok" and eye.two_frames.reason is not None:
        lines.append(str(eye.two_frames.reason))
    return "\n".join([*lines, *map(str, planned.advice)])


def _mm(metres: float | None) -> str:
    return "-" if metres is None else write_fixed(1000 * metres, 0)
