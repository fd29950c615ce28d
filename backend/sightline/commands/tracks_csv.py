"""tracks.csv of `sightline height --tracks` (docs/formats.md): one vehicle, a followed point a row."""

from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from sightline.commands.files import read_csv
from sightline.errors import BadInput
from sightline.geometry.followed_tracks import POINT_NAMES, Tracks
from sightline.geometry.whole_pass import WholePass
from sightline.infra.given_csv import GivenTable

NEEDED = ("frame", "time_s", "point", "x_px", "y_px")
_DEFAULT_SIGMA_PX = 1.0


def read_tracks(path: Path) -> Tracks:
    """The followed points of a tracks.csv. Raises BadInput, naming the row, where it cannot be read."""
    given = read_csv(path, NEEDED)
    rows = [_numbers(path, given, line, cells) for line, cells in given.sound_rows()]
    table = np.array(rows, dtype=np.float64).reshape(-1, 7)
    return Tracks(
        frame=table[:, 0].astype(np.int64),
        time_s=table[:, 1],
        point=table[:, 2].astype(np.int64),
        points_px=table[:, 3:5],
        sigma_px=table[:, 5:7],
    )


def _numbers(path: Path, given: GivenTable, number: int, by_name: Mapping[str, str]) -> list[float]:
    """Frame, time, kind of point, x, y, sigma of x and of y of one row."""
    if by_name["point"] not in POINT_NAMES:
        raise BadInput(
            "commands-tracks-point",
            path=path,
            row=number,
            point=by_name["point"],
            points=", ".join(POINT_NAMES),
        )
    frame = given.number(number, "frame", by_name["frame"])
    if frame != round(frame) or abs(frame) > 2**53:
        raise BadInput("commands-tracks-frame", path=path, row=number)
    time_s, x, y = (given.number(number, name, by_name[name]) for name in ("time_s", "x_px", "y_px"))
    sigma = (
        given.number(number, "sigma_px", by_name["sigma_px"])
        if by_name.get("sigma_px")
        else _DEFAULT_SIGMA_PX
    )
    own = [
        given.number(number, name, by_name[name]) if by_name.get(name) else sigma
        for name in ("sigma_x_px", "sigma_y_px")
    ]
    return [frame, time_s, POINT_NAMES.index(by_name["point"]), x, y, *own]


COLUMNS = (*NEEDED, "sigma_x_px", "sigma_y_px")


def track_rows(tracks: Tracks) -> list[dict[str, Any]]:
    """The rows of a tracks.csv, by column."""
    sigma = np.broadcast_to(tracks.sigma_px.reshape(len(tracks.frame), -1), (len(tracks.frame), 2))
    return [
        dict(zip(COLUMNS, (int(n), float(t), POINT_NAMES[int(point)], *map(float, (*at, *own))), strict=True))
        for n, t, point, at, own in zip(
            tracks.frame, tracks.time_s, tracks.point, tracks.points_px, sigma, strict=True
        )
    ]


def pass_to_dict(whole_pass: WholePass) -> dict[str, Any]:
    """What `sightline height --tracks --json` prints beside the height."""
    out: dict[str, Any] = {"u_random_height_m": whole_pass.u_random_height_m}
    for name in ("inset_m", "heading_rad", "speed_mps", "wheelbase_m", "acceleration_mps2"):
        solved = getattr(whole_pass, name)
        key = "solved_inset_m" if name == "inset_m" else name
        out[key] = None if solved is None else solved.value
        out[f"u_{key}"] = None if solved is None else solved.u
    return out | {
        "frames": whole_pass.frames,
        "chi2": whole_pass.chi2,
        "freedom": whole_pass.freedom,
        "chance": whole_pass.chance,
        "dropped": [{**asdict(one), "reason": str(one.reason)} for one in whole_pass.dropped],
        "solved_for": list(whole_pass.solved_for),
        "covariance": [list(row) for row in whole_pass.covariance],
    }
