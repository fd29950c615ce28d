"""The report's first half: title, set-up, calibration and pose, method."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import UTC, datetime

import numpy as np

from sightline.export.report.blocks import Cell, Column, Document
from sightline.export.report.facts import (
    CalibrationFacts,
    LensParameter,
    PoseFacts,
    RecordingFacts,
    ReportFacts,
)
from sightline.export.report.units import HEIGHT, NONE, SMALL, Scale, count, fixed, plural
from sightline.export.report.words import LIGHTING, TARGETS, heading

_MODELS = {
    "brown": "Brown’s radial and tangential model",
    "fisheye": "equidistant fisheye (Kannala and Brandt)",
}
_SOURCES = {
    "images": "from pictures of a board",
    "clip": "from a clip of a board",
    "import": "imported from another tool’s file",
}
_MOST_VERSIONS = 6


def moment(at: datetime | None) -> str:
    """A moment in UTC to the second, in words where there is none."""
    return "an empty audit trail" if at is None else f"{at.astimezone(UTC):%Y-%m-%d %H:%M:%S} UTC"


def title(document: Document, facts: ReportFacts) -> None:
    """Survey, site, dates, counts."""
    document.blocks.append({"kind": "title"})
    document.words(*facts.description.split("\n\n"))
    counted = facts.statistics.counted
    document.pairs(
        [
            ("Measured", _days(facts)),
            *((heading(word), count(number)) for word, number in facts.counts),
            (
                "In this report",
                f"{plural(counted.measurements, 'measurement', 'measurements')} of "
                f"{plural(counted.vehicles, 'vehicle', 'vehicles')}, {count(counted.with_reference)} with a "
                f"reference height. {facts.filter_words}",
            ),
            ("State of", moment(facts.as_of)),
            ("Code", _versions(facts.code_versions)),
        ]
    )


def _days(facts: ReportFacts) -> str:
    if facts.first_day is None or facts.last_day is None:
        return "nothing yet"
    if facts.first_day == facts.last_day:
        return facts.first_day.isoformat()
    return f"{facts.first_day.isoformat()} to {facts.last_day.isoformat()}"


def _versions(versions: Sequence[str]) -> str:
    shown = [f"Sightline {one}" for one in versions[:_MOST_VERSIONS]]
    more = len(versions) - len(shown)
    return ", ".join(shown) + (f", and {more} more (see measurements.csv)" if more > 0 else "")


def setup(document: Document, facts: ReportFacts) -> None:
    """Photographs and recordings."""
    document.section("Set-up")
    if facts.photos:
        document.photos((one.caption, one.content) for one in facts.photos)
    else:
        document.words("No photograph of the set-up was given.")
    if not facts.recordings:
        document.words("There is no recording.")
        return
    document.table(
        "Recordings. The file’s SHA-256 stands in full in recordings.csv.",
        [
            Column("Recording", 1.5),
            Column("Camera", 1.0),
            Column("Lighting"),
            Column("Picture", align="right"),
            Column("Frames", align="right"),
            Column("Duration", align="right"),
            Column("SHA-256"),
        ],
        [_recording(one) for one in facts.recordings],
    )


def _recording(one: RecordingFacts) -> list[str]:
    size = NONE if one.width_px is None or one.height_px is None else f"{one.width_px} × {one.height_px}"
    return [
        one.name,
        one.camera or NONE,
        LIGHTING.get(one.lighting, one.lighting),
        size,
        NONE if one.frames is None else count(one.frames),
        NONE if one.duration_s is None else f"{fixed(one.duration_s, 1)}\u00a0s",
        f"{one.sha256[:12]}…" if one.sha256 else NONE,
    ]


def calibration(document: Document, facts: ReportFacts) -> None:
    """How well the lenses are known, and where the cameras stood."""
    document.section("Calibration and road pose")
    if not facts.calibrations:
        document.words("No measurement rests on a calibration yet.")
    for one in facts.calibrations:
        _lens(document, one)
    if not facts.poses:
        document.words("No measurement rests on a road pose yet.")
        return
    document.subsection("Road poses")
    _poses(document, facts)
    for pose in facts.poses:
        for warning in pose.warnings:
            document.warning(f"Pose {pose.number}: {warning}")


def _lens(document: Document, one: CalibrationFacts) -> None:
    document.subsection(f"{one.camera}, calibration {one.number}")
    residual = (
        "" if one.rms_px is None else f"{fixed(one.rms_px, 3)} px (root mean square of point distances)"
    )
    views = f"{count(one.views_used)} of {count(one.views_given)} used" if one.views_given else ""
    document.pairs(
        [
            ("Made", f"{one.made_on.isoformat()}, {_SOURCES.get(one.source, one.source)}"),
            ("Picture", f"{one.width_px} × {one.height_px} pixels"),
            ("Lens model", _MODELS.get(one.model, one.model)),
            ("Views", views),
            ("Residual", residual),
            (
                "Verdict",
                "can be trusted" if one.trusted else "is not to be trusted without a look at the warnings",
            ),
        ]
    )
    if one.parameters:
        known = any(parameter.u is not None for parameter in one.parameters)
        document.table(
            f"Lens of {one.camera}: parameters"
            + (" with their standard uncertainties." if known else "; their uncertainties are not known."),
            [Column("", 0.0), *(_parameter(parameter.name) for parameter in one.parameters)],
            [
                ["Value", *(_value(parameter) for parameter in one.parameters)],
                *([["u", *(_u(parameter) for parameter in one.parameters)]] if known else []),
            ],
        )
    for warning in one.warnings:
        document.warning(warning)


def _parameter(name: str) -> Column:
    return Column(name.removesuffix("_px"), 0.0, "right", "px" if name.endswith("_px") else "")


def _decimals(one: LensParameter) -> int:
    """Two figures of the uncertainty, or what suits the kind of parameter."""
    if one.u:
        return int(np.clip(1 - np.floor(np.log10(one.u)), 0, 7))
    return 2 if abs(one.value) >= 10 else 5


def _value(one: LensParameter) -> str:
    return fixed(one.value, _decimals(one))


def _u(one: LensParameter) -> str:
    return NONE if one.u is None else fixed(one.u, _decimals(one))


def _poses(document: Document, facts: ReportFacts) -> None:
    height, small = HEIGHT[facts.unit], SMALL[facts.unit]
    distances = sorted({one.distance_m for pose in facts.poses for one in pose.expected})
    document.table(
        "Road poses. “±”: expected half-width of the 95 % interval of a height of 1.2 m clicked to 1 px, "
        "by distance "
        "from the camera. Residual: root mean square over the board’s corners.",
        [
            Column("Pose", align="right"),
            Column("Recording", 1.3),
            Column("Camera", 0.8),
            Column("Board", 1.0),
            Column("Camera", 0.0, "right", f"{height.sign} above road"),
            Column("Board", 0.0, "right", f"{height.sign} away"),
            Column("Residual", 0.0, "right", "px"),
            *(Column(f"± at {_short(height, d)}", 0.0, "right", small.sign) for d in distances),
        ],
        [_pose(one, distances, height, small) for one in facts.poses],
    )
    alike: dict[str, list[str]] = {}
    for one in facts.poses:
        alike.setdefault(_board(one, small, height), []).append(str(one.number))
    for words, numbers in alike.items():
        if words:
            document.note(f"Pose{'s' if len(numbers) > 1 else ''} {', '.join(numbers)}: {words}")


def _pose(one: PoseFacts, distances: Sequence[float], height: Scale, small: Scale) -> list[Cell]:
    expected = {found.distance_m: found.U95_height_m for found in one.expected}
    return [
        str(one.number),
        (one.recording, f"frames {one.first_frame} to {one.last_frame}"),
        (one.camera, f"calibration {one.calibration}"),
        one.board or "none: it came from elsewhere",
        height.number(one.camera_height_m),
        height.number(one.distance_m),
        NONE if one.rms_px is None else fixed(one.rms_px, 3),
        *(small.number(expected.get(distance)) for distance in distances),
    ]


def _short(scale: Scale, distance_m: float) -> str:
    return f"{scale.factor * distance_m:.3g}\u00a0{scale.sign}"


def _board(one: PoseFacts, small: Scale, height: Scale) -> str:
    if one.reference_height_m is None:
        return ""
    words = f"reference row of corners {height.length(one.reference_height_m)} above the road"
    if one.u_reference_height_m is not None:
        words += f", u\u00a0=\u00a0{small.length(one.u_reference_height_m)}"
    if one.u_lean_rad is not None:
        words += (
            f"; the board’s lean and roll, u\u00a0=\u00a0{fixed(1000 * one.u_lean_rad, 1)}\u00a0mrad each"
        )
    return words + "."


def method(document: Document, facts: ReportFacts) -> None:
    """Equations, assumptions, insets."""
    document.section("Method")
    document.fixed("method")
    if facts.insets:
        small = SMALL[facts.unit]
        document.table(
            "Insets in force: how far behind the plane of the contact a target is taken to lie, and the "
            "standard "
            "uncertainty.",
            [
                Column("Target"),
                Column(f"Inset ({small.sign})", align="right"),
                Column(f"u ({small.sign})", align="right"),
                Column("Where it comes from", 1.0),
            ],
            [
                [
                    heading(TARGETS.get(one.target, one.target)),
                    small.number(one.inset_m),
                    small.number(one.u_inset_m),
                    one.note.replace("+-", "±") or NONE,
                ]
                for one in facts.insets
            ],
        )
