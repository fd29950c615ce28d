"""Proposals for the passes of a video: one decode, which keeps a few frames of each pass and of the road."""

from collections import deque
from collections.abc import Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from av import VideoFrame

from sightline.detection.background import SAMPLES, WINDOW_S
from sightline.detection.classify import FoundPass
from sightline.errors import Stopped
from sightline.geometry.road_pose import RoadPose
from sightline.media.cancelling import Cancelled, Progress, Watch
from sightline.media.networks import proposal_networks
from sightline.media.video.decode import number_frames, open_container, video_stream
from sightline.media.video.picture import Bgr, Gray, Layout, upright_gray, upright_picture
from sightline.proposals.frames import frame_seen, frames_to_look_at
from sightline.proposals.propose import Proposals, propose_points
from sightline.proposals.road import road_behind

NO_DIRECTION = "proposals-not-across"
ROAD_SAMPLES = SAMPLES // 2


@dataclass(eq=False)
class _Waiting:
    """A pass whose frames are being collected; `index` in the list that was given."""

    index: int
    found: FoundPass
    wanted: tuple[int, ...]
    pictures: dict[int, tuple[Bgr, Gray]] = field(default_factory=dict)


class _Collector:
    """Keeps the wanted frames of the passes, and frames of the road within WINDOW_S of those to come."""

    def __init__(self, passes: Sequence[FoundPass], pose: RoadPose, rate_hz: float) -> None:
        width = pose.camera.width_px
        self.waiting = [
            _Waiting(i, one, frames_to_look_at(one.boxes, one.best_frame, width))
            for i, one in enumerate(passes)
        ]
        self._pose, self._networks = pose, proposal_networks()
        self._ahead = WINDOW_S * rate_hz
        self._every = max(1, round(2 * WINDOW_S * rate_hz / ROAD_SAMPLES))
        self._road: deque[tuple[int, Gray]] = deque()

    def offer(self, n: int, frame: VideoFrame, layout: Layout) -> None:
        """Frame n: kept where a pass wants it, or as one of the road."""
        takers = [one for one in self.waiting if n in one.wanted]
        if not takers and n % self._every:
            return
        gray = upright_gray(frame, layout)
        if n % self._every == 0:
            self._road.append((n, gray))
        picture = upright_picture(frame, layout) if takers else None
        for one in takers:
            assert picture is not None
            one.pictures[n] = (picture, gray)

    def done(self, n: int | None) -> Iterator[tuple[int, Proposals | str]]:
        """Passes of which all is seen at frame n, or at the end (None)."""
        ready = [one for one in self.waiting if n is None or one.found.last_frame + self._ahead <= n]
        for one in ready:
            self.waiting.remove(one)
            yield one.index, self._proposed(one)
        first = min((one.found.first_frame for one in self.waiting), default=n or 0)
        while self._road and self._road[0][0] < min(first, n or 0) - self._ahead:
            self._road.popleft()

    def _proposed(self, waiting: _Waiting) -> Proposals | str:
        found_pass, ahead = waiting.found, self._ahead
        if found_pass.direction is None:
            return NO_DIRECTION
        span = found_pass.first_frame - ahead, found_pass.last_frame + ahead
        road = road_behind([gray for n, gray in self._road if span[0] <= n <= span[1]])
        if isinstance(road, str):
            return road
        seen = [
            frame_seen(n, picture, gray, road, found_pass.boxes)
            for n, (picture, gray) in sorted(waiting.pictures.items())
        ]
        return propose_points(self._networks, seen, self._pose, found_pass.direction, found_pass.best_frame)


def propose_in_video(
    path: Path,
    passes: Sequence[FoundPass],
    pose: RoadPose,
    *,
    rate_hz: float | None = None,
    on_progress: Progress = lambda _: None,
    is_cancelled: Cancelled = lambda: False,
    name: str | None = None,
    stream_number: int | None = None,
) -> Iterator[tuple[int, Proposals | str]]:
    """Index in `passes` and what is proposed of each, or the key of why nothing is, as the video goes on.

    Frames count as in its frame table. The road behind a pass is what its pixels show most of the time within
    WINDOW_S of it. Raises BadInput (not a video, or not of the pose's size), Stopped.
    """
    name = name or path.name
    with closing(open_container(path, name)) as container:
        stream = video_stream(container, name, 1, stream_number)
        collector = _Collector(passes, pose, rate_hz or float(stream.average_rate or 25))
        stopped = partial(Stopped, "video-proposals-cancelled")
        watch = Watch(on_progress, is_cancelled, name, path.stat().st_size, stopped)
        size_px = pose.camera.width_px, pose.camera.height_px
        for n, frame, layout in number_frames(container, stream, name, size_px, watch.look):
            collector.offer(n, frame, layout)
            yield from collector.done(n)
    yield from collector.done(None)
    on_progress(1.0)
