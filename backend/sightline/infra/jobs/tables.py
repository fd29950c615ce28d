"""The table of jobs."""

from sqlalchemy import Boolean, CheckConstraint, Column, Float, ForeignKey, Index, Integer, String, false

from sightline.enums import JobState
from sightline.infra.database.types import (
    CanonicalJson,
    Saying,
    UtcDateTime,
    enum_check,
    made_columns,
    numbered_table,
)

jobs = numbered_table(
    "jobs",
    Column("kind", String(60), nullable=False),
    Column("state", String(20), nullable=False),
    Column("payload", CanonicalJson, nullable=False),
    Column("progress", Float, nullable=False),
    Column("message", Saying),
    Column("error", Saying),
    Column("result", CanonicalJson),
    Column("survey_id", ForeignKey("surveys.id"), index=True),
    Column("recording_id", ForeignKey("recordings.id"), index=True),
    Column("scan_id", Integer, ForeignKey("scans.id", use_alter=True), index=True),
    # work of a study, which has members of its own
    Column("study_id", Integer, ForeignKey("studies.id", use_alter=True), index=True),
    Column("attempts", Integer, nullable=False),
    # how often the database or the storage was away while it was done, and when it may be begun again
    Column("outages", Integer, nullable=False, server_default="0"),
    Column("not_before", UtcDateTime),
    Column("worker", String(200)),
    Column("cancel_requested", Boolean, nullable=False, server_default=false()),
    *made_columns(),
    Column("started_at", UtcDateTime),
    Column("finished_at", UtcDateTime),
    enum_check("state", JobState),
    CheckConstraint("progress >= 0 AND progress <= 1", name="progress_fraction"),
    CheckConstraint("state <> 'failed' OR error IS NOT NULL", name="failed_has_error"),
    CheckConstraint("state <> 'running' OR worker IS NOT NULL", name="running_has_worker"),
)

Index("ix_jobs_state", jobs.c.state)
