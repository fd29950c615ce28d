"""The rows of an export: from stored records to cells, table by table (columns: `exporting_tables.py`)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sightline.cameras.calibrations.records import Calibration
from sightline.cameras.records import Camera
from sightline.export.query import OfVehicle
from sightline.infra.audit.records import Who
from sightline.infra.csv_package.schema import Cells, when
from sightline.measurements.records import Measurement, Vehicle
from sightline.poses.records import Pose
from sightline.recordings.drift_query import drift_check_of, drift_figures
from sightline.recordings.records import Recording
from sightline.reviews.records import Review
from sightline.surveys.records import Survey


def _who(person: Who | None) -> int | None:
    return None if person is None else person.id


def pose_path(pose_id: int) -> str:
    return f"poses/pose-{pose_id}.json"


def calibration_path(calibration_id: int) -> str:
    return f"calibrations/calibration-{calibration_id}.json"


def clicks_path(pose_id: int) -> str:
    return f"clicks/pose-{pose_id}.csv"


def record_path(kind: str, row_id: int) -> str:
    """Where the whole stored content of a pose or calibration is, as the audit chain vouches for it."""
    return f"records/{kind}-{row_id}.json"


def measured(one: Measurement) -> Cells:
    """The columns that a current measurement and a revision share."""
    return {
        "vehicle_id": one.vehicle_id,
        "recording_id": one.recording_id,
        "target": one.values.target,
        "frame": one.values.frame,
        "pts": one.values.pts,
        "time_s": one.values.time_s,
        "frame_crc32": one.values.crc32,
        **clicked(one),
        "frames": 1 + len(one.values.more_frames),
        **{f"frame{k}": other.frame for k, other in enumerate(one.values.more_frames, start=2)},
        **further(one),
        "solved_inset_m": one.values.solved_inset_m,
        "u_solved_inset_m": one.values.u_solved_inset_m,
        "pose_id": one.values.pose_id,
        "calibration_id": one.values.calibration_id,
        "height_m": one.values.height_m,
        "uncorrected_height_m": one.values.uncorrected_height_m,
        "u_height_m": one.values.u_height_m,
        "U95_height_m": one.values.U95_height_m,
        "distance_m": one.values.distance_m,
        "status": one.values.status,
        "reason": one.values.reason,
        "flags": "; ".join(one.all_flags),
        "code_version": one.values.code_version,
        "created_by_id": _who(one.created_by),
        "created_at": when(one.created_at),
        "withdrawn": one.withdrawn,
    }


def clicked(one: Measurement) -> Cells:
    """The two points with their sigma and inset, as `sightline height --clicks` names them."""
    return {
        "contact_x_px": float(one.values.contact[0]),
        "contact_y_px": float(one.values.contact[1]),
        "target_x_px": float(one.values.target_point[0]),
        "target_y_px": float(one.values.target_point[1]),
        "sigma_px": float(one.values.sigma_px),
        "inset_m": float(one.values.inset_m),
        "u_inset_m": float(one.values.u_inset_m),
    }


def further(one: Measurement) -> Cells:
    """The same two points on the further frames: contact2, target2 on the second, and so on."""
    cells: Cells = {}
    for k, other in enumerate(one.values.more_frames, start=2):
        for word, (x, y) in (("contact", other.contact), ("target", other.target_point)):
            cells |= {f"{word}{k}_x_px": float(x), f"{word}{k}_y_px": float(y)}
    return cells


def measurement_row(one: Measurement, revision: Cells) -> Cells:
    """The current revision with its verdict, from its `revision_row`."""
    return {
        **revision,
        "id": one.id,
        "verdict": one.review.verdict,
        "review_reason": one.review.reason,
        "reviewer_id": _who(one.review.reviewer),
        "reviewed_at": when(one.review.at),
    }


def revision_row(one: Measurement) -> Cells:
    return {"measurement_id": one.id, "revision": one.revision, **measured(one)}


def budget_rows(one: Measurement) -> list[Cells]:
    return [
        {"measurement_id": one.id, "source": str(entry["source"]), "u_m": float(entry["u_m"])}
        for entry in one.values.budget
    ]


def click_row(one: Measurement, car: OfVehicle) -> Cells:
    return {
        "id": f"m{one.id}",
        **clicked(one),
        **further(one),
        "lighting": car.lighting,
        "reference_height_m": car.manufacturer_height_m if one.values.target == "roof" else None,
        "target": one.values.target,
        "category": car.category,
        "pose_id": one.values.pose_id,
        "pose_file": pose_path(one.values.pose_id),
    }


_OF_VEHICLE = [
    "id",
    "number",
    "recording_id",
    "first_frame",
    "last_frame",
    "best_frame",
    "make",
    "model",
    "year",
    "category",
    "manufacturer_height_m",
    "u_manufacturer_height_m",
    "height_source",
    "lighting",
    "notes",
    "state",
]


def vehicle_row(vehicle: Vehicle) -> Cells:
    return {name: getattr(vehicle, name) for name in _OF_VEHICLE}


_OF_RECORDING = [
    "id",
    "name",
    "sha256",
    "size_bytes",
    "width_px",
    "height_px",
    "frame_count",
    "duration_s",
    "codec",
    "container",
    "lighting",
    "camera_id",
    "pose_id",
]


def recording_row(one: Recording) -> Cells:
    known = {name: getattr(one, name) for name in _OF_RECORDING}
    return {**known, "variable_rate": one.vfr, **_drift_cells(one)}


def _drift_cells(one: Recording) -> Cells:
    """Whether the camera moved since the road pose in force, and what a person decided about it."""
    check = drift_check_of(one.drift, one.pose_id)
    found = None if check is None else drift_figures(check)
    return {**found_cells(found), **decision_cells(one.drift_decision, one.pose_id)}


def found_cells(found: Mapping[str, Any] | None) -> Cells:
    """The columns of what was found of a camera that moved, from its figures."""
    told = found or dict.fromkeys(("state", "floor_px", "moved_px", "height_m", "checked_at"))
    at = told["checked_at"]
    return {
        **{f"drift_{name}": told[name] for name in ("state", "floor_px", "moved_px", "height_m")},
        "drift_checked_at": None if at is None else at.replace("+00:00", "Z"),
    }


def decision_cells(decision: Mapping[str, Any] | None, pose_id: int | None) -> Cells:
    """The columns of what a person decided about the pose in force."""
    if decision is None or decision["pose_id"] != pose_id:
        return dict.fromkeys(("drift_decision", "drift_decided_by_id", "drift_decided_at"))
    return {
        "drift_decision": decision["reason"],
        "drift_decided_by_id": decision["by_id"],
        "drift_decided_at": decision["at"].replace("+00:00", "Z"),
    }


def pose_row(pose: Pose) -> Cells:
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


def calibration_row(one: Calibration, cameras: Mapping[int, Camera]) -> Cells:
    fields = "model width_px height_px fx_px fy_px cx_px cy_px rms_px"
    camera = cameras.get(one.camera_id)
    return {
        "id": one.id,
        "camera_id": one.camera_id,
        "camera_name": None if camera is None else camera.name,
        "source": one.source,
        **{name: one.document.get(name) for name in fields.split()},
        "distortion": " ".join(repr(float(value)) for value in one.document["distortion"]),
        "trusted": one.trusted,
        "document": calibration_path(one.id),
        "created_by_id": _who(one.created_by),
        "created_at": when(one.created_at),
    }


def review_row(one: Review) -> Cells:
    return {
        "id": one.id,
        "measurement_id": one.measurement_id,
        "revision": one.revision,
        "result_revision": one.result_revision,
        "verdict": one.verdict,
        "reason": one.reason,
        "reviewer_id": _who(one.reviewer),
        "at": when(one.at),
    }


def inset_rows(survey: Survey) -> list[Cells]:
    return [
        {"target": target, "inset_m": inset.inset_m, "u_inset_m": inset.u_inset_m, "note": inset.note}
        for target, inset in sorted(survey.insets.items())
    ]


_TOLD = ("at", "actor_id", "action", "entity", "entity_id", "survey_id", "before", "after")


def audit_row(event: Mapping[str, Any], withheld: bool) -> Cells:
    """One link; its content as the text that was hashed, or left out."""
    links = {name: event[name] for name in ("id", "previous_hash", "content_sha256", "hash")}
    told = {} if withheld else {name: event[name] for name in _TOLD}
    return {**links, **told, "withheld": withheld}
