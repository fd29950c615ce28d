"""Joins the sizes measured of a vehicle with the catalogue."""

from collections.abc import Sequence

import numpy as np

from sightline.enums import ModelSize, Target
from sightline.geometry.traffic import heading_of_pair
from sightline.infra.database import Session
from sightline.measurements.height_of_clicks import DEFAULT_SIGMA_PX
from sightline.measurements.records import VehicleSheet
from sightline.measurements.road_poses import road_pose
from sightline.measurements.sheets.query import get_sheet
from sightline.messages.said import Said
from sightline.quality.checks.store import of_vehicle
from sightline.quality.which_model.records import FittingModel, MeasuredSize, SizeDifference, WhichModel
from sightline.statistics.agreement import U_MANUFACTURER_M
from sightline.statistics.which_model import ModelFits, fit_models
from sightline.vehicles.catalogue.records import CatalogueEntry
from sightline.vehicles.catalogue.store import all_of_catalogue

MOST_SHOWN = 5
#: Sizes that rank. No height does: a roof is held against its model's, so it must not choose the model.
RANKING: frozenset[ModelSize] = frozenset({"length", "width", "wheelbase"})
# A catalogue size that states no u, metres (estimates; lamps move with load, tyres and trim).
USUAL_U_M: dict[ModelSize, float] = {
    "height": float(U_MANUFACTURER_M),
    "wheelbase": 0.010,
    "taillight": 0.020,
    "headlight": 0.020,
}
TARGET_OF: dict[ModelSize, Target] = {"height": "roof", "taillight": "taillight", "headlight": "headlight"}
SCALE_U = 0.015  # of a length on the road: what the pose may be off by, a share of it (estimate)


def which_model(session: Session, vehicle_id: int) -> WhichModel:
    """The catalogue's models (of its year, if given) that fit a vehicle; if its own can. Raises NotFound."""
    sheet = get_sheet(session, vehicle_id)
    catalogue = all_of_catalogue(session)
    entries = [one for one in catalogue if one.built_in(sheet.year)]
    measured = (*(_height(sheet, size) for size in TARGET_OF), _wheelbase(session, vehicle_id))
    if not entries:
        why = (
            Said("models-none-of-year", year=str(sheet.year))
            if catalogue
            else Said("models-none-in-catalogue")
        )
        return WhichModel(measured=measured, reason=why)
    values, u = (_numbers([getattr(one, name) for one in measured]) for name in ("value_m", "u_m"))
    sizes = _numbers([[entry.size(one.size) for one in measured] for entry in entries])
    u_sizes = _numbers([[_u_of(entry, one.size) for one in measured] for entry in entries])
    ranking = [one.size in RANKING for one in measured]
    fits = fit_models(values, u, sizes, u_sizes, _same_class(sheet, entries), ranking)
    if isinstance(fits, Said):
        return WhichModel(measured=measured, reason=fits)
    shown = [
        _fitting(entries[index], index, fits, measured, np.hypot(u, u_sizes[index])) for index in fits.order
    ]
    can = [one for one in shown if not one.cannot]
    return WhichModel(
        measured=measured,
        fitting=tuple(can[:MOST_SHOWN]),
        ranked_by=tuple(one.size for one, ranks in zip(measured, fits.ranks, strict=True) if ranks),
        fit=len(can),
        cannot_fit=len(shown) - len(can),
        chosen=next((one for one in shown if _is_chosen(one.entry, sheet)), None),
        reason=None if can else Said("models-none-fits"),
    )


def _height(sheet: VehicleSheet, size: ModelSize) -> MeasuredSize:
    """The height of the target that shows this size, if it stands and is not rejected."""
    target = TARGET_OF[size]
    measurement = next((one for one in sheet.measurements if one.values.target == target), None)
    if measurement is None:
        return MeasuredSize(size=size, reason=Said("size-not-measured"))
    if measurement.review.verdict == "rejected":
        return MeasuredSize(size=size, reason=Said("size-rejected"))
    if measurement.values.height_m is None:
        return MeasuredSize(size=size, reason=measurement.values.reason)
    return MeasuredSize(size=size, value_m=measurement.values.height_m, u_m=measurement.values.u_height_m)


def _wheelbase(session: Session, vehicle_id: int) -> MeasuredSize:
    """The distance of both tyre contacts (Checks, Road direction)."""
    pair = of_vehicle(session, vehicle_id)
    if pair is None or pair.pose_id is None:
        return MeasuredSize(size="wheelbase", reason=Said("size-no-tyres"))
    heading = heading_of_pair(road_pose(session, pair.pose_id), pair.first, pair.second, DEFAULT_SIGMA_PX)
    if isinstance(heading, Said):
        return MeasuredSize(size="wheelbase", reason=heading)
    if heading.u_base_m is None:
        return MeasuredSize(size="wheelbase", reason=Said("size-no-tyres"))
    u_m = float(np.hypot(heading.u_base_m, SCALE_U * heading.base_m))
    return MeasuredSize(size="wheelbase", value_m=heading.base_m, u_m=u_m)


def _numbers(values: object) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """None becomes NaN."""
    return np.array(values, dtype=np.float64)


def _u_of(entry: CatalogueEntry, size: ModelSize) -> float:
    stated: float | None = getattr(entry, f"u_{size}_m")
    return USUAL_U_M[size] if stated is None else stated


def _same_class(sheet: VehicleSheet, entries: Sequence[CatalogueEntry]) -> list[float] | None:
    if sheet.category is None:
        return None
    return [np.nan if one.category is None else float(one.category == sheet.category) for one in entries]


def _fitting(
    entry: CatalogueEntry,
    index: int,
    fits: ModelFits,
    measured: Sequence[MeasuredSize],
    u_m: np.ndarray[tuple[int, ...], np.dtype[np.float64]],
) -> FittingModel:
    compared = zip(measured, fits.deviate[index], u_m, strict=True)
    return FittingModel(
        entry=entry,
        chi_square=float(fits.chi_square[index]),
        compared=int(fits.compared[index]),
        p=float(fits.p[index]),
        cannot=bool(fits.cannot[index]),
        differences=tuple(
            SizeDifference(size=one.size, difference_m=float(z * u), u_m=float(u))
            for one, z, u in compared
            if np.isfinite(z)
        ),
    )


def _is_chosen(entry: CatalogueEntry, sheet: VehicleSheet) -> bool:
    """Whether make and model are those filled in."""
    if not sheet.make or not sheet.model:
        return False
    return (entry.make.lower(), entry.model.lower()) == (sheet.make.lower(), sheet.model.lower())
