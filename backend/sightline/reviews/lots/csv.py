"""The tables of lots in the package: each lot with its plan, draw and decision, and what it holds."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import get_args

from sightline.enums import Lighting, LotLeaving, LotRole, LotState, Target
from sightline.infra.csv_package.columns import columns_within, integer, key, moment, number, person, text
from sightline.infra.csv_package.schema import Column, Table, ids_of
from sightline.reviews.lots.records import Decision, Lot, LotItem


@dataclass(frozen=True, slots=True)
class ItemOfLot:
    """A measurement of a lot; its part is told once something was decided."""

    lot: Lot
    item: LotItem


def _decision_column(name: str, meaning: str, of: Callable[[Decision], int]) -> Column[Lot]:
    return integer(name, meaning, lambda lot: of(lot.decision) if lot.decision else None, minimum=0)


LOTS: Table[Lot] = Table(
    "lots",
    "Heights that were judged by a sample: plan, draw and decision. A height is nonconforming "
    "if its reviewer rejected it, or fixed it by more than its own U95. seed is sha256 over previous_hash of "
    'the lot\'s event in audit.csv and all "measurement_id.revision" of the lot in ascending order, '
    'separated by blanks; the draw\'s order is that of sha256 over "seed measurement_id".',
    (
        key("id", "lot"),
        key("number", "number of the lot in its survey"),
        *columns_within(
            "common",
            text("target", "target of all its heights", enum=get_args(Target)),
            text("lighting", "lighting of all", enum=get_args(Lighting)),
            person("operator_id", "who clicked all of them"),
            text("day", "day on which all were measured (UTC)"),
        ),
        integer("size", "heights in it when it was drawn", required=True, minimum=1),
        integer("sample_size", "of them to be judged", required=True, minimum=1),
        integer(
            "acceptance_number",
            "it is accepted with so many nonconforming ones in the sample, or fewer",
            required=True,
            minimum=0,
        ),
        *columns_within(
            "risks",
            number(
                "producer_quality", "fraction nonconforming of a lot that should be accepted", required=True
            ),
            number("producer_risk", "chance, at most, that such a lot is not", required=True),
            number(
                "consumer_quality",
                "fraction nonconforming of a lot that should not be accepted",
                required=True,
            ),
            number("consumer_risk", "chance, at most, that such a lot is", required=True),
        ),
        text("seed", "what the draw follows from", required=True),
        person("created_by_id", "who had it drawn"),
        moment("created_at", "when"),
        text(
            "state",
            "open; accepted by its sample; full inspection: its rest was reviewed one by one; dissolved "
            "before anything was judged; taken back: accepted before",
            required=True,
            enum=get_args(LotState),
        ),
        _decision_column("judged", "heights of the sample that were judged", lambda one: one.judged),
        _decision_column("nonconforming", "nonconforming ones among them", lambda one: one.nonconforming),
        _decision_column(
            "rest",
            "heights beside the sample that followed the decision; of one taken back: that it still held for",
            lambda one: one.rest,
        ),
        number(
            "outgoing_estimate",
            "of an accepted lot: nonconforming heights among the rest, by estimate",
            "",
            lambda lot: round(lot.outgoing.estimate, 6) if lot.outgoing else None,
        ),
        integer(
            "outgoing_at_most",
            "of an accepted lot: nonconforming heights among the rest, upper limit (one-sided, 95 %)",
            lambda lot: lot.outgoing.at_most if lot.outgoing else None,
        ),
        person("decided_by_id", "who decided", lambda lot: lot.decision.created_by if lot.decision else None),
        moment("decided_at", "when", lambda lot: lot.decision.created_at if lot.decision else None),
    ),
    primary=("id",),
)

LOT_ITEMS: Table[ItemOfLot] = Table(
    "lot_items",
    "What each lot holds, in the order of the draw.",
    (
        key("lot_id", "lot", lambda one: one.lot.id),
        *columns_within(
            "item",
            integer("place", "when it was drawn, from 1", required=True, minimum=1),
            key("measurement_id", "measurement"),
            key("revision", "its revision when the lot was drawn"),
        ),
        text(
            "role",
            "of a lot that was decided on: judged as part of the sample, part of the rest, or left before",
            lambda one: one.item.role if one.lot.decisions else None,
            enum=get_args(LotRole),
        ),
        text(
            "left_because",
            "why it left the lot",
            lambda one: one.item.why if one.lot.decisions else None,
            enum=get_args(LotLeaving),
        ),
    ),
    primary=("lot_id", "place"),
    foreign=(
        *ids_of(lot_id="lots", measurement_id="measurements"),
        (("measurement_id", "revision"), "revisions", ("measurement_id", "revision")),
    ),
)
