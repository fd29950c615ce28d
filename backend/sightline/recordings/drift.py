"""On which frames of a recording the camera was not where its pose says, as documents and sentences."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Annotated, Required

from pydantic import Field
from typing_extensions import TypedDict

from sightline.enums import DriftState
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
    """Frames with the same motion against the pose, and what it is worth in height."""

    first_frame: int
    last_frame: int
    moved: bool
    change_m: float | None


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
    checked_at: str


class SpanTold(TypedDict):
    """A span on which the camera had moved, as the audit event of the check says it."""

    first_frame: int
    last_frame: int
    moved_px: float
    change_m: float | None


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
    """Frames on which the camera had moved by `moved_px`; heights are then off by up to `change_m`."""

    first_frame: int
    last_frame: int
    moved_px: float
    change_m: float | None


def drift_check_of(drift: DriftChecks | None, pose_id: int | None) -> DriftCheck | None:
    """What was found against one camera pose; None where nobody looked."""
    if drift is None or pose_id is None:
        return None
    return drift["checks"].get(str(pose_id))


def drift_figures(check: DriftCheck) -> DriftFigures:
    """What a check found, in a few figures: the largest motion and the largest change of a height where the
    camera moved, None where it did not.
    """
    moved = [span for span in check["spans"] if span["moved"]]
    changes = [abs(span["change_m"]) for span in moved if span["change_m"] is not None]
    return {
        "state": check["state"],
        "floor_px": check.get("floor_px"),
        "moved_px": max((span["moved_px"] for span in moved), default=None),
        "height_m": max(changes, default=None),
        "checked_at": check.get("checked_at"),
    }


def spans_told(check: DriftCheck) -> list[SpanTold]:
    """The moved spans of a check: measurements on them are flagged."""
    return [
        {
            "first_frame": one["first_frame"],
            "last_frame": one["last_frame"],
            "moved_px": one["moved_px"],
            "change_m": one["change_m"],
        }
        for one in check["spans"]
        if one["moved"]
    ]


def flag_of_frames(spans: Iterable[MovedSpan], frames: Sequence[int]) -> Said | None:
    """The flag of a measurement on these frames: the largest motion's; None where the camera stood."""
    on = [span for span in spans if any(span.first_frame <= n <= span.last_frame for n in frames)]
    return _flag(max(on, key=lambda span: span.moved_px)) if on else None


def open_spans(
    drift: DriftChecks | None, decision: DriftDecision | None, pose_id: int | None
) -> list[MovedSpan]:
    """The moved spans against a pose that no decision covers."""
    check = drift_check_of(drift, pose_id)
    if check is None:
        return []
    return undecided(spans_told(check), decision, pose_id, check["floor_px"])


def undecided(
    spans: Iterable[SpanTold], decision: DriftDecision | None, pose_id: int | None, floor_px: float | None
) -> list[MovedSpan]:
    """The moved spans against a pose that no decision covers."""
    moved = [MovedSpan(**one) for one in spans]
    return [one for one in moved if not _decided(one, decision, pose_id, floor_px or 0.0)]


def _decided(span: MovedSpan, decision: DriftDecision | None, pose_id: int | None, floor_px: float) -> bool:
    """Whether somebody saw this very motion and let it stand; a larger one found since is another."""
    if decision is None or decision["pose_id"] != pose_id:
        return False
    return any(
        one["first_frame"] <= span.last_frame
        and span.first_frame <= one["last_frame"]
        and span.moved_px <= one["moved_px"] + floor_px
        for one in decision["spans"]
    )


def _flag(span: MovedSpan) -> Said:
    moved_px = round(span.moved_px, 1)
    if span.change_m is None:
        return Said("height-flag-camera-moved", moved_px=moved_px)
    error_m = round(abs(span.change_m), 3)
    return Said("height-flag-camera-moved-by", moved_px=moved_px, error_m=error_m)
