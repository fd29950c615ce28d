"""The statistics of an export's line scans: read from its own rows, and as tables of their own."""

from collections.abc import Iterable, Iterator
from dataclasses import asdict
from typing import cast, get_args

from sightline.enums import (
    KnownLength,
    ReferenceQuantity,
    ReferenceSource,
    RunsVerdict,
    ScanDirection,
    Target,
)
from sightline.export.chosen import chosen_scanned
from sightline.export.exclusions import reason_in
from sightline.export.statistics_rows import (
    BAND,
    INTERVAL,
    REASON,
    Cells,
    curve_rows,
    error_rows,
    said_of,
    statistics_table,
)
from sightline.infra.csv_package.columns import integer, metres, number, text
from sightline.infra.csv_package.files import Files, read_columns, read_rows, undo_safe_text
from sightline.infra.csv_package.files import number as figure_of
from sightline.results.csv import selection_in
from sightline.scans.csv import SCAN_MEASUREMENTS, rig_of_row
from sightline.scans.heights.csv import LINE_HEIGHTS
from sightline.scans.records import state_of
from sightline.scans.references.csv import SCAN_REFERENCES
from sightline.scans.references.records import ReferenceValues
from sightline.scans.statistics.heights import HeightSeen, ScannedHeights, scanned_heights
from sightline.scans.statistics.service import (
    GAPS,
    KNOWN_SIZES,
    MOTION,
    ScanStatistics,
    VehicleMotion,
    statistics_of_seen,
    when_passed,
)
from sightline.scans.store import RIG

# of a motion's rig, whose distance is that of its lane
_RIG = ("id", *(name for name in RIG if name != "lanes"))
_QUANTITY = text(
    "quantity",
    "speed: when the front reaches camera 1; length; time_gap and distance_gap: from the rear before to this "
    "front; headway: front to front",
    required=True,
    enum=("speed", "length", "time_gap", "distance_gap", "headway"),
)
_SIZE = text("size", "which size of a vehicle", required=True, enum=get_args(KnownLength))
_UNIT = text("unit", "unit of the figures of this row", required=True)
_N = integer("n", "number of vehicles", required=True, minimum=0)

ERRORS = statistics_table(
    "scan_errors",
    "Errors (measured minus manufacturer's) of lengths and wheelbases of accepted scanned vehicles, not "
    "rounded, by lighting and overall; figures named _m are in metres, _m2 in square metres. Intervals "
    "include sampling only, not the baseline's error, which all vehicles share.",
    _SIZE,
    text("group", "which group", required=True),
    text("figure", "which figure", required=True),
    _N,
    number("value", "the figure"),
    *INTERVAL,
    *REASON,
    primary=("size", "group", "figure"),
)
BASELINES = statistics_table(
    "scan_baselines",
    "What known sizes say of the baseline: measured over true, by weighted mean; 1.01 is 1 % too long.",
    _SIZE,
    _N,
    number("ratio", "measured over true"),
    number("u_ratio", "standard uncertainty of the ratio (k = 1)"),
    number("spread", "standard deviation of a vehicle's ratio"),
    *REASON,
    *said_of("warning", "warning"),
    primary=("size",),
)
QUANTITIES = statistics_table(
    "scan_quantities",
    "Mean and spread of what accepted scanned vehicles were measured for.",
    _QUANTITY,
    _UNIT,
    _N,
    number("mean", "mean, in the row's unit"),
    number("sd", "standard deviation (n - 1), in the row's unit"),
    primary=("quantity",),
)
PERCENTILES = statistics_table(
    "scan_percentiles",
    "Percentiles of the same with distribution-free 95 % intervals.",
    _QUANTITY,
    _UNIT,
    _N,
    number("percent", "which percentile", "%"),
    number("value", "the percentile, in the row's unit"),
    *INTERVAL,
    *REASON,
    primary=("quantity", "percent"),
)
ECDF = statistics_table(
    "scan_ecdf",
    "Cumulative distributions of the same with 95 % bands; at most 600 points of each.",
    _QUANTITY,
    number("value", "the value, in m/s, m or s as scan_quantities says"),
    number("share", "share of the vehicles that are not above it"),
    *BAND,
)
HEIGHTS = statistics_table(
    "scan_heights",
    "Heights clicked in the line scans, target by target: the figures are of the accepted ones; the heights "
    "that wait for a review or were rejected are counted.",
    text("target", "what was measured", required=True, enum=get_args(Target)),
    integer("n", "number of accepted heights", required=True, minimum=0),
    integer("to_review", "number of heights to review", required=True, minimum=0),
    integer("rejected", "number of rejected heights", required=True, minimum=0),
    metres("mean_m", "mean height"),
    metres("sd_m", "standard deviation (n - 1); empty for one height"),
    metres("median_m", "median height"),
    metres("U95_m", "median half-width of the heights' 95 % intervals"),
    primary=("target",),
)
REFERENCES = statistics_table(
    "scan_reference_errors",
    "Accepted scanned vehicles' own values minus reference values, by what measured those; where two or more "
    "sources did, also all together.",
    text("quantity", "which value", required=True, enum=get_args(ReferenceQuantity)),
    text("source", "what measured the references; all: every source, of two or more", required=True),
    _UNIT,
    _N,
    number("mean", "mean difference"),
    number("sd", "standard deviation of the differences (n - 1)"),
    number("rmse", "root mean square of the differences"),
    integer("within", "how many are within their combined U95", required=True, minimum=0),
    number("share_within", "that as a share: |E_n| <= 1"),
    number("low", "lower end of the share's exact 95 % interval"),
    number("high", "upper end of it"),
    primary=("quantity", "source"),
)
CARS = statistics_table(
    "scan_cars",
    "Runs of one car (scan_vehicles.run_of) among the accepted vehicles: a size does not change from run to "
    "run, so the runs must agree within their own uncertainty.",
    text("car", "name of the car", required=True),
    _SIZE,
    _N,
    metres("mean_m", "weighted mean of the runs (generalised least squares)"),
    metres("u_mean_m", "its standard uncertainty (k = 1), what the runs share included"),
    metres("U95_mean_m", "half-width of its 95 % interval"),
    metres("sd_m", "standard deviation of the runs (n - 1)"),
    metres("u_stated_m", "root mean square of what each run states for itself (k = 1)"),
    number("chi_square", "of the runs about their mean"),
    integer("degrees", "its degrees of freedom", required=True, minimum=0),
    number("p", "probability of a chi-square this large if the stated uncertainties are correct"),
    text("verdict", "what follows", required=True, enum=get_args(RunsVerdict)),
    primary=("car", "size"),
)
TABLES = (ERRORS, BASELINES, QUANTITIES, PERCENTILES, ECDF, HEIGHTS, REFERENCES, CARS)


def scans_in(files: Files, found: Iterable[VehicleMotion]) -> ScanStatistics:
    """Statistics of the accepted vehicles of all line scans that a package is of, `found` all it has."""
    filmed, of_kind = selection_in(files), chosen_scanned(files).of_kind
    seen = [one for one in found if str(one.vehicle_id) in of_kind]
    return statistics_of_seen(seen, accepted_only=True, filmed=filmed)


def scan_heights_in(files: Files) -> tuple[ScannedHeights, ...]:
    """The accepted heights of the same vehicles, target by target."""
    chosen = chosen_scanned(files).of
    names = ("vehicle_id", "target", "verdict", "current", "withdrawn", "height_m", "U95_height_m")
    return scanned_heights(
        (
            HeightSeen(target, verdict, float(height), float(U95))
            for vehicle, target, verdict, current, withdrawn, height, U95 in read_columns(
                files, LINE_HEIGHTS.key, names
            )
            if vehicle in chosen and current == "true" and withdrawn == "false" and height and U95
        ),
        accepted_only=True,
    )


def scanned_motions(files: Files) -> Iterator[VehicleMotion]:
    """All vehicles of a package's line scans, whatever it is of, as its tables say."""
    lighting = dict(read_columns(files, "line_scans.csv", ("id", "lighting")))
    rigs = {
        cells[0]: rig_of_row(SCAN_MEASUREMENTS.key, dict(zip(_RIG, cells, strict=True)))
        for cells in read_columns(files, SCAN_MEASUREMENTS.key, _RIG)
    }
    references = _standing(files)
    for row in read_rows(files, "scan_vehicles.csv"):
        rig = rigs.get(row["measurement_id"])
        yield VehicleMotion(
            vehicle_id=int(row["id"]),
            scan_id=int(row["scan_id"]),
            number=int(row["number"]),
            state=state_of(row["status"] or None, row["verdict"] or None),
            measured=row["status"] == "ok",
            lighting=row["lighting"] or lighting.get(row["scan_id"], "") or "unknown",
            values={name: figure_of(row[name]) for name in (*MOTION, *GAPS)},
            known={name: figure_of(row[column]) for name, column in KNOWN_SIZES.items()},
            status=row["status"] or "not_measurable",
            reason=reason_in(row),
            filmed_at=row["filmed_at"],
            u_filmed_at_s=figure_of(row["u_filmed_at_s"]),
            run_of=row["run_of"] or None,
            references=tuple(references.get(row["id"], ())),
            direction=cast(ScanDirection, row["direction"]) if row["direction"] else None,
            lane=undo_safe_text(row["lane"]) or None,
            axles=int(row["axles"]) if row["axles"] else None,
            **(
                {}
                if rig is None
                else when_passed(rig, float(row["front_line_1"]), float(row["rear_line_1"]), reason_in(row))
            ),
        )


def _standing(files: Files) -> dict[str, list[ReferenceValues]]:
    """The reference values that stand, by vehicle."""
    references: dict[str, list[ReferenceValues]] = {}
    names = ("vehicle_id", "current", "withdrawn", "quantity", "source", "value", "u")
    for vehicle, current, withdrawn, quantity, source, value, u in read_columns(
        files, SCAN_REFERENCES.key, names
    ):
        if current == "true" and withdrawn == "false":
            reference = ReferenceValues(
                cast(ReferenceQuantity, quantity), cast(ReferenceSource, source), float(value), float(u)
            )
            references.setdefault(vehicle, []).append(reference)
    return references


def scan_rows(statistics: ScanStatistics, heights: tuple[ScannedHeights, ...]) -> dict[str, Iterator[Cells]]:
    """The rows of every table by its path; of motions none where no scanned vehicle is accepted."""
    return {
        ERRORS.key: _error_rows(statistics),
        BASELINES.key: _baseline_rows(statistics),
        QUANTITIES.key: (vars(one) for one in statistics.spreads if one.n),
        PERCENTILES.key: _percentile_rows(statistics),
        ECDF.key: _ecdf_rows(statistics),
        HEIGHTS.key: (asdict(one) for one in heights),
        REFERENCES.key: _reference_rows(statistics),
        CARS.key: _car_rows(statistics),
    }


def _reference_rows(found: ScanStatistics) -> Iterator[Cells]:
    for reference in found.references:
        errors = reference.errors
        ends = {"low": errors.share_low, "high": errors.share_high}
        yield {**vars(reference), "source": reference.source or "all", **asdict(errors), **ends}


_METRIC = ("mean", "u_mean", "U95_mean", "sd", "u_stated")


def _car_rows(found: ScanStatistics) -> Iterator[Cells]:
    for car in found.cars:
        for size, together in car.sizes.items():
            told = asdict(together)
            yield {"car": car.car, "size": size, **told, **{f"{name}_m": told[name] for name in _METRIC}}


def _error_rows(found: ScanStatistics) -> Iterator[Cells]:
    for size, groups in (("length", found.length_errors), ("wheelbase", found.wheelbase_errors)):
        if groups["overall"].n:
            yield from error_rows({"size": size}, groups)


def _baseline_rows(found: ScanStatistics) -> Iterator[Cells]:
    for size, one in (("length", found.length_ratio), ("wheelbase", found.wheelbase_ratio)):
        if found.counted["used"]:
            yield {"size": size, **vars(one), "ratio": one.value, "u_ratio": one.u}


def _percentile_rows(found: ScanStatistics) -> Iterator[Cells]:
    return ({**vars(one), **vars(each)} for one in found.spreads for each in one.percentiles)


def _ecdf_rows(found: ScanStatistics) -> Iterator[Cells]:
    for one in found.spreads:
        key = {"quantity": one.quantity}
        yield from curve_rows(key, one.ecdf, value="value", share="share", low="low", high="high")
