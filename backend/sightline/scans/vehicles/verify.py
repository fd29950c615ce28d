"""Computing the gaps between scanned vehicles of a package again, from the events of their motions."""

from collections import defaultdict
from collections.abc import Mapping
from dataclasses import fields
from typing import Any

from sightline.errors import Damaged
from sightline.infra.csv_package.recomputing import Recomputing
from sightline.infra.csv_package.replay import first_difference
from sightline.linescan.parts import Motion, Rig
from sightline.linescan.rig import rig_from
from sightline.messages.said import Said
from sightline.scans.csv import GAP, SCAN_VEHICLES
from sightline.scans.heights.verify import LINES
from sightline.scans.vehicles.motion import gaps_of, motion_told

Row = Mapping[str, str]
Told = Mapping[str, Any]
_RIG = tuple(one.name for one in fields(Rig))
# of words only the codes are compared; they are held against each other
_COLUMNS = {column.name: column for column in GAP if column.name != "gap_reason"}


def check_gaps(
    vehicles: Mapping[int, Row],
    scans: Mapping[int, Told],
    motions: Mapping[int, Told],
    recomputing: Recomputing,
    program: str,
) -> None:
    """`program`: the version that made the package. Of motions whose events tell no budget, which earlier
    ones wrote, no uncertainty of a gap can be computed: the seal alone binds it. Raises Damaged.
    """
    of_scan: dict[int, list[tuple[Row, Told | None]]] = defaultdict(list)
    for row in vehicles.values():
        told = motions[int(row["measurement_id"])] if row["measurement_id"] else None
        of_scan[int(row["scan_id"])].append((row, told))
    for scan_id, passed in of_scan.items():
        rig = rig_from({name: scans[scan_id][name] for name in _RIG if name in scans[scan_id]})
        with recomputing.of(LINES, program):
            _check(rig, sorted(passed, key=_place))


def _place(passed: tuple[Row, Told | None]) -> tuple[float, int]:
    row, told = passed
    return 0.0 if told is None else told["front_line_1"], int(row["id"])


def _check(rig: Rig, passed: list[tuple[Row, Told | None]]) -> None:
    with_u = all(told is None or "budget" in told for _, told in passed)
    columns = {name: one for name, one in _COLUMNS.items() if with_u or not name.startswith("u_")}
    gaps = gaps_of(rig, [None if told is None else (_motion(told), told["rig"]) for _, told in passed])
    for (row, _), gap in zip(passed, gaps, strict=True):
        cells = {name: None if gap is None else one.of_object(gap) for name, one in columns.items()}
        name = first_difference(columns, row, cells)
        if name is not None:
            raise Damaged("scans-gap-differs", path=SCAN_VEHICLES.key, name=name, number=row["id"])


def _motion(told: Told) -> Motion:
    return motion_told({**told, "reason": told["reason"] and Said.read(told["reason"])})
