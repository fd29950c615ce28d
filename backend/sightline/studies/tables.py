"""The tables of studies, of what was computed of them, and of who belongs to them."""

from sqlalchemy import (
    BigInteger,
    Boolean,
    CheckConstraint,
    Column,
    ForeignKey,
    Integer,
    String,
    UniqueConstraint,
)

from sightline.infra.audit.vouched import table_changed_by_events, table_written_once
from sightline.infra.database.types import NEEDS_MEDIA, CanonicalJson, columns_for, numbered_table
from sightline.studies.records import StudyFacts

# Surveys joined: which ones at which site and of which year, the fleet, facts of the sites.
studies = table_changed_by_events(
    "studies",
    "study",
    *columns_for(StudyFacts, {"name": 200}),
    # invented surveys: said wherever its figures are shown
    Column("simulated", Boolean, nullable=False),
    # seen by everybody who signs in, or by its members and administrators alone
    Column("open_to_all", Boolean, nullable=False),
    # the newest computing that was asked for
    Column("job_id", ForeignKey("jobs.id")),
    CheckConstraint("goal_m > 0 AND goal_m < 1", name="goal_is_a_length"),
)

# Who sees a study that is not open to all; what they may do there is their account's role.
study_members = numbered_table(
    "study_members",
    Column("study_id", ForeignKey("studies.id"), nullable=False, index=True),
    Column("person_id", ForeignKey("people.id"), nullable=False, index=True),
    UniqueConstraint("study_id", "person_id"),
)

# What a computing found: the figures that its page shows, its package and its report.
study_results = table_written_once(
    "study_results",
    "study_result",
    Column("study_id", ForeignKey("studies.id"), nullable=False, index=True),
    # the version of the study that was computed
    Column("study_version", Integer, nullable=False),
    # {survey id: last hash of its chain when it was read}
    Column("heads", CanonicalJson, nullable=False),
    # the rows of the package's tables, and curves to draw
    Column("document", CanonicalJson, nullable=False),
    Column("media_key", String(400), nullable=False, info=NEEDS_MEDIA),
    Column("size_bytes", BigInteger, nullable=False),
    Column("sha256", String(64), nullable=False),
    Column("report_key", String(400), nullable=False, info=NEEDS_MEDIA),
    Column("report_sha256", String(64), nullable=False),
    Column("code_version", String(60), nullable=False),
)
