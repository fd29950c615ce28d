"""The command adjust: a pose corrected by the known lengths and heights of the traffic (docs/formats.md)."""

from pathlib import Path

import click

from sightline.adjustment.account import adjustment_to_dict
from sightline.adjustment.adjust import Adjustment, LeftOut, adjust
from sightline.adjustment.observed import DEFAULT_U_COMMON_M
from sightline.commands.files import write_json
from sightline.commands.geometry_input import problems_of, read_pose_file
from sightline.commands.options import FILE, json_option, number_option, output_option, tell
from sightline.commands.passes_csv import read_passes
from sightline.commands.pose import expected_lines
from sightline.errors import BadInput
from sightline.geometry.documents import LARGEST, pose_to_dict
from sightline.geometry.pose import expected_u


@click.command("adjust")
@click.option("--pose", "pose_file", type=FILE, required=True, help="pose.json to adjust.")
@click.option(
    "--passes", "passes_file", type=FILE, required=True, help="passes.csv with the observed vehicles."
)
@number_option(
    "--u-wheelbase-common",
    default=DEFAULT_U_COMMON_M,
    help="u of the error common to all known wheelbases, metres.",
)
@number_option(
    "--u-roof-common",
    default=DEFAULT_U_COMMON_M,
    help="u of the error common to all known roof heights, metres.",
)
@output_option("adjusted.json to write.")
@json_option
def adjust_command(
    pose_file: Path,
    passes_file: Path,
    u_wheelbase_common: float,
    u_roof_common: float,
    output: Path,
    as_json: bool,
) -> None:
    """Adjust a camera pose to the traffic: vehicles of known wheelbase or height, seen on several frames."""
    for name, u in (("--u-wheelbase-common", u_wheelbase_common), ("--u-roof-common", u_roof_common)):
        if not 0.0 <= u <= LARGEST:
            raise BadInput("commands-option-not-negative", option=name)
    pose = read_pose_file(pose_file)
    passes, unread = read_passes(passes_file)
    with problems_of(pose_file, passes_file):
        found = adjust(pose, passes, u_wheelbase_common, u_roof_common)
    document = {**pose_to_dict(found.pose), "adjustment": adjustment_to_dict(found, unread)}
    write_json(output, document)
    tell(as_json, document, _describe_adjustment(found, unread, output))


def _describe_adjustment(adjustment: Adjustment, unread: list[LeftOut], output: Path) -> str:
    lines = [
        f"{output}: {adjustment.used} of {adjustment.passes + len(unread)} passes used, "
        f"chi-square {adjustment.chi2:.0f} (degrees of freedom: {adjustment.degrees_of_freedom})"
    ]
    lines += [f"left out {one.name}: {one.reason}" for one in (*unread, *adjustment.left_out)]
    lines += [
        f"left out of {one.name}: {one.point} on frame {one.frame}" for one in adjustment.dropped_points
    ]
    lines += [
        f"{one.name}{'' if one.of_m is None else f' of {one.of_m:g} m'}: {one.value:+z.6f}, "
        f"u = {one.u_before:.6f} -> {one.u_after:.6f}"
        for one in adjustment.moved
    ]
    lines += expected_lines(expected_u(adjustment.pose))
    return "\n".join([*lines, *(f"note: {note}" for note in adjustment.notes)])
