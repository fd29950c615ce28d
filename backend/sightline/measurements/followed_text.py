"""A followed pass as the text that a measurement keeps: its points and how their errors hang together."""

import json
import math
from typing import Any

import numpy as np

from sightline.errors import Damaged
from sightline.geometry.followed_tracks import POINT_NAMES, Following, Tracks
from sightline.infra.audit.hashing import canonical_json

_DECIMALS = 4  # of a pixel
_OF_FOLLOWING = ("confirmed_px", "view_px", "u_depth_share", "u_time_s")
_LATER = {"u_time_s": 0.0}  # what texts of earlier versions lack


def text_of(tracks: Tracks, following: Following) -> str:
    """RFC 8785 JSON: `begun_on`, `confirmed_px`, `view_px`, `u_depth_share`, `u_time_s`, `matched` and
    `points`, a list of frame, time (s), point, x, y and the standard uncertainty of both (px).
    """
    sigma = np.broadcast_to(tracks.sigma_px.reshape(len(tracks.frame), -1), (len(tracks.frame), 2))
    points = [
        [
            int(n),
            float(t),
            POINT_NAMES[int(point)],
            *(round(float(v), _DECIMALS) for v in at),
            *(max(round(float(v), _DECIMALS), 10.0**-_DECIMALS) for v in own),
        ]
        for n, t, point, at, own in zip(
            tracks.frame, tracks.time_s, tracks.point, tracks.points_px, sigma, strict=True
        )
    ]
    said = {name: getattr(following, name) for name in _OF_FOLLOWING}
    said |= {"begun_on": following.begun_on, "matched": following.matched}
    return canonical_json({**said, "points": points})


def read_text(text: str) -> tuple[Tracks, Following]:
    """What `text_of` wrote. Raises Damaged for another text."""
    try:
        document: dict[str, Any] = {**_LATER, **json.loads(text)}
        rows = document["points"]
        table = np.array([[row[0], row[1], *row[3:7]] for row in rows], dtype=np.float64).reshape(-1, 6)
        following = Following(
            **{name: float(document[name]) for name in _OF_FOLLOWING},
            begun_on=int(document["begun_on"]),
            matched=bool(document["matched"]),
        )
        point = np.array([POINT_NAMES.index(row[2]) for row in rows], dtype=np.int64)
    except (KeyError, IndexError, TypeError, ValueError) as error:
        raise Damaged("measurements-followed-not-readable") from error
    if not np.isfinite(table).all() or not math.isfinite(following.confirmed_px):
        raise Damaged("measurements-followed-not-readable")
    tracks = Tracks(
        frame=table[:, 0].astype(np.int64),
        time_s=table[:, 1],
        point=point,
        points_px=table[:, 2:4],
        sigma_px=table[:, 4:6],
    )
    return tracks, following


def frames_of_text(text: str) -> int:
    """On how many frames something was followed."""
    return len(np.unique(read_text(text)[0].frame))
