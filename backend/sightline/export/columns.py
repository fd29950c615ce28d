"""What each CSV of an export holds: the name, type, unit and meaning of every column.

This is the data dictionary of the package (`datapackage.json` is made from it); the rows come from
`exporting_rows.py`. Which tables a package has, derived ones too, says `exporting_contents.py`.
"""

from __future__ import annotations

from dataclasses import replace

from sightline.infra.csv_package.schema import Column, Table

TARGETS = ("roof", "driver_eye", "taillight", "headlight", "other")
CATEGORIES = ("hatchback", "saloon", "estate", "suv", "van", "lorry", "other")
LIGHTING = ("daytime", "low_light")
DRIFT = ("still", "moved", "unknown")
VERDICTS = ("to_review", "accepted", "fixed", "rejected", "reopened")


def _id(name: str, meaning: str, required: bool = True) -> Column:
    return Column(name, "integer", meaning, required=required)


def _px(name: str, meaning: str) -> Column:
    return Column(
        name, "number", f"{meaning}; (0, 0) is the centre of the top-left pixel", "px", required=True
    )


def _m(name: str, meaning: str) -> Column:
    return Column(name, "number", meaning, "m")


def _time(name: str, meaning: str) -> Column:
    return Column(name, "datetime", f"{meaning} (ISO 8601, UTC)")


_WHERE = (
    _id("vehicle_id", "vehicle that was measured"),
    _id("recording_id", "recording in which the points were clicked"),
    Column("target", "string", "what was measured", required=True, enum=TARGETS),
    Column("frame", "integer", "frame number: the n-th decoded frame, from 0", required=True, minimum=0),
    Column("pts", "integer", "presentation time stamp of that frame, in the stream's own time base"),
    Column("time_s", "number", "time of that frame from the start of the stream", "s"),
    Column(
        "frame_crc32", "integer", "CRC-32 of the decoded luma of that frame: proof of what was clicked on"
    ),
)
_CLICKED = (
    _px("contact_x_px", "where the tyre meets the road, x to the right"),
    _px("contact_y_px", "where the tyre meets the road, y down"),
    _px("target_x_px", "the target point, x to the right"),
    _px("target_y_px", "the target point, y down"),
    Column("sigma_px", "number", "standard uncertainty of each coordinate of each click", "px", minimum=0),
    _id("pose_id", "road pose used"),
)
_INSET = (
    _m(
        "inset_m", "how far the target lies behind the vertical plane through the contact point, along road Y"
    ),
    _m("u_inset_m", "standard uncertainty of the inset (k = 1)"),
)


def _further_points(k: int) -> tuple[Column, ...]:
    """The same two points on the k-th frame; empty where fewer were clicked."""
    return tuple(
        Column(f"{word}{k}_{axis}_px", "number", f"{what} on frame {k} of the measurement, {axis}", "px")
        for word, what in (("contact", "the same tyre contact"), ("target", "the same target point"))
        for axis in "xy"
    )


def _frame_number(k: int) -> Column:
    return Column(f"frame{k}", "integer", f"number of frame {k} that the points were clicked on", minimum=0)


_SEVERAL = (
    Column("frames", "integer", "on how many frames the points were clicked", required=True, minimum=1),
    _frame_number(2),
    *_further_points(2),
    _m("solved_inset_m", "the inset found from several frames; inset_m is then not used for height_m"),
    _m("u_solved_inset_m", "standard uncertainty of the inset found (k = 1)"),
)
_HEIGHT = (
    _m("height_m", "height of the target above the road along its normal, corrected for the inset"),
    _m("uncorrected_height_m", "the first frame's height with an inset of 0 (the paper's assumption)"),
    _m("u_height_m", "standard uncertainty of height_m (k = 1)"),
    _m("U95_height_m", "half-width of the 95 % interval of height_m"),
    _m("distance_m", "from the camera's centre to the contact point"),
    Column("status", "string", "whether there is a height", required=True, enum=("ok", "not_measurable")),
    Column("reason", "string", "why there is no height"),
    Column("flags", "string", "warnings on this height, separated by semicolons"),
    Column("code_version", "string", "version of the program that computed the height", required=True),
    _id("created_by_id", "who clicked", required=False),
    _time("created_at", "when the revision was stored"),
    Column("withdrawn", "boolean", "true where the measurement was taken back", required=True),
)
_MEASURED = (
    *_WHERE,
    *_CLICKED,
    _id("calibration_id", "calibration behind that pose"),
    *_INSET,
    *_SEVERAL,
    *_HEIGHT,
)

MEASUREMENTS = Table(
    "measurements",
    "The current revision of every measurement, with the verdict on it. Withdrawn ones are kept and marked.",
    (
        _id("id", "measurement (a series of revisions)"),
        _id("revision", "number of the current revision, from 1"),
        *_MEASURED,
        Column("verdict", "string", "state of the review of this revision", required=True, enum=VERDICTS),
        Column("review_reason", "string", "the reviewer's reason"),
        _id("reviewer_id", "who reviewed", required=False),
        _time("reviewed_at", "when it was reviewed"),
    ),
    primary=("id",),
    foreign=(
        (("vehicle_id",), "vehicles", ("id",)),
        (("recording_id",), "recordings", ("id",)),
        (("recording_id", "frame"), "frames", ("recording_id", "frame")),
        (("pose_id",), "poses", ("id",)),
        (("calibration_id",), "calibrations", ("id",)),
        (("created_by_id",), "people", ("id",)),
        (("reviewer_id",), "people", ("id",)),
    ),
)

REVISIONS = Table(
    "revisions",
    "Every revision of every measurement as it was stored: nothing is overwritten.",
    (
        _id("measurement_id", "measurement that this is a revision of"),
        _id("revision", "number of the revision, from 1"),
        *_MEASURED,
    ),
    primary=("measurement_id", "revision"),
    foreign=(
        (("measurement_id",), "measurements", ("id",)),
        (("recording_id", "frame"), "frames", ("recording_id", "frame")),
        (("pose_id",), "poses", ("id",)),
        (("created_by_id",), "people", ("id",)),
    ),
)

BUDGET = Table(
    "budget",
    "The contributions to each current u_height_m; their root sum of squares is u_height_m.",
    (
        _id("measurement_id", "measurement"),
        Column("source", "string", "where the uncertainty comes from", required=True),
        _m("u_m", "its contribution to the standard uncertainty of the height"),
    ),
    primary=("measurement_id", "source"),
    foreign=((("measurement_id",), "measurements", ("id",)),),
)

CLICKS = Table(
    "clicks",
    "The clicks of every current measurement, as `sightline height --clicks` reads them; those of each pose "
    "alone are in clicks/pose-N.csv, to be used with poses/pose-N.json.",
    (
        Column("id", "string", "measurement the clicks belong to", required=True),
        *_CLICKED[:5],
        *_INSET,
        *_further_points(2),
        Column("lighting", "string", "light at the time of the pass", enum=LIGHTING),
        _m("reference_height_m", "manufacturer's height, for roofs"),
        Column("target", "string", "what was measured", required=True, enum=TARGETS),
        Column("category", "string", "body of the vehicle", enum=CATEGORIES),
        _id("pose_id", "road pose to compute the height with"),
        Column("pose_file", "string", "that pose as a file of this package", required=True),
    ),
    primary=("id",),
    foreign=((("pose_id",), "poses", ("id",)),),
)

VEHICLES = Table(
    "vehicles",
    "The passes and what is known of each vehicle.",
    (
        _id("id", "vehicle"),
        _id("number", "its number within the survey"),
        _id("recording_id", "recording it passes in"),
        Column("first_frame", "integer", "first frame of the pass", minimum=0),
        Column("last_frame", "integer", "last frame of the pass", minimum=0),
        Column("best_frame", "integer", "frame proposed for measuring", minimum=0),
        Column("make", "string", "maker"),
        Column("model", "string", "model"),
        Column("year", "integer", "model year"),
        Column("category", "string", "kind of body", enum=CATEGORIES),
        _m("manufacturer_height_m", "overall height the maker states"),
        _m("u_manufacturer_height_m", "standard uncertainty of that height (k = 1)"),
        Column("height_source", "string", "where that height comes from"),
        Column("lighting", "string", "light at the time of the pass", enum=LIGHTING),
        Column("notes", "string", "remarks"),
        Column("state", "string", "how far the work on it is", required=True),
    ),
    primary=("id",),
    foreign=((("recording_id",), "recordings", ("id",)),),
)

RECORDINGS = Table(
    "recordings",
    "The video files behind the measurements.",
    (
        _id("id", "recording"),
        Column("name", "string", "name of the file", required=True),
        Column("sha256", "string", "SHA-256 of the file"),
        Column("size_bytes", "integer", "size of the file", "byte"),
        Column("width_px", "integer", "width of a frame", "px"),
        Column("height_px", "integer", "height of a frame", "px"),
        Column("frame_count", "integer", "number of decoded frames"),
        Column("duration_s", "number", "time from the first frame to the end of the last", "s"),
        Column("codec", "string", "codec of the video stream"),
        Column("container", "string", "container of the file"),
        Column("variable_rate", "boolean", "true where the time between frames varies"),
        Column("lighting", "string", "light in the recording", enum=LIGHTING),
        _id("camera_id", "camera that made it", required=False),
        _id("pose_id", "road pose in force", required=False),
        Column("drift_state", "string", "whether the camera moved since that pose", enum=DRIFT),
        Column("drift_floor_px", "number", "motion that could not be told from standing still", "px"),
        Column("drift_moved_px", "number", "largest motion found, where it moved", "px"),
        _m("drift_height_m", "by how much heights are off at most for it"),
        Column("drift_checked_at", "datetime", "when that was looked at (ISO 8601, UTC)"),
        Column("drift_decision", "string", "why a person lets the pose stand although the camera moved"),
        _id("drift_decided_by_id", "who decided that", required=False),
        Column("drift_decided_at", "datetime", "when that was decided (ISO 8601, UTC)"),
    ),
    primary=("id",),
    foreign=((("drift_decided_by_id",), "people", ("id",)),),
)

FRAMES = Table(
    "frames",
    "The frames that were clicked on, so that each can be found again in the video and proved unchanged.",
    (
        _id("recording_id", "recording"),
        Column("frame", "integer", "the n-th decoded frame, from 0", required=True, minimum=0),
        Column("pts", "integer", "presentation time stamp in the stream's time base"),
        Column("time_s", "number", "time from the start of the stream", "s"),
        Column("crc32", "integer", "CRC-32 of the decoded luma", required=True),
    ),
    primary=("recording_id", "frame"),
    foreign=((("recording_id",), "recordings", ("id",)),),
)

POSES = Table(
    "poses",
    "Where the camera stood with respect to the road; the whole of each is in poses/pose-N.json.",
    (
        _id("id", "road pose"),
        _id("recording_id", "recording in which the board stood on the road", required=False),
        _id("calibration_id", "calibration it was solved with"),
        Column("first_frame", "integer", "first frame of the board's segment"),
        Column("last_frame", "integer", "last frame of the board's segment"),
        Column("frames_used", "integer", "frames that entered the solution"),
        Column("rms_px", "number", "root of the mean squared distance of the corners", "px"),
        _m("board_distance_m", "from the camera's centre to the board"),
        Column("board_columns", "integer", "inner corners in a row of the board"),
        Column("board_rows", "integer", "rows of inner corners"),
        _m("square_m", "side of a square"),
        Column(
            "reference", "string", "row of inner corners whose height was measured", enum=("top", "bottom")
        ),
        _m("reference_height_m", "height of that row above the road"),
        _m("u_reference_height_m", "standard uncertainty of that height (k = 1)"),
        Column("u_lean_rad", "number", "standard uncertainty of the board's lean (k = 1)", "rad"),
        _m("u_square_m", "standard uncertainty of the side of a square (k = 1)"),
        _m("u_bow_m", "standard uncertainty of the board's middle out of plane (k = 1)"),
        _id("turned_from", "the pose that this one was, before it was turned to the traffic", required=False),
        Column("turned_by_rad", "number", "by how much it was turned about the road's normal", "rad"),
        Column("document", "string", "the pose as a file of this package (sightline-pose-1)", required=True),
        _id("created_by_id", "who made it", required=False),
        _time("created_at", "when it was made"),
    ),
    primary=("id",),
    foreign=((("calibration_id",), "calibrations", ("id",)), (("created_by_id",), "people", ("id",))),
)

CALIBRATIONS = Table(
    "calibrations",
    "Lens and camera matrix behind the poses; the whole of each is in calibrations/calibration-N.json.",
    (
        _id("id", "calibration"),
        _id("camera_id", "camera it belongs to"),
        Column("camera_name", "string", "name of the camera"),
        Column("source", "string", "where it comes from", enum=("images", "clip", "import")),
        Column("model", "string", "lens model", required=True, enum=("brown", "fisheye")),
        Column("width_px", "integer", "width of the images it holds for", "px", required=True),
        Column("height_px", "integer", "height of the images it holds for", "px", required=True),
        Column("fx_px", "number", "focal length along x", "px", required=True),
        Column("fy_px", "number", "focal length along y", "px", required=True),
        Column("cx_px", "number", "principal point, x", "px", required=True),
        Column("cy_px", "number", "principal point, y", "px", required=True),
        Column("distortion", "string", "distortion coefficients in OpenCV's order, separated by blanks"),
        Column("rms_px", "number", "root of the mean squared point distance", "px"),
        Column("trusted", "boolean", "false where the program warned against using it"),
        Column(
            "document",
            "string",
            "the calibration as a file of this package (sightline-camera-1)",
            required=True,
        ),
        _id("created_by_id", "who made it", required=False),
        _time("created_at", "when it was made"),
    ),
    primary=("id",),
    foreign=((("created_by_id",), "people", ("id",)),),
)

REVIEWS = Table(
    "reviews",
    "Every verdict, in the order in which they were given.",
    (
        _id("id", "review"),
        _id("measurement_id", "measurement that was reviewed"),
        _id("revision", "revision that the reviewer saw"),
        _id("result_revision", "revision that the verdict holds for (a fix makes a new one)"),
        Column("verdict", "string", "the verdict", required=True, enum=VERDICTS[1:]),
        Column("reason", "string", "the reviewer's reason"),
        _id("reviewer_id", "who reviewed", required=False),
        _time("at", "when"),
    ),
    primary=("id",),
    foreign=((("measurement_id",), "measurements", ("id",)), (("reviewer_id",), "people", ("id",))),
)

INSETS = Table(
    "insets",
    "The insets in force in this survey: used for every measurement that does not carry its own.",
    (
        Column("target", "string", "what is measured", required=True, enum=TARGETS),
        *_INSET,
        Column("note", "string", "where the figure comes from"),
    ),
    primary=("target",),
)

PEOPLE = Table(
    "people",
    "The people named in the other tables, by number and name only. The audit chain holds their numbers; "
    "their names are covered by the checksums alone.",
    (_id("id", "person"), Column("name", "string", "name", required=True)),
    primary=("id",),
)

AUDIT = Table(
    "audit",
    "Who did what, when, chained by hash: hash = SHA-256 of previous_hash followed by content_sha256, "
    "content_sha256 = SHA-256 of the canonical JSON (keys sorted, no spaces, empty cells null) of id, at, "
    "actor_id, action, entity, entity_id, survey_id, before and after. Rows of other surveys and of accounts "
    "are links of the chain only: their content is withheld, their hashes can still be computed again.",
    (
        _id("id", "audit event"),
        Column("at", "string", "when (ISO 8601, UTC), as it was hashed"),
        _id("actor_id", "who; empty for the program itself", required=False),
        Column("action", "string", "what was done"),
        Column("entity", "string", "to what kind of thing"),
        _id("entity_id", "to which one", required=False),
        _id("survey_id", "survey it belongs to", required=False),
        Column("before", "string", "the thing before, as JSON"),
        Column("after", "string", "the thing after, as JSON"),
        Column("previous_hash", "string", "hash of the event before", required=True),
        Column("content_sha256", "string", "hash of this event's content, withheld or not", required=True),
        Column("hash", "string", "hash of this event", required=True),
        Column("withheld", "boolean", "true where only the hashes are given", required=True),
    ),
    primary=("id",),
)


def with_frames(table: Table, most: int) -> Table:
    """The table with the columns of frames 3 to `most`, where it has those of the second."""
    columns: list[Column] = []
    for column in table.columns:
        columns.append(column)
        if column.name == "frame2":
            columns += [_frame_number(k) for k in range(3, most + 1)]
        elif column.name == "target2_y_px":
            columns += [one for k in range(3, most + 1) for one in _further_points(k)]
    return replace(table, columns=tuple(columns))
