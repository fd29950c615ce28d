"""The table of recordings in the package, with what was found and decided of cameras that moved."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from datetime import datetime
from typing import TypeVar, get_args

from sightline.enums import DriftState
from sightline.infra.csv_package.chain import stamp
from sightline.infra.csv_package.columns import (
    columns_for,
    columns_within,
    flag,
    instant,
    integer,
    metres,
    number,
    text,
)
from sightline.infra.csv_package.files import Files, read_columns, read_integer, undo_safe_text
from sightline.infra.csv_package.files import number as figure
from sightline.infra.csv_package.schema import Cell, Cells, Column, Table, ids_of
from sightline.infra.local_time import local_text
from sightline.recordings.drift import DriftDecision, DriftFigures, drift_check_of, drift_figures
from sightline.recordings.filming import Filming
from sightline.recordings.records import Recording

Row = TypeVar("Row")


@dataclass(frozen=True, slots=True)
class Drift:
    """Figures of what was found of a camera against its pose in force, and what a person decided of that."""

    found: DriftFigures | None
    decision: DriftDecision | None


@dataclass(frozen=True, slots=True)
class DescribedRecording:
    """A recording, and whether its camera moved since its pose in force."""

    recording: Recording
    drift: Drift


def describe_recording(recording: Recording) -> DescribedRecording:
    """The recording with the figures of its drift."""
    check = drift_check_of(recording.drift, recording.pose_id)
    found = None if check is None else drift_figures(check)
    return DescribedRecording(recording, drift_of(found, recording.drift_decision, recording.pose_id))


def drift_of(found: DriftFigures | None, decision: DriftDecision | None, pose_id: int | None) -> Drift:
    """What was found of the pose in force, and the decision where it is about that pose."""
    in_force = decision is not None and decision["pose_id"] == pose_id
    return Drift(found, decision if in_force else None)


def drift_cells(drift: Drift) -> Cells:
    """The columns about a camera that moved, by name."""
    return {column.name: column.of_object(drift) for column in _DRIFT}


def _found_getter(name: str) -> Callable[[Drift], Cell]:
    return lambda drift: _cell_of(drift.found, name)


def _decision_getter(name: str) -> Callable[[Drift], Cell]:
    return lambda drift: _cell_of(drift.decision, name)


def _cell_of(document: Mapping[str, object] | None, name: str) -> Cell:
    value = None if document is None else document.get(name)
    return value if isinstance(value, str | int | float) else None


def _time(of: Callable[[Drift], Cell]) -> Callable[[Drift], Cell]:
    def cell(drift: Drift) -> Cell:
        at = of(drift)
        return stamp(at) if isinstance(at, str) else None

    return cell


_DRIFT: tuple[Column[Drift], ...] = (
    text("drift_state", "column-recordings-drift-state", _found_getter("state"), enum=get_args(DriftState)),
    number("drift_floor_px", "detection limit of camera movement", "px", _found_getter("floor_px")),
    number("drift_moved_px", "largest motion found, where it moved", "px", _found_getter("moved_px")),
    metres("drift_height_m", "column-recordings-drift-height-m", _found_getter("height_m")),
    metres("drift_distance_m", "column-recordings-drift-distance-m", _found_getter("distance_m")),
    instant("drift_checked_at", "when this was checked", _time(_found_getter("checked_at"))),
    text(
        "drift_decision", "reason for keeping the pose although the camera moved", _decision_getter("reason")
    ),
    integer("drift_decided_by_id", "who decided that", _decision_getter("by_id")),
    instant("drift_decided_at", "when that was decided", _time(_decision_getter("at"))),
)


def started_text(started_at: datetime | None, time_zone: str | None) -> str | None:
    """A start by the clocks of its zone."""
    return None if started_at is None or time_zone is None else local_text(started_at, time_zone)


def started_column(
    what: str, at: Callable[[Row], datetime | None], zone: Callable[[Row], str | None]
) -> Column[Row]:
    """The start of a recording, as a person confirmed it; `what` begins the description."""
    words = f"{what}, as a person confirmed, by the clocks of the place (ISO 8601 with offset)"
    return Column("started_at", "datetime", words, of=lambda one: started_text(at(one), zone(one)))


_FACTS: tuple[Column[Recording], ...] = (
    *columns_for(Recording, "id"),
    *columns_for(Recording, "name", required=True),
    *columns_for(Recording, "sha256 size_bytes width_px height_px frame_count duration_s codec container"),
    flag("variable_rate", "true where the time between frames varies", lambda r: r.vfr),
    *columns_for(Recording, "stream_number filmed_hz lighting"),
    started_column("when its first frame was filmed", lambda r: r.started_at, lambda r: r.time_zone),
    *columns_for(Recording, "time_zone weather street_lighting camera_id pose_id"),
)


RECORDINGS: Table[DescribedRecording] = Table(
    "recordings",
    "The video files behind the measurements.",
    (*columns_within("recording", *_FACTS), *columns_within("drift", *_DRIFT)),
    primary=("id",),
    foreign=ids_of(drift_decided_by_id="people"),
)


def mean_frames_s(files: Files) -> dict[str, float]:
    """How long a frame of each recording of a package is on average, seconds; 0 where that is not known. By
    it packages told the times of passes before their vehicles had first_s.
    """
    columns = read_columns(files, RECORDINGS.key, ("id", "duration_s", "frame_count"))
    lasting = ((id_, figure(duration), read_integer(frames)) for id_, duration, frames in columns)
    return {id_: duration_s / count if duration_s and count else 0.0 for id_, duration_s, count in lasting}


def filmings_in(files: Files) -> dict[str, Filming]:
    """The start of each recording of a package that has one, by its number."""
    columns = read_columns(files, RECORDINGS.key, ("id", "started_at", "time_zone"))
    return {id_: Filming(datetime.fromisoformat(at), undo_safe_text(zone)) for id_, at, zone in columns if at}
