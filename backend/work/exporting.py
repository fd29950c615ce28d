"""Exports: the CSV package of a survey as one transaction saw it; the same state gives the same bytes."""

from __future__ import annotations

import hashlib
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from sqlalchemy.orm import Session

from backend.media.store import check_room, key_of
from backend.storage import (
    audit,
    calibrations,
    cameras,
    exports,
    measurements,
    poses,
    recordings,
    reviews,
    surveys,
    vehicles,
    wheel_pairs,
)
from backend.storage.records import AuditHead, Job, Survey
from backend.work import exporting_rows as rows
from backend.work import exporting_tables as tables
from backend.work import jobs
from backend.work.exporting_repeats import REPEATS, repeat_rows
from backend.work.exporting_rows import SurveyState
from backend.work.exporting_wheels import WHEEL_PAIRS, wheel_pair_rows
from backend.work.packaging import (
    DESCRIPTION,
    Package,
    csv_bytes,
    describe,
    json_bytes,
    with_checksums,
    zip_bytes,
)
from backend.work.services import services_of

KIND = "export"

_ROWS = {
    tables.MEASUREMENTS: rows.measurement_rows,
    tables.REVISIONS: rows.revision_rows,
    tables.BUDGET: rows.budget_rows,
    tables.CLICKS: rows.click_rows,
    tables.VEHICLES: rows.vehicle_rows,
    tables.RECORDINGS: rows.recording_rows,
    tables.FRAMES: rows.frame_rows,
    tables.POSES: rows.pose_rows,
    tables.CALIBRATIONS: rows.calibration_rows,
    tables.REVIEWS: rows.review_rows,
    tables.INSETS: rows.inset_rows,
    WHEEL_PAIRS: lambda state: wheel_pair_rows(state.wheel_pairs),
    REPEATS: lambda state: repeat_rows(state.repeats),
    tables.PEOPLE: rows.person_rows,
    tables.AUDIT: rows.audit_rows,
}


def find_survey(session: Session, name: str) -> Survey:
    """A survey by its name, or by its number where no survey has that name. Raises BadInput, NotFound."""
    known = [survey for survey in surveys.list_all(session) if survey.name == name]
    if not known and name.isdigit():
        return surveys.get(session, int(name))
    return known[0] if known else surveys.by_name(session, name)


def state_of(session: Session, survey_id: int) -> SurveyState:
    """Everything that is stored of a survey. Raises NotFound."""
    survey = surveys.get(session, survey_id)
    stored = measurements.list_for_survey(session, survey_id, include_withdrawn=True, include_repeats=True)
    current = tuple(one for one in stored if one.repeat_of is None)
    known = {one.id for one in current}
    return SurveyState(
        survey=survey,
        cameras=cameras.list_for_survey(session, survey_id),
        calibrations=calibrations.list_for_survey(session, survey_id),
        recordings=recordings.list_for_survey(session, survey_id),
        poses=poses.whole_for_survey(session, survey_id),
        vehicles=tuple(sorted(vehicles.list_for_survey(session, survey_id), key=lambda one: one.id)),
        current=current,
        revisions=measurements.list_for_survey(session, survey_id, every_revision=True),
        reviews=tuple(
            one for one in reviews.list_for_survey(session, survey_id) if one.measurement_id in known
        ),
        audit=audit.for_export(session),
        wheel_pairs=wheel_pairs.list_for_survey(session, survey_id),
        repeats=tuple(one for one in stored if one.repeat_of is not None),
    )


def package_of(state: SurveyState) -> Package:
    """All files of the package: tables, poses, calibrations, clicks per pose, description and checksums."""
    most = rows.most_frames(state)
    files: dict[str, bytes] = {
        table.path: csv_bytes(tables.with_frames(table, most), make(state)) for table, make in _ROWS.items()
    }
    for pose in state.poses:
        files[rows.pose_path(pose.id)] = json_bytes(pose.document)
    for calibration in state.calibrations:
        files[rows.calibration_path(calibration.id)] = json_bytes(calibration.document)
    clicks = rows.click_rows(state)
    for pose_id in sorted({int(str(row["pose_id"])) for row in clicks}):
        mine = [row for row in clicks if row["pose_id"] == pose_id]
        files[rows.clicks_path(pose_id)] = csv_bytes(tables.with_frames(tables.CLICKS, most), mine)
    title = f"{state.survey.name}, {state.survey.site}" if state.survey.site else state.survey.name
    described = tuple(tables.with_frames(table, most) for table in tables.TABLES)
    files[DESCRIPTION] = describe(title, _about(state), _last_change(state), described, files)
    return with_checksums(files)


def _about(state: SurveyState) -> str:
    said = state.survey.description.strip()
    about = (
        "Heights of vehicles measured from roadside video with Sightline. Lengths are in metres with six "
        "decimals; u_ is a standard uncertainty (k = 1), U95_ the half-width of the 95 % interval; pixels "
        "have (0, 0) at the centre of the top-left pixel. `sightline verify` checks this folder; `sightline "
        "height --pose poses/pose-N.json --clicks clicks/pose-N.csv` computes its heights again. An "
        "apostrophe stands before any text that a spreadsheet would run as a formula."
    )
    return f"{said}\n\n{about}" if said else about


def _last_change(state: SurveyState) -> str | None:
    """When the last event of the chain happened: the package is dated by its content, not by the clock."""
    return rows.when(state.audit[-1].at) if state.audit else None


def head_of(state: SurveyState) -> AuditHead:
    """The end of the audit chain that the package carries."""
    if not state.audit:
        return AuditHead(0, "")
    return AuditHead(state.audit[-1].id, state.audit[-1].hash)


def request_export(session: Session, survey_id: int, *, actor: int) -> Job:
    """Queue an export. Raises NotFound."""
    surveys.get(session, survey_id)
    return jobs.enqueue(session, KIND, {"survey_id": survey_id}, survey_id=survey_id, actor=actor)


@jobs.handler(KIND)
def export(context: jobs.JobContext) -> jobs.Outcome:
    """Build the package, keep it in the media store, and note it with the head of the audit chain."""
    survey_id = int(context.payload["survey_id"])
    services = services_of(context)
    context.progress(0.05, "Reading the survey.")
    with services.reading() as session:
        state = state_of(session, survey_id)
    context.progress(0.4, "Writing the tables.")
    content = zip_bytes(package_of(state))
    context.progress(0.8, "Storing the package.")
    sha256 = hashlib.sha256(content).hexdigest()
    key = key_of(sha256, ".zip")
    check_room(services.scratch, 2 * len(content), "this export")  # here, and in the media store
    with tempfile.TemporaryDirectory(dir=services.scratch) as folder:
        path = Path(folder) / "export.zip"
        path.write_bytes(content)
        services.media.put_file(key, path)

    def store(session: Session) -> Mapping[str, Any]:
        made = exports.add(
            session,
            survey_id,
            media_key=key,
            size_bytes=len(content),
            sha256=sha256,
            head=head_of(state),
            actor=context.actor,
        )
        return {"export_id": made.id}

    return store
