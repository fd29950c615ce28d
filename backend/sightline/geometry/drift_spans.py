"""Motions over a recording: where the camera stood still, where it was bumped, and by how much.

"Moved" is what lies beyond the floor, four standard uncertainties of the motion and never less than 0.05 px.
A change from one look to the next is a bump; it is confirmed on a second frame and located by halving.
A change that no two neighbouring looks show is a creep; its looks are judged one by one, smoothed.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from sightline.arrays import Floats
from sightline.geometry.drift import Motion, displacement_px, motion_of
from sightline.messages.said import Said

LEAST_PX = 0.05
COVER = 4.0
_SMOOTH = 2
Size = tuple[int, int]
LookAt = Callable[[int], Motion | Said]


@dataclass(frozen=True)
class Look:
    """What one frame told: a motion, or why it told none."""

    frame: int
    motion: Motion | Said


@dataclass(frozen=True)
class Bump:
    """The picture jumped by `by_px` after frame `after`, at the latest on frame `frame`."""

    after: int
    frame: int
    by_px: float


@dataclass(frozen=True)
class Span:
    """Frames on which the camera stood in one place; `motion` is their mean, beyond the floor if `moved`."""

    first_frame: int
    last_frame: int
    moved: bool
    motion: Motion


@dataclass(frozen=True)
class Course:
    """The whole recording. `floor_px`: what could have been told. `spans` is empty where nothing could."""

    floor_px: float | None
    bumps: tuple[Bump, ...]
    spans: tuple[Span, ...]
    reason: Said | None


def floor_px(u_px: float) -> float:
    """How far a picture must have moved to be told from one that did not."""
    return max(LEAST_PX, COVER * u_px)


def course(looks: Sequence[Look], last_frame: int, size_px: Size, look_at: LookAt) -> Course:
    """Bumps and spans from looks in the order of their frames; `look_at` answers for single frames between.

    last_frame: the recording's last frame. Where fewer than two looks told a motion there is only a reason.
    """
    motions = [(look.frame, look.motion) for look in looks if isinstance(look.motion, Motion)]
    motions = _confirmed(motions, size_px, look_at)
    if len(motions) < 2:
        reasons = [look.motion for look in looks if isinstance(look.motion, Said)]
        return Course(None, (), (), max(reasons, key=reasons.count) if reasons else Said("drift-no-frame"))
    floor = floor_px(float(np.median([motion.u_px for _, motion in motions])))
    bumps = [
        _located(before, after, size_px, look_at)
        for before, after in pairwise(motions)
        if _differ(before[1], after[1], size_px)
    ]
    # frames that tell nothing beside a bump count as moved: their heights may be off
    cuts = [-1, *(_cut(bump, motions, floor) for bump in bumps), last_frame]
    spans: list[Span] = []
    for first, last in pairwise(cuts):
        own = [one for one in motions if first < one[0] <= last]
        spans += _spans_of(own, first + 1, last, floor, size_px)
    return Course(floor, tuple(bumps), tuple(_join_spans(spans, size_px)), None)


def _cut(bump: Bump, told: list[tuple[int, Motion]], floor: float) -> int:
    """The last frame before a bump's later span."""
    later = next(motion for frame, motion in told if frame >= bump.frame)
    return bump.after if later.moved_px > floor else bump.frame - 1


def _parameters(motion: Motion) -> Floats:
    return np.array([motion.x_px, motion.y_px, motion.scale - 1.0, motion.turn_rad])


def _difference_px(one: Motion, other: Motion, size_px: Size) -> float:
    return displacement_px(_parameters(one) - _parameters(other), size_px)


def _differ(one: Motion, other: Motion, size_px: Size) -> bool:
    return _difference_px(one, other, size_px) > floor_px(float(np.hypot(one.u_px, other.u_px)))


def _confirmed(motions: list[tuple[int, Motion]], size_px: Size, look_at: LookAt) -> list[tuple[int, Motion]]:
    """Without looks that jump away and whose next frames do not: something else moved before the camera."""
    kept: list[tuple[int, Motion]] = []
    for index, (frame, motion) in enumerate(motions):
        before = kept[-1][1] if kept else None
        stays = index + 1 < len(motions) and not _differ(motion, motions[index + 1][1], size_px)
        if before is None or stays or not _differ(before, motion, size_px):
            kept.append((frame, motion))
            continue
        near = [one for n in (frame + 1, frame - 1, frame + 3) if isinstance(one := look_at(n), Motion)]
        votes = sum(
            _difference_px(one, motion, size_px) < _difference_px(one, before, size_px) for one in near
        )
        if near and 2 * votes > len(near):
            kept.append((frame, motion))
    return kept


def _located(before: tuple[int, Motion], after: tuple[int, Motion], size_px: Size, look_at: LookAt) -> Bump:
    """Halve between two looks that differ; frames that tell nothing leave the bump between its neighbours."""
    low, high = before[0], after[0]
    while high - low > 1:
        middle = (low + high) // 2
        found = _nearest_told(middle, low, high, look_at)
        if found is None:
            break
        n, motion = found
        if _difference_px(motion, before[1], size_px) < _difference_px(motion, after[1], size_px):
            low = n
        else:
            high = n
    return Bump(low, high, _difference_px(before[1], after[1], size_px))


def _nearest_told(middle: int, low: int, high: int, look_at: LookAt) -> tuple[int, Motion] | None:
    """A frame strictly between `low` and `high` that tells a motion, the one nearest to `middle`."""
    for step in range(min(high - low, 16)):
        for n in {middle + step, middle - step}:
            if low < n < high and isinstance(motion := look_at(n), Motion):
                return n, motion
    return None


def _mean(motions: Sequence[Motion], size_px: Size) -> Motion:
    mean = np.mean([_parameters(one) for one in motions], axis=0)
    u_px = float(np.median([one.u_px for one in motions])) / float(np.sqrt(len(motions)))
    return motion_of(mean, size_px, u_px, int(np.median([one.points for one in motions])))


def _spans_of(
    own: list[tuple[int, Motion]], first: int, last: int, floor: float, size_px: Size
) -> list[Span]:
    """One span where the camera stood still between two bumps; several where it crept."""
    if not own:
        return []
    motions = [motion for _, motion in own]
    smooth = [_mean(motions[max(0, i - _SMOOTH) : i + _SMOOTH + 1], size_px) for i in range(len(motions))]
    if max(_difference_px(smooth[0], one, size_px) for one in smooth) <= floor:
        mean = _mean(motions, size_px)
        return [Span(first, last, mean.moved_px > floor, mean)]
    frames = [first, *(frame for frame, _ in own[1:]), last + 1]
    return [
        Span(begin, end - 1, one.moved_px > floor, one)
        for begin, end, one in zip(frames, frames[1:], smooth, strict=False)
        if end > begin
    ]


def _join_spans(spans: Sequence[Span], size_px: Size) -> list[Span]:
    """Neighbours of one state become one; frames between spans go to the one that moved."""
    out: list[Span] = []
    for span in spans:
        if out and out[-1].moved == span.moved and (not span.moved or _creeps(out[-1], span, size_px)):
            farther = max(out[-1].motion, span.motion, key=lambda one: one.moved_px)
            out[-1] = Span(out[-1].first_frame, span.last_frame, span.moved, farther)
        else:
            out.append(span)
    return out


def _creeps(one: Span, two: Span, size_px: Size) -> bool:
    """Whether two moved spans differ by so little that they are told as one."""
    return _difference_px(one.motion, two.motion, size_px) < 0.5 * min(
        one.motion.moved_px, two.motion.moved_px
    )
