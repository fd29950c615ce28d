"""The command propose: where a person would click on each vehicle of a video (docs/formats.md)."""

from pathlib import Path
from typing import Any

import click

from sightline.commands.options import FILE, filmed_at_option, json_option, stream_option, tell
from sightline.detection.classify import FoundPass
from sightline.messages import say
from sightline.proposals.propose import Proposals, Proposed


@click.command("propose")
@click.argument("video", type=FILE)
@click.option("--pose", "pose_file", type=FILE, required=True, help="pose.json of the recording.")
@stream_option
@filmed_at_option
@json_option
def propose_command(
    video: Path, pose_file: Path, stream_number: int | None, filmed_hz: float | None, as_json: bool
) -> None:
    """Suggest tyre contacts, roof, rear lamp and eye of each vehicle in a VIDEO, or state why not."""
    from sightline.commands.geometry import read_pose_file
    from sightline.media.video.passes import find_passes
    from sightline.media.video.proposals import propose_in_video
    from sightline.vehicles.passes.find_job import square_at

    pose = read_pose_file(pose_file)
    search = find_passes(
        video, rate_hz=filmed_hz, square_at=square_at(pose), name=str(video), stream_number=stream_number
    )
    proposals = dict(
        propose_in_video(
            video, search.passes, pose, rate_hz=filmed_hz, name=str(video), stream_number=stream_number
        )
    )
    told = [_json_of_proposals(one, proposals[index]) for index, one in enumerate(search.passes)]
    notes = (f"note: {note}" for note in search.notes)
    tell(as_json, {"passes": told, "notes": list(search.notes)}, *map(_line, told), *notes)


def _json_of_proposals(one: FoundPass, proposals: Proposals | str) -> dict[str, Any]:
    out: dict[str, Any] = {"first": one.first_frame, "last": one.last_frame, "direction": one.direction}
    if isinstance(proposals, str):
        return out | {"frame": None, "reason": say(proposals, {}), "wheelbase_m": None, "points": []}
    points = [_point(name, point) for name, point in proposals.points.items()]
    return out | {
        "frame": proposals.frame,
        "reason": None,
        "wheelbase_m": proposals.wheelbase_m,
        "points": points,
    }


def _point(name: str, point: Proposed | str) -> dict[str, Any]:
    if isinstance(point, str):
        return {"point": name, "reason": say(point, {})}
    x, y = point.point_px
    place = {"x_px": round(x, 2), "y_px": round(y, 2), "expected_px": round(point.expected_px, 2)}
    height = {} if point.expected_m is None else {"expected_m": round(point.expected_m, 4)}
    return {"point": name, **place, **height}


def _line(proposed: dict[str, Any]) -> str:
    span = f"frames {proposed['first']} to {proposed['last']}"
    if proposed["reason"] is not None:
        return f"{span}: {proposed['reason']}"
    return f"{span}, on frame {proposed['frame']}: " + "; ".join(
        _describe_point(point) for point in proposed["points"]
    )


def _describe_point(point: dict[str, Any]) -> str:
    name = point["point"].replace("_", " ")
    if "reason" in point:
        return f"{name}: none"
    error = f"{point['expected_px']:.1f} px" + (
        f", {1000 * point['expected_m']:.0f} mm" if "expected_m" in point else ""
    )
    return f"{name} at ({point['x_px']:.1f}, {point['y_px']:.1f}), expect about {error}"
