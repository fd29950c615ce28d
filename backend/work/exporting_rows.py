"""The rows of an export: from stored records to cells, table by table (columns: `exporting_tables.py`)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from datetime import datetime

from backend.storage.chain import plain
from backend.storage.columns import canonical_json
from backend.storage.records import (
    AuditEvent,
    Calibration,
    Camera,
    FurtherFrame,
    Measurement,
    Pose,
    Recording,
    Review,
    Survey,
    Vehicle,
    WheelPair,
    Who,
)
from backend.work.packaging import Cell


@dataclass(frozen=True, eq=False)
class SurveyState:
    """All that is stored of one survey, as one transaction saw it; every tuple in the order of ids."""

    survey: Survey
    cameras: tuple[Camera, ...]
    calibrations: tuple[Calibration, ...]
    recordings: tuple[Recording, ...]
    poses: tuple[Pose, ...]
    vehicles: tuple[Vehicle, ...]
    current: tuple[Measurement, ...]
    revisions: tuple[Measurement, ...]
    reviews: tuple[Review, ...]
    audit: tuple[AuditEvent, ...]
    wheel_pairs: tuple[WheelPair, ...] = ()
    repeats: tuple[Measurement, ...] = ()


Rows = list[dict[str, Cell]]


def when(moment: datetime | None) -> str | None:
    """ISO 8601 in UTC, to the microsecond."""
    return None if moment is None else moment.isoformat(timespec="microseconds").replace("+00:00", "Z")


def _who(person: Who | None) -> int | None:
    return None if person is None else person.id


def pose_path(pose_id: int) -> str:
    return f"poses/pose-{pose_id}.json"


def calibration_path(calibration_id: int) -> str:
    return f"calibrations/calibration-{calibration_id}.json"


def clicks_path(pose_id: int) -> str:
    return f"clicks/pose-{pose_id}.csv"


def measured(one: Measurement) -> dict[str, Cell]:
    """The columns that a current measurement and a revision share."""
    return {
        "vehicle_id": one.vehicle_id,
        "recording_id": one.recording_id,
        "target": one.target,
        "frame": one.frame,
        "pts": one.pts,
        "time_s": one.time_s,
        "frame_crc32": one.frame_crc,
        **clicked(one),
        "frames": 1 + len(one.more_frames),
        **{f"frame{k}": other.frame for k, other in enumerate(one.more_frames, start=2)},
        **further(one),
        "solved_inset_m": one.solved_inset_m,
        "u_solved_inset_m": one.u_solved_inset_m,
        "pose_id": one.pose_id,
        "calibration_id": one.calibration_id,
        "height_m": one.height_m,
        "uncorrected_height_m": one.uncorrected_height_m,
        "u_height_m": one.u_height_m,
        "U95_height_m": one.U95_height_m,
        "distance_m": one.distance_m,
        "status": one.status,
        "reason": one.reason,
        "flags": "; ".join(one.all_flags),
        "code_version": one.code_version,
        "created_by_id": _who(one.created_by),
        "created_at": when(one.created_at),
        "withdrawn": one.withdrawn,
    }


def clicked(one: Measurement) -> dict[str, Cell]:
    """The two points with their sigma and inset, as `sightline height --clicks` names them."""
    return {
        "contact_x_px": float(one.contact[0]),
        "contact_y_px": float(one.contact[1]),
        "target_x_px": float(one.point[0]),
        "target_y_px": float(one.point[1]),
        "sigma_px": float(one.sigma_px),
        "inset_m": float(one.inset_m),
        "u_inset_m": float(one.u_inset_m),
    }


def most_frames(state: SurveyState) -> int:
    """On how many frames the points of a measurement were clicked at most: so many columns there are."""
    return max((1 + len(one.more_frames) for one in state.revisions), default=1)


def further(one: Measurement) -> dict[str, Cell]:
    """The same two points on the further frames: contact2, target2 on the second, and so on."""
    cells: dict[str, Cell] = {}
    for k, other in enumerate(one.more_frames, start=2):
        for word, (x, y) in (("contact", other.contact), ("target", other.point)):
            cells |= {f"{word}{k}_x_px": float(x), f"{word}{k}_y_px": float(y)}
    return cells


def measurement_rows(state: SurveyState) -> Rows:
    return [
        {
            "id": one.id,
            "revision": one.revision,
            **measured(one),
            "verdict": one.review.verdict,
            "review_reason": one.review.reason,
            "reviewer_id": _who(one.review.reviewer),
            "reviewed_at": when(one.review.at),
        }
        for one in state.current
    ]


def revision_rows(state: SurveyState) -> Rows:
    return [{"measurement_id": one.id, "revision": one.revision, **measured(one)} for one in state.revisions]


def budget_rows(state: SurveyState) -> Rows:
    return [
        {"measurement_id": one.id, "source": str(entry["source"]), "u_m": float(entry["u_m"])}
        for one in state.current
        for entry in one.budget
    ]


def click_rows(state: SurveyState) -> Rows:
    """One row for every measurement that still counts; those withdrawn are left out."""
    vehicles = {vehicle.id: vehicle for vehicle in state.vehicles}
    rows: Rows = []
    for one in state.current:
        if one.withdrawn:
            continue
        vehicle = vehicles.get(one.vehicle_id)
        roof = vehicle is not None and one.target == "roof"
        rows.append(
            {
                "id": f"m{one.id}",
                **clicked(one),
                **further(one),
                "lighting": None if vehicle is None else vehicle.lighting,
                "reference_height_m": vehicle.manufacturer_height_m if vehicle is not None and roof else None,
                "target": one.target,
                "category": None if vehicle is None else vehicle.category,
                "pose_id": one.pose_id,
                "pose_file": pose_path(one.pose_id),
            }
        )
    return rows


def vehicle_rows(state: SurveyState) -> Rows:
    fields = (
        "id number recording_id first_frame last_frame best_frame make model year category "
        "manufacturer_height_m u_manufacturer_height_m height_source lighting notes state"
    )
    return [{name: getattr(vehicle, name) for name in fields.split()} for vehicle in state.vehicles]


def recording_rows(state: SurveyState) -> Rows:
    fields = (
        "id name sha256 size_bytes width_px height_px frame_count duration_s codec container lighting "
        "camera_id pose_id"
    )
    return [
        {**{name: getattr(one, name) for name in fields.split()}, "variable_rate": one.vfr}
        for one in state.recordings
    ]


def frame_rows(state: SurveyState) -> Rows:
    """Every frame that any revision was clicked on, once."""
    seen: dict[tuple[int, int], Measurement | FurtherFrame] = {}
    for one in state.revisions:
        clicked_on: tuple[Measurement | FurtherFrame, ...] = (one, *one.more_frames)
        seen |= {(one.recording_id, frame.frame): frame for frame in clicked_on}
    return [
        {
            "recording_id": recording_id,
            "frame": frame,
            "pts": one.pts,
            "time_s": one.time_s,
            "crc32": one.frame_crc,
        }
        for (recording_id, frame), one in sorted(seen.items())
    ]


def pose_rows(state: SurveyState) -> Rows:
    return [_pose_row(pose) for pose in state.poses]


def _pose_row(pose: Pose) -> dict[str, Cell]:
    board = pose.document.get("board") or {}
    return {
        "id": pose.id,
        "recording_id": pose.recording_id,
        "calibration_id": pose.calibration_id,
        "first_frame": pose.first_frame,
        "last_frame": pose.last_frame,
        "frames_used": pose.document.get("frames_used"),
        "rms_px": pose.rms_px,
        "board_distance_m": pose.distance_m,
        "board_columns": board.get("columns"),
        "board_rows": board.get("rows"),
        "square_m": board.get("square_m"),
        "reference": board.get("reference"),
        "reference_height_m": board.get("reference_height_m"),
        "u_reference_height_m": board.get("u_reference_height_m"),
        "u_lean_rad": board.get("u_lean_rad"),
        "u_square_m": board.get("u_square_m"),
        "u_bow_m": board.get("u_bow_m"),
        "turned_from": pose.turned_from,
        "turned_by_rad": pose.turned_by_rad,
        "document": pose_path(pose.id),
        "created_by_id": _who(pose.created_by),
        "created_at": when(pose.created_at),
    }


def calibration_rows(state: SurveyState) -> Rows:
    names = {camera.id: camera.name for camera in state.cameras}
    rows: Rows = []
    for one in state.calibrations:
        fields = "model width_px height_px fx_px fy_px cx_px cy_px rms_px"
        rows.append(
            {
                "id": one.id,
                "camera_id": one.camera_id,
                "camera_name": names.get(one.camera_id),
                "source": one.source,
                **{name: one.document.get(name) for name in fields.split()},
                "distortion": " ".join(repr(float(value)) for value in one.document["distortion"]),
                "trusted": one.trusted,
                "document": calibration_path(one.id),
                "created_by_id": _who(one.created_by),
                "created_at": when(one.created_at),
            }
        )
    return rows


def review_rows(state: SurveyState) -> Rows:
    return [
        {
            "id": one.id,
            "measurement_id": one.measurement_id,
            "revision": one.revision,
            "result_revision": one.result_revision,
            "verdict": one.verdict,
            "reason": one.reason,
            "reviewer_id": _who(one.reviewer),
            "at": when(one.at),
        }
        for one in state.reviews
    ]


def inset_rows(state: SurveyState) -> Rows:
    return [
        {"target": target, "inset_m": inset.inset_m, "u_inset_m": inset.u_inset_m, "note": inset.note}
        for target, inset in sorted(state.survey.insets.items())
    ]


def person_rows(state: SurveyState) -> Rows:
    """Everybody who is named in another table, by number and name, and nothing else about them."""
    people: dict[int, str] = {}
    for person in _named(state):
        if person is not None:
            people[person.id] = person.name
    return [{"id": number, "name": people[number]} for number in sorted(people)]


def _named(state: SurveyState) -> Iterable[Who | None]:
    made: Sequence[Measurement | Pose | Calibration] = (*state.revisions, *state.poses, *state.calibrations)
    yield from (one.created_by for one in made)
    yield from (one.review.reviewer for one in state.current)
    yield from (one.reviewer for one in state.reviews)
    yield from (event.actor for event in _shown(state))


def _shown(state: SurveyState) -> list[AuditEvent]:
    return [event for event in state.audit if event.survey_id == state.survey.id]


def audit_rows(state: SurveyState) -> Rows:
    """The chain from this survey's first event on; rows of other surveys and accounts as links only."""
    shown = _shown(state)
    first = shown[0].id if shown else 1
    return [
        audit_row(event, event.survey_id != state.survey.id) for event in state.audit if event.id >= first
    ]


def audit_row(event: AuditEvent, withheld: bool) -> dict[str, Cell]:
    """One link; its content as the text that was hashed, or left out."""
    links: dict[str, Cell] = {
        "id": event.id,
        "previous_hash": event.previous_hash,
        "content_sha256": event.content_sha256,
        "hash": event.hash,
        "withheld": withheld,
    }
    if withheld:
        return links
    return {
        **links,
        "at": plain(event.at),
        "actor_id": _who(event.actor),
        "action": event.action,
        "entity": event.entity,
        "entity_id": event.entity_id,
        "survey_id": event.survey_id,
        "before": None if event.before is None else canonical_json(event.before),
        "after": None if event.after is None else canonical_json(event.after),
    }
