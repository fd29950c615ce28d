"""The table of jobs."""

from sqlalchemy import Boolean, CheckConstraint, Column, ForeignKey, Index, Integer, false

from sightline.infra.database.types import columns_for, made_columns, numbered_table
from sightline.infra.jobs.records import Job

jobs = numbered_table(
    "jobs",
    *columns_for(Job, {"kind": 60}, only="kind state payload progress message error result"),
    Column("survey_id", ForeignKey("surveys.id"), index=True),
    Column("recording_id", ForeignKey("recordings.id"), index=True),
    Column("scan_id", Integer, ForeignKey("scans.id", use_alter=True), index=True),
    # work of a study, which has members of its own
    Column("study_id", Integer, ForeignKey("studies.id", use_alter=True), index=True),
    *columns_for(Job, only="attempts"),
    # how often the database or the storage was away while it was done, and when it may be begun again
    Column("outages", Integer, nullable=False, server_default="0"),
    *columns_for(Job, {"worker": 200}, only="not_before worker"),
    Column("cancel_requested", Boolean, nullable=False, server_default=false()),
    *made_columns(),
    *columns_for(Job, only="started_at finished_at"),
    CheckConstraint("progress >= 0 AND progress <= 1", name="progress_fraction"),
    CheckConstraint("state <> 'failed' OR error IS NOT NULL", name="failed_has_error"),
    CheckConstraint("state <> 'running' OR worker IS NOT NULL", name="running_has_worker"),
)

Index("ix_jobs_state", jobs.c.state)
