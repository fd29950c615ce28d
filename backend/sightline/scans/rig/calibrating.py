"""A rig's calibration from a table of passes: to look at, stored and put in force, and made again."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from typing import Annotated, Any

from pydantic import Field

from sightline.coverage import expanded
from sightline.enums import JsonObject
from sightline.errors import BadInput
from sightline.infra.by_name import filled_from
from sightline.infra.database import Session
from sightline.infra.version import code_version
from sightline.linescan.parts import Rig
from sightline.linescan.rig import CALIBRATED
from sightline.linescan.rig_calibration import Common, RigCalibration, RigPass, calibrate_rig, lane_baseline
from sightline.scans.bodies import DistanceM, UDistanceM
from sightline.scans.rig.passes_csv import read_rig_passes
from sightline.scans.rig.records import (
    CalibrationFigures,
    CalibrationLook,
    LaneOfRig,
    RigCalibrationShown,
    RigCalibrationValues,
    StoredRigCalibration,
)
from sightline.scans.rig.store import append_rig_calibration, rig_calibration_history
from sightline.scans.store import get_scan, update_scan

# Lengths are kept to the micrometre, which is what the CSV carries: an export computes to the same figures.
LENGTH_DECIMALS = 6


Share = Annotated[float, Field(ge=0, le=0.1, description="A share that all passes have in common (k = 1).")]


@dataclass(frozen=True, kw_only=True)
class Given:
    """What is said beside the passes: shares that all have in common, and where the vehicles drive."""

    u_tape_ratio: Share = 0.0
    u_speed_ratio: Share = 0.0
    distance_m: Annotated[DistanceM | None, Field(description="To the vehicles; null: as in the rig.")] = None
    u_distance_m: UDistanceM = 0.0


def preview_rig_calibration(
    session: Session, scan_id: int, data: bytes, name: str, said: Given
) -> CalibrationLook:
    """What a table of passes would give. Raises NotFound, BadInput where it is no table of passes."""
    rig = _at_lane(get_scan(session, scan_id).rig, said)
    common = _common(rig, said)
    given = read_rig_passes(data, name, common)
    try:
        found = solve_passes(given.passes, common)
    except BadInput as error:
        return CalibrationLook(status="not_solvable", reason=error.said, figures=None, refused=given.refused)
    figures = _figures(found, rig)
    return CalibrationLook(status="ok", reason=None, figures=figures, refused=given.refused)


def store_rig_calibration(
    session: Session, scan_id: int, data: bytes, name: str, stated: Given, *, version: int, actor: int | None
) -> StoredRigCalibration:
    """Store the calibration of these passes, and put its values in force; rows that cannot be used are left
    out.

    Raises NotFound, Conflict, BadInput where the passes give no calibration, or where nobody said how far the
    vehicles are: without that their baseline would be the one at the cameras.
    """
    rig = _at_lane(get_scan(session, scan_id).rig, stated)
    if rig.distance_m is None and not rig.lanes:
        raise BadInput("scans-rig-needs-distance")
    common = _common(rig, stated)
    given = read_rig_passes(data, name, common)
    found = solve_passes(given.passes, common)
    values = calibration_values(given.passes, common, found)
    changes: dict[str, Any] = {name: getattr(values, name) for name in CALIBRATED}
    changes |= {"distance_m": rig.distance_m, "u_distance_m": rig.u_distance_m}
    update_scan(session, scan_id, changes, version=version, actor=actor)
    return append_rig_calibration(session, scan_id, values, actor=actor)


def rig_calibrations_of(session: Session, scan_id: int) -> tuple[RigCalibrationShown, ...]:
    """Every calibration of a scan's rig, newest first; the newest whose values the rig has is in force."""
    rig = get_scan(session, scan_id).rig
    shown: list[RigCalibrationShown] = []
    for calibration in reversed(rig_calibration_history(session, scan_id)):
        same = all(getattr(calibration.values, name) == getattr(rig, name) for name in CALIBRATED)
        shown.append(
            filled_from(
                RigCalibrationShown,
                calibration,
                in_force=same and not any(other.in_force for other in shown),
                figures=_figures(found_of(calibration.values), rig),
            )
        )
    return tuple(shown)


def calibration_values(
    passes: Sequence[RigPass], common: Common, calibration: RigCalibration
) -> RigCalibrationValues:
    """A calibration as it is stored."""
    return filled_from(
        RigCalibrationValues,
        calibration,
        common,
        passes=[_document(one) for one in passes],
        line_rate_hz=common.line_rate_hz or 0.0,
        baseline_m=round(calibration.baseline_m, LENGTH_DECIMALS),
        u_baseline_m=round(calibration.u_baseline_m, LENGTH_DECIMALS),
        baseline_correlation=calibration.correlation,
        code_version=code_version(),
    )


def found_of(values: RigCalibrationValues) -> RigCalibration:
    """A stored calibration, solved again from its passes; what the rig took stands as it was stored."""
    found = solve_passes([RigPass(**one) for one in values.passes], filled_from(Common, values))
    return filled_from(
        RigCalibration, values, found, passes=found.passes, correlation=values.baseline_correlation
    )


def solve_passes(passes: Sequence[RigPass], common: Common) -> RigCalibration:
    """The calibration of passes, lengths rounded as they are stored. Raises BadInput."""
    return calibrate_rig([RigPass(**_document(one)) for one in passes], common)


def _at_lane(rig: Rig, stated: Given) -> Rig:
    if stated.distance_m is None:
        return rig
    return replace(
        rig,
        distance_m=round(stated.distance_m, LENGTH_DECIMALS),
        u_distance_m=round(stated.u_distance_m, LENGTH_DECIMALS),
    )


def _common(rig: Rig, said: Given) -> Common:
    return filled_from(Common, rig, said)


def _document(one: RigPass) -> JsonObject:
    """What is given of a pass, by name; lengths to the micrometre."""
    given = {name: value for name, value in asdict(one).items() if value is not None}
    return {
        name: round(value, LENGTH_DECIMALS) if name.endswith("_m") else value for name, value in given.items()
    }


def _figures(calibration: RigCalibration, rig: Rig) -> CalibrationFigures:
    return filled_from(
        CalibrationFigures,
        calibration,
        U95_baseline_m=expanded(calibration.u_baseline_m),
        U95_divergence_rad=expanded(calibration.u_divergence_rad),
        baseline_correlation=calibration.correlation,
        lane=None if rig.distance_m is None else _lane_at(calibration, rig.distance_m, rig.u_distance_m),
        lanes=tuple(_lane_at(calibration, one.distance_m, one.u_distance_m, one.name) for one in rig.lanes),
    )


def _lane_at(
    found: RigCalibration, distance_m: float, u_distance_m: float, name: str | None = None
) -> LaneOfRig:
    lane = lane_baseline(found, distance_m, u_distance_m)
    u95 = expanded(lane.u_baseline_m)
    U95_percent = 100 * u95 / lane.baseline_m
    return filled_from(LaneOfRig, lane, name=name, U95_baseline_m=u95, U95_percent=U95_percent)
