"""What people clicked and what follows: measurements, computings, verdicts, tyre contacts, click sigmas."""

from sqlalchemy import (
    BigInteger,
    Boolean,
    CheckConstraint,
    Column,
    Float,
    ForeignKey,
    Index,
    Integer,
    String,
    Text,
    UniqueConstraint,
)

from sightline.enums import Target
from sightline.infra.audit.vouched import WrittenOnceApart, table_written_once, vouched_info
from sightline.infra.database.types import HOLDS, CanonicalJson, columns_for, enum_check, numbered_table
from sightline.measurements.again.records import Computing
from sightline.measurements.records import HeightOfClicks, Origin, Review

# What stays the same over all revisions of one measurement; append-only like them.
measurement_series = numbered_table(
    "measurement_series",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    # of a frame: recording and vehicle; of a line scan: the scan and its vehicle
    Column("recording_id", ForeignKey("recordings.id"), index=True, info=HOLDS),
    Column("vehicle_id", ForeignKey("vehicles.id"), index=True),
    Column("scan_id", ForeignKey("scans.id"), index=True),
    Column("scan_vehicle_id", ForeignKey("scan_vehicles.id"), index=True),
    Column("client_key", String(36), nullable=False),
    # the measurement that this one repeats: shown and counted with the repeats only
    Column("repeat_of", ForeignKey("measurement_series.id"), index=True),
    UniqueConstraint("client_key"),
    CheckConstraint(
        "(recording_id IS NULL) = (vehicle_id IS NULL) AND (scan_id IS NULL) = (scan_vehicle_id IS NULL) "
        "AND (vehicle_id IS NULL) <> (scan_vehicle_id IS NULL)",
        name="of_one_vehicle",
    ),
    info=vouched_info(WrittenOnceApart("series")),
)


# Heights of a survey computed again in one go; each revision that it made names it.
computings = table_written_once(
    "computings",
    "computing",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    *columns_for(
        Computing,
        {"code_version": 60},
        {"undoes": "computings.id"},
        only="kind undoes heights to_review kept largest_m causes code_version",
    ),
    CheckConstraint("(kind = 'undo') = (undoes IS NOT NULL)", name="undo_names_another"),
)


# One row a revision; the one with the highest number is the current one. Of a line scan, points are (line,
# row) of strip 1, `line_pose_id` is the pose, and what tells a frame is empty.
measurements = table_written_once(
    "measurements",
    "measurement",
    Column("series_id", ForeignKey("measurement_series.id"), nullable=False),
    Column("revision", Integer, nullable=False),
    Column("target", String(20), nullable=False),
    Column("frame", Integer),
    Column("pts", BigInteger),
    Column("time_s", Float),
    Column("frame_crc32", BigInteger),
    Column("contact_x_px", Float, nullable=False),
    Column("contact_y_px", Float, nullable=False),
    Column("target_x_px", Float, nullable=False),
    Column("target_y_px", Float, nullable=False),
    Column("sigma_px", Float, nullable=False),
    *columns_for(Origin),
    Column("pose_id", ForeignKey("road_poses.id")),
    Column("calibration_id", ForeignKey("calibrations.id")),
    Column("line_pose_id", ForeignKey("line_poses.id")),
    *columns_for(HeightOfClicks, left_out=("reason", "flags")),
    Column("u_distance_m", Float),
    Column("reason", CanonicalJson),
    Column("flags", CanonicalJson, nullable=False),
    Column("code_version", String(60), nullable=False),
    # the same two points in further frames: then the inset is solved for
    Column("more_frames", CanonicalJson, nullable=False, server_default="[]"),
    # of a whole pass: the points followed from these through its frames, as JSON (followed_text.py)
    Column("followed", Text),
    Column("withdrawn", Boolean, nullable=False),
    # what computed it again, the clicks being those of the revision before; `created_by` is who clicked
    Column("computing_id", ForeignKey("computings.id"), index=True),
    # the revision before it whose verdict holds for this one too: hardly moved, or put back where it was
    Column("verdict_of_revision", Integer),
    UniqueConstraint("series_id", "revision"),
    enum_check("target", Target),
    CheckConstraint("revision >= 1", name="revision_counts"),
    CheckConstraint("sigma_px > 0", name="sigma_positive"),
    CheckConstraint(
        "(pose_id IS NULL) <> (line_pose_id IS NULL) AND (pose_id IS NULL) = (calibration_id IS NULL) "
        "AND (pose_id IS NULL) = (frame IS NULL) AND (pose_id IS NULL) = (pts IS NULL) "
        "AND (pose_id IS NULL) = (time_s IS NULL) AND (pose_id IS NULL) = (frame_crc32 IS NULL)",
        name="of_a_frame_or_a_line",
    ),
    CheckConstraint(
        "(proposal IS NULL AND proposed_contact_x_px IS NULL AND proposed_contact_y_px IS NULL "
        "AND proposed_target_x_px IS NULL AND proposed_target_y_px IS NULL) OR "
        "(proposal IS NOT NULL AND proposed_contact_x_px IS NOT NULL AND proposed_contact_y_px IS NOT NULL "
        "AND proposed_target_x_px IS NOT NULL AND proposed_target_y_px IS NOT NULL)",
        name="proposal_has_its_points",
    ),
    CheckConstraint(
        "(snapped_from_x_px IS NULL) = (snapped_from_y_px IS NULL) "
        "AND (made <> 'snapped' OR snapped_from_x_px IS NOT NULL)",
        name="snapped_from_a_click",
    ),
    CheckConstraint("verdict_of_revision < revision", name="verdict_of_an_earlier_one"),
    CheckConstraint("inset_m IS NOT NULL OR target = 'driver_eye'", name="inset_of_all_but_eyes"),
    CheckConstraint(
        "line_pose_id IS NULL OR target <> 'driver_eye' OR side IS NOT NULL OR inset_from = 'own'",
        name="eye_of_a_line_has_side",
    ),
    CheckConstraint(
        "(status = 'ok' AND height_m IS NOT NULL) OR (status <> 'ok' AND reason IS NOT NULL)",
        name="height_or_reason",
    ),
)


# A person's own click sigma in a survey, from repeats; the newest row counts, without a figure the usual one.
click_sigmas = table_written_once(
    "click_sigmas",
    "click_sigma",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("person_id", ForeignKey("people.id"), nullable=False),
    Column("sigma_px", Float),
    Column("pairs", Integer, nullable=False),
    CheckConstraint("sigma_px > 0", name="sigma_positive"),
)


# `revision` is what the reviewer saw, `result_revision` what the verdict holds for (a fix makes a new one).
reviews = table_written_once(
    "reviews",
    "review",
    Column("series_id", ForeignKey("measurement_series.id"), nullable=False),
    *columns_for(Review, only="revision result_revision verdict reason"),
    # empty for a verdict on this measurement alone
    Column("lot_id", ForeignKey("lots.id"), index=True),
    CheckConstraint("verdict <> 'rejected' OR reason IS NOT NULL", name="rejected_has_reason"),
    CheckConstraint("lot_id IS NULL OR verdict IN ('accepted', 'reopened')", name="lot_accepts_or_reopens"),
)


Index("ix_reviews_series_id_result_revision", reviews.c.series_id, reviews.c.result_revision)


# Both tyre contacts of a vehicle on one frame: its direction of travel. The newest row of a vehicle counts.
wheel_pairs = table_written_once(
    "wheel_pairs",
    "wheel_pair",
    Column("survey_id", ForeignKey("surveys.id"), nullable=False, index=True),
    Column("recording_id", ForeignKey("recordings.id"), nullable=False),
    Column("vehicle_id", ForeignKey("vehicles.id"), nullable=False, index=True),
    Column("frame", Integer, nullable=False),
    Column("pts", BigInteger, nullable=False),
    Column("time_s", Float, nullable=False),
    Column("frame_crc32", BigInteger, nullable=False),
    Column("first_x_px", Float, nullable=False),
    Column("first_y_px", Float, nullable=False),
    Column("second_x_px", Float, nullable=False),
    Column("second_y_px", Float, nullable=False),
    Column("withdrawn", Boolean, nullable=False),
)
