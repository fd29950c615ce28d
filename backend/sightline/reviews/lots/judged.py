"""What the verdicts since the draw say of a lot's items: which are its sample, which left, which conform.

An item conforms if it was accepted, or fixed by no more than its own U95. It does not if it was rejected, or
fixed by more, or its height went. What is said of the lot's revision counts, whatever comes after; an
item changed before anybody judged it leaves the lot, and the next of the draw takes its place in the sample.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from sightline.enums import LotLeaving, LotRole, ReviewVerdict
from sightline.infra.by_name import filled_from
from sightline.reviews.lots.records import LotItem


@dataclass(frozen=True, slots=True)
class Judgement:
    """A verdict since the draw: on which revision, and for which it holds."""

    revision: int
    result_revision: int
    verdict: ReviewVerdict


@dataclass(frozen=True, slots=True)
class ItemNow:
    """A drawn item with what became of its measurement. `heights`: (height, U95) by revision, metres.

    `newest`: the current revision; `gone`: why it counts for nothing any more, if it does not.
    """

    measurement_id: int
    revision: int
    place: int
    newest: int
    gone: LotLeaving | None = None
    said: Sequence[Judgement] = ()
    heights: Mapping[int, tuple[float | None, float | None]] = field(default_factory=dict)


def items_of(found: Iterable[ItemNow], sample_size: int) -> tuple[LotItem, ...]:
    """The items in the order of the draw, each with its part: the sample are the first that did not leave."""
    out: list[LotItem] = []
    taken = 0
    for drawn in sorted(found, key=lambda item: item.place):
        standing, conforming = _follow_verdicts(drawn)
        why = None if conforming is not None else _left(drawn, standing)
        if why is None and taken < sample_size:
            taken += 1
            out.append(lot_item(drawn, "sample", conforming))
            continue
        if why is None and conforming is not None:
            why = "verdict_of_its_own"
        elif why is None and standing != drawn.revision:
            why = "measured_again"
        role: LotRole = "rest" if why is None else "left"
        out.append(lot_item(drawn, role, conforming, why))
    return tuple(out)


def lot_item(
    item: ItemNow, role: LotRole, conforming: bool | None = None, why: LotLeaving | None = None
) -> LotItem:
    """A drawn item with its part."""
    return filled_from(LotItem, item, role=role, conforming=conforming, why=why)


def _follow_verdicts(item: ItemNow) -> tuple[int, bool | None]:
    """The revision that the verdicts led to, and what they say of the lot's; a reopened one waits again, but
    once it changed, what was said before counts.
    """
    standing, conforming, waits = item.revision, None, False
    for judgement in item.said:
        if judgement.revision != standing:
            continue
        standing = judgement.result_revision
        waits = judgement.verdict == "reopened"
        if not waits:
            conforming = judgement.verdict != "rejected" and not _has_moved(item, standing)
    return standing, None if waits and _left(item, standing) is None else conforming


def _has_moved(item: ItemNow, standing: int) -> bool:
    """Whether the height that stands is another one than the lot's by more than the U95 that had."""
    if standing == item.revision:
        return False
    (then, U95), (now, _) = item.heights[item.revision], item.heights[standing]
    return then is None or now is None or U95 is None or abs(now - then) > U95


def _left(item: ItemNow, standing: int) -> LotLeaving | None:
    if item.gone is not None:
        return item.gone
    return None if item.newest == standing else "measured_again"
