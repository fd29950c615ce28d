"""Reference values from a CSV: what each line would do, and doing it. One line a vehicle and source.

A line names its vehicle by number, or by the time of day at which it passed: by a time, one vehicle alone
must fit the line and one line alone the vehicle, else neither is taken.
"""

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from statistics import median
from typing import cast, get_args

from sightline.coverage import expanded
from sightline.enums import JsonObject, ReferenceChange, ReferenceQuantity, ReferenceSource
from sightline.errors import BadInput
from sightline.infra.database import Session
from sightline.infra.given_csv import (
    GivenRow,
    GivenTable,
    read_table,
    require_standard,
    strip_formula_apostrophe,
)
from sightline.messages.said import Said
from sightline.scans.records import Scan, ScanVehicle
from sightline.scans.references.passing_times import USUAL_TOLERANCE_S, Ambiguous, Matching, PassedAt
from sightline.scans.references.records import (
    MEASURED,
    ReferencePlan,
    ReferenceRow,
    ReferencesImported,
    ReferenceValues,
    StoredReference,
    Unit,
    require_reference,
)
from sightline.scans.references.store import append_scan_reference, reference_history_of_scan
from sightline.scans.store import get_scan
from sightline.scans.vehicles.listing import ShownVehicle, vehicles_of
from sightline.scans.vehicles.store import change_scan_vehicle

MOST_BYTES = 5_000_000
MOST_ROWS_SHOWN = 500
_TEXTS = ("number", "time", "source", "device", "run_of")
_ALSO = {
    **{"vehicle": "number", "vehicle_number": "number", "car": "run_of", "instrument": "device"},
    **{"time_of_day": "time", "passed_at": "time", "timestamp": "time", "filmed_at": "time"},
}
_MPS, _KMH = Unit("m/s", 1.0), Unit("km/h", 1 / 3.6)
_SPEEDS = {"mps": _MPS, "m_s": _MPS, "kmh": _KMH, "km_h": _KMH, "mph": Unit("mph", 0.44704)}
_LENGTHS = {
    one.name: one for one in (Unit("m", 1.0), Unit("cm", 0.01), Unit("mm", 0.001), Unit("ft", 0.3048))
}
_IN: dict[ReferenceQuantity, dict[str, Unit]] = {
    "speed": _SPEEDS,
    "length": _LENGTHS,
    "wheelbase": _LENGTHS,
}
_QUANTITY = re.compile(rf"^(u_|u95_)?({'|'.join(get_args(ReferenceQuantity))})(?:_(.+))?$")
_ORDER: dict[ReferenceChange, int] = {"ambiguous": 0, "refused": 1, "replaces": 2, "new": 3, "same": 4}
#: (vehicle, quantity, source)
_Key = tuple[int, ReferenceQuantity, ReferenceSource]
#: What a column holds: a text by name, or (quantity, whether it is its u, its unit).
_Field = str | tuple[ReferenceQuantity, bool, Unit]


_FEW = 3  # lines whose times say how far a file's clock is off
_LIKE_UNITS = 0.05  # by so large a share a value may be off what one in another unit would be


@dataclass
class _Line:
    """A line that was read, and what becomes of it."""

    row: ReferenceRow
    vehicle: ScanVehicle | None = None

    @property
    def keys(self) -> list[_Key]:
        """(vehicle, quantity, source) of each value."""
        return [
            (self.vehicle.id, one.quantity, one.source) for one in self.row.given if self.vehicle is not None
        ]


def plan_references(
    session: Session, scan_id: int, data: bytes, name: str, tolerance_s: float = USUAL_TOLERANCE_S
) -> ReferencePlan:
    """What an import of this file would do.

    Raises NotFound, BadInput for a file that is no such table, or one with times where the recording's start
    is not confirmed.
    """
    lines, matching = _lines(session, scan_id, data, name, tolerance_s)
    return _plan(lines, matching)


def import_references(
    session: Session,
    scan_id: int,
    data: bytes,
    name: str,
    tolerance_s: float = USUAL_TOLERANCE_S,
    *,
    actor: int | None,
) -> ReferencesImported:
    """Store the usable lines, an event each. Raises as `plan_references`, BadInput where there is none."""
    lines, matching = _lines(session, scan_id, data, name, tolerance_s)
    plan = _plan(lines, matching)
    usable = [one for one in lines if one.row.change in ("new", "replaces") and one.vehicle is not None]
    if lines and plan.counts["refused"] + plan.counts["ambiguous"] == len(lines):
        first = plan.rows[0]
        raise BadInput("reference-no-line-used", name=name, line=first.line, reason=first.words[0])
    standing = _newest(session, scan_id)
    versions: dict[int, int] = {}
    values = cars = 0
    for line in usable:
        vehicle = cast(ScanVehicle, line.vehicle)
        for given in line.row.given:
            before = standing.get((vehicle.id, given.quantity, given.source))
            if before is not None and before.values == given:
                continue
            seen = before.revision if before else 0
            matched = _matched(line.row, tolerance_s)
            append_scan_reference(
                session, vehicle.id, given, seen_revision=seen, matched=matched, actor=actor
            )
            values += 1
        if line.row.run_of not in (None, vehicle.run_of):
            version = versions.get(vehicle.id, vehicle.version)
            change_scan_vehicle(
                session, vehicle.id, {"run_of": line.row.run_of}, version=version, actor=actor
            )
            versions[vehicle.id] = version + 1
            cars += 1
    return ReferencesImported(values, cars, plan)


def _matched(row: ReferenceRow, tolerance_s: float) -> JsonObject | None:
    """What the audit event keeps of a match by time."""
    if not row.by_time:
        return None
    return {"time": row.time, "apart_s": row.apart_s, "tolerance_s": tolerance_s}


def _plan(lines: Sequence[_Line], matching: Matching | None) -> ReferencePlan:
    rows = sorted((one.row for one in lines), key=lambda row: (_ORDER[row.change], row.line))
    counts = Counter(row.change for row in rows)
    return ReferencePlan(
        counts={word: counts[word] for word in get_args(ReferenceChange)},
        rows=tuple(rows[:MOST_ROWS_SHOWN]),
        tolerance_s=None if matching is None else matching.tolerance_s,
        notes=(*_unit_notes(lines), *(() if matching is None else _notes(rows, matching))),
    )


def _unit_notes(lines: Sequence[_Line]) -> Iterator[Said]:
    """Values to be stored of which most are to ours as two units are: they may be in another unit than their
    column says.
    """
    times: dict[ReferenceQuantity, list[float]] = {}
    for line in lines:
        measured = None if line.vehicle is None else line.vehicle.measurement
        if measured is None or measured.values.status != "ok" or line.row.change not in ("new", "replaces"):
            continue
        for given in line.row.given:
            ours = getattr(measured.values, MEASURED[given.quantity])
            if ours:
                times.setdefault(given.quantity, []).append(given.value / ours)
    for quantity, several in times.items():
        units = {one.si for one in _IN[quantity].values()}
        for ratio in sorted({first / second for first in units for second in units if first != second}):
            alike = sum(abs(one / ratio - 1) < _LIKE_UNITS for one in several)
            if alike >= max(_FEW, len(several) // 2 + 1):
                yield Said("reference-unit-doubtful", quantity=quantity, count=alike, times=ratio)


def _notes(rows: Sequence[ReferenceRow], matching: Matching) -> Iterator[Said]:
    """How far the file's clock is off as a whole, and whether the recording's start is known well enough."""
    apart = [row.apart_s for row in rows if row.apart_s is not None]
    if len(apart) >= _FEW:
        off, off_s = median(apart), f"{abs(median(apart)):.2f}"
        if off >= 0:
            yield Said("reference-times-later", count=len(apart), off_s=off_s)
        else:
            yield Said("reference-times-earlier", count=len(apart), off_s=off_s)
    U95_s = expanded(matching.u_start_s)
    if U95_s > matching.tolerance_s:
        tolerance_s = matching.tolerance_s
        yield Said("reference-times-start", U95_s=float(f"{U95_s:.2g}"), tolerance_s=tolerance_s)


def _newest(session: Session, scan_id: int) -> dict[tuple[int, str, str], StoredReference]:
    """The newest revision of each vehicle, quantity and source, withdrawn or not."""
    return {
        (one.vehicle_id, one.values.quantity, one.values.source): one
        for one in reference_history_of_scan(session, scan_id)
    }


def _lines(
    session: Session, scan_id: int, data: bytes, name: str, tolerance_s: float
) -> tuple[list[_Line], Matching | None]:
    scan = get_scan(session, scan_id)
    table = read_table(data, name, MOST_BYTES)
    fields = _fields(table.header, name)
    if not table.rows:
        raise BadInput("reference-no-rows", name=name)
    found = vehicles_of(session, scan_id)
    vehicles = {one.vehicle.number: one.vehicle for one in found}
    matching = _matching(scan, found, name, tolerance_s) if "time" in fields else None
    lines = [_line(table, row, fields, vehicles, matching) for row in table.rows]
    _refuse_repeats(lines)
    standing = _newest(session, scan_id)
    for line in lines:
        if line.vehicle is not None and line.row.change == "new":
            change, words = _change(line.vehicle, line.row.given, line.row.run_of, standing)
            line.row = replace(line.row, change=change, words=words)
    return lines, matching


def _matching(scan: Scan, vehicles: Sequence[ShownVehicle], name: str, tolerance_s: float) -> Matching:
    """Raises BadInput where the recording's start is not confirmed, so that no vehicle has a time of day."""
    if scan.clock is None:
        raise BadInput("reference-times-need-start", name=name)
    passed = (
        PassedAt(one.vehicle.number, datetime.fromisoformat(one.passing.filmed_at))
        for one in vehicles
        if one.passing is not None
    )
    return Matching(
        filming=scan.clock.filming,
        duration_s=(scan.lines or 0) / scan.rig.line_rate_hz,
        u_start_s=scan.clock.u_start_s,
        passed=tuple(passed),
        tolerance_s=tolerance_s,
    )


def _refuse_repeats(lines: Sequence[_Line]) -> None:
    """Of what several lines say of one vehicle by one source: those that found it by time are ambiguous, of
    the others the first one stands. By time one vehicle is a run of one car alone.
    """
    of_key: dict[_Key, list[_Line]] = {}
    of_vehicle: dict[int, list[_Line]] = {}
    for line in lines:
        for key in line.keys:
            of_key.setdefault(key, []).append(line)
        if line.vehicle is not None and line.row.run_of is not None:
            of_vehicle.setdefault(line.vehicle.id, []).append(line)
    for key, several in of_key.items():
        named = [line for line in several if not line.row.by_time]
        for line in several:
            if line.row.by_time and len(several) > 1:
                problem = Said(
                    "reference-line-fits-others",
                    number=line.row.number,
                    lines=_other_lines(line, several),
                    quantity=key[1],
                    source=key[2],
                )
                line.row = replace(line.row, change="ambiguous", words=(problem,))
            elif not line.row.by_time and line is not named[0] and line.row.change == "new":
                problem = Said("reference-line-twice", line=named[0].row.line, quantity=key[1], source=key[2])
                line.row = replace(line.row, change="refused", words=(problem,))
    for several in of_vehicle.values():
        for line in several if len({other.row.run_of for other in several}) > 1 else ():
            if line.row.by_time:
                others = _other_lines(line, several)
                problem = Said("reference-line-fits-cars", number=line.row.number, lines=others)
                line.row = replace(line.row, change="ambiguous", words=(problem,))


def _other_lines(one: _Line, several: Sequence[_Line]) -> str:
    """The lines that fit its vehicle too."""
    return ", ".join(str(other.row.line) for other in several if other is not one)


def _fields(header: Sequence[str], name: str) -> list[_Field | None]:
    """What each column holds, each once. Raises BadInput for a quantity without a unit or in two
    columns, an expanded uncertainty, or no number.
    """
    held: list[_Field | None] = []
    titles: dict[object, str] = {}
    for title in header:
        field = _field(title, name)
        held.append(field)
        of = field[:2] if isinstance(field, tuple) else field
        if of is not None and of in titles:
            raise BadInput("reference-columns-of-one", name=name, first=titles[of][:60], second=title[:60])
        titles[of] = title
    names_vehicle = "number" in held or "time" in held
    if not names_vehicle or not any(isinstance(one, tuple) or one == "run_of" for one in held):
        raise BadInput("reference-columns-missing", name=name)
    return held


def _field(title: str, name: str) -> _Field | None:
    folded = re.sub(r"[^a-z0-9]+", "_", title.strip().lower()).strip("_")
    folded = _ALSO.get(folded, folded)
    if folded in _TEXTS:
        return folded
    matched = _QUANTITY.match(folded)
    if matched is None:
        return None
    u, quantity, unit = matched.groups()
    if u is not None:
        require_standard(title, name)
    units = _IN[cast(ReferenceQuantity, quantity)]
    if unit not in units:
        names = ", ".join(f"{quantity}_{one}" for one in units if "_" not in one)
        raise BadInput("reference-column-unit", name=name, column=title[:60], names=names)
    return cast(ReferenceQuantity, quantity), u is not None, units[unit]


def _line(
    table: GivenTable,
    given_row: GivenRow,
    fields: Sequence[_Field | None],
    vehicles: Mapping[int, ScanVehicle],
    matching: Matching | None,
) -> _Line:
    """A line as read; "new" where it can be used, until it is held against other lines and what stands."""
    named = {
        field: cell.strip()
        for field, cell in zip(fields, given_row.cells, strict=True)
        if field is not None and cell.strip()
    }
    number, source = named.get("number", "")[:20], named.get("source", "").lower()[:40]
    row = ReferenceRow(
        given_row.line,
        number,
        time=named.get("time", "")[:40],
        apart_s=None,
        by_time=False,
        source=source,
        given=(),
        run_of=None,
        change="refused",
        words=(),
    )
    try:
        if given_row.problem is not None:
            raise given_row.problem
        vehicle, row = _vehicle(row, vehicles, matching)
        given = _values(table, given_row, fields, named)
        run_of = strip_formula_apostrophe(named.get("run_of", "")) or None
        if run_of is not None and len(run_of) > 100:
            raise BadInput("reference-car-too-long")
        if not given and run_of is None:
            raise BadInput("reference-line-empty")
    except Ambiguous as several:
        return _Line(replace(row, change="ambiguous", words=(several.said,)))
    except BadInput as error:
        return _Line(replace(row, words=(error.said,)))
    return _Line(replace(row, given=given, run_of=run_of, change="new"), vehicle)


def _vehicle(
    row: ReferenceRow, vehicles: Mapping[int, ScanVehicle], matching: Matching | None
) -> tuple[ScanVehicle, ReferenceRow]:
    """The vehicle that a line is of, by its number (which its time must fit) or else by its time alone."""
    if not row.number and row.time and matching is not None:
        number, apart = matching.vehicle_at(matching.instant(row.time), row.time)
        return vehicles[number], replace(row, number=str(number), apart_s=apart, by_time=True)
    if not (row.number.isascii() and row.number.isdigit()):
        raise BadInput("reference-line-no-number", number=row.number or "–")
    if int(row.number) not in vehicles:
        raise BadInput("reference-line-no-vehicle", number=row.number)
    if row.time and matching is not None:
        apart = matching.require_near(int(row.number), matching.instant(row.time))
        row = replace(row, apart_s=apart)
    return vehicles[int(row.number)], row


def _values(
    table: GivenTable, row: GivenRow, fields: Sequence[_Field | None], named: Mapping[_Field, str]
) -> tuple[ReferenceValues, ...]:
    """The values of a line, each with its u. Raises BadInput saying what is wrong."""
    numbers: dict[tuple[ReferenceQuantity, bool], float] = {}
    for column, field, cell in zip(table.header, fields, row.cells, strict=True):
        if isinstance(field, tuple) and cell.strip():
            quantity, is_u, unit = field
            read = table.size_m if unit.name == "m" and not is_u else table.number
            numbers[quantity, is_u] = round(read(row.line, column, cell.strip()) * unit.si, 9)
    units = {field[0]: field[2] for field in fields if isinstance(field, tuple) and not field[1]}
    source = named.get("source", "").lower()[:40]
    values = []
    for quantity in get_args(ReferenceQuantity):
        value, u = numbers.get((quantity, False)), numbers.get((quantity, True))
        if value is None and u is None:
            continue
        if value is None:
            raise BadInput("reference-line-no-value", quantity=quantity)
        if u is None:
            raise BadInput("reference-line-no-u", quantity=quantity)
        if source not in get_args(ReferenceSource):
            known = ", ".join(get_args(ReferenceSource))
            raise BadInput("reference-line-no-source", source=source or "–", known=known)
        device = strip_formula_apostrophe(named.get("device", "")) or None
        one = ReferenceValues(quantity, cast(ReferenceSource, source), value=value, u=u, device=device)
        require_reference(one, units[quantity])
        values.append(one)
    return tuple(values)


def _change(
    vehicle: ScanVehicle,
    given: Sequence[ReferenceValues],
    run_of: str | None,
    standing: Mapping[tuple[int, str, str], StoredReference],
) -> tuple[ReferenceChange, tuple[Said, ...]]:
    """What a line would do, and the values that it would replace."""
    before = {one: standing.get((vehicle.id, one.quantity, one.source)) for one in given}
    changed = [one for one, old in before.items() if old is None or old.values != one]
    replaced = [old for one in changed if (old := before[one]) is not None and not old.values.withdrawn]
    renamed = run_of not in (None, vehicle.run_of)
    if not changed and not renamed:
        return "same", ()
    words = [
        Said(
            "reference-line-replaces",
            quantity=reference.values.quantity,
            value=float(f"{reference.values.value:.6g}"),
            u=float(f"{reference.values.u:.6g}"),
            unit="m/s" if reference.values.quantity == "speed" else "m",
        )
        for reference in replaced
    ]
    if renamed and vehicle.run_of:
        words.append(Said("reference-line-renames", car=vehicle.run_of))
    return "replaces" if words else "new", tuple(words)
