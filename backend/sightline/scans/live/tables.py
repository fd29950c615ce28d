"""The table of live streams: how each recording's stream is, written every second like a job's progress."""

from sqlalchemy import Column, Float, ForeignKey, String, Text, UniqueConstraint

from sightline.infra.database.types import CanonicalJson, UtcDateTime, numbered_table

# What is measured stands in the tables of scans; this says how the stream is, and is no result.
scan_live = numbered_table(
    "scan_live",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("scan_id", ForeignKey("scans.id"), nullable=False),
    # the recordings of one stream have the same sign
    Column("stream", String(40), nullable=False),
    # the file or the cameras; none of a pipe
    Column("source", Text),
    # by which its lines were counted; the scan's may be corrected later
    Column("line_rate_hz", Float, nullable=False),
    # when line 0 was taken, by the computer's clock
    Column("began_at", UtcDateTime, nullable=False),
    Column("heard_at", UtcDateTime, nullable=False),
    Column("ended_at", UtcDateTime),
    Column("health", CanonicalJson),
    UniqueConstraint("scan_id"),
)
