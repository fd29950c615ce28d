"""`sightline rig`: what a rig of two line-scan cameras is, found by measuring it (docs/formats.md)."""

import math
from dataclasses import asdict
from pathlib import Path
from typing import Any

import click

from sightline.commands.files import read_bytes, write_json
from sightline.commands.options import FILE, json_option, number_option, output_option, tell
from sightline.commands.scanned import NO_U_LINE_RATE, U_LINE_RATE
from sightline.coverage import expanded
from sightline.errors import BadInput
from sightline.linescan.rig_calibration import (
    Common,
    LaneBaseline,
    RigCalibration,
    calibrate_rig,
    lane_baseline,
)
from sightline.scans.rig.passes_csv import MOST_BYTES, GivenPasses, read_rig_passes


@click.group()
def rig() -> None:
    """Calibrate the rig of two line-scan cameras."""


@rig.command()
@click.argument("passes_csv", type=FILE)
@number_option(
    "--line-rate", "line_rate_hz", help="Line rate of each camera, Hz; needed for passes of known speed."
)
@U_LINE_RATE
@number_option("--u-tape", "u_tape_ratio", default=0.0, help="Relative u of the scale of the tape.")
@number_option("--u-speed", "u_speed_ratio", default=0.0, help="Relative u common to all known speeds.")
@click.option(
    "--distance",
    "lanes",
    multiple=True,
    metavar="M[,U]",
    help="Distance of a lane from the cameras and its u, metres. May be repeated.",
)
@output_option("Also write the JSON object to this file.", required=False)
@json_option
def calibrate(
    passes_csv: Path, lanes: tuple[str, ...], output: Path | None, as_json: bool, **shared: Any
) -> None:
    """Compute baseline and divergence from PASSES_CSV: passes of a staff or board at two distances or more.

    Each row is one pass: its distance, and positions on a tape, lines at a known speed, or the lines of a
    board of known width. Rows that cannot be used are skipped and listed.
    """
    common = Common(**shared)
    line_rate = common.line_rate_hz
    if line_rate is not None and not (math.isfinite(line_rate) and line_rate > 0):
        raise BadInput("commands-option-above-zero", option="--line-rate")
    asked = [_lane(one) for one in lanes]
    given = read_rig_passes(read_bytes(passes_csv, "a CSV table", MOST_BYTES + 1), str(passes_csv), common)
    try:
        calibration = calibrate_rig(given.passes, common)
    except BadInput as error:
        left = "".join(f" Row {one.row} is skipped: {one.reason}" for one in given.refused[:3])
        raise BadInput("rig-passes-problem", path=passes_csv, message=error.message, left=left) from None
    at = [lane_baseline(calibration, *one) for one in asked]
    timed = any(one.kind == "speed" for one in calibration.passes)
    notes = [NO_U_LINE_RATE] if timed and common.u_line_rate_ratio == 0 else []
    document = {
        **asdict(calibration),
        "warnings": [*calibration.warnings, *notes],
        "U95_baseline_m": expanded(calibration.u_baseline_m),
        "U95_divergence_rad": expanded(calibration.u_divergence_rad),
        "lanes": [{**asdict(one), "U95_baseline_m": expanded(one.u_baseline_m)} for one in at],
        "left_out": [asdict(one) for one in given.refused],
    }
    if output is not None:
        write_json(output, document)
    tell(as_json, document, _describe_calibration(calibration, at, given, notes))


def _lane(text: str) -> tuple[float, float]:
    """A distance and its u, 0 where none is given."""
    try:
        numbers = [float(one) for one in text.split(",")]
    except ValueError:
        numbers = []
    if len(numbers) not in (1, 2) or not all(math.isfinite(one) and one >= 0 for one in numbers):
        raise BadInput("rig-no-lane", text=text)
    return numbers[0], (numbers[1] if len(numbers) == 2 else 0.0)


def _describe_calibration(
    calibration: RigCalibration, lanes: list[LaneBaseline], given: GivenPasses, notes: list[str]
) -> str:
    divergence, U95_divergence = (
        1e3 * calibration.divergence_rad,
        1e3 * expanded(calibration.u_divergence_rad),
    )
    lines = [
        f"baseline at the cameras {_mm(calibration.baseline_m)} "
        f"± {_mm(expanded(calibration.u_baseline_m))} mm (95 %)",
        f"divergence {divergence:z.3f} ± {U95_divergence:.3f} mm per m (95 %)",
        f"correlation of both {calibration.correlation:z.3f}",
        f"{len(calibration.passes)} passes from {calibration.nearest_m:.2f} to "
        f"{calibration.farthest_m:.2f} m: chi-square "
        f"{calibration.chi2:.1f} (degrees of freedom: {calibration.degrees_of_freedom}), "
        f"chance {100 * calibration.p_value:.1f} %",
    ]
    lines += [_lane_text(one) for one in lanes]
    lines += [
        f"pass {one.name} at {one.distance_m:.2f} m: {_mm(one.span_m)} mm, "
        f"{1e3 * one.residual_m:+z.2f} mm from the line"
        for one in calibration.passes
    ]
    lines += [f"left out row {one.row} ({one.name}): {one.reason}" for one in given.refused]
    warnings = [*calibration.warnings, *(one.warning for one in lanes if one.warning), *notes]
    return "\n".join([*lines, *(f"note: {one}" for one in warnings)])


def _lane_text(lane: LaneBaseline) -> str:
    u95 = expanded(lane.u_baseline_m)
    share = 100 * u95 / lane.baseline_m
    return (
        f"at {lane.distance_m:.2f} m: baseline {_mm(lane.baseline_m)} ± {_mm(u95)} mm (95 %), "
        f"{share:.3f} % of every speed there"
    )


def _mm(metres: float) -> str:
    return f"{1e3 * metres:.2f}"
