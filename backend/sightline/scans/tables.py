"""The tables of line-scan recordings: scans, runs of the finder, vehicles, measurements, reviews."""

from sqlalchemy import (
    BigInteger,
    CheckConstraint,
    Column,
    ForeignKey,
    Index,
    Integer,
    String,
    UniqueConstraint,
)

from sightline.infra.audit.vouched import table_changed_by_events, table_written_once
from sightline.infra.database.types import (
    KEEPS_TIMES,
    NEEDS_MEDIA,
    columns_for,
    needs_media,
)
from sightline.linescan.parts import Rig
from sightline.scans.records import KnownOfScanned, Scan, ScanReview, ScanRunValues, ScanValues, ScanVehicle
from sightline.scans.references.records import ReferenceValues

_VERSION = {"code_version": 60}
_HASHES = {f"{which}_sha256": 64 for which in ("first", "second", "first_source", "second_source")}
_TO_READ = needs_media(lambda its: its.state != "ready")

# A pair of strips and the rig that took them. `first` is the camera that a vehicle reaches first.
scans = table_changed_by_events(
    "scans",
    "scan",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    # two strips that were uploaded, or two pixel columns or rows of a video
    *columns_for(Scan, {"name": 400}, only="name state error source"),
    Column("recording_id", ForeignKey("recordings.id"), index=True, info=KEEPS_TIMES),
    *columns_for(Scan, only="cut_along cut_1_px cut_2_px"),
    *columns_for(Scan, {"first_name": 400, "second_name": 400}, only="first_name second_name"),
    Column("first_source_key", String(400), info=_TO_READ),
    Column("second_source_key", String(400), info=_TO_READ),
    *columns_for(Scan, _HASHES, only="first_source_sha256 second_source_sha256 time_axis"),
    # the tiled form that everything is read from
    Column("first_key", String(400), info=NEEDS_MEDIA),
    Column("second_key", String(400), info=NEEDS_MEDIA),
    *columns_for(Scan, _HASHES, only="first_sha256 second_sha256 rows_px"),
    Column("lines", BigInteger),
    *columns_for(Scan, only="bits notes"),
    *columns_for(Rig),
    *columns_for(Scan, {"time_zone": 60}, only="lighting started_at time_zone u_start_s"),
    CheckConstraint(
        "(started_at IS NULL) = (time_zone IS NULL) AND (started_at IS NULL) = (u_start_s IS NULL)",
        name="start_whole",
    ),
    CheckConstraint("baseline_m > 0 AND line_rate_hz > 0", name="rig_positive"),
    CheckConstraint(
        "state <> 'ready' OR (lines IS NOT NULL AND first_key IS NOT NULL)", name="ready_has_lines"
    ),
    CheckConstraint("state <> 'failed' OR error IS NOT NULL", name="failed_has_error"),
)

# One search for vehicles (or one measuring again of those that are known); written once.
scan_runs = table_written_once(
    "scan_runs",
    "scan_run",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("scan_id", ForeignKey("scans.id"), nullable=False, index=True),
    Column("job_id", ForeignKey("jobs.id")),
    *columns_for(ScanRunValues, _VERSION),
)

scan_vehicles = table_changed_by_events(
    "scan_vehicles",
    "scan_vehicle",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("scan_id", ForeignKey("scans.id"), nullable=False),
    *columns_for(ScanVehicle, only="number origin"),
    *columns_for(KnownOfScanned, {"make": 100, "model": 200, "run_of": 100}),
    UniqueConstraint("scan_id", "number"),
)

# One row a revision of a vehicle's motion, with the rig that it was computed with; written once.
scan_measurements = table_written_once(
    "scan_measurements",
    "scan_measurement",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("scan_id", ForeignKey("scans.id"), nullable=False, index=True),
    Column("vehicle_id", ForeignKey("scan_vehicles.id"), nullable=False),
    Column("revision", Integer, nullable=False),
    *columns_for(ScanValues, {"lane": 40, **_VERSION}, {"run_id": "scan_runs.id", "placed_by": "people.id"}),
    # the earlier revision of this very content whose verdict holds for this one too
    Column("verdict_of_id", ForeignKey("scan_measurements.id")),
    UniqueConstraint("vehicle_id", "revision"),
    CheckConstraint("(lane IS NULL) = (lane_by IS NULL)", name="lane_by_whom"),
    CheckConstraint("(axle_lines IS NULL) = (axles_by IS NULL)", name="axles_by_whom"),
    CheckConstraint("revision >= 1", name="revision_counts"),
    CheckConstraint(
        "(status = 'ok' AND speed_mps IS NOT NULL) OR (status <> 'ok' AND reason IS NOT NULL)",
        name="speed_or_reason",
    ),
    CheckConstraint("(front_wheel_line IS NULL) = (rear_wheel_line IS NULL)", name="two_wheels"),
)

# Verdicts on a revision; written once, the newest of a revision counts.
scan_reviews = table_written_once(
    "scan_reviews",
    "scan_review",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("measurement_id", ForeignKey("scan_measurements.id"), nullable=False),
    *columns_for(ScanReview, only="verdict reason"),
    CheckConstraint("verdict <> 'rejected' OR reason IS NOT NULL", name="rejected_has_reason"),
)
Index("ix_scan_reviews_measurement_id", scan_reviews.c.measurement_id)

# What something else measured of a vehicle (m/s or m); the newest revision of a quantity and source counts,
# and takes it away where it is withdrawn. Written once.
scan_references = table_written_once(
    "scan_references",
    "scan_reference",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("scan_id", ForeignKey("scans.id"), nullable=False, index=True),
    Column("vehicle_id", ForeignKey("scan_vehicles.id"), nullable=False),
    *columns_for(ReferenceValues, {"device": 200}),
    Column("revision", Integer, nullable=False),
    UniqueConstraint("vehicle_id", "quantity", "source", "revision"),
    CheckConstraint("revision >= 1", name="revision_counts"),
    CheckConstraint("value > 0 AND u > 0", name="value_with_u"),
)
