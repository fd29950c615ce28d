"""Heights computed again in one go, and what that changed."""

from dataclasses import dataclass
from datetime import datetime
from typing import Annotated

from pydantic import Field

from sightline.enums import ComputingCause, ComputingKind, MeasurementStatus, Target
from sightline.infra.audit.records import Who
from sightline.messages.said import Said


@dataclass(frozen=True, slots=True, kw_only=True)
class Computing:
    """Heights of a survey that were computed again together, and can be undone together."""

    id: int
    survey_id: int
    kind: Annotated[
        ComputingKind,
        Field(
            description="Asked for; after the driver's side was told; after an adjustment; or an undo of "
            "another."
        ),
    ]
    undoes: Annotated[
        int | None, Field(description="Of an undo: the computing whose earlier heights it restored.")
    ]
    undone_by: Annotated[int | None, Field(description="The one that put its old heights back.")]
    heights: Annotated[int, Field(description="How many revisions it made, those of repeats among them.")]
    to_review: Annotated[
        int,
        Field(
            description="How many of them moved by more than the u they had, so that their verdict no longer "
            "held."
        ),
    ]
    kept: Annotated[int, Field(description="Of an undo: how many were changed since, and stay as they are.")]
    largest_m: Annotated[float | None, Field(description="The largest change of a height.")]
    causes: Annotated[dict[ComputingCause, int], Field(description="How many followed from what.")]
    code_version: str
    created_at: datetime
    created_by: Who | None


@dataclass(frozen=True, slots=True, kw_only=True)
class OutOfDate:
    """Standing heights that follow from other facts than those that hold now.

    `heights`: how many in all, by cause in `causes` (one height may have two); `in_line_scans`: those of them
    that were clicked in line scans; `waiting`: those that have no height yet. `other_program`: heights of
    another version of the program, which may come out alike. `measurements`: those of recordings by their id,
    repeats among them, each with its causes.
    """

    heights: int
    in_line_scans: int
    waiting: int
    other_program: int
    causes: dict[ComputingCause, int]
    measurements: dict[int, tuple[ComputingCause, ...]]


@dataclass(frozen=True, slots=True, kw_only=True)
class ComputedHeight:
    """One height as it was and is; `scan_id`: of a line scan. `moved_by_u`: the change by the u it had."""

    measurement_id: int
    scan_id: int | None = None
    revision: int
    vehicle_id: int
    vehicle_number: int
    target: Target
    repeat: bool
    status_before: MeasurementStatus
    status: MeasurementStatus
    height_before_m: float | None
    u_before_m: float | None
    U95_before_m: float | None
    height_m: float | None
    u_height_m: float | None
    U95_height_m: float | None
    x_m: float | None = None
    y_m: float | None = None
    distance_m: Annotated[
        float | None, Field(description="Of a line scan: from the camera to the contact.")
    ] = None
    change_m: float | None
    moved_by_u: float | None
    to_review: Annotated[bool, Field(description="Its verdict no longer holds: it moved by more than its u.")]
    reason: Said | None


@dataclass(frozen=True, slots=True, kw_only=True)
class ComputedHeights:
    """A computing and its heights, those that moved most by their u first; `listed` may be cut off."""

    computing: Computing
    listed: tuple[ComputedHeight, ...]
    mean_change_m: float | None
    undoable: Annotated[str | None, Field(description="Why it cannot be undone; null where it can be.")]
