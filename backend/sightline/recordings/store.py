"""Recordings: from upload through ingest to use. Their frame tables are in `frames`."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, replace
from typing import Any, cast, get_args

from sqlalchemy import ColumnElement, select
from sqlalchemy.orm import Session

from sightline.cameras.tables import cameras
from sightline.enums import AuditAction, JsonObject, StreetLighting
from sightline.errors import BadInput, Conflict
from sightline.infra.audit import trail
from sightline.infra.audit.changing import take_out_along
from sightline.infra.database.rows import add_row, change_row, get_row, is_held, name_of, named_table
from sightline.infra.database.types import HOLDS, KEEPS_TIMES, columns_of, now
from sightline.infra.jobs.store import latest_jobs_of_recordings
from sightline.media.video.frame_table import FrameTable
from sightline.messages.said import Said
from sightline.recordings.drift import (
    DriftCheck,
    DriftChecks,
    DriftDecision,
    drift_check_of,
    drift_figures,
    spans_told,
)
from sightline.recordings.frames.records import lasting_s
from sightline.recordings.frames.store import (
    change_times,
    frame_table_fingerprint,
    get_frame_table,
    remove_frames,
    replace_frames,
)
from sightline.recordings.frames.tables import frames
from sightline.recordings.records import Facts, Recording, RecordingChanges
from sightline.recordings.tables import recordings
from sightline.surveys.tables import surveys

_INGESTED = (
    "width_px",
    "height_px",
    "duration_s",
    "codec",
    "container",
    "vfr",
    "frame_count",
    "stream_number",
)
_SAME_S = 1e-6
_ALIVE: ColumnElement[bool] = recordings.c.deleted_at.is_(None)
_NAMED = [column.name for column in columns_of(recordings, "created_by", "deleted_at")]


def create_recording(
    session: Session,
    survey_id: int,
    *,
    name: str,
    media_key: str,
    sha256: str,
    size_bytes: int,
    camera_id: int | None = None,
    stream_number: int | None = None,
    actor: int | None,
) -> Recording:
    """A recording whose file is stored and whose ingest is to come (state "ingesting")."""
    get_row(session, surveys, survey_id, "survey")
    content = {"survey_id": survey_id, "name": name.strip() or "recording", "media_key": media_key}
    content |= {"sha256": sha256, "size_bytes": size_bytes, "camera_id": camera_id}
    content |= {} if stream_number is None else {"stream_number": stream_number}
    if camera_id is not None:
        _same_survey(session, cameras, camera_id, "camera", survey_id)
    empty: dict[str, Any] = {"vfr": False, "notes": [], "report": {}, "thumbs": []}
    stamps = {"state": "ingesting", "created_at": now(), "created_by": actor}
    recording_id = add_row(session, recordings, {**content, **empty, **stamps})
    trail.record(session, actor, "create", "recording", recording_id, survey_id, None, content)
    return get_recording(session, recording_id)


def get_recording(session: Session, recording_id: int) -> Recording:
    """One recording with its latest job. Raises NotFound (also when it was deleted)."""
    return _recordings(session, [_get_living_row(session, recording_id)])[0]


def get_ready_recording(session: Session, recording_id: int) -> Recording:
    """One whose frames can be looked at. Raises NotFound, BadInput while or because it has none."""
    recording = get_recording(session, recording_id)
    if recording.state == "failed":
        raise BadInput("recordings-import-failed", name=recording.name)
    if recording.state != "ready":
        raise BadInput("recordings-not-ready", name=recording.name)
    return recording


def list_recordings(session: Session, survey_id: int) -> tuple[Recording, ...]:
    """The recordings of a survey, in the order in which they came; two queries."""
    query = select(recordings).where(recordings.c.survey_id == survey_id, _ALIVE).order_by(recordings.c.id)
    return _recordings(session, [dict(row) for row in session.execute(query).mappings()])


def update_recording(
    session: Session, recording_id: int, changes: RecordingChanges, *, actor: int | None
) -> Recording:
    """Change name, camera, pose, lighting, or when and in what weather it was filmed.

    Raises NotFound, BadInput for things of another survey.
    """
    before = _get_living_row(session, recording_id)
    change: dict[str, Any] = dict(changes)
    unknown = set(change) - set(RecordingChanges.__annotations__)
    if unknown:
        raise BadInput("recordings-field-unknown", unknown=", ".join(sorted(unknown)))
    if "filming" in change:
        filming = change.pop("filming")
        change |= dict.fromkeys(("started_at", "time_zone")) if filming is None else asdict(filming)
    if "name" in change and not str(change["name"]).strip():
        raise BadInput("recordings-no-name")
    if change.get("lighting") not in (None, "daytime", "low_light"):
        raise BadInput("recordings-lighting-unknown")
    if change.get("street_lighting") not in (None, *get_args(StreetLighting)):
        raise BadInput("recordings-street-lighting-unknown")
    for column, word in ((recordings.c.camera_id, "camera"), (recordings.c.pose_id, "camera pose")):
        if change.get(column.name) is not None:
            row_id = cast(int, change[column.name])
            _same_survey(session, named_table(column), row_id, word, before["survey_id"])
    if change.get("pose_id") is not None:
        _same_size(session, before, cast(int, change["pose_id"]))
    return _write(session, before, change, "update", actor, trail.changed_fields(before, change, change))


def note_ingested(
    session: Session, recording_id: int, facts: Facts, frame_table: FrameTable, *, actor: int | None
) -> Recording:
    """Store what the ingest found and the frame table; the recording is ready. May be repeated.

    Raises Conflict when measurements exist and the new frames are not the ones they were clicked on; their
    times may be others where those of before were in doubt, so that nothing was measured from them.
    """
    before = _get_living_row(session, recording_id)
    fingerprint = frame_table_fingerprint(frame_table)
    if is_held(session, recordings, recording_id):
        known = get_frame_table(session, recording_id)
        if before["report"].get("clock_doubt") and before["filmed_hz"] is not None:
            known = replace(
                known, time_s=frame_table.time_s if len(known) == len(frame_table) else known.time_s
            )
            if fingerprint == frame_table_fingerprint(known):
                change_times(session, recording_id, frame_table.time_s)
        if fingerprint != frame_table_fingerprint(known):
            raise Conflict("recordings-frames-differ")
    else:
        replace_frames(session, recording_id, frame_table)
    values = {**asdict(facts), "frame_count": len(frame_table), "state": "ready", "error": None}
    told = {key: values[key] for key in _INGESTED}
    after = {"state": "ready", **told, "frames_sha256": fingerprint}
    return _write(session, before, values, "ingest", actor, ({"state": before["state"]}, after))


def require_same_pictures(session: Session, recording_id: int, frame_table: FrameTable) -> None:
    """Raises Conflict when measurements exist and these frames, but for times, are not those clicked on."""
    if not is_held(session, recordings, recording_id):
        return
    known = get_frame_table(session, recording_id)
    same = len(known) == len(frame_table) and frame_table_fingerprint(known) == frame_table_fingerprint(
        replace(frame_table, time_s=known.time_s)
    )
    if not same:
        raise Conflict("recordings-frames-differ")


def durations_to_correct(session: Session) -> dict[int, float]:
    """What earlier versions stored otherwise: how long recordings last by their frame tables, s, by number.
    They let the last frame last as long as the mean one, with every pause in it.
    """
    corrected = {}
    first, last = frames.alias(), frames.alias()
    lasts_s = last.c.time_s - first.c.time_s
    query = (
        select(recordings.c.id, recordings.c.duration_s, lasts_s, recordings.c.frame_count)
        .join(first, (first.c.recording_id == recordings.c.id) & (first.c.n == 0))
        .join(last, (last.c.recording_id == recordings.c.id) & (last.c.n == recordings.c.frame_count - 1))
        .where(_ALIVE, recordings.c.state == "ready", recordings.c.vfr, recordings.c.frame_count > 1)
    )
    for recording_id, stored_s, between_s, count in session.execute(query).all():
        if stored_s is None or abs(stored_s - between_s - between_s / (count - 1)) > _SAME_S:
            continue
        true_s = lasting_s(get_frame_table(session, recording_id).time_s)
        if abs(stored_s - true_s) > _SAME_S:
            corrected[recording_id] = true_s
    return corrected


def change_fact(
    session: Session, recording_id: int, name: str, value: float | None, *, actor: int | None
) -> None:
    """Store what is known of a recording (`duration_s`, `stream_number`), where something else stands."""
    before = _get_living_row(session, recording_id)
    if before[name] != value:
        _write(session, before, {name: value}, "update", actor)


def note_ingest_failed(session: Session, recording_id: int, error: Said, *, actor: int | None) -> Recording:
    """The video cannot be used; `error` says why."""
    return _state(session, recording_id, "failed", error, "ingest_failed", actor)


def restart_ingest(session: Session, recording_id: int, *, actor: int | None) -> Recording:
    """Back to "ingesting" for another try."""
    return _state(session, recording_id, "ingesting", None, "restart_ingest", actor)


def state_filming_rate(
    session: Session, recording_id: int, filmed_hz: float, *, actor: int | None
) -> Recording:
    """A person says at how many frames per second it was filmed: it is to be read again, with those times.

    Raises as `require_times_in_doubt`.
    """
    require_times_in_doubt(session, recording_id)
    _write(session, _get_living_row(session, recording_id), {"filmed_hz": filmed_hz}, "update", actor)
    return restart_ingest(session, recording_id, actor=actor)


def require_times_in_doubt(session: Session, recording_id: int) -> None:
    """Raise Conflict where a recording is not ready, where nothing is in doubt, and where the rate that was
    said before has been measured with.
    """
    before = _get_living_row(session, recording_id)
    if before["state"] != "ready":
        raise Conflict("recordings-not-ready", name=before["name"])
    if not before["report"].get("clock_doubt"):
        if before["filmed_hz"] is None:
            raise Conflict("recordings-times-are-filming", name=before["name"])
        if is_held(session, recordings, recording_id, (HOLDS, KEEPS_TIMES)):
            raise Conflict("recordings-rate-in-use", name=before["name"])


def remove_recording(session: Session, recording_id: int, *, actor: int | None) -> Recording:
    """Delete (softly) a recording without measurements, with its passes; its frame table goes. Raises
    Conflict otherwise.

    The caller lets go of its files.
    """
    gone = get_recording(session, recording_id)
    if is_held(session, recordings, recording_id):
        raise Conflict("recordings-measured")
    take_out_along(session, recordings, recording_id, actor=actor)
    remove_frames(session, recording_id)
    change_row(session, recordings, recording_id, {"deleted_at": now()})
    before = {"name": gone.name, "sha256": gone.sha256}
    after = {"deleted": True}
    trail.record(session, actor, "delete", "recording", recording_id, gone.survey_id, before, after)
    return gone


def store_drift(
    session: Session, recording_id: int, pose_id: int, check: DriftCheck, *, actor: int | None
) -> Recording:
    """What was found of a camera that moved since a camera pose; what was found against others stays."""
    before = _get_living_row(session, recording_id)
    none: DriftChecks = {"checks": {}}
    known: DriftChecks = before["drift"] or none
    drift: DriftChecks = {"checks": {**known["checks"], str(pose_id): check}}
    old = drift_check_of(known, pose_id)
    then = {"pose_id": pose_id, "drift": None if old is None else old["words"]}
    seen: dict[str, Any] = {"drift": check["words"], "bumps": check["bumps"], "found": drift_figures(check)}
    seen["spans"] = spans_told(check)
    return _write(
        session, before, {"drift": drift}, "check_drift", actor, (then, {"pose_id": pose_id, **seen})
    )


def decide_drift(session: Session, recording_id: int, reason: str, *, actor: int | None) -> Recording:
    """A person lets the pose in force stand although the camera moved. Raises Conflict if it did not."""
    before = _get_living_row(session, recording_id)
    check = drift_check_of(before["drift"], before["pose_id"])
    if check is None or check["state"] != "moved":
        raise Conflict("recordings-camera-not-moved")
    if not reason.strip():
        raise BadInput("recordings-pose-without-reason")
    decision: DriftDecision = {
        "pose_id": before["pose_id"],
        "spans": [one for one in check["spans"] if one["moved"]],
        "reason": reason.strip(),
        "by": name_of(session, actor),
        "by_id": actor,
        "at": now().isoformat(timespec="seconds"),
    }
    return _write(session, before, {"drift_decision": decision}, "decide_drift", actor)


def take_back_drift_decision(session: Session, recording_id: int, *, actor: int | None) -> Recording:
    """The measurements after the bump are flagged again. Raises Conflict where nothing was decided."""
    before = _get_living_row(session, recording_id)
    if before["drift_decision"] is None:
        raise Conflict("recordings-no-decision")
    return _write(session, before, {"drift_decision": None}, "take_back_drift_decision", actor)


def recordings_of_content(session: Session, sha256: str, stream_number: int | None) -> list[int]:
    """The recordings that were not deleted and read this picture of this content, whatever their names.

    One that is being read does not know yet which of several pictures it has.
    """
    picture = recordings.c.stream_number
    same = recordings.c.sha256 == sha256, picture.is_(None) | picture.is_not_distinct_from(stream_number)
    return list(session.execute(select(recordings.c.id).where(*same, _ALIVE)).scalars())


def _state(
    session: Session,
    recording_id: int,
    state: str,
    error: Said | None,
    action: AuditAction,
    actor: int | None,
) -> Recording:
    before, change = _get_living_row(session, recording_id), {"state": state, "error": error}
    return _write(session, before, change, action, actor, ({"state": before["state"]}, change))


def _write(
    session: Session,
    before: Mapping[str, Any],
    change: Mapping[str, Any],
    action: AuditAction,
    actor: int | None,
    told: tuple[JsonObject, JsonObject] | None = None,
) -> Recording:
    """Change a row; its event has what changes, before and after, or what is to be `told`."""
    then, after = told or ({name: before[name] for name in change}, dict(change))
    if change:
        change_row(session, recordings, before["id"], change)
    trail.record(session, actor, action, "recording", before["id"], before["survey_id"], then, after)
    return get_recording(session, before["id"])


def _get_living_row(session: Session, recording_id: int) -> dict[str, Any]:
    return get_row(session, recordings, recording_id, "recording", _ALIVE)


def _same_survey(session: Session, table: Any, row_id: int, word: str, survey_id: int) -> None:
    if get_row(session, table, row_id, word)["survey_id"] != survey_id:
        raise BadInput("recordings-named-other-survey", word=word, row_id=row_id)


def _same_size(session: Session, recording: Mapping[str, Any], pose_id: int) -> None:
    """A pose's pixels are those of its camera's pictures: at another size every height would be wrong."""
    document = get_row(session, named_table(recordings.c.pose_id), pose_id, "camera pose")["document"]
    camera = document.get("camera", {})
    posed = (camera.get("width_px"), camera.get("height_px"))
    filmed = (recording["width_px"], recording["height_px"])
    if None not in posed + filmed and posed != filmed:
        raise BadInput(
            "recordings-pose-image-size",
            pose_id=pose_id,
            posed=posed[0],
            posed_2=posed[1],
            name=recording["name"],
            filmed=filmed[0],
            filmed_2=filmed[1],
        )


def _recordings(session: Session, rows: Sequence[Mapping[str, Any]]) -> tuple[Recording, ...]:
    latest = latest_jobs_of_recordings(session, [row["id"] for row in rows])
    return tuple(Recording(job=latest.get(row["id"]), **{name: row[name] for name in _NAMED}) for row in rows)
