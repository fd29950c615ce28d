"""Trains, and whatever else fills the picture for seconds: there is no road left to tell its parts from.

On each picture the columns are counted in which something goes one way, by optical flow alone. Where nearly
all of them do for longer than a lorry takes, one vehicle goes by, and what was found of it in pieces is
that vehicle. Between the vehicles of a queue there is road in some columns.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from sightline.detection.background import Small
from sightline.detection.classify import FoundPass, View
from sightline.detection.flow import LEAST_STEP_PX, Flow
from sightline.enums import Direction

FULL_SHARE = 0.88  # of the columns
HIGH_SHARE = 0.2  # of a column
LONGEST_LORRY_S = 1.8
PAUSE_S = 0.4
ONE_WAY_SHARE = 0.8
INSIDE_SHARE = 0.6
TOUCH = 3  # frames
LEAST_CHANGE = 6
NEAR_PX = 7
SCORE = 0.8


@dataclass(frozen=True)
class FullSpan:
    """Frames on which something goes one way in all of the picture: 1 right, -1 left, as the finder sees."""

    first: int
    last: int
    way: int


class FullPicture:
    """Feed it the flow of each picture in which something moves."""

    def __init__(self, rate_hz: float) -> None:
        self._pause = max(2, round(PAUSE_S * rate_hz))
        self._long = max(4, round(LONGEST_LORRY_S * rate_hz))
        self._ways: list[tuple[int, int]] = []

    def see(self, n: int, flow: Flow, small: Small, before: Small) -> None:
        """Frame n: `flow` (h, w, 2), pixels since the picture `before` (h, w); `small` (h, w) is this one.

        Flow spreads over a plain road, so it counts only near a pixel that changed.
        """
        changed = np.where(cv2.absdiff(small, before) > LEAST_CHANGE, np.uint8(1), np.uint8(0))
        near = cv2.dilate(changed, np.ones((NEAR_PX, NEAR_PX), np.uint8)) > 0
        high = HIGH_SHARE * len(flow)
        for way in (1, -1):
            moving: NDArray[np.intp] = (near & (way * flow[..., 0] > LEAST_STEP_PX)).sum(axis=0)
            if (moving >= high).mean() >= FULL_SHARE:
                self._ways.append((n, way))
                return

    def spans(self) -> list[FullSpan]:
        """The spans that are too long for a lorry."""
        if not self._ways:
            return []
        frames, ways = np.array(self._ways).T
        out = []
        for run in np.split(np.arange(len(frames)), np.flatnonzero(np.diff(frames) > self._pause) + 1):
            mean = float(ways[run].mean())
            first, last = int(frames[run[0]]), int(frames[run[-1]])
            if last - first >= self._long and abs(mean) >= 2 * ONE_WAY_SHARE - 1:
                out.append(FullSpan(first, last, 1 if mean > 0 else -1))
        return out


def join_long_vehicles(passes: Sequence[FoundPass], spans: Sequence[FullSpan], view: View) -> list[FoundPass]:
    """The passes with those that lie in a full span made one vehicle, which need not have been found at all.

    Own method: INSIDE_SHARE of a piece lies in the span, or it goes the same way and was seen with it: the
    front before the picture was full, the end after.
    """
    left = list(passes)
    out = []
    for span in spans:
        way = _direction(span, view)
        pieces = [one for one in left if _is_piece(one, span, way)]
        left = [one for one in left if one not in pieces]
        out.append(_join_pieces(pieces, span, view))
    return [*left, *out]


def _is_piece(piece: FoundPass, span: FullSpan, way: Direction | None) -> bool:
    shared = min(piece.last_frame, span.last) - max(piece.first_frame, span.first) + 1
    if shared >= INSIDE_SHARE * (piece.last_frame - piece.first_frame + 1):
        return True
    return shared >= TOUCH and way is not None and piece.direction == way


def _direction(span: FullSpan, view: View) -> Direction | None:
    return None if view.turned else ("right" if span.way > 0 else "left")


def _join_pieces(pieces: Sequence[FoundPass], span: FullSpan, view: View) -> FoundPass:
    """One pass over the span and its pieces; nowhere is all of it in view."""
    middle = (span.first + span.last) // 2
    w, h = view.width * view.scale, view.height * view.scale
    box = (middle, 0.0, 0.0, h, w) if view.turned else (middle, 0.0, 0.0, w, h)
    whole_pass = FoundPass(
        first_frame=min([span.first, *(one.first_frame for one in pieces)]),
        last_frame=max([span.last, *(one.last_frame for one in pieces)]),
        best_frame=middle,
        direction=_direction(span, view),
        whole=False,
        score=SCORE,
        sharpness=0.0,
        luminance=0.0,
        boxes=(box,),
    )
    if not pieces:
        return whole_pass
    largest = max(pieces, key=lambda one: one.last_frame - one.first_frame)
    return replace(whole_pass, sharpness=largest.sharpness, luminance=largest.luminance)
