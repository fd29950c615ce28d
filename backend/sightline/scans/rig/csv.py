"""What the package holds of rigs' calibrations: their figures, and the passes that they are solved from."""

from collections.abc import Iterable
from dataclasses import dataclass, fields
from typing import Any, get_args

from sightline.enums import RigPassKind
from sightline.infra.csv_package.columns import (
    columns_within,
    integer,
    key,
    metres,
    moment,
    number,
    person,
    text,
)
from sightline.infra.csv_package.files import Staging
from sightline.infra.csv_package.schema import Column, Table, ids_of
from sightline.infra.database import Session
from sightline.linescan.rig_calibration import FittedPass, RigPass
from sightline.scans.rig.calibrating import found_of
from sightline.scans.rig.records import StoredRigCalibration
from sightline.scans.rig.store import rig_calibration_history

_MEANINGS = {
    "distance_m": "taped distance from the cameras",
    "u_distance_m": "standard uncertainty of distance_m (k = 1)",
    "u_line": "standard uncertainty of each line (k = 1)",
    "position_1_m": "where along the tape camera 1 saw the staff",
    "position_2_m": "where along the tape camera 2 saw it",
    "u_position_m": "standard uncertainty of either position (k = 1)",
    "speed_mps": "known speed of the staff",
    "u_speed_mps": "standard uncertainty of speed_mps (k = 1)",
    "line_1": "line at which camera 1 saw the staff",
    "line_2": "line at which camera 2 saw it",
    "width_m": "known width of the board",
    "u_width_m": "standard uncertainty of width_m (k = 1)",
    "front_line_1": "line at which the board's first edge crosses camera 1",
    "rear_line_1": "line at which its last edge crosses camera 1",
    "front_line_2": "line at which its first edge crosses camera 2",
    "rear_line_2": "line at which its last edge crosses camera 2",
}
GIVEN = tuple(one.name for one in fields(RigPass) if one.name != "name")


@dataclass(frozen=True, slots=True)
class ListedPass:
    """A pass of a calibration, as it was given and beside the fit."""

    calibration_id: int
    number: int
    given: dict[str, Any]
    fitted: FittedPass


def _unit(name: str) -> str:
    return next((unit for end, unit in (("_mps", "m/s"), ("_m", "m")) if name.endswith(end)), "")


def _given_column(name: str) -> Column[ListedPass]:
    return number(name, _MEANINGS[name], _unit(name), lambda one: one.given.get(name))


RIG_CALIBRATIONS: Table[StoredRigCalibration] = Table(
    "rig_calibrations",
    "Calibrations of rigs by a staff or board that passed both planes; solved for from rig_passes. The rig "
    "took the values of each when it was stored.",
    (
        key("id", "calibration"),
        key("scan_id", "line-scan recording"),
        key("revision", "number of the calibration, from 1"),
        *columns_within(
            "values",
            number("line_rate_hz", "lines a second, for passes of known speed", "Hz", required=True),
            number("u_line_rate_ratio", "its standard uncertainty over it (k = 1)", required=True),
            number("u_tape_ratio", "standard uncertainty of the tape's scale", required=True),
            number("u_speed_ratio", "what all known speeds share, a share", required=True),
            metres("baseline_m", "baseline at the cameras", required=True),
            metres("u_baseline_m", "standard uncertainty of baseline_m (k = 1)", required=True),
            number("divergence_rad", "how the baseline grows with the distance", "rad", required=True),
            number(
                "u_divergence_rad", "standard uncertainty of divergence_rad (k = 1)", "rad", required=True
            ),
            number("baseline_correlation", "of the errors of both", required=True),
            number("chi2", "chi-square of the passes about the straight line", required=True),
            integer("degrees_of_freedom", "of the chi-square", required=True),
            number("p_value", "chance of a chi-square as large", required=True),
            text("code_version", "version of the program that computed it", required=True),
        ),
        person("created_by_id", "who made it current"),
        moment("created_at", "when it was stored"),
    ),
    primary=("id",),
    foreign=ids_of(scan_id="line_scans"),
)
RIG_PASSES: Table[ListedPass] = Table(
    "rig_passes",
    "The passes that each calibration of a rig is solved for from, as they were given, beside the fit.",
    (
        key("calibration_id", "calibration, in rig_calibrations"),
        key("number", "number of the pass, from 1"),
        text("pass", "its name", lambda one: one.given["name"], required=True),
        *columns_within(
            "fitted",
            text("kind", "how it determines the baseline", required=True, enum=get_args(RigPassKind)),
        ),
        *(_given_column(name) for name in GIVEN),
        *columns_within(
            "fitted",
            metres("span_m", "baseline that the pass gives at its distance", required=True),
            metres("u_span_m", "standard uncertainty of span_m (k = 1)", required=True),
            metres("residual_m", "span_m minus the fitted baseline", required=True),
        ),
    ),
    primary=("calibration_id", "number"),
    foreign=ids_of(calibration_id="rig_calibrations"),
)
TABLES: tuple[Table[Any], ...] = (RIG_CALIBRATIONS, RIG_PASSES)


def fill_rigs(staging: Staging, session: Session, scan_ids: Iterable[int]) -> None:
    """Write the tables of these recordings' calibrations, by number."""
    found = [one for scan_id in scan_ids for one in rig_calibration_history(session, scan_id)]
    found.sort(key=lambda one: one.id)
    staging.fill(RIG_CALIBRATIONS, found)
    staging.fill(RIG_PASSES, (one for made in found for one in _listed(made)))


def _listed(made: StoredRigCalibration) -> list[ListedPass]:
    fitted = found_of(made.values).passes
    return [
        ListedPass(made.id, at, given, one)
        for at, (given, one) in enumerate(zip(made.values.passes, fitted, strict=True), 1)
    ]
