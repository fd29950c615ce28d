"""The command follow: points confirmed on one frame, followed through a vehicle's pass (docs/formats.md)."""

from dataclasses import asdict
from pathlib import Path

import click

from sightline.commands.options import (
    FILE,
    choice_option,
    filmed_at_option,
    json_option,
    number_option,
    stream_option,
)
from sightline.enums import DriverSide, Target
from sightline.errors import BadInput
from sightline.messages.said import Said

_MOST_FRAMES = 120  # to each side, where the pass is not given


@click.command("follow")
@click.argument("video", type=FILE)
@click.option("--pose", "pose_file", type=FILE, required=True, help="pose.json of the recording.")
@click.option("--frame", type=click.IntRange(0), required=True, help="Frame of the points.")
@click.option("--contact", metavar="X,Y", required=True, help="Tyre contact point, pixels.")
@click.option("--second", metavar="X,Y", help="Contact point of the other tyre on the same side, pixels.")
@click.option("--target", metavar="X,Y", required=True, help="Target point, pixels.")
@choice_option("--kind", of=Target, default="other", help="Kind of target; sets the default inset.")
@choice_option("--side", of=DriverSide, help="Driver's side, for an eye.")
@number_option("--inset", help="Approximate inset: distance of the target behind the side plane, metres.")
@number_option("--u-inset", help="u of the inset, metres.")
@number_option("--sigma", default=1.0, help="u of the given points, pixels.")
@click.option("--first", type=click.IntRange(0), help="First frame of the pass.")
@click.option("--last", type=click.IntRange(0), help="Last frame of the pass.")
@click.option("-o", "--output", type=FILE, help="tracks.csv to write.")
@stream_option
@filmed_at_option
@json_option
def follow_command(
    video: Path,
    pose_file: Path,
    frame: int,
    contact: str,
    second: str | None,
    target: str,
    kind: Target,
    side: str | None,
    inset: float | None,
    u_inset: float | None,
    sigma: float,
    first: int | None,
    last: int | None,
    output: Path | None,
    stream_number: int | None,
    filmed_hz: float | None,
    as_json: bool,
) -> None:
    """Follow one vehicle through a VIDEO, starting from confirmed points, and measure it from its whole
    pass.
    """
    from sightline.commands.clicks import assumed_inset
    from sightline.commands.files import csv_text, write_whole
    from sightline.commands.geometry import parse_point, read_pose_file, tell_pass
    from sightline.commands.tracks_csv import COLUMNS, track_rows
    from sightline.geometry.follow_pass import follow_pass
    from sightline.geometry.followed_tracks import CONTACT, SECOND, TARGET
    from sightline.geometry.whole_pass import measure_pass
    from sightline.media.video.passing import frames_between

    pose = read_pose_file(pose_file)
    points = {CONTACT: parse_point(contact, "--contact"), TARGET: parse_point(target, "--target")}
    if second is not None:
        points[SECOND] = parse_point(second, "--second")
    assumed = assumed_inset(kind, side or "", inset, u_inset)
    if isinstance(assumed, Said):
        raise BadInput("commands-follow-none", reason=assumed)
    least = max(0, frame - _MOST_FRAMES) if first is None else first
    span = least, frame + _MOST_FRAMES if last is None else last
    size_px = pose.camera.width_px, pose.camera.height_px
    frames = frames_between(video, *span, size_px, str(video), stream_number, filmed_hz)
    followed = follow_pass(pose, frames, frame, points, kind, assumed.inset_m, sigma)
    if isinstance(followed, Said):
        raise BadInput("commands-follow-none", reason=followed)
    known = (assumed.inset_m, assumed.u_inset_m) if assumed.u_inset_m > 0 else None
    rows = track_rows(followed.tracks)
    if output is not None:
        write_whole(output, csv_text(COLUMNS, rows))
    lost = [{**asdict(one), "reason": str(one.reason)} for one in followed.lost]
    also = {"tracks": rows, "following": asdict(followed.following), "lost": lost}
    tell_pass(measure_pass(pose, followed.tracks, followed.following, assumed_inset=known), as_json, also)
    if not as_json:
        for one in followed.lost:
            click.echo(f"not followed: {one.point} on frame {one.frame}. {one.reason}")
