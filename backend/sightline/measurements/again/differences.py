"""What makes a height another one, of frames or of a line scan: the facts that it follows from, and its
numbers; and which verdict holds for it then.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, fields
from typing import Protocol, TypeVar

from sightline.enums import Category, ComputingCause, DriverSide, InsetSource, SideBasis, Target, Verdict
from sightline.geometry.sides import FoundSide
from sightline.infra.by_name import filled_from
from sightline.measurements.height_of_clicks import filled_in, on_side
from sightline.measurements.records import Clicks, MeasurementValues, ScanHeightValues
from sightline.surveys.records import Inset

# Half of the last decimal that the package carries: less than that is the same number.
_SAME_M = 0.5e-6
#: Lengths that one frame assumes; several frames solve for the inset, and these say nothing of the height.
_ASSUMED = ("inset_m", "u_inset_m")
#: What a person clicked; of a line scan there is no more than two points.
_CLICKED = ("frame", "contact", "target_point", "target", "sigma_px", "more_frames", "followed")

Values = MeasurementValues | ScanHeightValues
_Revision = TypeVar("_Revision")


class WithInset(Protocol):
    """An inset, or what a height was computed with; metres."""

    @property
    def inset_m(self) -> float | None: ...
    @property
    def u_inset_m(self) -> float | None: ...


class WithHeight(Protocol):
    """A height, metres; None where there is none."""

    @property
    def height_m(self) -> float | None: ...
    @property
    def u_height_m(self) -> float | None: ...


@dataclass(frozen=True, slots=True, kw_only=True)
class Facts:
    """What a height follows from beside its clicks. `solved`: from several frames, which need no inset."""

    pose_id: int
    side: DriverSide | None
    side_from: SideBasis | None
    inset_m: float | None
    u_inset_m: float | None
    inset_from: InsetSource | None
    solved: bool


def facts_of(content: Values | Clicks, pose_id: int) -> Facts:
    """Those of a stored content, or of clicks with everything filled in."""
    solved = bool(content.more_frames)
    return filled_from(Facts, content, pose_id=pose_id, side_from=content.side_from, solved=solved)


def causes_of_facts(then: Facts, now: Facts) -> tuple[ComputingCause, ...]:
    """Which facts are others in a way that a height depends on."""
    causes: list[ComputingCause] = []
    if then.pose_id != now.pose_id:
        causes.append("pose")
    if then.solved or then.inset_from == "own":
        return tuple(causes)
    by_place = (then.side_from == "place") != (now.side_from == "place")  # which a flag says
    if then.side != now.side or by_place:
        causes.append("side")
    elif not same_inset(then, now):
        causes.append("inset")
    return tuple(causes)


def causes_now(
    target: Target,
    then: Facts,
    *,
    pose_id: int | None,
    side: FoundSide | None,
    category: Category | None,
    insets: Mapping[str, Inset],
) -> tuple[ComputingCause, ...]:
    """Which facts of a stored height no longer hold, with those that hold now: the road pose in force of its
    recording (None: it has none, and the height stays), where the driver sits, the vehicle's class, and the
    survey's insets.
    """
    own = then.inset_from == "own"
    clicks = Clicks(
        target=target,
        contact=(0.0, 0.0),  # where the clicks are does not matter
        target_point=(0.0, 0.0),
        inset_m=then.inset_m if own else None,
        u_inset_m=then.u_inset_m if own else None,
    )
    in_force = then.pose_id if pose_id is None else pose_id
    now = filled_in(on_side(clicks, side), insets, category)
    return causes_of_facts(then, facts_of(now, in_force))


def causes_of(then: Values, now: Values) -> tuple[ComputingCause, ...]:
    """Why a height computed again is another one; none where it is the same."""
    found = causes_of_facts(facts_of(then, then.pose_id), facts_of(now, now.pose_id))
    if found:
        return found
    free = then.more_frames or then.inset_from == "own"
    lengths = [one.name for one in fields(then) if one.name.endswith("_m")]
    alike = (then.status, then.flags) == (now.status, now.flags) and all(
        same_length(getattr(then, name), getattr(now, name))
        for name in lengths
        if not (free and name in _ASSUMED)
    )
    return () if alike else ("program",)


def same_inset(then: WithInset, now: WithInset) -> bool:
    """Whether two insets are the same to what the package carries."""
    return same_length(then.inset_m, now.inset_m) and same_length(then.u_inset_m, now.u_inset_m)


def same_height(then: Values, now: Values) -> bool:
    """Whether a revision has the very clicks of another and, by the same facts, its numbers."""
    clicked = [tuple(getattr(one, name, None) for name in _CLICKED) for one in (then, now)]
    return clicked[0] == clicked[1] and not causes_of(then, now)


def same_length(length_m: float | None, other: float | None) -> bool:
    if length_m is None or other is None:
        return length_m is other
    return abs(length_m - other) <= _SAME_M


def moved_beyond_u(then_m: float | None, u_then_m: float | None, now_m: float | None) -> bool:
    """Whether a height moved by more than the standard uncertainty that it had, or came or went."""
    if then_m is None or now_m is None:
        return (then_m is None) != (now_m is None)
    return abs(now_m - then_m) > (u_then_m or 0.0)


def verdict_still_holds(verdict: Verdict, then: WithHeight, now: WithHeight) -> bool:
    """Whether a verdict holds for a content computed again too: of what hardly moved, and of a rejection, for
    the clicks that were rejected are the same.
    """
    return verdict == "rejected" or not moved_beyond_u(then.height_m, then.u_height_m, now.height_m)


def judged_alike(
    newest_first: Iterable[_Revision],
    alike: Callable[[_Revision], bool],
    judged: Callable[[_Revision], int | None],
) -> int | None:
    """The newest of the verdicts on content that is put back: where it was `judged`, by the revisions that
    are `alike`; None where none of them was.
    """
    where = (judged(one) for one in newest_first if alike(one))
    return next((one for one in where if one is not None), None)


@dataclass(frozen=True, slots=True, kw_only=True)
class HeightChange:
    """What a computing counts of one height: as it was, as it is, why, and whether its verdict goes over."""

    then_m: float | None
    u_then_m: float | None
    now_m: float | None
    causes: tuple[ComputingCause, ...]
    verdict_goes_over: bool

    @property
    def to_review(self) -> bool:
        return not self.verdict_goes_over and moved_beyond_u(self.then_m, self.u_then_m, self.now_m)

    @property
    def size_m(self) -> float | None:
        """By how much; None where one of the two is no height."""
        return None if self.then_m is None or self.now_m is None else abs(self.now_m - self.then_m)
