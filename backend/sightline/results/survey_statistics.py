"""Statistics of stored measurements: a filter, the columns that it leaves, and what is shown of them.

`survey_statistics(session, Filter, StatisticsOptions)` is the one way in: page, report and package all show
its answer. `Filter(survey_ids=(survey_id,))` with the usual options gives a survey's accepted measurements,
read against the survey's own table of standards (`results.standards_store`).
`made_of` makes the same of columns that come from elsewhere, such as the rows of a package: what the database
would tell is then given, `StatisticsOptions.standards` included.
"""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, replace
from datetime import date
from threading import Lock
from typing import Annotated, Any, get_args

import numpy as np
from cachetools import LRUCache, cached
from numpy.typing import NDArray
from pydantic import Field

from sightline.arrays import Ints
from sightline.enums import (
    AcceptedVerdict,
    Category,
    ClassSet,
    Correction,
    Rounding,
    StandardHeight,
    StatisticsState,
    StatisticsTarget,
)
from sightline.errors import BadInput, NotFound
from sightline.infra.audit import trail
from sightline.infra.database import Session
from sightline.infra.web.person import Seen
from sightline.messages.said import Said
from sightline.people.store import list_people
from sightline.results.measured_columns_query import (
    CATEGORIES,
    CLASS_SETS,
    LANES,
    LIGHTING,
    NONE,
    TARGETS,
    VERDICTS,
    Heights,
    Measured,
    load_measured_columns,
)
from sightline.results.selection import Selection
from sightline.results.standards_store import standards_of_surveys
from sightline.results.survey_comparison import ComparedSurveys, compared_surveys
from sightline.results.usual_standards import STANDARDS
from sightline.statistics.agreement import U_MANUFACTURER_M
from sightline.statistics.known_errors import COMPARED, Compared, KnownErrors, known_errors
from sightline.statistics.lateral import Lateral, lateral_positions
from sightline.statistics.rules import RuleToday, rule_today
from sightline.statistics.shared_errors import inset_codes
from sightline.statistics.standards import Standard
from sightline.statistics.summary import Errors, Grouping, Roofs, Target, errors_of, target_of
from sightline.statistics.total_uncertainty import HeightSample, TotalUncertainty, sample_of_measurements
from sightline.surveys.store import survey_names

SHOWN: tuple[StatisticsTarget, ...] = get_args(StatisticsTarget)
OUT_OF_SAMPLE = "out_of_sample"
_STATES: dict[StatisticsState, tuple[str, ...]] = {
    "accepted": get_args(AcceptedVerdict),
    "to_review": ("to_review", "reopened"),
    "rejected": ("rejected",),
    "all": VERDICTS,
}
_WHAT: dict[StatisticsTarget, str] = {
    "driver_eye": "eye_car",
    "taillight": "object_stopping",
    "headlight": "headlight",
}
#: Whose heights a standard's rule is read on: a target of some classes, or of what counts in a set.
_CARS: tuple[tuple[Category, ...], tuple[ClassSet, ...]] = ((), ("passenger_cars",))
_TRUCKS: tuple[tuple[Category, ...], tuple[ClassSet, ...]] = (("lorry", "tractor_unit"), ())
RULE_OF: dict[StandardHeight, tuple[StatisticsTarget, tuple[tuple[Category, ...], tuple[ClassSet, ...]]]] = {
    "eye_car": ("driver_eye", _CARS),
    "eye_truck": ("driver_eye", _TRUCKS),
    "object_stopping": ("taillight", _CARS),
    "headlight": ("headlight", _CARS),
    "vehicle": ("roof", _CARS),
}
_EYE_PERCENT, _OBJECT_PERCENT = 10.0, 5.0  # AASHTO's
_EPOCH = date(1970, 1, 1)


@dataclass(frozen=True)
class Filter(Selection):
    """Which measurements count; None or empty: no limit. Days are those of clicking (UTC).

    A vehicle counts if its class is one of `categories` or counts in one of `class_sets`.

    `target` limits what is counted and shown, not the errors: they are of roofs, and corrections need them.
    `seen`: the surveys that the person who asks sees; others are left out, and are not there when named.
    """

    survey_ids: tuple[int, ...] = ()
    operator_id: int | None = None
    first_day: date | None = None
    last_day: date | None = None
    state: StatisticsState = "accepted"
    target: StatisticsTarget | None = None
    seen: Seen = None


def filter_of(selection: Selection) -> Filter:
    """The accepted measurements of the vehicles of a selection."""
    return Filter(**{one.name: getattr(selection, one.name) for one in fields(Selection)})


@dataclass(frozen=True)
class StatisticsOptions:
    """How figures are made: rounding of the error table, correction, u of a height without one of its own,
    limits of the reader's own beside the standards', and the standards; None: those of the surveys.
    """

    rounding: Rounding = "none"
    correction: Correction = "inset"
    u_reference_m: float = float(U_MANUFACTURER_M)
    own_standards: tuple[Standard, ...] = ()
    standards: tuple[Standard, ...] | None = None


@dataclass(frozen=True)
class SampleCounts:
    """What the filter left, and what it left out by review state."""

    measurements: int
    vehicles: int
    with_reference: Annotated[int, Field(description="Roofs of vehicles with a reference height.")]
    by_size: Annotated[
        int, Field(description="Roofs that have none because the model was chosen by its sizes.")
    ]
    left_out: Annotated[
        dict[str, int],
        Field(
            description="Left out by the review state alone, or (out_of_sample) by the survey's rule alone."
        ),
    ]
    without_class: Annotated[
        int, Field(description="Vehicles of which nobody said the class: no figure of a class counts them.")
    ]
    without_time: Annotated[
        int,
        Field(
            description="Vehicles left out because days or hours of filming are asked for and nobody has "
            "confirmed the start of their recording."
        ),
    ]


@dataclass(frozen=True, eq=False)
class Statistics:
    """Everything a statistics page shows; each target's shares are in the order of its `standards_of`.

    sight: an eye and an object by one standard's rules, which crests are computed from (`sight_pair`).
    of_chosen: whether classes are chosen, so that a rule is on those of its class alone that are.
    """

    counted: SampleCounts
    standards: tuple[Standard, ...]
    errors: Errors
    targets: dict[StatisticsTarget, Target]
    surveys: dict[int, str]
    operators: dict[int, str]
    rules: tuple[RuleToday, ...] = ()
    sight: tuple[RuleToday, RuleToday] | None = None
    known_errors: tuple[KnownErrors, ...] = ()
    lateral: Lateral | None = None
    comparison: ComparedSurveys | None = None
    of_chosen: bool = False


def survey_statistics(
    session: Session, chosen: Filter, choices: StatisticsOptions = StatisticsOptions()
) -> Statistics:
    """Error table, figures and distributions of the measurements that a filter leaves.

    Raises NotFound for a survey that is not there, BadInput for days in the wrong order.
    """
    return _compute_statistics(session, trail.head(session).hash, chosen, choices)


def measured_columns(session: Session, chosen: Filter) -> Measured:
    """What a filter leaves, of its target where it has one. Raises as `survey_statistics`."""
    wanted = _wanted(chosen, survey_names(session))
    days = chosen.first_day is not None or chosen.last_day is not None
    found, _ = filter_measured(_columns(session, trail.head(session).hash, wanted, days), chosen)
    return found.where(_of_target(found, chosen.target) & found.counts)


# The keys of what is kept hold the audit chain's last hash, so that any write makes it old.
@cached(LRUCache(16), key=lambda _session, *rest: rest, lock=Lock())
def _compute_statistics(
    session: Session, last_hash: str, chosen: Filter, choices: StatisticsOptions
) -> Statistics:
    everywhere = survey_names(session)
    wanted = _wanted(chosen, everywhere)
    places = {id_: place for id_, place in everywhere.items() if chosen.seen is None or id_ in chosen.seen}
    days = chosen.first_day is not None or chosen.last_day is not None
    found = _columns(session, last_hash, wanted, days)
    measured, left_out = filter_measured(found, chosen)
    named = _told_apart({one.id: one.name for one in list_people(session)})
    there = {int(one) for one in _distinct(found.operator_id)}
    operators = {id_: name for id_, name in named.items() if id_ in there}
    groupings = {
        "lighting": Grouping(measured.lighting, LIGHTING),
        "category": Grouping(measured.category, CATEGORIES),
        "class_set": Grouping(measured.class_set, CLASS_SETS),
        "site": _by_site(measured, places),
        "operator": _group_by_name(measured.operator_id, named),
    }
    choosable = {id_: name for id_, (name, _) in places.items()}
    if choices.standards is None:
        choices = replace(choices, standards=standards_of_surveys(session, wanted))
    return made_of(measured, left_out, chosen, choices, groupings, choosable, operators)


@cached(LRUCache(1), key=lambda _session, *rest: rest, lock=Lock())  # a million measurements take 110 MB
def _columns(session: Session, _last_hash: str, survey_ids: tuple[int, ...] | None, days: bool) -> Measured:
    return load_measured_columns(session, survey_ids, days=days)


def _wanted(chosen: Filter, places: Mapping[int, Any]) -> tuple[int, ...] | None:
    """The surveys that count: those that are named, else all that are seen; None for every one there is."""
    _refuse(chosen, places)
    if chosen.survey_ids:
        return chosen.survey_ids
    return None if chosen.seen is None or chosen.seen >= places.keys() else tuple(sorted(chosen.seen))


def _refuse(chosen: Filter, places: Mapping[int, Any]) -> None:
    if chosen.first_day and chosen.last_day and chosen.last_day < chosen.first_day:
        raise BadInput("results-days-exchanged")
    chosen.require_sense()
    for survey_id in chosen.survey_ids:
        if survey_id not in places or (chosen.seen is not None and survey_id not in chosen.seen):
            raise NotFound("results-no-survey", survey_id=survey_id)


@dataclass(frozen=True)
class LeftOut:
    """How many measurements a filter leaves out by their review state alone, or for being out of their
    survey's sample alone; and how many vehicles because nobody knows when they were filmed.
    """

    by_state: dict[str, int]
    without_time: int = 0


def filter_measured(measured: Measured, chosen: Filter) -> tuple[Measured, LeftOut]:
    """The measurements that a filter leaves, and what it leaves out. Those of check targets stay, for their
    errors.
    """
    keep = np.ones(len(measured), dtype=np.bool_)
    if chosen.lighting is not None:
        keep &= measured.lighting == LIGHTING.index(chosen.lighting)
    if chosen.of_classes:
        keep &= measured.of_classes(chosen.categories, chosen.class_sets)
    if chosen.operator_id is not None:
        keep &= measured.operator_id == chosen.operator_id
    if chosen.first_day is not None:
        keep &= measured.day >= (chosen.first_day - _EPOCH).days
    if chosen.last_day is not None:
        keep &= measured.day <= (chosen.last_day - _EPOCH).days
    wanted = np.isin(measured.verdict, [VERDICTS.index(word) for word in _STATES[chosen.state]])
    of_target = _of_target(measured, chosen.target)
    timeless = keep & wanted & of_target & measured.counts & (measured.filmed_hour == NONE)
    without_time = len(_distinct(measured.vehicle_id[timeless])) if chosen.limits_time else 0
    keep &= chosen.holding(measured.filmed_hour)
    others = measured.verdict[keep & ~wanted & of_target & measured.counts]
    counts = np.bincount(others, minlength=len(VERDICTS))
    left_out = {word: int(count) for word, count in zip(VERDICTS, counts, strict=True) if count}
    outside = keep & wanted & ~measured.counts & ~measured.check_target
    if count := int(np.count_nonzero(outside & of_target)):
        left_out[OUT_OF_SAMPLE] = count
    return measured.where(keep & wanted & ~outside), LeftOut(left_out, without_time)


def _of_target(measured: Measured, target: StatisticsTarget | None) -> NDArray[np.bool_]:
    if target is None:
        return np.ones(len(measured), dtype=np.bool_)
    return np.equal(measured.target, TARGETS.index(target))


def made_of(
    measured: Measured,
    left_out: LeftOut,
    chosen: Filter,
    choices: StatisticsOptions,
    groupings: Mapping[str, Grouping],
    named_surveys: dict[int, str],
    operators: dict[int, str],
) -> Statistics:
    """The statistics of columns (N,) that a filter left, divided by groupings (N,).

    Check targets have their own rows among the errors, and count nowhere else.
    """
    only = chosen.target
    checks, traffic = measured.where(measured.check_target), ~measured.check_target
    of_checks = groupings["site"].where(measured.check_target) if "site" in groupings else None
    measured = measured.where(traffic)
    groupings = {name: one.where(traffic) for name, one in groupings.items()}
    roofs = _roofs(measured, choices.u_reference_m, groupings.get("site"))
    table = STANDARDS if choices.standards is None else choices.standards
    against = (*table, *choices.own_standards)
    targets: dict[StatisticsTarget, Target] = {}
    sites = groupings.get("site")
    for name in SHOWN if only is None else (only,):
        rows = _of_target(measured, name)
        targets[name] = target_of(
            measured.height_m[rows],
            measured.uncorrected_height_m[rows],
            roofs,
            choices.correction,
            [one.height_m for one in standards_of(against, name)],
            {grouping: one.where(rows) for grouping, one in groupings.items()},
            height_sample(measured.where(rows), sites.where(rows) if sites else None),
        )
    vehicles = measured.vehicle_id[_of_target(measured, only)]
    unclassed = measured.category == NONE
    counted = SampleCounts(
        measurements=len(vehicles),
        vehicles=len(_distinct(vehicles)),
        with_reference=len(roofs.reference_m),
        by_size=int(np.count_nonzero(measured.by_size & _of_target(measured, "roof"))),
        left_out=left_out.by_state,
        without_time=left_out.without_time,
        without_class=len(_distinct(measured.vehicle_id[_of_target(measured, only) & unclassed])),
    )
    rules: tuple[RuleToday, ...] = ()
    sight = None
    if choices.correction == "inset" and only is None:
        rules, sight = _rules(measured, against, sites)
    errors = errors_of(roofs, choices.correction, choices.rounding)
    return Statistics(
        counted=counted,
        standards=against,
        errors=errors,
        targets=targets,
        surveys=named_surveys,
        operators=operators,
        known_errors=_known_errors(((measured, sites), (checks, of_checks)), choices),
        lateral=_lateral(measured.where(_of_target(measured, only))),
        rules=rules,
        sight=sight,
        comparison=compared_surveys(
            measured, {name: _of_target(measured, name) for name in targets}, named_surveys, height_sample
        ),
        of_chosen=chosen.of_classes,
    )


def _rules(
    measured: Measured, table: Sequence[Standard], sites: Grouping | None
) -> tuple[tuple[RuleToday, ...], tuple[RuleToday, RuleToday] | None]:
    """The rule of every standard that states one, on the heights of its class; of all, where no class is
    known.
    """
    stated = [one for one in table if one.percent is not None and one.what in RULE_OF]
    pair = sight_pair(table)
    asked = {one.what for one in (*stated, *(pair or ()))}
    of_each = {what: figures_of_rule(measured, what, sites) for what in asked}
    found = [rule_today(one, *of_each[one.what]) for one in stated]
    rules = tuple(one for one in found if one is not None)
    if pair is None:
        return rules, None
    eye, thing = (rule_today(one, *of_each[one.what]) for one in pair)
    return rules, None if eye is None or thing is None else (eye, thing)


def sight_pair(table: Sequence[Standard]) -> tuple[Standard, Standard] | None:
    """The first eye and object of one standard, else the first of each; where the standard states no rule,
    with that of AASHTO's heights.
    """
    eyes, objects = standards_of(table, "driver_eye"), standards_of(table, "taillight")
    if not eyes or not objects:
        return None
    same = ((eye, thing) for eye in eyes for thing in objects if eye.name == thing.name)
    eye, thing = next(same, (eyes[0], objects[0]))
    return (
        replace(eye, percent=eye.percent or _EYE_PERCENT),
        replace(thing, percent=thing.percent or _OBJECT_PERCENT),
    )


def figures_of_rule(
    measured: Measured, what: StandardHeight, sites: Grouping | None
) -> tuple[TotalUncertainty | None, bool]:
    """THE population that a standard's height is read on, ready for its figure: the heights of its target and
    class, of all where no class is known; None: there are none. Beside it: whether others were left out by
    class.
    """
    target, classes = RULE_OF[what]
    rows = _of_target(measured, target)
    by_class = bool(np.any(measured.category[rows] != NONE))
    if by_class:
        rows = rows & measured.of_classes(*classes)
    if not rows.any():
        return None, by_class
    sample = height_sample(measured.where(rows), sites.where(rows) if sites else None)
    return TotalUncertainty(sample), by_class


def sites_of(session: Session, measured: Measured) -> Grouping:
    """The sites of heights (N,), by name: the clusters of every figure of them."""
    return _by_site(measured, survey_names(session))


def _by_site(measured: Measured, places: Mapping[int, tuple[str, str]]) -> Grouping:
    return _group_by_name(measured.survey_id, {id_: site or name for id_, (name, site) in places.items()})


def _lateral(measured: Measured) -> Lateral:
    """Where the vehicles drive across the road; a lane is all that goes one way in the picture."""
    return lateral_positions(
        measured.across_m, measured.vehicle_id, measured.lane, measured.category, LANES, CATEGORIES
    )


def height_sample(
    measured: Heights, sites: Grouping | None = None, named_poses: Ints | None = None
) -> HeightSample:
    """Heights of one target with the parts of their uncertainty: which pose and which inset each one used.
    `named_poses`: (N,), where the poses of several packages have one number.
    """
    named = measured.pose_id if named_poses is None else named_poses
    poses, pose = np.unique(named, return_inverse=True)
    return sample_of_measurements(
        height_m=measured.height_m,
        u_height_m=measured.u_height_m,
        u_clicks_m=measured.u_clicks_m,
        u_by_inset_m=measured.u_by_inset_m,
        pose=pose.astype(np.int64),
        pose_names=poses.astype(np.int64),
        inset=inset_codes(measured.inset_m, measured.u_inset_m),
        site=None if sites is None else sites.code,
    )


def standards_of(table: Sequence[Standard], target: StatisticsTarget) -> list[Standard]:
    """The standards that a target is read against, in the order of its shares."""
    return [one for one in table if one.drawn and one.what == _WHAT.get(target)]


def _roofs(measured: Measured, u_reference_m: float, sites: Grouping | None) -> Roofs:
    """Roofs with a reference height, measured with and without their inset."""
    chosen = (
        (measured.target == TARGETS.index("roof"))
        & np.isfinite(measured.known_m)
        & np.isfinite(measured.uncorrected_height_m)
    )
    rows = measured.where(chosen)
    u = np.where(np.isfinite(rows.u_known_m), rows.u_known_m, u_reference_m)
    parts = height_sample(rows, sites.where(chosen) if sites else None)
    return Roofs(
        measured_m=rows.height_m,
        paper_m=rows.uncorrected_height_m,
        reference_m=rows.known_m,
        u_reference_m=u,
        lighting=_lighting_words(rows),
        parts=parts,
    )


def _lighting_words(rows: Measured) -> NDArray[np.str_]:
    """The lighting of each row (N,), "" where unknown."""
    return np.array([*LIGHTING, ""])[np.where(rows.lighting == NONE, len(LIGHTING), rows.lighting)]


_U_IS_CORRECTED = Said("stat-known-u-is-corrected")


def _known_errors(
    both: tuple[tuple[Measured, Grouping | None], tuple[Measured, Grouping | None]],
    choices: StatisticsOptions,
) -> tuple[KnownErrors, ...]:
    """Errors against known heights by target, of the traffic and then of check targets, each with their
    sites: those there are.
    """
    all_errors = []
    for (measured, sites), of_checks in zip(both, (False, True), strict=True):
        for code, target in enumerate(COMPARED):
            compared = _compared(measured, measured.target == code, sites, choices)
            if len(compared.known_m) == 0:
                continue
            errors = known_errors(target, of_checks, compared)
            all_errors.append(
                errors if choices.correction == "inset" else replace(errors, inside=_U_IS_CORRECTED)
            )
    return tuple(all_errors)


def _compared(
    measured: Measured, chosen: NDArray[np.bool_], sites: Grouping | None, choices: StatisticsOptions
) -> Compared:
    """The chosen heights (N,) with a known height, as the error table takes them."""
    chosen = chosen & np.isfinite(measured.known_m) & np.isfinite(measured.uncorrected_height_m)
    rows = measured.where(chosen)
    measured_m = rows.height_m if choices.correction == "inset" else rows.uncorrected_height_m
    sample = replace(height_sample(rows, sites.where(chosen) if sites else None), height_m=measured_m)
    category = np.array([*CATEGORIES, ""])[rows.category]  # the last place is for none
    return Compared(
        measured=sample,
        u_measured_m=rows.u_height_m,
        known_m=rows.known_m,
        u_known_m=rows.u_known_m,
        lighting=_lighting_words(rows).tolist(),
        category=category.tolist(),
    )


def _group_by_name(ids: NDArray[np.int64], names: Mapping[int, str]) -> Grouping:
    """Groups by name: what has the same name is one group."""
    distinct = _distinct(ids)
    words = sorted({names[int(one)] for one in distinct if int(one) in names})
    code = [words.index(names[int(one)]) if int(one) in names else NONE for one in distinct]
    return Grouping(np.array(code, dtype=np.int64)[np.searchsorted(distinct, ids)], words)


def _distinct(ids: NDArray[np.int64]) -> NDArray[np.int64]:
    """The different ids (N,), ascending; ids lie close together, so counting is quicker than sorting."""
    if len(ids) == 0 or ids.max() > 8 * len(ids) + 1000:
        return np.unique(ids)
    return np.flatnonzero(np.bincount(ids - NONE)) + NONE


def _told_apart(names: Mapping[int, str]) -> dict[int, str]:
    """Names of people; those who share one get their number."""
    often = Counter(names.values())
    return {id_: name if often[name] == 1 else f"{name} ({id_})" for id_, name in names.items()}
