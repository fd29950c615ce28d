"""The command adjust: a pose corrected by the known lengths and heights of the traffic (docs/formats.md)."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import click
import numpy as np

from sightline.adjustment.account import adjustment_to_dict
from sightline.adjustment.adjust import Adjustment, LeftOut, adjust
from sightline.adjustment.observed import DEFAULT_U_COMMON_M, LENGTHS, POINTS, Known, ObservedPass
from sightline.commands.files import read_csv, write_json
from sightline.commands.geometry_input import problems_of, read_pose_file
from sightline.commands.options import FILE, json_option, number_option, output_option, tell
from sightline.commands.pose import expected_lines
from sightline.errors import BadInput
from sightline.geometry.documents import LARGEST, pose_to_dict
from sightline.geometry.pose import expected_u
from sightline.infra.given_csv import GivenTable
from sightline.messages.said import Said

# passes.csv of `sightline adjust` (docs/formats.md): a point a row, lengths on any row of a pass.


NEEDED = ("pass", "frame", "point", "x_px", "y_px")
OPTIONS = ("sigma_px", *(f"{u}{name}_m" for name in LENGTHS for u in ("", "u_")))
_READ = {
    "sigma_px": GivenTable.uncertainty,
    **{f"u_{name}_m": GivenTable.u_length_m for name in LENGTHS},
    **{f"{name}_m": GivenTable.size_m for name in LENGTHS},
    "roof_inset_m": GivenTable.length_m,
}


@dataclass
class _Pass:
    """Rows of one pass so far; the first thing that cannot be read is why it is left out."""

    rows: list[tuple[float, ...]] = field(default_factory=list)
    lengths: dict[str, float] = field(default_factory=dict)
    problem: Said | None = None


def read_passes(path: Path) -> tuple[list[ObservedPass], list[LeftOut]]:
    """The passes of a passes.csv, and those that cannot be read. Raises BadInput where the table cannot."""
    passes: dict[str, _Pass] = {}
    table = read_csv(path, NEEDED, path.name)
    for number, cells in table.sound_rows():
        name = cells["pass"]
        if not name:
            raise BadInput("commands-row-without-pass", path=path, row=number)
        one = passes.setdefault(name, _Pass())
        one.problem = one.problem or _take(table, one, cells, number)
    for one in passes.values():
        one.problem = one.problem or _lone_length(one)
    good = [_observed(name, one) for name, one in passes.items() if one.problem is None]
    return good, [LeftOut(name, one.problem) for name, one in passes.items() if one.problem is not None]


def _take(table: GivenTable, given_pass: _Pass, cells: Mapping[str, str], number: int) -> Said | None:
    """Add a row to its pass, or say what is wrong with it."""
    values: dict[str, float] = {"sigma_px": 1.0}
    for name in ("frame", "x_px", "y_px", *OPTIONS):
        text = cells.get(name, "")
        if not text and name in OPTIONS:
            continue
        try:
            values[name] = _READ.get(name, GivenTable.number)(table, number, name, text)
        except BadInput as error:
            return error.said
    if values["frame"] != round(values["frame"]) or abs(values["frame"]) > 2**53:
        return Said("adjustment-row-frame", row=number)
    if cells["point"] not in POINTS:
        return Said("adjustment-row-point", row=number, points=", ".join(POINTS))
    for name in OPTIONS[1:]:
        if name in values and given_pass.lengths.setdefault(name, values[name]) != values[name]:
            return Said("adjustment-row-another", row=number, column=name)
    point = POINTS.index(cells["point"])
    given_pass.rows.append((values["frame"], point, values["x_px"], values["y_px"], values["sigma_px"]))
    return None


def _lone_length(given_pass: _Pass) -> Said | None:
    for name in LENGTHS:
        value, u = f"{name}_m", f"u_{name}_m"
        if (value in given_pass.lengths) != (u in given_pass.lengths):
            given, lacking = (value, u) if value in given_pass.lengths else (u, value)
            return Said("adjustment-u-lacking", given=given, lacking=lacking)
    return None


def _observed(name: str, given_pass: _Pass) -> ObservedPass:
    table = np.array(given_pass.rows, dtype=np.float64)
    known = {
        length: Known(given_pass.lengths[f"{length}_m"], given_pass.lengths[f"u_{length}_m"])
        for length in LENGTHS
        if f"{length}_m" in given_pass.lengths
    }
    return ObservedPass(
        name=name,
        frame=table[:, 0].astype(np.int64),
        point=table[:, 1].astype(np.int64),
        points_px=table[:, 2:4],
        sigma_px=table[:, 4],
        **known,
    )


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
        f"chi-square {adjustment.chi2:.0f} with {adjustment.degrees_of_freedom} degrees of freedom"
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
