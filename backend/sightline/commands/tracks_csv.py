"""tracks.csv of `sightline height --tracks` (docs/formats.md): one vehicle, a followed point a row."""

import csv
import io
import math
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from sightline.commands.files import read_text
from sightline.errors import BadInput
from sightline.geometry.followed_tracks import POINT_NAMES, Tracks
from sightline.geometry.whole_pass import WholePass

NEEDED = ("frame", "time_s", "point", "x_px", "y_px")
_WHAT = f"a CSV table with the columns {', '.join(NEEDED)}"
_DEFAULT_SIGMA_PX = 1.0


def read_tracks(path: Path) -> Tracks:
    """The followed points of a tracks.csv. Raises BadInput, naming the row, where it cannot be read."""
    text = read_text(path, _WHAT)
    try:
        lines = [
            (number, [cell.strip() for cell in cells])
            for number, cells in enumerate(csv.reader(io.StringIO(text, newline=""), strict=True), 1)
            if any(cell.strip() for cell in cells)
        ]
    except csv.Error as error:
        raise BadInput("commands-not-readable-csv-table-give", path=path, problem=error, what=_WHAT) from None
    if not lines:
        raise BadInput("commands-empty-give", path=path, what=_WHAT)
    header = lines[0][1]
    missing = [name for name in NEEDED if name not in header]
    if missing:
        hint = "; separate its columns by commas" if ";" in header[0] else ""
        raise BadInput(
            "commands-no-column-give", path=path, missing=", ".join(missing), what=_WHAT, hint=hint
        )
    twice = sorted({name for name in header if header.count(name) > 1})
    if twice:
        raise BadInput("commands-column-more-once-name-each-column", path=path, twice=", ".join(twice))
    rows = [_numbers(path, number, header, cells) for number, cells in lines[1:]]
    table = np.array(rows, dtype=np.float64).reshape(-1, 7)
    return Tracks(
        frame=table[:, 0].astype(np.int64),
        time_s=table[:, 1],
        point=table[:, 2].astype(np.int64),
        points_px=table[:, 3:5],
        sigma_px=table[:, 5:7],
    )


def _numbers(path: Path, number: int, header: list[str], cells: list[str]) -> list[float]:
    """Frame, time, kind of point, x, y, sigma of x and of y of one row."""
    if len(cells) != len(header):
        raise BadInput("commands-row-cells", path=path, row=number, cells=len(cells), columns=len(header))
    by_name = dict(zip(header, cells, strict=True))
    if by_name["point"] not in POINT_NAMES:
        raise BadInput(
            "commands-tracks-point",
            path=path,
            row=number,
            point=by_name["point"],
            points=", ".join(POINT_NAMES),
        )
    frame = _number(path, number, by_name, "frame")
    if frame != round(frame) or abs(frame) > 2**53:
        raise BadInput("commands-tracks-frame", path=path, row=number)
    time_s, x, y = (_number(path, number, by_name, name) for name in ("time_s", "x_px", "y_px"))
    sigma = _number(path, number, by_name, "sigma_px") if by_name.get("sigma_px") else _DEFAULT_SIGMA_PX
    own = [
        _number(path, number, by_name, name) if by_name.get(name) else sigma
        for name in ("sigma_x_px", "sigma_y_px")
    ]
    return [frame, time_s, POINT_NAMES.index(by_name["point"]), x, y, *own]


def _number(path: Path, number: int, by_name: Mapping[str, str], name: str) -> float:
    try:
        value = float(by_name[name])
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise BadInput("commands-tracks-number", path=path, row=number, name=name)
    return value


COLUMNS = (*NEEDED, "sigma_x_px", "sigma_y_px")


def track_rows(tracks: Tracks) -> list[dict[str, Any]]:
    """The rows of a tracks.csv, by column."""
    sigma = np.broadcast_to(tracks.sigma_px.reshape(len(tracks.frame), -1), (len(tracks.frame), 2))
    return [
        dict(
            zip(
                COLUMNS,
                (int(n), float(t), POINT_NAMES[int(point)], *map(float, (*at, *own))),
                strict=True,
            )
        )
        for n, t, point, at, own in zip(
            tracks.frame, tracks.time_s, tracks.point, tracks.points_px, sigma, strict=True
        )
    ]


def pass_to_dict(found: WholePass) -> dict[str, Any]:
    """What `sightline height --tracks --json` prints beside the height."""
    out: dict[str, Any] = {"u_random_height_m": found.u_random_height_m}
    for name in ("inset_m", "heading_rad", "speed_mps", "wheelbase_m", "acceleration_mps2"):
        solved = getattr(found, name)
        key = "solved_inset_m" if name == "inset_m" else name
        out[key] = None if solved is None else solved.value
        out[f"u_{key}"] = None if solved is None else solved.u
    return out | {
        "frames": found.frames,
        "chi2": found.chi2,
        "freedom": found.freedom,
        "chance": found.chance,
        "dropped": [asdict(one) for one in found.dropped],
        "solved_for": list(found.solved_for),
        "covariance": [list(row) for row in found.covariance],
    }
