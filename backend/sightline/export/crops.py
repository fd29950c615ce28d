"""Crops of an export: the part of the picture that each measurement was clicked on, and where the points are.

The picture itself stays unmarked (JPEG from the decoded frame whose checksum is stored); the drawing that
names the points is an SVG of the same size beside it, which shows the picture when it is opened.
"""

from collections.abc import Iterator, Mapping, Sequence
from html import escape
from itertools import groupby
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sightline.errors import Away, Damaged, NoRoom, SightlineError
from sightline.infra.csv_package.columns import integer, key, number, text
from sightline.infra.csv_package.files import Staging, Tick
from sightline.infra.csv_package.files import number as figure_of
from sightline.infra.csv_package.schema import Cell, Column, Table, ids_of, sha256_hex
from sightline.infra.services import Services
from sightline.measurements.csv import TARGETS
from sightline.measurements.records import FurtherFrame, Measurement, MeasurementValues
from sightline.media.images import jpeg
from sightline.media.video.picture import Bgr
from sightline.messages import write_fixed
from sightline.recordings.frames.stills import stills_of

MARGIN_PX = 48
QUALITY = 92
_RECORD = np.dtype(
    [
        ("recording", "i8"),
        ("frame", "i8"),
        ("vehicle", "i8"),
        ("id", "i8"),
        ("k", "i4"),
        ("target", "u1"),
        ("crc", "i8"),
    ]
    + [(name, "f8") for name in ("contact_x", "contact_y", "target_x", "target_y", "height_m", "U95_m")]
)
Spots = NDArray[Any]


def _in_crop(name: str) -> tuple[Column, ...]:
    """Where a point lies in the crop."""
    return tuple(number(f"{name}_{axis}_px", f"column-crops-{name}-{axis}-px", "px") for axis in "xy")


CROPS = Table(
    "crops",
    "The part of each frame that a measurement was clicked on: crops/mN-K.jpg is frame K of measurement N, "
    "unmarked, crops/mN-K.svg shows it with its points. Measurements that were withdrawn have none, nor have "
    "those of vehicles that the package is not of (selection.csv).",
    (
        key("measurement_id", "measurement"),
        integer("k", "which of the measurement's frames, from 1", required=True, minimum=1),
        key("recording_id", "recording"),
        integer("frame", "frame number: the n-th decoded frame, from 0", required=True, minimum=0),
        text("file", "the crop in this package"),
        text("overlay", "the same with its points, as SVG"),
        text("sha256", "SHA-256 of the crop"),
        integer("x_px", "column of the frame in which the crop begins", unit="px"),
        integer("y_px", "row of the frame in which the crop begins", unit="px"),
        integer("width_px", "width of the crop", unit="px"),
        integer("height_px", "height of the crop", unit="px"),
        *_in_crop("contact"),
        *_in_crop("target"),
        text("reason", "why there is no crop"),
    ),
    primary=("measurement_id", "k"),
    foreign=(
        *ids_of(measurement_id="measurements"),
        (("recording_id", "frame"), "frames", ("recording_id", "frame")),
    ),
)


def spots_of(found: Sequence[Measurement]) -> Spots:
    """Where crops are to be taken: one record a frame of each measurement, compact (some 90 bytes)."""
    rows: list[tuple[Any, ...]] = []
    for measurement in found:
        values = measurement.values
        height, u95 = (np.nan if m is None else m for m in (values.height_m, values.U95_height_m))
        on_frames: tuple[MeasurementValues | FurtherFrame, ...] = (values, *values.more_frames)
        for k, on in enumerate(on_frames, start=1):
            place = (measurement.recording_id, on.frame, measurement.vehicle_id, measurement.id, k)
            on_what = (TARGETS.index(values.target), on.frame_crc32)
            rows.append((*place, *on_what, *on.contact, *on.target_point, height, u95))
    return np.array(rows, dtype=_RECORD)


def take_crops(staging: Staging, services: Services, spots: Spots, tick: Tick) -> int:
    """Write every crop and crops.csv, in the order of frames, so that each video is decoded once from its
    beginning to its end; how many crops there are. A frame that cannot be read gives a row with its reason.
    """
    ordered = np.sort(spots, order=["recording", "frame", "id", "k"])
    taken = done = 0
    with staging.table(CROPS) as table:
        for (recording, frame), group in groupby(ordered, key=lambda one: (one["recording"], one["frame"])):
            here = list(group)
            picture = _picture(services, int(recording), int(frame), int(here[0]["crc"]))
            for spot in here:
                table.add(_crop(staging, spot, picture))
            done += len(here)
            taken += 0 if isinstance(picture, str) else len(here)
            tick(done / len(ordered))
    return taken


def _picture(services: Services, recording_id: int, frame: int, crc: int) -> Bgr | str:
    """The frame that was clicked on, or the sentence that says why it cannot be shown."""
    try:
        opened = stills_of(services).open(recording_id)
        if not frame < len(opened.media) or int(opened.media.crc[frame]) != crc:
            raise Damaged("export-frame-not-clicked", frame=frame)
        return services.frames.bgr(opened.media, frame)
    except (Away, NoRoom):
        raise  # no fact of the frame: the same export has it another time
    except SightlineError as error:
        return error.message


def _crop(staging: Staging, spot: Any, picture: Bgr | str) -> dict[str, Cell]:
    stem = f"crops/m{spot['id']}-{spot['k']}"
    place: dict[str, Cell] = {
        "measurement_id": int(spot["id"]),
        "k": int(spot["k"]),
        "recording_id": int(spot["recording"]),
        "frame": int(spot["frame"]),
    }
    if isinstance(picture, str):
        return {**place, "reason": picture}
    x, y, right, bottom = _rectangle(spot, picture.shape[1], picture.shape[0])
    content = jpeg(picture[y:bottom, x:right], QUALITY)
    row = {
        **place,
        "file": f"{stem}.jpg",
        "overlay": f"{stem}.svg",
        "sha256": sha256_hex(content),
        "x_px": x,
        "y_px": y,
        "width_px": right - x,
        "height_px": bottom - y,
        **points_in(spot, x, y),
    }
    staging.add(f"{stem}.jpg", content)
    target, heights = TARGETS[spot["target"]], (float(spot["height_m"]), float(spot["U95_m"]))
    # to the micrometre, as in the tables: so that the label can be made again from them
    label = label_of(target, *(None if np.isnan(one) else round(one, 6) for one in heights))
    staging.add(f"{stem}.svg", overlay(row, label))
    return row


def points_in(spot: Any, x: int, y: int) -> dict[str, Cell]:
    """The two points of a spot within a crop that begins at (x, y)."""
    return {
        f"{word}_{axis}_px": float(spot[f"{word}_{axis}"]) - start
        for word in ("contact", "target")
        for axis, start in (("x", x), ("y", y))
    }


def _rectangle(spot: Any, width_px: int, height_px: int) -> tuple[int, int, int, int]:
    """(left, top, right, bottom), the last two beyond the end: both points and a margin, within the frame."""
    bounds: list[int] = []
    for axis, size in (("x", width_px), ("y", height_px)):
        ends = sorted(
            min(max(float(spot[f"{word}_{axis}"]), 0.0), size - 1.0) for word in ("contact", "target")
        )
        low = max(0, int(np.floor(ends[0])) - MARGIN_PX)
        bounds += [low, min(size, int(np.ceil(ends[1])) + MARGIN_PX + 1)]
    return bounds[0], bounds[2], bounds[1], bounds[3]


def label_of(target: str, height_m: float | None, U95_m: float | None) -> str:
    """What is written beside the target: "driver's eye 1.172 ± 0.018 m"."""
    word = {"driver_eye": "driver's eye"}.get(target, target)
    if height_m is None:
        return f"{word}, no height"
    height = write_fixed(height_m, 3)
    return f"{word} {height} m" if U95_m is None else f"{word} {height} ± {write_fixed(U95_m, 3)} m"


def overlay(row: Mapping[str, Any], label: str) -> bytes:
    """The SVG over a crop, from the crop's row: rings round both points, joined, with what they are."""
    (cx, cy), (tx, ty) = (
        (float(row[f"{word}_x_px"]) + 0.5, float(row[f"{word}_y_px"]) + 0.5) for word in ("contact", "target")
    )
    width, height = int(row["width_px"]), int(row["height_px"])
    name = str(row["file"]).rpartition("/")[2]
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
        f'viewBox="0 0 {width} {height}">',
        f"<title>measurement {row['measurement_id']}, frame {row['frame']}: {escape(label)}</title>",
        f'<image href="{escape(name)}" width="{width}" height="{height}"/>',
    ]
    shapes = (
        f'<path d="M{cx:.2f} {cy:.2f}L{tx:.2f} {ty:.2f}" stroke-dasharray="4 3"/>'
        f'<circle cx="{cx:.2f}" cy="{cy:.2f}" r="5"/><path d="M{cx - 9:.2f} {cy:.2f}h18"/>'
        f'<circle cx="{tx:.2f}" cy="{ty:.2f}" r="5"/><path d="M{tx:.2f} {ty - 9:.2f}v18"/>'
    )
    for colour, thick in (("#000", 3), ("#fff", 1)):
        parts.append(f'<g fill="none" stroke="{colour}" stroke-width="{thick}">{shapes}</g>')
    words = (*_draw_text("tyre contact", cx, cy, width, height), *_draw_text(label, tx, ty, width, height))
    style = 'font-family="sans-serif" font-size="11" fill="#fff" stroke="#000" stroke-width="3"'
    parts.append(f'<g {style} paint-order="stroke">{"".join(words)}</g>')
    return ("\n".join(parts) + "\n</svg>\n").encode()


def _draw_text(text: str, x: float, y: float, width: int, height: int) -> Iterator[str]:
    """The text beside a point, on the side where there is room."""
    left = x > width / 2
    at, anchor = (x - 10, "end") if left else (x + 10, "start")
    below = min(max(y + 4, 12), height - 4)
    yield f'<text x="{at:.2f}" y="{below:.2f}" text-anchor="{anchor}">{escape(text)}</text>'


def expected_overlay(row: Mapping[str, str], measured: Mapping[str, str]) -> bytes:
    """The SVG that a row of crops.csv and one of measurements.csv give, to be compared with the one there."""
    label = label_of(measured["target"], figure_of(measured["height_m"]), figure_of(measured["U95_height_m"]))
    return overlay(row, label)
