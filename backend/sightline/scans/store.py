"""Line-scan recordings: from two strips (or two columns of a video) through reading to use."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, fields, replace
from datetime import datetime
from functools import partial
from typing import Any, cast, get_args

from sqlalchemy import ColumnElement, func, select
from sqlalchemy import update as sql_update
from sqlalchemy.orm import Session

from sightline.enums import AuditAction, Lighting, ScanDirection, TimeAxis
from sightline.errors import BadInput, Conflict
from sightline.infra.audit import trail
from sightline.infra.audit.changing import alter_row, change_since, make_rows, take_out_row
from sightline.infra.database.rows import change_row, get_row, names, who
from sightline.infra.jobs.store import latest_jobs_of_scans
from sightline.linescan.parts import Rig
from sightline.linescan.rig import CALIBRATED, at_lane, require_rig, rig_from
from sightline.measurements.tables import measurement_series
from sightline.messages.said import Said
from sightline.recordings.tables import recordings
from sightline.recordings.uploads.tables import uploads
from sightline.scans.clock import CLOCK
from sightline.scans.heights.store import scan_height_states
from sightline.scans.heights.tables import line_poses
from sightline.scans.live.tables import scan_live
from sightline.scans.records import (
    Changes,
    CutSource,
    LiveSource,
    Scan,
    ScanCounts,
    StripFacts,
    StripSource,
    state_of,
)
from sightline.scans.rig.tables import rig_calibrations
from sightline.scans.tables import scan_measurements, scan_reviews, scan_vehicles, scans
from sightline.scans.vehicles.run_store import latest_scan_runs
from sightline.scans.vehicles.store import counts_of_scans
from sightline.surveys.tables import surveys

#: The values of a rig, by name.
RIG = tuple(one.name for one in fields(Rig))
# What changes places with the cameras; a lane's direction is told by the camera that is reached first.
_PAIRS = (
    ("cut_1_px", "cut_2_px"),
    *(
        (f"first_{word}", f"second_{word}")
        for word in ("name", "source_key", "source_sha256", "key", "sha256")
    ),
)
_OTHER_WAY = dict(zip(get_args(ScanDirection), reversed(get_args(ScanDirection)), strict=True))
_ALIVE: ColumnElement[bool] = scans.c.deleted_at.is_(None)
_CHANGEABLE = {"name", "lighting", *RIG, *CLOCK}
_DERIVED = ("rig", "start_proposed", "heard_at", "job", "counts", "run", "created_by", "updated_by")
_NAMED = [one.name for one in fields(Scan) if one.name not in _DERIVED]


def create_scan(
    session: Session,
    survey_id: int,
    *,
    name: str,
    source: tuple[StripSource, StripSource] | CutSource | LiveSource,
    time_axis: TimeAxis,
    rig: Rig,
    lighting: Lighting | None = None,
    actor: int | None,
) -> Scan:
    """A scan whose strips are stored and whose reading is to come (state "reading"), or are coming ("live").

    Strips that came as uploads belong to it from then on. Raises BadInput for things of another survey.
    """
    get_row(session, surveys, survey_id, "survey")
    require_rig(rig)
    content: dict[str, Any] = {"survey_id": survey_id, "name": name.strip() or "line scan"}
    content |= {"time_axis": time_axis, "lighting": lighting, **rig_columns(rig), **dict.fromkeys(CLOCK)}
    if isinstance(source, CutSource):
        recording = get_row(session, recordings, source.recording_id, "recording")
        if recording["survey_id"] != survey_id:
            raise BadInput("scans-recording-other-survey")
        content |= {"source": "video", "first_source_sha256": recording["sha256"], **asdict(source)}
    elif isinstance(source, LiveSource):
        content["source"] = "live"
    else:
        content |= _strip_columns(source)
        content["source"] = "strips"
    begun: dict[str, Any] = {"state": "live" if isinstance(source, LiveSource) else "reading", "notes": []}
    (scan_id,) = make_rows(session, scans, [content], survey_id=survey_id, untold=begun, actor=actor)
    if isinstance(source, tuple):
        _take_uploads(session, scan_id, source)
    return get_scan(session, scan_id)


def _take_uploads(session: Session, scan_id: int, source: tuple[StripSource, StripSource]) -> None:
    ids = [one.upload_id for one in source if one.upload_id is not None]
    session.execute(sql_update(uploads).where(uploads.c.id.in_(ids)).values(scan_id=scan_id))


def get_scan(session: Session, scan_id: int) -> Scan:
    """One scan with its latest job and run. Raises NotFound (also when it was deleted)."""
    return _scans(session, [_get_living_row(session, scan_id)])[0]


def list_scans(session: Session, survey_id: int) -> tuple[Scan, ...]:
    """The scans of a survey, in the order in which they came."""
    query = select(scans).where(scans.c.survey_id == survey_id, _ALIVE).order_by(scans.c.id)
    return _scans(session, [dict(row) for row in session.execute(query).mappings()])


def note_scan_read(session: Session, scan_id: int, facts: StripFacts, *, actor: int | None) -> Scan:
    """Both tiled forms are stored; the scan is ready. May be repeated."""
    return _note(session, scan_id, {**asdict(facts), "state": "ready", "error": None}, "read", actor)


def note_scan_recorded(
    session: Session, scan_id: int, source: tuple[StripSource, StripSource], *, actor: int | None
) -> Scan:
    """A live stream has ended and its strips are stored; their reading is to come."""
    _take_uploads(session, scan_id, source)
    return _note(session, scan_id, {**_strip_columns(source), "state": "reading"}, "recorded", actor)


def note_reading_failed(session: Session, scan_id: int, error: Said, *, actor: int | None) -> Scan:
    """The strips cannot be used; `error` says why."""
    return _note(session, scan_id, {"state": "failed", "error": error}, "reading_failed", actor)


def restart_reading(session: Session, scan_id: int, *, actor: int | None) -> Scan:
    """Back to "reading" for another try."""
    return _note(session, scan_id, {"state": "reading", "error": None}, "restart_reading", actor)


def update_scan(session: Session, scan_id: int, changes: Changes, *, version: int, actor: int | None) -> Scan:
    """Change name, lighting, the start or values of the rig. What was measured stays, with its rig.

    Raises Conflict, naming who and when, if `version` is not the current one; BadInput.
    """
    before = _get_living_row(session, scan_id)
    if by := change_since(session, before, version):
        raise Conflict("scans-changed-meanwhile", name=by[0], when=by[1], name_2=before["name"])
    change: dict[str, Any] = dict(changes)
    if "clock" in change:
        clock = change.pop("clock")
        change |= dict.fromkeys(CLOCK) if clock is None else clock.columns()
    unknown = set(change) - _CHANGEABLE
    if unknown:
        raise BadInput("scans-field-unknown", unknown=", ".join(sorted(unknown)))
    if "name" in change and not str(change["name"]).strip():
        raise BadInput("scans-no-name")
    if any(key in change and change[key] != before[key] for key in CALIBRATED):
        change.setdefault("baseline_correlation", 0.0)
    rig = rig_from({key: change.get(key, before[key]) for key in RIG})
    require_rig(rig)
    if "lanes" in change:
        change["lanes"] = rig_columns(rig)["lanes"]
    alter_row(session, scans, before, change, actor=actor)
    return get_scan(session, scan_id)


def swap_scan_cameras(session: Session, scan_id: int, *, version: int, actor: int | None) -> Scan:
    """What was camera 2 is camera 1 from now on. Vehicles must be found again; until then theirs are wrong.

    Raises NotFound, Conflict (another's change in between; not read yet; people have worked on it: their
    boundaries belong to the order in which they were placed).
    """
    row = _get_living_row(session, scan_id)
    if by := change_since(session, row, version):
        raise Conflict("scans-changed-meanwhile", name=by[0], when=by[1], name_2=row["name"])
    if row["state"] != "ready":
        raise Conflict("scans-unread", name=row["name"])
    if scan_worked_on(session, scan_id):
        raise Conflict("scans-cameras-worked-on", name=row["name"])
    change = {name: row[other] for pair in _PAIRS for name, other in (pair, pair[::-1])}
    if row["misalignment_px"] is not None:
        change["misalignment_px"] = -row["misalignment_px"]
    change["lanes"] = [{**one, "direction": _OTHER_WAY.get(one["direction"])} for one in row["lanes"]]
    alter_row(session, scans, row, change, "swap_cameras", actor=actor)
    return get_scan(session, scan_id)


def remove_scan(session: Session, scan_id: int, *, actor: int | None) -> Scan:
    """Delete (softly) a scan on which nobody worked yet; its vehicles leave all lists with it.

    Raises Conflict where a person placed boundaries, filled in facts, calibrated, measured a height or gave
    a verdict. The caller lets go of its files.
    """
    gone = get_scan(session, scan_id)
    if scan_worked_on(session, scan_id):
        raise Conflict("scans-worked-on")
    take_out_row(session, scans, _get_living_row(session, scan_id), "name", actor=actor)
    return gone


def _strip_columns(source: tuple[StripSource, StripSource]) -> dict[str, Any]:
    columns: dict[str, Any] = {}
    for word, one in zip(("first", "second"), source, strict=True):
        columns |= {f"{word}_name": one.name, f"{word}_source_key": one.media_key}
        columns[f"{word}_source_sha256"] = one.sha256
    return columns


def rig_columns(rig: Rig) -> dict[str, Any]:
    """The rig as it is stored and compared."""
    return {**{name: getattr(rig, name) for name in RIG}, "lanes": [asdict(one) for one in rig.lanes]}


def rig_for(rig: Rig, lane: str | None, way: ScanDirection) -> dict[str, Any]:
    """The rig as a vehicle of a lane and direction is measured with it, as it is stored and compared."""
    return rig_columns(at_lane(rig, lane, way))


def _note(
    session: Session, scan_id: int, values: dict[str, Any], action: AuditAction, actor: int | None
) -> Scan:
    """What became of a scan's strips."""
    before = _get_living_row(session, scan_id)
    change_row(session, scans, scan_id, values)
    then = {"state": before["state"]}
    trail.record(session, actor, action, "scan", scan_id, before["survey_id"], then, values)
    return get_scan(session, scan_id)


def _get_living_row(session: Session, scan_id: int) -> dict[str, Any]:
    return get_row(session, scans, scan_id, "line-scan recording", _ALIVE)


def scan_worked_on(session: Session, scan_id: int) -> bool:
    """Whether a person placed, filled in, calibrated, measured or judged something of this scan."""
    placed = select(scan_measurements.c.id).where(
        scan_measurements.c.scan_id == scan_id, scan_measurements.c.placed_by.is_not(None)
    )
    judged = (
        select(scan_reviews.c.id)
        .join(scan_measurements, scan_measurements.c.id == scan_reviews.c.measurement_id)
        .where(scan_measurements.c.scan_id == scan_id)
    )
    filled = select(scan_vehicles.c.id).where(
        scan_vehicles.c.scan_id == scan_id,
        (scan_vehicles.c.make.is_not(None)) | (scan_vehicles.c.true_length_m.is_not(None)),
    )
    stored = (line_poses, measurement_series, rig_calibrations)
    made = (select(one.c.id).where(one.c.scan_id == scan_id) for one in stored)
    found = (placed, judged, filled, *made)
    return any(session.execute(one.limit(1)).first() is not None for one in found)


def _scans(session: Session, rows: Sequence[Mapping[str, Any]]) -> tuple[Scan, ...]:
    ids = [row["id"] for row in rows]
    latest, runs = latest_jobs_of_scans(session, ids), latest_scan_runs(session, ids)
    people = names(session, [row[key] for row in rows for key in ("created_by", "updated_by")])
    rigs = {row["id"]: rig_from({key: row[key] for key in RIG}) for row in rows}
    counted = counts_of_scans(session, {key: partial(rig_for, rig) for key, rig in rigs.items()})
    heights, begun = _height_counts(session, ids), _begun(session, [row["recording_id"] for row in rows])
    heard = _heard(session, [row["id"] for row in rows if row["state"] == "live"])
    return tuple(
        Scan(
            rig=rigs[row["id"]],
            job=latest.get(row["id"]),
            run=runs.get(row["id"]),
            start_proposed=begun.get(row["recording_id"]),
            heard_at=heard.get(row["id"]),
            counts=replace(counted.get(row["id"], ScanCounts()), **heights[row["id"]]),
            created_by=who(row["created_by"], people.get(cast(int, row["created_by"]))),
            updated_by=who(row["updated_by"], people.get(cast(int, row["updated_by"]))),
            **{name: row[name] for name in _NAMED},
        )
        for row in rows
    )


def _heard(session: Session, live_ids: Sequence[int]) -> dict[int, datetime]:
    """When the streams of scans that are still live were last heard."""
    query = select(scan_live.c.scan_id, scan_live.c.heard_at).where(scan_live.c.scan_id.in_(live_ids))
    return {row.scan_id: row.heard_at for row in session.execute(query)} if live_ids else {}


def _begun(session: Session, recording_ids: Sequence[int | None]) -> dict[int | None, datetime]:
    """When the videos that scans were cut from began: as a person said, else as their files state."""
    at = func.coalesce(recordings.c.started_at, recordings.c.start_proposed)
    query = select(recordings.c.id, at).where(recordings.c.id.in_(set(recording_ids) - {None}))
    return {id_: begun for id_, begun in session.execute(query) if begun is not None}


def _height_counts(session: Session, scan_ids: Sequence[int]) -> dict[int, dict[str, int]]:
    """How many standing heights each scan has, and how many of them wait for a verdict."""
    counted = {scan_id: {"heights": 0, "heights_to_review": 0} for scan_id in scan_ids}
    for scan_id, verdict in session.execute(scan_height_states(measurement_series.c.scan_id.in_(scan_ids))):
        counted[scan_id]["heights"] += 1
        counted[scan_id]["heights_to_review"] += state_of("ok", verdict) == "to_review"
    return counted
