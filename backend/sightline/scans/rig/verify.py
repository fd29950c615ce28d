"""Solving every calibration of a rig again from its passes."""

import math
from collections import defaultdict
from collections.abc import Mapping
from typing import Any

from sightline.enums import JsonObject
from sightline.errors import BadInput, Damaged
from sightline.infra.csv_package.files import Files, read_rows
from sightline.infra.csv_package.recomputing import Recomputing
from sightline.infra.csv_package.schema import AnyTable
from sightline.linescan.rig import CALIBRATED
from sightline.linescan.rig_calibration import Common, RigPass
from sightline.scans.heights.verify import LINES
from sightline.scans.rig.calibrating import calibration_values, solve_passes
from sightline.scans.rig.csv import GIVEN, RIG_CALIBRATIONS, RIG_PASSES

Row = Mapping[str, str]
# Half of the last decimal that a CSV carries; of what has all its digits, what another machine may round.
_TOLERANCE_M = 0.51e-6
_CLOSE = 1e-6
_COMMON = ("line_rate_hz", "u_line_rate_ratio", "u_tape_ratio", "u_speed_ratio")
_FIGURES = (*CALIBRATED, "chi2", "p_value")


def check_rig_calibrations(
    files: Files, events: Mapping[int, Mapping[str, Any]], recomputing: Recomputing
) -> None:
    """Solve each calibration again. `events`: what their audit events say. Raises Damaged."""
    passes: dict[int, list[Row]] = defaultdict(list)
    for row in read_rows(files, RIG_PASSES.key):
        passes[int(row["calibration_id"])].append(row)
    for row in read_rows(files, RIG_CALIBRATIONS.key):
        number = int(row["id"])
        rows = passes.pop(number, [])
        given = _check_given_passes(row, rows, events[number])
        with recomputing.of(LINES, row["code_version"]):
            _calibration(row, rows, given)
    if passes:
        raise Damaged("scans-rig-passes-without", path=RIG_PASSES.key, id=min(passes))


def _check_given_passes(row: Row, rows: list[Row], event: Mapping[str, Any]) -> list[RigPass]:
    """The passes, as the event tells them."""
    given: list[JsonObject] = [
        {"name": one["pass"], **{name: float(one[name]) for name in GIVEN if one[name]}} for one in rows
    ]
    if given != event["passes"] or [int(one["number"]) for one in rows] != list(range(1, len(rows) + 1)):
        raise Damaged("scans-rig-passes-differ", path=RIG_PASSES.key, id=row["id"])
    return [RigPass(**one) for one in given]


def _calibration(row: Row, rows: list[Row], passes: list[RigPass]) -> None:
    common = Common(**{name: float(row[name]) for name in _COMMON})
    try:
        calibration = solve_passes(passes, common)
    except BadInput as error:
        raise Damaged("scans-rig-unsolvable", path=RIG_CALIBRATIONS.key, id=row["id"]) from error
    values = calibration_values(passes, common, calibration)
    for name in _FIGURES:
        _compare_value(RIG_CALIBRATIONS, row, name, getattr(values, name), row["id"])
    if int(row["degrees_of_freedom"]) != calibration.degrees_of_freedom:
        raise Damaged("scans-rig-differs", path=RIG_CALIBRATIONS.key, name="degrees_of_freedom", id=row["id"])
    for pass_row, fitted in zip(rows, calibration.passes, strict=True):
        if pass_row["kind"] != fitted.kind:
            raise Damaged("scans-rig-differs", path=RIG_PASSES.key, name="kind", id=row["id"])
        for name in ("span_m", "u_span_m", "residual_m"):
            _compare_value(RIG_PASSES, pass_row, name, getattr(fitted, name), row["id"])


def _compare_value(table: AnyTable, row: Row, name: str, value: float, number: str) -> None:
    stored = float(row[name])
    most = _TOLERANCE_M if name.endswith("_m") else _CLOSE * max(1e-6, abs(value))
    # a chi-square of next to nothing is rounding
    if name in ("chi2", "p_value"):
        most = max(most, 1e-6)
    if not math.fabs(stored - value) <= most:
        raise Damaged("scans-rig-differs", path=table.path, name=name, id=number)
