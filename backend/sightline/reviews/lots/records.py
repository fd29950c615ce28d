"""Lots of heights that are judged by a sample: what they hold, how far they are, what became of them."""

from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from typing import Annotated

from pydantic import Field

from sightline.enums import Lighting, LotChoice, LotLeaving, LotRole, LotState, Target
from sightline.infra.audit.records import Who
from sightline.statistics.acceptance import Outgoing, RiskPoints, estimate_outgoing


@dataclass(frozen=True, slots=True, kw_only=True)
class Common:
    """What all heights of a lot have in common; None: it was not divided by that, or nobody said it."""

    target: Target | None = None
    lighting: Lighting | None = None
    operator: Who | None = None
    day: Annotated[str | None, Field(description="On which it was measured (UTC).")] = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Decision:
    """What became of a lot: counts as they were then. `sample`: the measurements judged; `left_out`: why
    others were no longer in the lot, by measurement.
    """

    id: int
    choice: LotChoice
    judged: int
    nonconforming: int
    rest: int
    sample: tuple[int, ...]
    left_out: Mapping[int, LotLeaving]
    created_by: Who | None
    created_at: datetime


@dataclass(frozen=True, slots=True, kw_only=True)
class Lot:
    """A lot as it was drawn, with the decisions on it, oldest first."""

    id: int
    survey_id: int
    number: int
    common: Common
    size: int
    sample_size: int
    acceptance_number: int
    risks: RiskPoints
    seed: str
    created_by: Who | None
    created_at: datetime
    decisions: tuple[Decision, ...] = ()

    @property
    def decision(self) -> Decision | None:
        """The newest one."""
        return self.decisions[-1] if self.decisions else None

    @property
    def state(self) -> LotState:
        """Open until something was decided."""
        return self.decisions[-1].choice if self.decisions else "open"

    @property
    def outgoing(self) -> Outgoing | None:
        """What an accepted lot lets through; None for any other."""
        made = self.decision
        if made is None or made.choice != "accepted":
            return None
        return estimate_outgoing(made.judged + made.rest, made.judged, made.nonconforming)


@dataclass(frozen=True, slots=True)
class LotItem:
    """A measurement of a lot, and whether it was drawn: `place` counts from 1 in the order of the draw.

    `conforming`: what was said of it since, None while nothing was. `why`: why it left.
    """

    measurement_id: int
    revision: int
    place: int
    role: LotRole
    conforming: bool | None = None
    why: LotLeaving | None = None


@dataclass(frozen=True, slots=True)
class Progress:
    """How far a lot is: of `sample` heights `judged`, `nonconforming` of them; `rest` follow the decision.

    `own`: of those still to be judged, the asker's own, which others judge.
    """

    sample: int
    judged: int
    nonconforming: int
    rest: int
    left: dict[LotLeaving, int]
    own: int
    may_accept: Annotated[bool, Field(description="The sample is judged and within the acceptance number.")]
    next_measurement: Annotated[int | None, Field(description="Of the sample: the next for the asker.")]


@dataclass(frozen=True, slots=True)
class CurvePoint:
    """Fraction nonconforming in the lot, and the probability that it is accepted."""

    fraction: float
    accepted: float


@dataclass(frozen=True, slots=True, kw_only=True)
class PlannedLot:
    """A lot that could be drawn now: its size and plan; `saves` is false where the sample is all of it."""

    common: Common
    size: int
    sample_size: int
    acceptance_number: int
    producer_risk: Annotated[float, Field(description="That the plan keeps; no more than asked.")]
    consumer_risk: Annotated[float, Field(description="That the plan keeps; no more than asked.")]
    saves: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class ShownLot:
    """A lot with all that is told of it."""

    lot: Lot
    state: LotState
    progress: Progress
    curve: tuple[CurvePoint, ...]
    kept: Annotated[RiskPoints, Field(description="Qualities at whole heights, and the risks there.")]
    outgoing: Annotated[Outgoing | None, Field(description="Of an accepted lot.")]


@dataclass(frozen=True, slots=True, kw_only=True)
class LotSummary:
    """How many accepted heights of a survey rest on what: on their own verdict, or on their lot's sample."""

    individual: int
    by_lot: int
    waiting: Annotated[int, Field(description="Held by open lots, beside their samples.")]
    outgoing: Outgoing


@dataclass(frozen=True, slots=True)
class LotPlace:
    """Where a measurement stands in an open lot."""

    lot_id: int
    number: int
    in_sample: bool
