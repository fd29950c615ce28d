"""What a survey knows that adjusts a pose: tyres of vehicles of known wheelbase, roofs of known height."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from sightline.adjustment.observed import FRONT, REAR, ROOF, Known, ObservedPass
from sightline.geometry.insets import INSET_CHOICES
from sightline.infra.database import Session
from sightline.measurements.height_of_clicks import DEFAULT_SIGMA_PX
from sightline.measurements.records import VehicleSheet
from sightline.measurements.sheets.query import list_sheets
from sightline.messages.said import Said
from sightline.quality.adjusting.records import LeftOutVehicle
from sightline.quality.checks.records import WheelPair
from sightline.quality.checks.store import list_wheel_pairs
from sightline.vehicles.catalogue.records import CatalogueEntry
from sightline.vehicles.catalogue.store import catalogue_of_models
from sightline.vehicles.records import is_reference

_SAME_LENGTH_M = 1e-4
_BY_SIZE = Said("adjustment-model-by-size")
_CROWNS = {(inset, u) for _, inset, u in INSET_CHOICES.get("roof", ())[1:]}


@dataclass(frozen=True, slots=True, kw_only=True)
class Seen:
    """One observed pass and the vehicle that it is of. `what`: tyres or roof; each stands by itself, for a
    contact clicked for a roof may be either tyre.
    """

    vehicle: VehicleSheet
    what: str
    observed: ObservedPass

    @property
    def model(self) -> str:
        """Which vehicles stand and fall together: those of one model."""
        named = " ".join(word for word in (self.vehicle.make, self.vehicle.model) if word)
        return named or f"#{self.vehicle.number}"


@dataclass(frozen=True, slots=True, kw_only=True)
class Observations:
    """What can be used of the vehicles of some recordings, what cannot and why; all numbers."""

    seen: tuple[Seen, ...]
    left_out: tuple[LeftOutVehicle, ...]
    numbers: Mapping[int, int]


def observations_of(
    session: Session, survey_id: int, recording_ids: set[int], u_wheelbase_m: float
) -> Observations:
    """Tyres and roofs of the vehicles of these recordings; `u_wheelbase_m` where none is stated."""
    sheets = [one for one in list_sheets(session, survey_id) if one.recording_id in recording_ids]
    pairs = {one.vehicle_id: one for one in list_wheel_pairs(session, survey_id)}
    models = _models(session, sheets)
    observations: list[Seen] = []
    left_out: list[LeftOutVehicle] = []
    for vehicle in sheets:
        found = (_tyres(vehicle, pairs.get(vehicle.id), models, u_wheelbase_m), _roof(vehicle))
        for what, outcome in zip(("tyres", "roof"), found, strict=True):
            if isinstance(outcome, ObservedPass):
                observations.append(Seen(vehicle=vehicle, what=what, observed=outcome))
            elif outcome is not None:
                left_out.append(
                    LeftOutVehicle(vehicle_id=vehicle.id, number=vehicle.number, what=what, reason=outcome)
                )
    numbers = {one.id: one.number for one in sheets}
    return Observations(seen=tuple(observations), left_out=tuple(left_out), numbers=numbers)


def _models(
    session: Session, sheets: Sequence[VehicleSheet]
) -> Mapping[tuple[str, str], list[CatalogueEntry]]:
    named = {(one.make, one.model) for one in sheets if one.make and one.model}
    found: dict[tuple[str, str], list[CatalogueEntry]] = {}
    for entry in catalogue_of_models(session, named):
        found.setdefault((entry.make.lower(), entry.model.lower()), []).append(entry)
    return found


def _tyres(
    vehicle: VehicleSheet,
    pair: WheelPair | None,
    models: Mapping[tuple[str, str], list[CatalogueEntry]],
    u_wheelbase_m: float,
) -> ObservedPass | Said | None:
    """Both tyres with the wheelbase of the model; why not; None where nobody clicked them."""
    if pair is None:
        return None
    if not vehicle.make or not vehicle.model:
        return Said("adjustment-no-model")
    if not is_reference(vehicle.model_chosen_by):
        return _BY_SIZE
    entries = models.get((vehicle.make.lower(), vehicle.model.lower()), [])
    offered = [one for one in entries if one.retired_at is None and one.built_in(vehicle.year)]
    fitting = [one for one in offered if one.wheelbase_m is not None]
    lengths = [one.wheelbase_m for one in fitting if one.wheelbase_m is not None]
    if not lengths:
        return Said("adjustment-no-wheelbase")
    if max(lengths) - min(lengths) > _SAME_LENGTH_M:
        return Said("adjustment-several-wheelbases")
    # of which of them it is, nothing is known: the least sure holds
    u_m = max(u_wheelbase_m if one.u_wheelbase_m is None else one.u_wheelbase_m for one in fitting)
    return ObservedPass(
        name=f"{vehicle.number} tyres",
        frame=np.array([pair.frame, pair.frame]),
        point=np.array([REAR, FRONT]),
        points_px=np.array([pair.first, pair.second], dtype=np.float64),
        sigma_px=np.full(2, DEFAULT_SIGMA_PX),
        wheelbase=Known(lengths[0], u_m),
    )


def _roof(vehicle: VehicleSheet) -> ObservedPass | Said | None:
    """The roof with its known height and inset; why not; None where nobody measured it."""
    measurement = next((one for one in vehicle.measurements if one.values.target == "roof"), None)
    if measurement is None or measurement.review.verdict == "rejected":
        return None
    if vehicle.manufacturer_height_m is None:
        return Said("adjustment-no-height")
    if vehicle.reference_m is None:
        return _BY_SIZE
    values = measurement.values
    if values.inset_m is None or values.u_inset_m is None or (values.inset_m, values.u_inset_m) in _CROWNS:
        return Said("adjustment-roof-not-near-edge")
    frames = np.repeat(np.array(values.frames), 2)
    points = [point for both in zip(values.contacts, values.target_points, strict=True) for point in both]
    return ObservedPass(
        name=f"{vehicle.number} roof",
        frame=frames,
        point=np.tile([REAR, ROOF], len(values.frames)),
        points_px=np.array(points, dtype=np.float64),
        sigma_px=np.full(len(frames), values.sigma_px),
        roof=Known(vehicle.reference_m, vehicle.u_reference_m),
        roof_inset=Known(values.inset_m, values.u_inset_m),
    )
