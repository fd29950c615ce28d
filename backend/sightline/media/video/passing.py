"""The frames of one pass of a video, in memory, with their times."""

from contextlib import closing
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np

from sightline.errors import BadInput
from sightline.geometry.follow_pass import PassFrame
from sightline.media.video.decode import (
    NO_PTS,
    frame_pts,
    number_frames,
    open_container,
    require_whole,
    video_stream,
)
from sightline.media.video.picture import Gray, upright_gray
from sightline.media.video.report import clock_doubt_of, require_clock_of_filming, times_of_filming
from sightline.media.video.stated import stated_of

_MOST_EARLY = 16  # frames by which a packet may come before its picture is shown (H.264, A.3.1)


def frames_between(
    path: Path,
    first: int,
    last: int,
    size_px: tuple[int, int],
    name: str,
    stream_number: int | None = None,
    filmed_hz: float | None = None,
) -> list[PassFrame]:
    """Frames `first` to `last`, upright, as far as the video has them; `size_px`: width and height;
    `filmed_hz`: the rate of filming, where its times are not those of filming (`times_of_filming`). Times are
    those of the frame table (`frame_table.FrameTable`): the file's, sorted.

    Raises BadInput for what is no video, one of another size, without times, or whose times are not those of
    filming.
    """
    stamps: list[Fraction] = []
    pictures: list[tuple[int, Gray, float]] = []
    with closing(open_container(path, name)) as container:
        require_whole(path, name, stream_number)
        stream = video_stream(container, name, number=stream_number)
        for n, frame, layout in number_frames(container, stream, name, size_px):
            if n > last + _MOST_EARLY:
                break
            pts, base = frame_pts(frame), frame.time_base
            if pts == NO_PTS or base is None:
                if n > last:
                    break
                raise BadInput("video-no-times-follow", name=name)
            stamps.append(pts * base)
            if first <= n <= last:
                pictures.append((n, upright_gray(frame, layout), float(base)))
        stated = stated_of(container, path)
    stamps.sort()
    out = [PassFrame(n, float(stamps[n]), gray, tick_s) for n, gray, tick_s in pictures]
    time_s = np.array([one.time_s for one in out])
    if filmed_hz is None:
        require_clock_of_filming(clock_doubt_of(time_s, stated), name)
        return out
    times = times_of_filming(time_s, filmed_hz, name)
    return [replace(one, time_s=float(at), tick_s=0.0) for one, at in zip(out, times, strict=True)]
