"""What repeats say of a survey: figures per target and person, differences, and people's own click sigma."""

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import groupby
from math import dist, hypot
from random import Random
from statistics import fmean
from typing import Annotated

from pydantic import Field

from sightline.coverage import expanded
from sightline.enums import Point, Target
from sightline.errors import BadInput
from sightline.infra.audit.records import Who
from sightline.infra.database import Session
from sightline.measurements.click_sigma_store import choose_click_sigma, list_click_sigmas
from sightline.measurements.records import ClickSigma, Measurement
from sightline.measurements.store import get_measurement
from sightline.messages.said import Said
from sightline.people.store import get_person
from sightline.quality.repeats.clicks import Click, clicks_of_survey, height_of_first_frame
from sightline.quality.repeats.query import (
    Blind,
    list_blind,
    measurements_to_click_again,
    repeats_of_measurement,
)
from sightline.statistics.repeatability import (
    LEAST_FREEDOM,
    Gauge,
    Spread,
    UncertaintyCheck,
    codes_of,
    gauge,
    no_spread,
    spread_of,
    uncertainty_check,
    within_cells,
)

LEAST_PAIRS = 10
# A wheelbase is 60 px and more on any vehicle that can be measured; a click is off by a few.
SAME_WHEEL_PX = 25.0


@dataclass(frozen=True)
class OfTarget:
    """Figures of one target in metres; `target` None: of all (a person may lean otherwise at each target).

    `another_frame`: the same person on another frame of the pass, which adds to the clicks what the place in
    the picture does to lens, camera pose and inset, and how the vehicle sways.
    """

    target: Annotated[Target | None, Field(description="None: all targets together.")]
    gauge: Gauge
    uncertainty_check: UncertaintyCheck
    another_frame: Annotated[Spread, Field(description="The same person on another frame of the pass, m.")]


@dataclass(frozen=True)
class OfPerson:
    """Figures of one person: heights (m) and clicks (px) of their own repeats; their leaning against others.

    pairs: how often they clicked again what they had clicked themselves; sigma: of clicks that would make
    heights scatter as theirs do; operator_bias_m: their heights minus the others' of the same `items`, mean,
    None below 5.
    """

    person: Who
    pairs: Annotated[int, Field(description="How often they clicked their own measurements again.")]
    heights: Annotated[Spread, Field(description="Of their own repeats, m.")]
    contact: Annotated[Spread, Field(description="Each coordinate, px.")]
    target_point: Annotated[Spread, Field(description="Each coordinate, px.")]
    sigma: Annotated[Spread, Field(description="Of clicks that make heights scatter as theirs do, px.")]
    operator_bias_m: Annotated[
        float | None, Field(description="Their heights minus the others' of the same items, mean.")
    ]
    items: Annotated[int, Field(description="Items that they and others clicked.")]
    chosen: ClickSigma | None
    may_choose: bool


@dataclass(frozen=True)
class Difference:
    """A repeat minus what it repeats, and their mean, metres; `expected_m`: twice the u of both clicks."""

    first_id: int
    repeat_id: int
    vehicle_id: int
    target: Target
    first_person: Who
    person: Who
    mean_m: float
    difference_m: float
    expected_m: float


@dataclass(frozen=True)
class Findings:
    """All that the repeats of a survey say. `not_compared`: those of another pose or inset, or no height."""

    repeats: int
    targets: tuple[OfTarget, ...]
    people: tuple[OfPerson, ...]
    differences: tuple[Difference, ...]
    not_compared: Annotated[
        int, Field(description="Repeats with another camera pose or inset, or without height.")
    ]


@dataclass(frozen=True, kw_only=True)
class Compared:
    """How a repeat differs from the measurement that it repeats; or the reason why they do not compare."""

    first_height_m: float | None
    difference_m: float | None = None
    expected_m: float | None = None
    agrees: bool | None = None
    reason: Said | None = None


@dataclass(frozen=True, kw_only=True)
class Comparison(Compared):
    """A repeat beside the measurement that it repeats."""

    repeat: Measurement


def findings(session: Session, survey_id: int) -> Findings:
    """The figures of a survey's repeats; those that too few repeats cannot give have their reason."""
    clicks = clicks_of_survey(session, survey_id)
    persons = sorted({one.person for one in clicks}, key=lambda who: (who.name, who.id))
    chosen = {one.person.id: one for one in list_click_sigmas(session, survey_id) if one.person}
    targets: list[Target | None] = [None, *sorted({one.target for one in clicks})] if clicks else []
    repeated = [one for one in clicks if one.measurement_id != one.first_id]
    differences = tuple(_differences(clicks))
    return Findings(
        repeats=len(repeated),
        targets=tuple(_of_target(clicks, target) for target in targets),
        people=tuple(_of_person(clicks, person, chosen.get(person.id)) for person in persons),
        differences=differences,
        not_compared=len(repeated) - len(differences) - len(_elsewhere(clicks)),
    )


def comparisons(session: Session, measurement_id: int) -> tuple[Comparison, ...]:
    """The standing repeats of a measurement, each against its current revision."""
    first = get_measurement(session, measurement_id)
    height_m, u_m = height_of_first_frame(session, first)
    return tuple(
        _comparison(session, first, height_m, u_m, one)
        for one in repeats_of_measurement(session, measurement_id)
    )


def sample(
    session: Session, survey_id: int, *, person_id: int, count: int, only_own: bool
) -> tuple[Blind, ...]:
    """At most `count` measurements for a person to click again, in random order; unrepeated ones first."""
    fresh, known = measurements_to_click_again(session, survey_id, person_id=person_id, only_own=only_own)
    draw = Random(f"{person_id} {len(known)} {len(fresh)}")  # the same until something is clicked
    chosen = draw.sample(fresh, min(count, len(fresh)))
    return list_blind(session, chosen + draw.sample(known, min(count - len(chosen), len(known))))


def use_own_sigma(session: Session, survey_id: int, person_id: int, *, own: bool, actor: int) -> ClickSigma:
    """From now on a person's clicks count with the sigma of their repeats, or with the usual one again.

    Raises NotFound, BadInput below 10 own repeats.
    """
    if not own:
        return choose_click_sigma(session, survey_id, person_id, sigma_px=None, pairs=0, actor=actor)
    who = get_person(session, person_id)
    person_clicks = _of_person(clicks_of_survey(session, survey_id), Who(who.id, who.name), None)
    if not person_clicks.may_choose or person_clicks.sigma.sd is None:
        raise BadInput(
            "quality-repeats-too-few", name=who.name, pairs=person_clicks.pairs, least_pairs=LEAST_PAIRS
        )
    sigma_px = round(person_clicks.sigma.sd, 3)
    return choose_click_sigma(
        session, survey_id, person_id, sigma_px=sigma_px, pairs=person_clicks.pairs, actor=actor
    )


def _of_target(clicks: Sequence[Click], target: Target | None) -> OfTarget:
    usable = [one for one in clicks if target in (None, one.target) and one.height_m is not None]
    heights = [one.height_m for one in usable]
    items = codes_of([one.item for one in usable])
    # One person may lean up at roofs and down at eyes.
    persons = codes_of([(one.person.id, one.target) for one in usable])
    u_clicks = [one.u_clicks_m for one in usable]
    often = Counter(one.item for one in usable)
    people = {one.person.id for one in usable if often[one.item] > 1}  # each once, not by target
    found = replace(gauge(_floats(heights), items, persons), persons=len(people))
    claimed = uncertainty_check(_floats(heights), _floats(u_clicks), items)
    return OfTarget(target, found, claimed, _another_frame(usable))


def _another_frame(clicks: Sequence[Click]) -> Spread:
    """Of one person's heights of one target, each frame's mean once."""
    cells, heights = [], []
    for name, found in _group_clicks(clicks, lambda one: (*one.framed, one.person.id, one.frame)):
        cells.append(name[:-1])
        heights.append(fmean(_floats([one.height_m for one in found])))
    sums = within_cells(heights, codes_of(cells))
    return spread_of(*sums, Said("repeats-few-other-frame", count=sums[1], least=LEAST_FREEDOM))


def _elsewhere(clicks: Sequence[Click]) -> list[Click]:
    """Repeats with a height on another frame than what they repeat, alike in all else."""
    firsts = {click.first_id: click for click in clicks if click.measurement_id == click.first_id}
    return [
        click
        for click in clicks
        if (first := firsts.get(click.first_id))
        and first.frame != click.frame
        and first.framed == click.framed
        and None not in (first.height_m, click.height_m)
    ]


def _floats(values: Sequence[float | None]) -> list[float]:
    return [float("nan") if value is None else value for value in values]


def _of_person(clicks: Sequence[Click], person: Who, chosen: ClickSigma | None) -> OfPerson:
    own = [one for one in clicks if one.person.id == person.id]
    points = within_cells(
        [one.target_point for one in own], codes_of([(one.first_id, one.frame) for one in own])
    )
    contacts = _contacts(own)
    measured = [one for one in own if one.height_m is not None]
    heights = within_cells(
        _floats([one.height_m for one in measured]), codes_of([one.item for one in measured])
    )
    pairs = points[1] // 2
    few = Said("repeats-few-own", name=person.name, pairs=pairs, least=LEAST_FREEDOM)
    enough = pairs >= LEAST_FREEDOM
    contact, target = (
        spread_of(*one, few) if enough else no_spread(few, one[1]) for one in (contacts, points)
    )
    # A click along an edge moves no height: the sigma is what the heights show.
    shown = uncertainty_check(
        _floats([one.height_m for one in measured]),
        _floats([one.u_pixel_m for one in measured]),
        codes_of([one.item for one in measured]),
    )
    sigma = Spread(shown.ratio, shown.low, shown.high, shown.freedom, shown.reason)
    biases = list(_operator_bias(clicks, person))
    return OfPerson(
        person=person,
        pairs=pairs,
        heights=spread_of(*heights, few),
        contact=contact,
        target_point=target,
        sigma=sigma if enough else no_spread(few, shown.freedom),
        operator_bias_m=sum(biases) / len(biases) if len(biases) >= LEAST_FREEDOM else None,
        items=len(biases),
        chosen=chosen,
        may_choose=pairs >= LEAST_PAIRS and bool(sigma.sd),
    )


def _contacts(own: Sequence[Click]) -> tuple[float, int]:
    """(sum of squares, degrees of freedom) of the contacts; one that several targets share counts once.

    Contacts too far apart for one wheel are of two (either will do for a height) and not compared.
    """
    clicked = sorted({((one.vehicle_id, one.frame, one.first_contact), one.contact) for one in own})
    wheels: list[tuple[object, Point]] = []
    cells = [_wheel(wheels, at, contact) for at, contact in clicked]
    return within_cells([contact for _, contact in clicked], codes_of(cells))


def _wheel(wheels: list[tuple[object, Point]], at: object, contact: Point) -> int:
    """The number of the wheel that was clicked; a new one joins the list."""
    for number, (where, known) in enumerate(wheels):
        if where == at and dist(known, contact) < SAME_WHEEL_PX:
            return number
    wheels.append((at, contact))
    return len(wheels) - 1


def _operator_bias(clicks: Sequence[Click], person: Who) -> Iterator[float]:
    """Mean height of the person minus that of the others, of each item that both clicked."""
    for _, found in _group_clicks(clicks, lambda one: one.item):
        own = [one.height_m for one in found if one.person.id == person.id and one.height_m is not None]
        others = [one.height_m for one in found if one.person.id != person.id and one.height_m is not None]
        if own and others:
            yield sum(own) / len(own) - sum(others) / len(others)


def _group_clicks(
    clicks: Sequence[Click], key: Callable[[Click], tuple[float, ...]]
) -> Iterator[tuple[tuple[float, ...], list[Click]]]:
    for name, found in groupby(sorted(clicks, key=key), key):
        yield name, list(found)


def _differences(clicks: Sequence[Click]) -> Iterator[Difference]:
    firsts = {click.first_id: click for click in clicks if click.measurement_id == click.first_id}
    for click in clicks:
        first = firsts.get(click.first_id)
        if first is None or first is click or first.item != click.item:
            continue
        if None in (first.height_m, click.height_m, first.u_clicks_m, click.u_clicks_m):
            continue
        a, b, u_a, u_b = _floats([first.height_m, click.height_m, first.u_clicks_m, click.u_clicks_m])
        yield Difference(
            first_id=first.measurement_id,
            repeat_id=click.measurement_id,
            vehicle_id=click.vehicle_id,
            target=click.target,
            first_person=first.person,
            person=click.person,
            mean_m=(a + b) / 2,
            difference_m=b - a,
            expected_m=expanded(hypot(u_a, u_b)),
        )


def _comparison(
    session: Session, first: Measurement, height_m: float | None, u_m: float | None, repeat: Measurement
) -> Comparison:
    again_m, u_again_m = height_of_first_frame(session, repeat)
    reason = _not_alike(first, repeat, height_m, again_m)
    if reason or height_m is None or again_m is None or u_m is None or u_again_m is None:
        reason = reason or Said("repeat-no-uncertainty")
        return Comparison(repeat=repeat, first_height_m=height_m, reason=reason)
    difference, expected = again_m - height_m, expanded(hypot(u_m, u_again_m))
    return Comparison(
        repeat=repeat,
        first_height_m=height_m,
        difference_m=difference,
        expected_m=expected,
        agrees=abs(difference) <= expected,
    )


def _not_alike(
    first: Measurement, repeat: Measurement, height_m: float | None, again_m: float | None
) -> Said | None:
    if height_m is None:
        return Said("repeat-first-no-height", reason=first.values.reason)
    if again_m is None:
        return Said("repeat-second-no-height", reason=repeat.values.reason)
    if first.values.frame != repeat.values.frame:
        return Said("repeat-other-frame")
    if first.values.pose_id != repeat.values.pose_id:
        return Said("repeat-other-pose")
    if first.values.inset_m != repeat.values.inset_m:
        return Said("repeat-other-inset")
    return None
