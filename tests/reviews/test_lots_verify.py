"""The check of lots by itself: a lot told event by event, sound in each of its courses, then with one thing
another way, as who could write events, rows and hashes anew would leave it.
"""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import pytest

from sightline.errors import Damaged
from sightline.infra.audit.hashing import content_hash
from sightline.infra.csv_package.files import FolderFiles, Staging
from sightline.infra.csv_package.replay import Replay
from sightline.reviews.lots.csv import LOT_ITEMS, LOTS, ItemOfLot
from sightline.reviews.lots.draw import drawn_order, seed_of
from sightline.reviews.lots.judged import ItemNow, items_of
from sightline.reviews.lots.query import decision_of, lot_of
from sightline.reviews.lots.service import decided_items
from sightline.reviews.lots.verify import LotEvents, check_lots
from sightline.statistics.acceptance import RiskPoints, single_plan

SIZE, REVISION = 24, 2
HEAD, AT = "ab" * 32, "2026-11-27T09:00:00.000000+00:00"
HEIGHT_M, U95_M = 1.5, 0.030
RISKS = {"producer_quality": 0.01, "producer_risk": 0.1, "consumer_quality": 0.25, "consumer_risk": 0.2}
PLAN = single_plan(SIZE, RiskPoints(**RISKS))
DRAWN_BY, DECIDED_BY, TAKEN_BACK_BY = 10, 100, 200  # numbers of events


@dataclass(frozen=True)
class Verdict:
    """One verdict, given by event `event`; `lot`: of a verdict by lot."""

    number: int
    verdict: str
    event: int
    lot: int | None = None
    revision: int = REVISION
    result_revision: int = REVISION


@dataclass
class Told:
    """A lot as its events tell it. `moved_m`: what a fix, revision 3, moved a measurement by."""

    draw: dict[str, Any]
    decisions: list[tuple[int, dict[str, Any]]] = field(default_factory=list)
    verdicts: list[Verdict] = field(default_factory=list)
    moved_m: dict[int, float] = field(default_factory=dict)
    deleted: set[int] = field(default_factory=set)

    @property
    def order(self) -> list[int]:
        return [number for number, _ in self.draw["items"]]

    @property
    def sample(self) -> list[int]:
        return self.order[: PLAN.sample_size]

    @property
    def rest(self) -> list[int]:
        return self.order[PLAN.sample_size :]

    def judged(self, number: int, verdict: str, event: int = 50, result_revision: int = REVISION) -> None:
        """What the reviewer says of a measurement instead."""
        self.verdicts = [one for one in self.verdicts if one.number != number or one.lot]
        self.verdicts.append(Verdict(number, verdict, event, result_revision=result_revision))

    def check(self, folder: Path) -> None:
        """Check a package whose rows are what these events say. Raises Damaged."""
        events, replay = LotEvents(), Replay({"review": ("vehicle_id", "vehicle")})
        for n, one in enumerate(sorted(self.verdicts, key=lambda one: one.event), start=1):
            after = {"series_id": one.number, "vehicle_id": one.number, "lot_id": one.lot}
            after |= {name: getattr(one, name) for name in ("verdict", "revision", "result_revision")}
            event = {"entity": "review", "entity_id": str(n), "actor_id": "7", "number": str(one.event)}
            replay.add(event, after)
        for number in self.deleted:
            replay.row("vehicle", number)["deleted"] = True
        events.add("lot", 1, {"number": DRAWN_BY, "previous_hash": HEAD}, hashed(self.draw))
        for n, (event_number, decision) in enumerate(self.decisions, start=1):
            event = {"number": event_number, "previous_hash": HEAD}
            events.add("lot_decision", n, event, hashed(decision))
        self._write(Staging(folder), events)
        check_lots(FolderFiles(folder), events, replay, {number: number for number in self.order})

    def _write(self, staging: Staging, events: LotEvents) -> None:
        lot = lot_of(events.draws[1], "", {}, [decision_of(one, "") for one in events.decisions.get(1, ())])
        staging.fill(LOTS, [lot])
        now = [ItemNow(number, rev, n, rev) for n, (number, rev) in enumerate(self.draw["items"], start=1)]
        items = decided_items(lot, now) if lot.decisions else items_of(now, lot.sample_size)
        there = [ItemOfLot(lot, one) for one in items if one.measurement_id not in self.deleted]
        staging.fill(LOT_ITEMS, there)
        lines = ["measurement_id,revision,height_m,U95_height_m"]
        for number in sorted(set(self.order) - self.deleted):
            for revision, moved in ((REVISION, 0.0), (REVISION + 1, self.moved_m.get(number))):
                if moved is not None:
                    lines.append(f"{number},{revision},{HEIGHT_M + moved:.6f},{U95_M:.6f}")
        staging.add("revisions.csv", "\n".join([*lines, ""]).encode())


def hashed(row: dict[str, Any]) -> dict[str, Any]:
    """An event's content with the hash of its row."""
    content = {name: value for name, value in row.items() if name != "items"}
    return {**row, "content_sha256": content_hash(content)}


def a_lot() -> Told:
    """A lot that was drawn and not yet decided, its sample judged."""
    items = [(number, REVISION) for number in range(1, SIZE + 1)]
    seed = seed_of(HEAD, items)
    draw = {"survey_id": 1, "number": 1, "common": {"target": "roof"}, "size": SIZE, "seed": seed, **RISKS}
    draw |= {"sample_size": PLAN.sample_size, "acceptance_number": PLAN.acceptance_number}
    draw |= {"created_at": AT, "created_by": 7}
    draw["items"] = [[one, REVISION] for one in drawn_order(seed, range(1, SIZE + 1))]
    told = Told(draw)
    told.verdicts = [Verdict(number, "accepted", 20) for number in told.sample]
    return told


def decide(told: Told, choice: str, event: int = DECIDED_BY, **otherwise: Any) -> None:
    """A decision with the counts of a sample that was accepted whole."""
    n = PLAN.sample_size
    made = {"lot_id": 1, "choice": choice, "judged": n, "nonconforming": 0, "rest": SIZE - n}
    made |= {"sample": told.sample, "left_out": {}, "created_at": AT, "created_by": 7}
    told.decisions.append((event, {**made, **otherwise}))


def accepted() -> Told:
    """A lot that was accepted by its sample, with its verdicts by lot."""
    told = a_lot()
    decide(told, "accepted")
    told.verdicts += [Verdict(number, "accepted", DECIDED_BY + 1, lot=1) for number in told.rest]
    return told


def taken_back() -> Told:
    """One that was accepted and taken back as a whole."""
    told = accepted()
    decide(told, "taken_back", TAKEN_BACK_BY)
    told.verdicts += [Verdict(number, "reopened", TAKEN_BACK_BY + 1, lot=1) for number in told.rest]
    return told


def undecided(choice: str) -> Callable[[], Told]:
    def made() -> Told:
        told = a_lot()
        decide(told, choice)
        return told

    return made


@pytest.mark.parametrize(
    "course",
    [a_lot, accepted, taken_back, undecided("full_inspection"), undecided("dissolved")],
    ids=["open", "accepted", "taken back", "full inspection", "dissolved"],
)
def test_a_lot_that_is_what_its_events_say_is_sound(course: Callable[[], Told], tmp_path: Path) -> None:
    course().check(tmp_path)


def refused(told: Told, folder: Path) -> str:
    """The case that the check names."""
    with pytest.raises(Damaged) as error:
        told.check(folder)
    return error.value.code


Change = Callable[[Told], Any]
_DRAW: dict[str, tuple[Change, str]] = {
    "another seed": (lambda told: told.draw.update(seed="cd" * 32), "lots-seed-differs"),
    "another revision drawn": (
        lambda told: told.draw["items"].__setitem__(0, [told.order[0], REVISION + 1]),
        "lots-seed-differs",
    ),
    "two exchanged": (lambda told: told.draw["items"].reverse(), "lots-order-differs"),
    "more than it says": (lambda told: told.draw.update(size=SIZE - 1), "lots-order-differs"),
    "too small a sample": (lambda told: told.draw.update(sample_size=1), "lots-plan-risk"),
    "too mild a plan": (
        lambda told: told.draw.update(acceptance_number=PLAN.acceptance_number + 1),
        "lots-plan-risk",
    ),
}


@pytest.mark.parametrize("change", _DRAW)
def test_a_draw_that_somebody_chose_is_refused(change: str, tmp_path: Path) -> None:
    told, (alter, code) = a_lot(), _DRAW[change]
    alter(told)
    assert refused(told, tmp_path) == code


def _decision(told: Told) -> dict[str, Any]:
    return told.decisions[0][1]


_DECIDED: dict[str, tuple[Change, str]] = {
    "decided twice": (lambda told: decide(told, "accepted", 150), "lots-decided-otherwise"),
    "taken back first": (
        lambda told: told.decisions.insert(0, (90, {**_decision(told), "choice": "taken_back"})),
        "lots-decided-otherwise",
    ),
    "a sample without its last": (
        lambda told: _decision(told).update(sample=told.sample[:-1]),
        "lots-sample-differs",
    ),
    "a smaller rest": (lambda told: _decision(told).update(rest=0), "lots-sample-differs"),
    "one left that was judged": (
        lambda told: _decision(told).update(left_out={str(told.sample[0]): "withdrawn"}),
        "lots-sample-differs",
    ),
    "fewer judged": (
        lambda told: _decision(told).update(judged=PLAN.sample_size - 1),
        "lots-counts-differ",
    ),
    "more nonconforming": (
        lambda told: _decision(told).update(nonconforming=1),
        "lots-counts-differ",
    ),
    "one rejected and not counted": (
        lambda told: told.judged(told.sample[0], "rejected"),
        "lots-counts-differ",
    ),
    "judged before the draw": (
        lambda told: told.judged(told.sample[0], "accepted", event=DRAWN_BY - 1),
        "lots-counts-differ",
    ),
    "judged after the decision": (
        lambda told: told.judged(told.sample[0], "accepted", event=DECIDED_BY + 1),
        "lots-counts-differ",
    ),
}


@pytest.mark.parametrize("change", _DECIDED)
def test_a_decision_that_does_not_follow_from_the_sample_is_refused(change: str, tmp_path: Path) -> None:
    told, (alter, code) = accepted(), _DECIDED[change]
    alter(told)
    assert refused(told, tmp_path) == code


def test_a_lot_with_more_nonconforming_ones_than_its_plan_allows_is_not_accepted(tmp_path: Path) -> None:
    told = accepted()
    bad = told.sample[: PLAN.acceptance_number + 1]
    for number in bad:
        told.judged(number, "rejected")
    _decision(told)["nonconforming"] = len(bad)
    assert refused(told, tmp_path) == "lots-beyond-plan"


def test_a_lot_whose_sample_is_not_judged_whole_is_not_accepted(tmp_path: Path) -> None:
    told = accepted()
    told.verdicts = [one for one in told.verdicts if one.number != told.sample[0]]
    _decision(told)["judged"] = PLAN.sample_size - 1
    assert refused(told, tmp_path) == "lots-beyond-plan"


# A fix of a height conforms if it moved it by no more than its U95; lengths are written to the micrometre.
@pytest.mark.parametrize(
    ("moved_m", "counts"),
    [(0.0, {0}), (0.5 * U95_M, {0}), (-2 * U95_M, {1}), (2 * U95_M, {1}), (U95_M + 1e-6, {0, 1})],
)
def test_a_fix_counts_by_how_far_it_moved_the_height(
    moved_m: float, counts: set[int], tmp_path: Path
) -> None:
    for count in (0, 1):
        told = undecided("full_inspection")()
        told.judged(told.sample[0], "fixed", result_revision=REVISION + 1)
        told.moved_m[told.sample[0]] = moved_m
        _decision(told)["nonconforming"] = count
        if count in counts:
            told.check(tmp_path / str(count))
        else:
            assert refused(told, tmp_path / str(count)) == "lots-counts-differ"


def test_what_a_fix_of_a_deleted_vehicle_counted_as_nobody_can_tell_but_a_rejection_is_one(
    tmp_path: Path,
) -> None:
    for count in (0, 1):
        told = undecided("full_inspection")()
        told.judged(told.sample[0], "fixed", result_revision=REVISION + 1)
        told.deleted.add(told.sample[0])
        _decision(told)["nonconforming"] = count
        told.check(tmp_path / str(count))
        told.judged(told.sample[0], "rejected")
        if count == 1:
            told.check(tmp_path / "rejected")
        else:
            assert refused(told, tmp_path / "rejected, not counted") == "lots-counts-differ"


def test_a_verdict_that_was_reopened_waits_again(tmp_path: Path) -> None:
    told = undecided("full_inspection")()
    told.verdicts.append(Verdict(told.sample[0], "reopened", 30))
    assert refused(told, tmp_path / "waits") == "lots-counts-differ"
    _decision(told)["judged"] -= 1
    told.check(tmp_path / "counted")


def without_the_last(told: Told, verdict: str) -> None:
    """One verdict by lot fewer."""
    last = [one for one in told.verdicts if one.lot and one.verdict == verdict][-1]
    told.verdicts.remove(last)


def one_more(told: Told, **otherwise: Any) -> None:
    """One verdict by lot more, or another in place of the first."""
    by_lot = next(one for one in told.verdicts if one.lot)
    told.verdicts.append(replace(by_lot, **otherwise))


def instead(told: Told, **otherwise: Any) -> None:
    by_lot = next(one for one in told.verdicts if one.lot)
    told.verdicts[told.verdicts.index(by_lot)] = replace(by_lot, **otherwise)


_BY_LOT: dict[str, tuple[Callable[[], Told], Change, str]] = {
    "of a lot that is not there": (accepted, lambda told: one_more(told, lot=2), "lots-verdict-without-lot"),
    "one missing": (accepted, lambda told: without_the_last(told, "accepted"), ""),
    "one twice": (accepted, one_more, ""),
    "on the sample": (accepted, lambda told: one_more(told, number=told.sample[0]), ""),
    "on another revision": (accepted, lambda told: instead(told, revision=REVISION + 1), ""),
    "rejected by lot": (accepted, lambda told: one_more(told, verdict="rejected"), ""),
    "of an open lot": (
        a_lot,
        lambda told: told.verdicts.append(Verdict(told.rest[0], "accepted", 60, 1)),
        "",
    ),
    "of an inspected one": (
        undecided("full_inspection"),
        lambda told: told.verdicts.append(Verdict(told.rest[0], "accepted", 160, 1)),
        "",
    ),
    "reopened, not taken back": (accepted, lambda told: one_more(told, verdict="reopened"), ""),
    "one not taken back": (taken_back, lambda told: without_the_last(told, "reopened"), ""),
    "before the decision": (
        accepted,
        lambda told: instead(told, event=DECIDED_BY - 1),
        "lots-verdict-too-early",
    ),
}


@pytest.mark.parametrize("change", _BY_LOT)
def test_verdicts_by_lot_are_those_of_its_rest_and_no_others(change: str, tmp_path: Path) -> None:
    course, alter, code = _BY_LOT[change]
    told = course()
    alter(told)
    assert refused(told, tmp_path) == (code or "lots-rest-differs")


def test_an_event_whose_row_is_not_the_one_it_hashed_is_refused() -> None:
    told = {**hashed(a_lot().draw), "acceptance_number": 9}
    with pytest.raises(Damaged) as error:
        LotEvents().add("lot", 1, {"number": DRAWN_BY, "previous_hash": HEAD}, told)
    assert error.value.code == "lots-event-another-row"
