"""Holding the lots of a package against the audit chain: draw, sample and verdicts by lot."""

from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime
from itertools import product
from typing import Any

from sightline.errors import Damaged
from sightline.infra.audit.hashing import content_hash
from sightline.infra.csv_package.files import Files, read_columns
from sightline.infra.csv_package.files import number as figure_of
from sightline.infra.csv_package.replay import Replay, hold_all, values_of
from sightline.reviews.lots.csv import LOT_ITEMS, LOTS, ItemOfLot
from sightline.reviews.lots.draw import drawn_order, seed_of
from sightline.reviews.lots.judged import ItemNow, Judgement, items_of
from sightline.reviews.lots.query import decision_of, lot_of
from sightline.reviews.lots.records import Lot, LotItem
from sightline.reviews.lots.service import decided_items
from sightline.statistics.acceptance import accepted_with, best_bad, worst_good

_HAIR = 1e-6
_LENGTH_M = 2e-6  # two heights and a U95 of six decimals
Event = Mapping[str, Any]
Heights = Mapping[int, Mapping[int, tuple[float | None, float | None]]]


@dataclass(eq=False)
class LotEvents:
    """What the chain says of lots: draws and decisions by number, each with its event's own number."""

    draws: dict[int, dict[str, Any]] = field(default_factory=dict)
    decisions: dict[int, list[dict[str, Any]]] = field(default_factory=lambda: defaultdict(list))

    def add(self, entity: str, row_id: int, event: Event, after: Mapping[str, Any]) -> None:
        """An event of a lot or of a decision. Raises Damaged where its row is not the one it hashed."""
        apart = ("content_sha256", "items")
        row = {name: value for name, value in after.items() if name not in apart}
        if content_hash(row) != after["content_sha256"]:
            raise Damaged("lots-event-another-row", number=event["number"])
        entry = {**after, "id": row_id, "event": int(event["number"]), "head": event["previous_hash"]}
        entry["created_at"] = datetime.fromisoformat(after["created_at"])
        if entity == "lot":
            self.draws[row_id] = entry
        else:
            self.decisions[int(after["lot_id"])].append(entry)


def check_lots(files: Files, events: LotEvents, replay: Replay, vehicle_of: Mapping[int, int]) -> None:
    """Every lot is that of its event, drawn as its seed says, decided as its sample's verdicts say, and its
    verdicts are those of its rest. `vehicle_of`: of a measurement.

    Raises Damaged.
    """
    lots = {id_: _lot(draw, events.decisions.get(id_, ())) for id_, draw in events.draws.items()}
    hold_all(files, LOTS, (values_of(LOTS, lot) for lot in lots.values()))
    heights = _heights(files, {int(number) for one in events.draws.values() for number, _ in one["items"]})
    by_lot: dict[int, list[Event]] = defaultdict(list)
    by_series: dict[int, list[Event]] = defaultdict(list)
    for _, review in sorted(replay.of("review").items()):
        if review.get("lot_id") is not None:
            by_lot[int(review["lot_id"])].append(review)
        else:
            by_series[int(review["series_id"])].append(review)
    if strange := set(by_lot) - set(lots):
        raise Damaged("lots-verdict-without-lot", lot=min(strange))

    def there(number: int) -> bool:
        return not replay.is_gone("vehicle", vehicle_of[number])

    items: dict[int, tuple[LotItem, ...]] = {}
    for id_, lot in lots.items():
        draw, decisions = events.draws[id_], events.decisions.get(id_, ())
        _check_draw(lot, draw)
        now = [ItemNow(number, rev, place, rev) for place, (number, rev) in enumerate(draw["items"], 1)]
        items[id_] = decided_items(lot, now) if lot.decisions else items_of(now, lot.sample_size)
        _check_decisions(lot, draw, decisions, by_series, heights, there, items[id_])
        _check_verdicts(lot, decisions, by_lot.get(id_, ()), items[id_])
    listed = (ItemOfLot(lots[id_], one) for id_, found in items.items() for one in found)
    standing = (values_of(LOT_ITEMS, one) for one in listed if there(one.item.measurement_id))
    hold_all(files, LOT_ITEMS, standing)


def _lot(draw: Event, decisions: Sequence[Event]) -> Lot:
    return lot_of(draw, "", {}, [decision_of(one, "") for one in decisions])


def _heights(files: Files, wanted: set[int]) -> Heights:
    by_measurement: dict[int, dict[int, tuple[float | None, float | None]]] = defaultdict(dict)
    columns = ("measurement_id", "revision", "height_m", "U95_height_m")
    for number, revision, height, u95 in read_columns(files, "revisions.csv", columns):
        if int(number) in wanted:
            by_measurement[int(number)][int(revision)] = (figure_of(height), figure_of(u95))
    return by_measurement


def _check_draw(lot: Lot, draw: Event) -> None:
    """The seed is the chain's, the order the seed's, and the plan keeps both risks that it promises."""
    items = [(int(number), int(revision)) for number, revision in draw["items"]]
    if seed_of(draw["head"], items) != lot.seed:
        raise Damaged("lots-seed-differs", id=lot.id)
    numbers = [number for number, _ in items]
    if drawn_order(lot.seed, numbers) != numbers or len(set(numbers)) != lot.size or len(items) != lot.size:
        raise Damaged("lots-order-differs", id=lot.id)
    plan = (lot.sample_size, lot.acceptance_number)
    refused = 1.0 - accepted_with(lot.size, worst_good(lot.size, lot.risks), *plan)
    passed = accepted_with(lot.size, best_bad(lot.size, lot.risks), *plan)
    if refused > lot.risks.producer_risk + _HAIR or passed > lot.risks.consumer_risk + _HAIR:
        raise Damaged("lots-plan-risk", id=lot.id)


def _check_decisions(
    lot: Lot,
    draw: Event,
    decisions: Sequence[Event],
    by_series: Mapping[int, Sequence[Event]],
    heights: Heights,
    there: Callable[[int], bool],
    items: Sequence[LotItem],
) -> None:
    """One decision, and after an acceptance one that took it back; its sample is the first of the draw that
    did not leave, its counts are those of their verdicts between draw and decision.
    """
    if not decisions:
        return
    first = lot.decisions[0]
    if [one["choice"] for one in decisions] not in _COURSES:
        raise Damaged("lots-decided-otherwise", id=lot.id)
    left = set(first.left_out)
    drawn = [item.measurement_id for item in items if item.measurement_id not in left]
    if list(first.sample) != drawn[: lot.sample_size] or first.rest != len(drawn) - len(first.sample):
        raise Damaged("lots-sample-differs", id=lot.id)
    span = (int(draw["event"]), int(decisions[0]["event"]))
    least, most, judged, perhaps = 0, 0, 0, 0
    for item in items:
        if item.role != "sample":
            continue
        said = [each for each in by_series.get(item.measurement_id, ()) if span[0] < each["event"] < span[1]]
        conforming = _conforming(
            item, said, heights.get(item.measurement_id) if there(item.measurement_id) else None
        )
        judged += None not in conforming
        perhaps += conforming != {None}
        least += conforming == {False}
        most += False in conforming
    if not judged <= first.judged <= perhaps or not least <= first.nonconforming <= most:
        raise Damaged("lots-counts-differ", id=lot.id)
    enough = first.judged == len(first.sample) > 0 and first.nonconforming <= lot.acceptance_number
    if first.choice == "accepted" and not enough:
        raise Damaged("lots-beyond-plan", id=lot.id)


_COURSES = (["accepted"], ["full_inspection"], ["dissolved"], ["accepted", "taken_back"])


def _conforming(
    item: LotItem, events: Sequence[Event], heights: Mapping[int, tuple[float | None, float | None]] | None
) -> set[bool | None]:
    """What the verdicts may say of an item: None where nobody judged it; more where a fix moved it by just
    about its U95, where its heights are not in the package any more (its vehicle was deleted), or where a
    reopened one changed, before the decision or after it.
    """
    verdicts = [
        Judgement(int(each["revision"]), int(each["result_revision"]), each["verdict"]) for each in events
    ]
    answers: set[bool | None] = set()
    said_of = _revisions(item, verdicts)
    newest = max(said_of)
    changes = (0, 1) if heights is None or max(heights) > newest else (0,)
    hairs = (-_LENGTH_M, _LENGTH_M) if heights is not None else (-1e9, 1e9)
    for hair, change in product(hairs, changes):
        known = heights if heights is not None else {each: (0.0, 0.0) for each in said_of}
        moved = {each: (height, None if u95 is None else u95 + hair) for each, (height, u95) in known.items()}
        now = ItemNow(
            measurement_id=item.measurement_id,
            revision=item.revision,
            place=1,
            newest=newest + change,
            said=verdicts,
            heights=moved,
        )
        answers.add(items_of([now], 1)[0].conforming)
    return answers


def _revisions(one: LotItem, verdicts: Sequence[Judgement]) -> set[int]:
    return {one.revision, *(each.result_revision for each in verdicts)}


def _check_verdicts(
    lot: Lot, decisions: Sequence[Event], given: Sequence[Event], items: Sequence[LotItem]
) -> None:
    """An accepted lot gave its verdict to each of its rest, of the revision drawn, after the decision; one
    taken back took it from as many as it says, and from no other.
    """
    rest = {(one.measurement_id, one.revision) for one in items if one.role == "rest"}
    accepted = [one for one in given if one["verdict"] == "accepted"]
    again = [one for one in given if one["verdict"] == "reopened"]
    chosen = {one["choice"]: one for one in decisions}
    told = [(int(one["series_id"]), int(one["revision"])) for one in accepted]
    wanted = rest if "accepted" in chosen else set()
    if set(told) != wanted or len(told) != len(wanted) or len(again) + len(accepted) != len(given):
        raise Damaged("lots-rest-differs", id=lot.id)
    taken = {int(one["series_id"]) for one in again}
    back = chosen.get("taken_back")
    if not taken <= {number for number, _ in rest} or len(again) != (int(back["rest"]) if back else 0):
        raise Damaged("lots-rest-differs", id=lot.id)
    for verdicts, choice in ((accepted, "accepted"), (again, "taken_back")):
        if any(one["event"] < chosen[choice]["event"] for one in verdicts):
            raise Damaged("lots-verdict-too-early", id=lot.id)
