"""The command height (docs/formats.md)."""

from collections.abc import Mapping
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import click
import numpy as np

from sightline.commands.clicks import OF_HEIGHT, Assumed, assumed_inset, heights_csv
from sightline.commands.files import write_whole
from sightline.commands.geometry_input import parse_point, read_pose_file
from sightline.commands.options import (
    FILE,
    choice_option,
    json_option,
    number_option,
    output_option,
    refuse_ignored,
    tell,
)
from sightline.commands.tracks_csv import pass_to_dict, read_tracks
from sightline.enums import DriverSide, Target
from sightline.errors import BadInput
from sightline.geometry.documents import LARGEST
from sightline.geometry.followed_tracks import Following
from sightline.geometry.height import Height, measure_height, not_measurable
from sightline.geometry.road_pose import RoadPose
from sightline.geometry.whole_pass import WholePass, measure_pass
from sightline.messages import write_fixed
from sightline.messages.said import Said


@click.command()
@click.option("--pose", "pose_file", type=FILE, required=True, help="pose.json of the recording.")
@click.option("--contact", metavar="X,Y", help="Tyre contact point, pixels.")
@click.option("--target", metavar="X,Y", help="Target point, pixels.")
@choice_option("--kind", of=Target, help="Kind of target; sets the default inset.")
@choice_option("--side", of=DriverSide, help="Driver's side of the vehicle.")
@number_option(
    "--inset",
    help="Inset: distance of the target behind the side plane, metres (default: that of --kind, else 0).",
)
@number_option("--u-inset", help="u of the inset, metres (default: that of --kind, else 0).")
@number_option("--sigma", default=1.0, help="u of each click coordinate, pixels.")
@click.option("--clicks", type=FILE, help="clicks.csv instead of one pair of clicks.")
@click.option("--tracks", type=FILE, help="tracks.csv: one vehicle followed through its pass.")
@number_option("--confirmed", "confirmed_px", default=1.0, help="u of each track's first click, pixels.")
@click.option("--begun-on", type=int, help="Frame that was clicked on (default: the first of the table).")
@number_option("--drift", "drift_px", default=0.0, help="u of a followed point from frame to frame, pixels.")
@number_option("--u-time", "u_time_s", default=0.0, help="u of the time of a frame, seconds.")
@number_option(
    "--row-time", "row_time_s", default=0.0, help="Rolling shutter: time from one row to the next, seconds."
)
@number_option("--u-row-time", "u_row_time_s", default=0.0, help="u of the rolling-shutter time, seconds.")
@number_option("--exposure", "exposure_s", default=0.0, help="Exposure of a row, seconds (motion blur).")
@number_option(
    "--view",
    "view_px",
    default=0.0,
    help="u of a point due to its changing aspect, pixels per 100 px of travel.",
)
@number_option(
    "--depth-share", "u_depth_share", default=0.0, help="Relief around the followed target: depth / distance."
)
@click.option("--matched", is_flag=True, help="Followed points are given as shifts from the clicked frame.")
@output_option("heights.csv to write.", required=False)
@json_option
def height(
    pose_file: Path,
    contact: str | None,
    target: str | None,
    kind: str | None,
    side: str | None,
    inset: float | None,
    u_inset: float | None,
    sigma: float,
    clicks: Path | None,
    tracks: Path | None,
    output: Path | None,
    as_json: bool,
    **followed: Any,
) -> None:
    """Compute one height from two clicks or a followed pass, or all heights of a clicks.csv."""
    solved = read_pose_file(pose_file)
    if tracks is not None:
        one_or_many = (contact, target, clicks)
        if any(given is not None for given in one_or_many):
            raise BadInput("commands-tracks-alone")
        refuse_ignored(("sigma",), "the CSV's column sigma_px")
        refuse_ignored(("inset", "u_inset", "kind", "side"), "nothing: a whole pass is solved for its inset")
        refuse_ignored(("output",), "--json and a redirection")
        following = Following(**followed)
        if not following.can_be:
            raise BadInput("height-pass-statement-not-valid")
        tell_pass(measure_pass(solved, read_tracks(tracks), following), as_json)
        return
    refuse_ignored(tuple(followed), "--tracks with a CSV file")
    if clicks is not None:
        if contact is not None or target is not None:
            raise BadInput("commands-points-or-clicks")
        columns = "the CSV's columns sigma_px, inset_m, u_inset_m, target, side"
        refuse_ignored(("sigma", "inset", "u_inset", "kind", "side"), columns)
        _measure_file(solved, clicks, output, as_json)
        return
    refuse_ignored(("output",), "--json and a redirection, or --clicks with a CSV file")
    if contact is None or target is None:
        raise BadInput("commands-points-missing")
    points = parse_point(contact, "--contact"), parse_point(target, "--target")
    assumed = assumed_inset(kind or "", side or "", inset, u_inset)
    measured = _measure_one(solved, *points, sigma, assumed)
    unknown = {"inset_m": None, "u_inset_m": None} if isinstance(assumed, Said) else {}
    tell(as_json, height_to_dict(measured) | unknown, *_height_lines(measured))


def tell_pass(found: WholePass, as_json: bool, also: Mapping[str, Any] | None = None) -> None:
    """A whole pass as a sentence and notes, or as JSON with more beside it."""
    value, *notes = _height_lines(found.height, f", followed on {found.frames} frames")
    dropped = (f"excluded: {one.point} on frame {one.frame}. {one.reason}" for one in found.dropped)
    document = height_to_dict(found.height) | pass_to_dict(found) | dict(also or {})
    tell(as_json, document, value, *dropped, *notes)


def _height_lines(measured: Height, how: str = "") -> list[str]:
    """A height and its notes, a line each; `how`: what is said of it behind its interval."""
    if measured.height_m is None or measured.U95_height_m is None:
        return [f"not measurable: {measured.reason}"]
    height, U95 = (write_fixed(one, 3) for one in (measured.height_m, measured.U95_height_m))
    value = f"{height} m ± {U95} m (95 %){how}"
    return [value, *(f"note: {flag}" for flag in measured.flags)]


def _measure_one(
    solved: RoadPose,
    contact: tuple[float, float],
    target: tuple[float, float],
    sigma: float,
    inset: Assumed | Said,
) -> Height:
    """One height with the flags of its inset. Raises BadInput for a number that cannot be used."""
    numbers = (sigma, 0.0, 0.0) if isinstance(inset, Said) else (sigma, inset.inset_m, inset.u_inset_m)
    if not (np.abs(numbers) <= LARGEST).all() or sigma < 0 or numbers[2] < 0:
        raise BadInput("commands-sigmas-not-finite")
    if isinstance(inset, Said):
        return not_measurable(inset)
    measured = measure_height(solved, contact, target, *numbers)
    return replace(measured, flags=(*inset.flags, *measured.flags)) if measured.status == "ok" else measured


def _measure_file(solved: RoadPose, clicks: Path, output: Path | None, as_json: bool) -> None:
    if output is None:
        raise BadInput("commands-output-missing")
    text, counts = heights_csv(solved, clicks)
    write_whole(output, text)
    told = f"{output}: {counts.measured} of {counts.rows} rows have a height"
    tell(as_json, {**asdict(counts), "output": str(output)}, told)


def height_to_dict(measured: Height) -> dict[str, Any]:
    """A height as `sightline height --json` prints it."""
    said = {name: getattr(measured, name) for name in _PRINTED}
    return said | {
        "reason": measured.reason and str(measured.reason),
        "budget": [asdict(entry) for entry in measured.budget],
        "flags": [str(flag) for flag in measured.flags],
    }


_PRINTED = (*OF_HEIGHT, "inset_m", "u_inset_m", "status")
