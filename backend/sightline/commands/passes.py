"""The command passes: the vehicles that go by in a video (docs/formats.md)."""

from pathlib import Path

import click

from sightline.commands.options import FILE, filmed_at_option, json_option, stream_option, tell
from sightline.detection.classify import FoundPass


@click.command()
@click.argument("video", type=FILE)
@stream_option
@filmed_at_option
@json_option
def passes(video: Path, stream_number: int | None, filmed_hz: float | None, as_json: bool) -> None:
    """Find the vehicle passes in a VIDEO (frame numbers start at 0)."""
    from sightline.media.video.passes import find_passes

    search = find_passes(video, rate_hz=filmed_hz, name=str(video), stream_number=stream_number)
    tell(
        as_json,
        {"passes": [_json_of_pass(one) for one in search.passes], "notes": search.notes},
        f"{video}: {len(search.passes)} found in {search.frames} frames",
        *(
            f"frames {one.first_frame} to {one.last_frame}, best {one.best_frame}, "
            f"{one.direction or 'down or up the frame'}"
            for one in search.passes
        ),
        *(f"note: {note}" for note in search.notes),
    )


def _json_of_pass(found_pass: FoundPass) -> dict[str, int | str | None]:
    return {
        "first": found_pass.first_frame,
        "best": found_pass.best_frame,
        "last": found_pass.last_frame,
        "direction": found_pass.direction,
    }
