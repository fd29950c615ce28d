"""Between the line-scan room and the store: a motion as stored values and back, gaps of stored vehicles."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, fields, replace
from typing import Any

from sightline.enums import Cause, JsonObject
from sightline.infra.version import code_version
from sightline.linescan.gaps import NONE_BEFORE, gaps
from sightline.linescan.parts import Crossings, Entry, Gap, Motion, Rig
from sightline.linescan.rig import rig_from, wheelbase
from sightline.messages.said import Said
from sightline.scans.records import ScanMeasurement, ScanValues
from sightline.scans.store import rig_for

_NUMBERS = tuple(one.name for one in fields(Motion) if one.type == float | None)
_AS_STORED = ("method", "status", "reason", "lane", "lane_by", "u_boundaries_m")
_LINES = tuple(one.name for one in fields(Crossings))
_OF_MOTION = (*_AS_STORED, *_NUMBERS, *_LINES, "budget")
_WHEELS = ("front_wheel_line", "rear_wheel_line", "wheelbase_m", "u_wheelbase_m")
_NO_WHEELS: dict[str, Any] = dict.fromkeys(_WHEELS)


def values_of(
    motion: Motion, rig: Rig, cause: Cause, *, placed_by: int | None = None, run_id: int | None = None
) -> ScanValues:
    """A motion as it is stored, with the scan's rig as it is at its lane; no wheels yet."""
    return values_told(measured_of(motion), rig, cause, placed_by=placed_by, run_id=run_id)


def measured_of(motion: Motion) -> JsonObject:
    """What was measured, by name, as a stream sends it too: all else of a revision follows from it."""
    told: JsonObject = {name: float(line) for name, line in asdict(motion.crossings).items()}
    told |= {name: _number(getattr(motion, name)) for name in _NUMBERS}
    return told | {
        "method": motion.method,
        "axle_lines": None if motion.axle_lines is None else [float(line) for line in motion.axle_lines],
        "lane": motion.lane,
        "lane_by": motion.lane_by,
        "u_boundaries_m": float(motion.u_boundaries_m),
        "status": motion.status,
        "reason": motion.reason,
        "budget": [asdict(entry) for entry in motion.budget],
        "profile": _profile(motion),
        "warnings": list(motion.warnings),
        "code_version": code_version(),
    }


def values_told(
    told: Mapping[str, Any],
    rig: Rig,
    cause: Cause,
    *,
    placed_by: int | None = None,
    run_id: int | None = None,
) -> ScanValues:
    """What `measured_of` told as it is stored."""
    direction = Crossings(*(told[name] for name in _LINES)).direction
    return ScanValues(
        cause=cause,
        placed_by=placed_by,
        run_id=run_id,
        rig=rig_for(rig, told["lane"], direction),
        direction=direction,
        **_NO_WHEELS,
        axles_by=None if told["axle_lines"] is None else "machine",
        **told,
    )


def motion_of(values: ScanValues) -> Motion:
    """A stored revision as a motion again, without its profile."""
    return motion_told({name: getattr(values, name) for name in _OF_MOTION})


def motion_told(stored: Mapping[str, Any]) -> Motion:
    """The same of what is told of a revision by name; what is not told is None."""
    return Motion(
        crossings=Crossings(*(stored[name] for name in _LINES)),
        budget=tuple(Entry(**entry) for entry in stored.get("budget", ())),
        **{name: stored[name] for name in (*_AS_STORED, *_NUMBERS) if name in stored},
    )


def crossings_of(values: ScanValues) -> Crossings:
    """Where front and rear cross the cameras, as stored."""
    return Crossings(*(getattr(values, name) for name in _LINES))


def with_wheels(values: ScanValues, lines: tuple[float, float] | None) -> ScanValues:
    """The same revision with the wheelbase between two lines of strip 1 (None: without).

    Where there is no wheelbase the lines stay, and a warning says why.
    """
    if lines is None:
        return replace(values, **_NO_WHEELS)
    front, rear = sorted(lines)
    measured = wheelbase(motion_of(values), rig_from(values.rig), front, rear)
    why = [Said("scan-motion-no-wheelbase", reason=measured.reason)] if measured.reason else []
    return replace(
        values,
        front_wheel_line=front,
        rear_wheel_line=rear,
        wheelbase_m=measured.wheelbase_m,
        u_wheelbase_m=measured.u_wheelbase_m,
        warnings=[*values.warnings, *why],
    )


def with_people(values: ScanValues, before: ScanValues) -> ScanValues:
    """A new revision with what people had clicked of the one before: both wheels, and corrected axles."""
    kept = with_wheels(values, wheels_of(before))
    if before.axles_by != "person":
        return kept
    return replace(kept, axle_lines=before.axle_lines, axles_by="person")


def brought_back(history: Sequence[ScanMeasurement], crossings: Crossings) -> ScanValues | None:
    """The newest revision with these very boundaries, `history` oldest first; None where none had them."""
    return next((one.values for one in reversed(history) if crossings_of(one.values) == crossings), None)


def lane_by_person(measured: ScanMeasurement | None) -> str | None:
    """The lane that a person chose of a vehicle; None where the machine is to tell."""
    return measured.values.lane if measured is not None and measured.values.lane_by == "person" else None


def wheels_of(values: ScanValues) -> tuple[float, float] | None:
    """The lines of both wheels, where a person clicked them."""
    if values.front_wheel_line is None or values.rear_wheel_line is None:
        return None
    return values.front_wheel_line, values.rear_wheel_line


def gaps_of(rig: Rig, motions: Sequence[tuple[Motion, Mapping[str, Any]] | None]) -> list[Gap | None]:
    """The gap before each vehicle, in the order of the vehicles; None for the first of its direction and
    lane, and for the unmeasured. `motions`: each with the rig that it was measured with, as stored.
    """
    there = [(one[0].crossings, one[0], rig_from(one[1])) for one in motions if one is not None]
    after = iter(None if one.reason == NONE_BEFORE else one for one in gaps(there, rig))
    return [None if one is None else next(after) for one in motions]


def _profile(motion: Motion) -> JsonObject | None:
    if motion.profile is None:
        return None
    columns = ("line_1", "speed_mps", "fitted_mps", "used")
    return {name: getattr(motion.profile, name).tolist() for name in columns}


def _number(value: float | None) -> float | None:
    return None if value is None else float(value)
