"""What a camera that moved since its road pose does to a height, at the height's own clicks."""

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.geometry.height import measure_heights
from sightline.geometry.road_pose import RoadPose
from sightline.measurements.followed_text import read_text, text_of
from sightline.measurements.height_of_clicks import measured_frames, measured_pass
from sightline.measurements.records import ClickedFrame, Clicks
from sightline.messages.said import Said
from sightline.recordings.drift import MovedSpan

_MOST_KEPT = 4096


def drift_flags(pose: RoadPose, every: Sequence[Clicks], spans: Sequence[MovedSpan]) -> list[Said | None]:
    """What is said of each height where the camera had moved on a frame clicked on; None where it stood."""
    there = [at for at, one in enumerate(every) if spans_clicked_on(one, spans)]
    errors = errors_of_motion(pose, [every[at] for at in there], spans)
    flags: list[Said | None] = [None] * len(every)
    for at, error_m in zip(there, errors, strict=True):
        flags[at] = drift_flag(every[at], spans, error_m)
    return flags


def drift_flag(clicks: Clicks, spans: Sequence[MovedSpan], error_m: float | None) -> Said:
    """What is said of a height clicked on a moved frame; `error_m`: what `errors_of_motion` gives, metres."""
    moved_px = round(max(one.moved_px for one in spans_clicked_on(clicks, spans)), 1)
    if error_m is None:
        return Said("height-flag-camera-moved", moved_px=moved_px)
    return Said("height-flag-camera-moved-height", moved_px=moved_px, error_m=round(abs(error_m), 3))


def earlier_drift_flag(clicks: Clicks, spans: Sequence[MovedSpan]) -> Said | None:
    """What an earlier version said: the error on the nearest road in view, of checks that told no motion."""
    worst = max(spans_clicked_on(clicks, spans), key=lambda one: one.moved_px)
    if worst.change_m is None or worst.motion is not None:
        return None
    moved_px, error_m = round(worst.moved_px, 1), round(abs(worst.change_m), 3)
    return Said("height-flag-camera-moved-by", moved_px=moved_px, error_m=error_m)


def spans_clicked_on(clicks: Clicks, spans: Sequence[MovedSpan]) -> list[MovedSpan]:
    """Those that hold a frame clicked on."""
    return [one for one in spans if any(one.first_frame <= n <= one.last_frame for n in clicks.frames)]


def errors_of_motion(
    pose: RoadPose, every: Sequence[Clicks], spans: Sequence[MovedSpan]
) -> list[float | None]:
    """How much too large each height is by the camera's motions in `spans`, metres: that of the clicks as
    they are less that of the clicks with the motion undone. None where there is none, or a motion is not
    told.
    """
    errors: list[float | None] = [None] * len(every)
    if any(one.motion is None for one in spans):
        return errors
    size_px = (pose.camera.width_px, pose.camera.height_px)
    of_two = [at for at, one in enumerate(every) if not one.solves_inset and one.inset_m is not None]
    moved = [every[at] for at in of_two]
    both = [*moved, *(_undone(one, spans, size_px) for one in moved)]
    contacts, targets = [one.contact for one in both], [one.target_point for one in both]
    insets_m = [one.assumed()[1] for one in both]
    found = measure_heights(pose, contacts, targets, inset_m=insets_m, with_uncertainty=False)
    change_m = np.where(found.ok, found.height_m, np.nan).reshape(2, -1)
    for at, error_m in zip(of_two, (change_m[0] - change_m[1]).tolist(), strict=True):
        errors[at] = error_m if math.isfinite(error_m) else None
    for at, one in enumerate(every):
        if one.solves_inset:
            errors[at] = _solved_error_m(pose, one, tuple(spans))
    return errors


@lru_cache(_MOST_KEPT)
def _solved_error_m(pose: RoadPose, clicks: Clicks, spans: tuple[MovedSpan, ...]) -> float | None:
    """A whole pass takes long to solve and never changes: kept."""
    back = _undone(clicks, spans, (pose.camera.width_px, pose.camera.height_px))
    moved_m, back_m = _solved_m(pose, clicks), _solved_m(pose, back)
    return None if moved_m is None or back_m is None else moved_m - back_m


def _solved_m(pose: RoadPose, clicks: Clicks) -> float | None:
    if clicks.followed is None:
        return measured_frames(pose, clicks).height.height_m
    return measured_pass(pose, clicks).height.height_m


def _undone(clicks: Clicks, spans: Sequence[MovedSpan], size_px: tuple[int, int]) -> Clicks:
    """The clicks, and what was followed from them, where they lay in the pose's picture."""

    def back(frame: NDArray[np.int64], points_px: Floats) -> Floats:
        out = np.array(points_px)
        for span in spans:
            on = (frame >= span.first_frame) & (frame <= span.last_frame)
            if span.motion is not None and on.any():
                out[on] = span.motion.undo(points_px[on], size_px)
        return out

    clicked = np.array([*clicks.contacts, *clicks.target_points], dtype=np.float64)
    places = back(np.array(clicks.frames * 2), clicked).reshape(2, -1, 2).tolist()
    first, *more = (
        ClickedFrame(frame=n, contact=(x, y), target_point=(u, v))
        for n, (x, y), (u, v) in zip(clicks.frames, *places, strict=True)
    )
    followed = clicks.followed
    if followed is not None:
        tracks, following = read_text(followed)
        followed = text_of(replace(tracks, points_px=back(tracks.frame, tracks.points_px)), following)
    return replace(
        clicks,
        contact=first.contact,
        target_point=first.target_point,
        more_frames=tuple(more),
        followed=followed,
    )
