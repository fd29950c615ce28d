"""What a survey says of its own insets: from manufacturers' heights, the trend with distance, two frames."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import groupby
from typing import Annotated, get_args

import numpy as np
import scipy
from pydantic import Field

from sightline.coverage import COVERAGE_95
from sightline.enums import InsetMethod, InsetName, InsetPlace, Target
from sightline.geometry.height import shared_covariance
from sightline.geometry.inset_trend import (
    InsetEstimate,
    Sightings,
    combine_sightings,
    inset_from_known_heights,
    inset_from_solved,
    inset_from_trend,
    sightings,
)
from sightline.geometry.insets import INSET_CHOICES, USUAL_INSETS, bias_m, inset_name, target_of
from sightline.geometry.road_pose import RoadPose
from sightline.infra.by_name import filled_from
from sightline.infra.database import Session
from sightline.measurements.height_of_clicks import SolvedInset, inset_alone
from sightline.measurements.records import Measurement, VehicleSheet
from sightline.measurements.road_poses import road_pose
from sightline.measurements.service import clicked_again
from sightline.measurements.sheets.query import list_sheets
from sightline.measurements.store import list_measurements
from sightline.messages.said import Said
from sightline.recordings.store import list_recordings
from sightline.surveys.records import Inset, Survey
from sightline.surveys.store import get_survey

USUAL_CAMERA_M = 1.5
CASES_AT_M = (2.0, 3.0, 4.0, 5.0)
# Heights for the table of typical cases; the insets are the survey's own.
_CASES: tuple[tuple[InsetName, float], ...] = (
    ("driver_eye_near", 1.16),
    ("driver_eye_far", 1.16),
    ("taillight", 0.87),
    ("headlight", 0.65),
    ("roof", 1.45),
    ("roof", 1.90),
    ("roof_van", 2.50),
    ("roof_box", 3.60),
)
_OFFER_STEP_M = 0.01
_NO_GAIN = Said("inset-no-gain")
_NOTES: dict[InsetMethod, str] = {
    "known_heights": "from the manufacturers' heights of {n} vehicles of this survey",
    "trend": "from the trend with distance of {n} vehicles of this survey",
    "two_frames": "from {n} vehicles of this survey measured on two frames",
}


@dataclass(frozen=True)
class VehicleName:
    """A vehicle as lists name it."""

    id: int
    number: int


@dataclass(frozen=True)
class Offer:
    """What the survey's inset would become: its u holds for one vehicle, not for the mean."""

    inset_m: float
    u_inset_m: float
    note: str


@dataclass(frozen=True)
class Estimate:
    """One way to an inset. `reason`: why there is no figure; `caution`: why it should not be used.

    `difference_m`: what it would change the target's typical height by, against the inset in force.
    """

    method: InsetMethod
    reason: Said | None = None
    inset_m: float | None = None
    u_inset_m: float | None = None
    spread_m: Annotated[
        float | None, Field(description="Standard deviation between vehicles, where it is known.")
    ] = None
    vehicles: int = 0
    caution: Annotated[Said | None, Field(description="Why it should not be used; null where it can be.")] = (
        None
    )
    left_out: Annotated[
        tuple[VehicleName, ...], Field(description="Vehicles that do not fit the others.")
    ] = ()
    difference_m: Annotated[
        float | None, Field(description="What it would change the typical height by.")
    ] = None
    offer: Annotated[
        Offer | None, Field(description="What the survey's inset would become, with its note.")
    ] = None


@dataclass(frozen=True)
class TargetInsets:
    """An inset in force and what the survey says of it; typical: medians of what was measured."""

    name: InsetName
    target: Target
    in_force: Inset
    is_default: bool
    measured: int
    other_insets: Annotated[int, Field(description="Measured as something else (a roof's crown); not used.")]
    typical_height_m: float | None
    typical_distance_m: float | None
    estimates: tuple[Estimate, ...]


@dataclass(frozen=True)
class InsetCase:
    """How much too high a target would read without its inset, at `CASES_AT_M`."""

    target: Target
    place: InsetPlace | None
    height_m: float
    inset_m: float
    bias_m: tuple[float, ...]


@dataclass(frozen=True)
class InsetCheck:
    """Everything about a survey's insets; `cases` are for a camera at `camera_height_m`."""

    targets: tuple[TargetInsets, ...]
    camera_height_m: float
    cases_at_m: tuple[float, ...]
    cases: tuple[InsetCase, ...]


@dataclass(frozen=True, eq=False)
class _Rows:
    """The measurements of a target that can be used, in the order of `seen`."""

    made: tuple[Measurement, ...]
    seen: Sightings | None


def check_insets(session: Session, survey_id: int) -> InsetCheck:
    """Estimate each inset from the survey's traffic alone: a check target's are its own. Raises NotFound."""
    survey = get_survey(session, survey_id)
    known = {one.id: one for one in list_sheets(session, survey_id) if not one.check_target}
    of_inset = dict[InsetName | None, list[Measurement]]()
    for made in list_measurements(session, survey_id):
        if made.review.verdict != "rejected" and made.vehicle_id in known:
            name = inset_name(made.values.target, made.values.side, known[made.vehicle_id].category)
            of_inset.setdefault(name, []).append(made)
    checked = tuple(
        _inset(session, survey, name, of_inset.get(name, []), known) for name in get_args(InsetName)
    )
    camera_m = _camera_height(session, survey_id)
    return InsetCheck(checked, camera_m, CASES_AT_M, cases(survey, camera_m))


def cases(survey: Survey, camera_height_m: float) -> tuple[InsetCase, ...]:
    """Typical heights with the survey's insets: eyes of both sides, roofs' edges and crowns."""
    rows: list[tuple[Target, InsetPlace | None, float, float]] = []
    for name, height_m in _CASES:
        target, side = target_of(name)
        choices = INSET_CHOICES.get(target, ())
        place = side or (choices[0][0] if choices else None)
        rows.append((target, place, height_m, survey.insets[name].inset_m))
        rows += [(target, other, height_m, inset_m) for other, inset_m, _ in choices[1:]]
    return tuple(
        InsetCase(
            target, place, height, inset, tuple(bias_m(camera_height_m, height, inset, CASES_AT_M).tolist())
        )
        for target, place, height, inset in rows
    )


def _camera_height(session: Session, survey_id: int) -> float:
    """The camera's height over the recordings with a road pose (median), else the usual one."""
    posed = {one.pose_id for one in list_recordings(session, survey_id) if one.pose_id is not None}
    found = [float(road_pose(session, pose_id).centre_m[2]) for pose_id in sorted(posed)]
    return float(np.median(found)) if found else USUAL_CAMERA_M


def _inset(
    session: Session,
    survey: Survey,
    name: InsetName,
    standing: Sequence[Measurement],
    known: dict[int, VehicleSheet],
) -> TargetInsets:
    in_force, (target, _) = survey.insets[name], target_of(name)
    fitting = [one for one in standing if not _is_other_choice(one, in_force)]
    rows = _uncorrected_rows(session, fitting)
    estimates = [_from_known(rows, known)] if target == "roof" else []
    estimates += [_from_trend(rows, known), _from_solved(session, fitting, known)]
    default = USUAL_INSETS[name][:2]
    return TargetInsets(
        name=name,
        target=target,
        in_force=in_force,
        is_default=(in_force.inset_m, in_force.u_inset_m) == default,
        measured=len(fitting),
        other_insets=len(standing) - len(fitting),
        typical_height_m=_median([one.values.height_m for one in fitting if one.values.height_m is not None]),
        typical_distance_m=None if rows.seen is None else _median(rows.seen.distance_m.tolist()),
        estimates=tuple(_offered(one, name, in_force, rows.seen) for one in estimates),
    )


def _is_other_choice(measurement: Measurement, in_force: Inset) -> bool:
    """Whether it was clicked as something else: a roof's crown."""
    stored = (measurement.values.inset_m, measurement.values.u_inset_m)
    others = {(inset, u) for _, inset, u in INSET_CHOICES.get(measurement.values.target, ())[1:]}
    return stored in others and stored != (in_force.inset_m, in_force.u_inset_m)


def _uncorrected_rows(session: Session, made: Sequence[Measurement]) -> _Rows:
    """The uncorrected heights of measurements, each under the pose that it was measured with."""
    parts, kept = [], []
    for pose, of_pose in _by_pose(session, made):
        sighted, fine = sightings(
            pose,
            [one.values.contact for one in of_pose],
            [one.values.target_point for one in of_pose],
            [one.values.sigma_px for one in of_pose],
        )
        parts.append(sighted)
        kept += [one for one, good in zip(of_pose, fine, strict=True) if good]
    return _Rows(tuple(kept), combine_sightings(parts) if kept else None)


def _by_pose(session: Session, made: Sequence[Measurement]) -> Iterator[tuple[RoadPose, list[Measurement]]]:
    ordered = sorted(made, key=lambda one: one.values.pose_id)
    for pose_id, group in groupby(ordered, key=lambda one: one.values.pose_id):
        yield road_pose(session, pose_id), list(group)


def _from_known(rows: _Rows, known: dict[int, VehicleSheet]) -> Estimate:
    heights = [known[one.vehicle_id].reference_m for one in rows.made]
    u = [known[one.vehicle_id].u_reference_m for one in rows.made]
    has = np.array([height is not None for height in heights], dtype=np.bool_)
    if rows.seen is None or not has.any():
        return Estimate("known_heights", Said("inset-no-known-roof"))
    estimate = inset_from_known_heights(
        rows.seen.only(has),
        [height for height in heights if height is not None],
        [u_m for u_m, height in zip(u, heights, strict=True) if height is not None],
    )
    made = [one for one, good in zip(rows.made, has, strict=True) if good]
    return _estimate("known_heights", estimate, made, known)


def _from_trend(rows: _Rows, known: dict[int, VehicleSheet]) -> Estimate:
    if rows.seen is None:
        return Estimate("trend", Said("inset-nothing-measured"))
    return _estimate("trend", inset_from_trend(rows.seen), rows.made, known)


def _from_solved(session: Session, made: Sequence[Measurement], known: dict[int, VehicleSheet]) -> Estimate:
    """Of several frames and whole passes, each solved with nothing assumed of its inset: an average of what
    rests on the assumed one would count that once for each vehicle.
    """
    several = [one for one in made if one.values.more_frames or one.values.followed is not None]
    solved: list[tuple[Measurement, SolvedInset]] = []
    shared = [np.zeros((0, 0))]
    for pose, group in _by_pose(session, several):
        alone = [
            (one, inset_alone(pose, clicked_again(one.values, *one.values.first_clicks))) for one in group
        ]
        good = [(one, inset) for one, inset in alone if inset is not None]
        solved += good
        shared.append(shared_covariance(pose, [inset.parts for _, inset in good]))
    estimate = inset_from_solved(
        [inset.inset_m for _, inset in solved],
        [inset.parts.u_own for _, inset in solved],
        scipy.linalg.block_diag(*shared),
    )
    return _estimate("two_frames", estimate, [one for one, _ in solved], known)


def _estimate(
    method: InsetMethod,
    estimate: InsetEstimate | Said,
    measurements: Sequence[Measurement],
    known: dict[int, VehicleSheet],
) -> Estimate:
    if isinstance(estimate, Said):
        return Estimate(method, estimate)
    gone = [known[measurements[i].vehicle_id] for i in estimate.left_out]
    left_out = tuple(VehicleName(one.id, one.number) for one in gone)
    return filled_from(
        Estimate, estimate, method=method, left_out=left_out, reason=None, difference_m=None, offer=None
    )


def _offered(estimate: Estimate, name: InsetName, in_force: Inset, sighted: Sightings | None) -> Estimate:
    """The estimate with what it would change, and as the survey's inset where it may become that: it says
    another one, or the same with a smaller u.
    """
    if estimate.inset_m is None or estimate.u_inset_m is None:
        return estimate
    difference = None
    if sighted is not None:
        by_inset = (sighted.measured_m - sighted.camera_height_m) / sighted.distance_m
        difference = float(np.median(by_inset)) * (estimate.inset_m - in_force.inset_m)
    offer, caution = None, estimate.caution
    if caution is None:
        between = USUAL_INSETS[name][1] if estimate.spread_m is None else estimate.spread_m
        u = float(np.ceil(np.hypot(estimate.u_inset_m, between) / _OFFER_STEP_M - 1e-9)) * _OFFER_STEP_M
        note = _NOTES[estimate.method].format(n=estimate.vehicles)
        mean = f"{estimate.inset_m:.3f} m (u = {estimate.u_inset_m:.3f} m) on average, "
        mean += f"{between:.2f} m between vehicles"
        agrees = abs(estimate.inset_m - in_force.inset_m) <= COVERAGE_95 * estimate.u_inset_m
        if agrees and round(u, 2) >= in_force.u_inset_m:
            caution = _NO_GAIN
        else:
            offer = Offer(
                round(estimate.inset_m, 2),
                round(u, 2),
                f"{note}: {mean}{' (estimate)' if estimate.spread_m is None else ''}",
            )
    return replace(estimate, difference_m=difference, offer=offer, caution=caution)


def _median(values: Sequence[float]) -> float | None:
    return float(np.median(values)) if values else None
