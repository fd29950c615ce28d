"""On which frames of a recording the camera was not where its pose says, as documents and sentences."""

from collections.abc import Iterable
from dataclasses import dataclass, fields
from typing import Annotated, NotRequired, Required

from pydantic import Field
from typing_extensions import TypedDict

from sightline.enums import DriftState, JsonObject
from sightline.geometry.drift import Motion
from sightline.messages.said import Said


class DriftLook(TypedDict, total=False):
    """One frame against the pose's: a motion in pixels with what it is worth in height, or a reason."""

    frame: Required[int]
    time_s: Required[float]
    x_px: float
    y_px: float
    turn_rad: float
    scale: float
    moved_px: float
    u_px: float
    points: int
    change_m: float | None
    reason: Said


class DriftStep(TypedDict):
    """The camera moved between two frames."""

    after: Annotated[int, Field(description="The last frame before it.")]
    frame: int
    time_s: float
    by_px: float


class DriftMotion(TypedDict):
    """How the picture moved since the pose (`geometry.drift.Motion`)."""

    x_px: float
    y_px: float
    turn_rad: float
    scale: float
    moved_px: float
    u_px: float
    points: int


class DriftSpan(DriftMotion):
    """Frames with the same motion against the pose, and what it is worth in height `distance_m` across."""

    first_frame: int
    last_frame: int
    moved: bool
    change_m: float | None
    distance_m: NotRequired[Annotated[float | None, Field(description="Not in checks of old versions.")]]


class DriftCheck(TypedDict):
    """What was found of a recording's camera against one camera pose."""

    pose_id: int
    pose_recording_id: int
    state: DriftState
    words: list[Said]
    reason: Said | None
    floor_px: float | None
    floor_m: float | None
    target_m: float
    distance_m: float | None
    looks: list[DriftLook]
    bumps: list[DriftStep]
    spans: list[DriftSpan]
    checked_at: str
    code_version: str


class DriftChecks(TypedDict):
    """A recording's checks by the number of the pose."""

    checks: dict[str, DriftCheck]


class DriftFigures(TypedDict):
    """A check in a few figures, as its audit event and a package say it."""

    state: DriftState
    floor_px: float | None
    moved_px: float | None
    height_m: float | None
    distance_m: NotRequired[float | None]
    checked_at: str


class DriftDecision(TypedDict):
    """Why somebody lets a camera pose stand, and the moved spans that they saw."""

    pose_id: int
    reason: str
    by: str
    by_id: int | None
    at: str
    spans: list[DriftSpan]


@dataclass(frozen=True, slots=True)
class MovedSpan:
    """Frames on which the camera had moved by `moved_px`. A height of 1.2 m is then off by up to `change_m`,
    `distance_m` across from the camera. Checks of earlier versions told neither that nor the motion.
    """

    first_frame: int
    last_frame: int
    moved_px: float
    change_m: float | None
    distance_m: float | None = None
    x_px: float | None = None
    y_px: float | None = None
    turn_rad: float | None = None
    scale: float | None = None

    @property
    def motion(self) -> Motion | None:
        """How the picture moved, as far as it is told."""
        if self.x_px is None or self.y_px is None or self.turn_rad is None or self.scale is None:
            return None
        how = {"turn_rad": self.turn_rad, "scale": self.scale, "moved_px": self.moved_px}
        return Motion(x_px=self.x_px, y_px=self.y_px, **how, u_px=0.0, points=0)


def drift_check_of(drift: DriftChecks | None, pose_id: int | None) -> DriftCheck | None:
    """What was found against one camera pose; None where nobody looked."""
    if drift is None or pose_id is None:
        return None
    return drift["checks"].get(str(pose_id))


def drift_figures(check: DriftCheck) -> DriftFigures:
    """A check in few figures: the largest motion and change of a height; None where it did not move."""
    moved = [span for span in check["spans"] if span["moved"]]
    worst = max(moved, key=lambda span: abs(span["change_m"] or 0.0), default=None)
    change_m = None if worst is None else worst["change_m"]
    return {
        "state": check["state"],
        "floor_px": check.get("floor_px"),
        "moved_px": max((span["moved_px"] for span in moved), default=None),
        "height_m": None if change_m is None else abs(change_m),
        "distance_m": None if worst is None else worst.get("distance_m"),
        "checked_at": check.get("checked_at"),
    }


def spans_told(check: DriftCheck) -> list[JsonObject]:
    """The fields of a check's `MovedSpan`s, as its event has them; an earlier version's as it told them."""
    told = [one.name for one in fields(MovedSpan)]
    return [
        {name: one.get(name) for name in (told if "distance_m" in one else told[:4])}
        for one in check["spans"]
        if one["moved"]
    ]


def open_spans(
    drift: DriftChecks | None, decision: DriftDecision | None, pose_id: int | None
) -> list[MovedSpan]:
    """The moved spans against a pose that no decision covers."""
    check = drift_check_of(drift, pose_id)
    if check is None:
        return []
    return undecided_spans(spans_told(check), decision, pose_id, check["floor_px"])


def undecided_spans(
    spans: Iterable[JsonObject], decision: DriftDecision | None, pose_id: int | None, floor_px: float | None
) -> list[MovedSpan]:
    """The moved spans against a pose that no decision covers."""
    moved = [MovedSpan(**one) for one in spans]
    return [one for one in moved if not _is_decided(one, decision, pose_id, floor_px or 0.0)]


def _is_decided(
    span: MovedSpan, decision: DriftDecision | None, pose_id: int | None, floor_px: float
) -> bool:
    """Whether somebody saw this very motion and let it stand; a larger one found since is another."""
    if decision is None or decision["pose_id"] != pose_id:
        return False
    return any(
        decided["first_frame"] <= span.last_frame
        and span.first_frame <= decided["last_frame"]
        and span.moved_px <= decided["moved_px"] + floor_px
        for decided in decision["spans"]
    )
