"""Ingest: one sequential decode of a recording that fixes what "frame n" means from then on."""

from contextlib import closing
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from av.container import InputContainer
from av.video.stream import VideoStream

from sightline.errors import BadInput
from sightline.media.cancelling import Cancelled, Progress, Watch
from sightline.media.store.local import check_room, no_room_told
from sightline.media.video.decode import (
    NO_PTS,
    Damage,
    Picture,
    VideoFacts,
    facts_of,
    frame_pts,
    number_frames,
    open_container,
    picture_read,
    require_whole,
    video_stream,
)
from sightline.media.video.frame_table import FrameTable
from sightline.media.video.picture import luma_crc
from sightline.media.video.remux import WorkingCopy, make_copy, needs_copy
from sightline.media.video.report import IngestReport, report_of, times_of_filming
from sightline.media.video.sniff import extent_of
from sightline.media.video.stated import Stated, stated_of
from sightline.media.video.thumbnails import ROOM_BYTES, Thumbnail, ThumbnailWriter

OTHER_SIZE_SHARE = 0.05


@dataclass(frozen=True, eq=False)
class Ingested:
    """What an ingest found. `media_path` is the file that the frame table numbers: the original, or for
    streams without an index the working copy written beside it (`is_working_copy`), which has to be kept
    with it.
    """

    facts: VideoFacts
    frames: FrameTable
    report: IngestReport
    thumbnails: tuple[Thumbnail, ...]
    media_path: Path
    is_working_copy: bool
    stated: Stated = field(default_factory=Stated)


@dataclass
class _Rows:
    pts: list[int]
    key: list[bool]
    crc: list[int]


def ingest(
    path: Path,
    on_progress: Progress,
    is_cancelled: Cancelled,
    thumb_dir: Path,
    *,
    work_dir: Path | None = None,
    name: str | None = None,
    stream_number: int | None = None,
    filmed_hz: float | None = None,
) -> Ingested:
    """Decode the recording once, from the first frame to the last, and write down what it is.

    `on_progress` gets a fraction 0..1 a few times a second; `is_cancelled` is asked at every frame.
    Thumbnails are written to `thumb_dir` (emptied of older ones first), a working copy if one is needed
    to `work_dir` (default: beside the file). `name` is what people call the file. `stream_number`: see
    `video_stream`; `filmed_hz`: see `times_of_filming`. May be called again after being killed at any moment.

    Raises BadInput (not a video, or nothing in it can be decoded), NoRoom and Stopped.
    """
    name = name or path.name
    folder = work_dir or path.parent
    copy: WorkingCopy | None = None
    with closing(open_container(path, name)) as original:
        require_whole(path, name, stream_number)
        stated = stated_of(original, path)
        number, pictures = picture_read(original, name, stream_number)
        kind = original.format.name
        by_copy = needs_copy(kind)
    if by_copy:
        copy = make_copy(path, folder, name, is_cancelled, keep_times=True, stream_number=number)
    asked = _Asked(number, filmed_hz, kind, pictures)
    watch = Watch(on_progress, is_cancelled, name)
    container = open_container(copy.path if copy else path, name)
    result = _ingest_open(container, path, copy, watch, thumb_dir, stated, asked)
    if copy is None and bool(np.any(result.frames.pts == NO_PTS)):
        copy = make_copy(path, folder, name, is_cancelled, keep_times=False, stream_number=number)
        result = _ingest_open(open_container(copy.path, name), path, copy, watch, thumb_dir, stated, asked)
    on_progress(1.0)
    return replace(result, stated=stated)


@dataclass(frozen=True)
class _Asked:
    """What a person asked of the reading, and what the original is: its container and its pictures (a working
    copy has a container of its own, and one picture).
    """

    number: int
    filmed_hz: float | None
    container: str
    pictures: tuple[Picture, ...]


def _ingest_open(
    container: InputContainer,
    path: Path,
    copy: WorkingCopy | None,
    watch: Watch,
    thumb_dir: Path,
    stated: Stated,
    asked: _Asked,
) -> Ingested:
    """Decode an open container to its end and close it; a damaged one again, so that it can be repeated."""
    damage = Damage()
    media_path, of_copy = (copy.path, None) if copy else (path, asked.number)
    watch.size = media_path.stat().st_size
    with no_room_told():
        with closing(container):
            thumb_dir.mkdir(parents=True, exist_ok=True)
            check_room(thumb_dir, ROOM_BYTES)
            stream = video_stream(container, watch.name, number=of_copy)
            facts, rows, thumbs = _decode_all(container, stream, damage, watch, thumb_dir)
        if damage.any:
            damage = Damage()
            with closing(open_container(media_path, watch.name)) as again:
                stream = video_stream(again, watch.name, threads=1, number=of_copy)
                facts, rows, thumbs = _decode_all(again, stream, damage, watch, thumb_dir)
    facts = replace(facts, container=asked.container, stream=asked.number, pictures=asked.pictures)
    table = _table(rows, float(facts.time_base))
    played = table.time_s, table.crc32, damage, copy, stated, extent_of(path)
    if asked.filmed_hz is not None:
        table = replace(table, time_s=times_of_filming(table.time_s, asked.filmed_hz, watch.name))
    return Ingested(
        facts=facts,
        frames=table,
        report=report_of(facts, table.pts, *played, asked.filmed_hz),
        thumbnails=thumbs.finish(),
        media_path=media_path,
        is_working_copy=copy is not None,
    )


def _decode_all(
    container: InputContainer, stream: VideoStream, damage: Damage, watch: Watch, thumb_dir: Path
) -> tuple[VideoFacts, _Rows, ThumbnailWriter]:
    rows = _Rows([], [], [])
    for n, frame, layout in number_frames(container, stream, watch.name, look=watch.look, damage=damage):
        if n == 0:
            facts = facts_of(container, stream, frame)
            thumbs = ThumbnailWriter(thumb_dir, layout, facts.duration_s)
        if frame.is_corrupt:
            damage.patched.append(n)
        rows.pts.append(frame_pts(frame))
        rows.key.append(bool(frame.key_frame))
        rows.crc.append(luma_crc(frame))
        thumbs.offer(n, frame)
    if not rows.pts:
        raise BadInput("video-no-frame-readable", name=watch.name)
    if damage.other_size > OTHER_SIZE_SHARE * (len(rows.pts) + damage.other_size):
        raise BadInput("video-size-changes", name=watch.name)
    return facts, rows, thumbs


def _table(rows: _Rows, tick_s: float) -> FrameTable:
    pts = np.array(rows.pts, np.int64)
    stamped = pts != NO_PTS
    ordered = np.sort(pts) if stamped.all() else np.arange(len(pts))
    time_s = (ordered - ordered[0]) * tick_s
    return FrameTable(pts, time_s, np.array(rows.key, np.bool_), np.array(rows.crc, np.uint32))
