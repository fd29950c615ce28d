"""Ways to forge a package, each by somebody who makes all sums fit: each answers what gives it away."""

import json
from collections.abc import Callable
from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq

from sightline.geometry.documents import pose_from_dict
from sightline.measurements.height_of_clicks import answer
from sightline.measurements.verify import clicks_of_row
from tests.support.packages import drop, edit, rederive, rehash, reseal, rewrite, rows

Row = dict[str, str]


def roof(row: Row) -> bool:
    return row["target"] == "roof" and row["height_m"] == "1.310000"


def newest(row: Row) -> bool:
    return roof(row) or row.get("id") == "m1"


def a_height(place: Path) -> str:
    for name in ("measurements.csv", "revisions.csv"):
        edit(place, name, roof, height_m="1.210000")
    reseal(place)
    return "states height 1.210000, its clicks give 1.310000 m"


def a_height_in_one_table(place: Path) -> str:
    edit(place, "measurements.csv", roof, height_m="1.210000")
    reseal(place)
    return "another height_m than its last revision"


def a_click_and_its_height(place: Path) -> str:
    """The click moves everywhere, and the height with it: rows agree, the audit event does not."""
    (row,) = (row for row in rows(place, "measurements.csv") if roof(row))
    moved = repr(float(row["target_y_px"]) + 5.0)
    path = f"poses/pose-{row['pose_id']}.json"
    pose = pose_from_dict(json.loads((place / path).read_text()), path)
    found = answer(pose, clicks_of_row({**row, "target_y_px": moved}))
    heights = {name: f"{getattr(found, name):.6f}" for name in ("height_m", "uncorrected_height_m")}
    parts = ("u_height_m", "U95_height_m", "u_clicks_m", "u_by_inset_m")
    u = {name: f"{getattr(found, name):.6f}" for name in parts}
    cells = {"target_y_px": moved, **heights, **u}
    for name in ("measurements.csv", "revisions.csv"):
        edit(place, name, roof, **cells)
    for name in ("clicks.csv", f"clicks/pose-{row['pose_id']}.csv"):
        edit(place, name, lambda one: one["id"] == f"m{row['id']}", target_y_px=moved)
    budget = [one for one in rows(place, "budget.csv") if one["measurement_id"] != row["id"]]
    told = {"measurement_id": row["id"]}
    budget += [{**told, "source": one["source"], "u_m": f"{one['u_m']:.6f}"} for one in found.budget]
    rewrite(place, "budget.csv", sorted(budget, key=lambda one: int(one["measurement_id"])))
    reseal(place)
    return "differs from its audit event"


def a_click_in_one_table(place: Path) -> str:
    edit(place, "clicks.csv", lambda row: row["target"] == "roof", contact_x_px="141.5")
    reseal(place)
    return "another contact_x_px than measurements.csv"


def a_pose(place: Path) -> str:
    path = next(place.glob("poses/*.json"))
    path.write_text(path.read_text().replace('"rms_px": 0.1', '"rms_px": 0.2'))
    reseal(place)
    return f"poses/{path.name} is not the one recorded in the audit chain"


def a_pose_with_its_record(place: Path) -> str:
    for path in (next(place.glob("poses/*.json")), next(place.glob("records/pose-*.json"))):
        path.write_text(path.read_text().replace('"rms_px": 0.1', '"rms_px": 0.2'))
    reseal(place)
    return "differs from its audit event"


def a_camera(place: Path) -> str:
    path = next(place.glob("calibrations/*.json"))
    path.write_text(path.read_text().replace('"fx_px": 150.0', '"fx_px": 151.0'))
    reseal(place)
    return f"calibrations/{path.name} is not the one recorded in the audit chain"


def a_row_taken_out(place: Path) -> str:
    """The rejected taillight, from every table that names it."""
    (row,) = (row for row in rows(place, "measurements.csv") if row["verdict"] == "rejected")
    for name, key in (("measurements.csv", "id"), ("clicks.csv", "id"), ("clicks/pose-1.csv", "id")):
        drop(place, name, lambda one, key=key: one[key].removeprefix("m") == row["id"])  # type: ignore[misc]
    for name in ("revisions.csv", "budget.csv", "reviews.csv", "crops.csv"):
        drop(place, name, lambda one: one["measurement_id"] == row["id"])
    for path in place.glob(f"crops/m{row['id']}-*"):
        path.unlink()
    reseal(place)
    return "is missing, although it has an audit event"


def a_row_put_in(place: Path) -> str:
    """A second roof like the first, under a number of its own."""
    new = "99"
    for name in ("measurements.csv", "revisions.csv", "budget.csv", "clicks.csv", "clicks/pose-1.csv"):
        found = rows(place, name)
        key = "id" if "id" in found[0] else "measurement_id"
        mine = [row for row in found if row[key].removeprefix("m") == "1"]
        same = mine if name == "budget.csv" else mine[-1:]
        prefix = "m" if mine[0][key].startswith("m") else ""
        rewrite(place, name, [*found, *({**row, key: f"{prefix}{new}"} for row in same)])
    reseal(place)
    return "measurement 99 has no audit event"


def a_makers_height(place: Path, drawings: bool = False) -> str:
    edit(
        place,
        "vehicles.csv",
        lambda row: row["manufacturer_height_m"] != "",
        manufacturer_height_m="1.310000",
    )
    for name in ("clicks.csv", *(f"clicks/{one.name}" for one in (place / "clicks").glob("pose-*.csv"))):
        edit(place, name, lambda row: row["target"] == "roof", reference_height_m="1.310000")
    (rederive if drawings else reseal)(place)
    return "vehicles.csv: manufacturer_height_m of row 1 differs from its audit events"


def a_vehicles_state(place: Path) -> str:
    edit(place, "vehicles.csv", lambda row: row["state"] == "rejected", state="accepted")
    reseal(place)
    return "vehicles.csv: 1 is accepted, its measurements make it rejected"


def an_operator(place: Path) -> str:
    for name in ("measurements.csv", "revisions.csv"):
        edit(place, name, roof, created_by_id="3")
    reseal(place)
    return "differs from its audit event"


def an_uncertainty(place: Path) -> str:
    """The u of the roof halved with its whole budget; the U95 stands in the audit chain."""
    (row,) = (one for one in rows(place, "measurements.csv") if roof(one))
    for name in ("measurements.csv", "revisions.csv"):
        edit(place, name, roof, u_height_m=f"{float(row['u_height_m']) / 2:.6f}")
    budget = rows(place, "budget.csv")
    for one in budget:
        if one["measurement_id"] == row["id"]:
            one["u_m"] = f"{float(one['u_m']) / 2:.6f}"
    rewrite(place, "budget.csv", budget)
    reseal(place)
    return "differs from its audit event"


def a_share_of_u(place: Path) -> str:
    """Two contributions exchanged: their root sum of squares stays."""
    budget = rows(place, "budget.csv")
    one, other = [row for row in budget if row["measurement_id"] == "1"][:2]
    assert one["u_m"] != other["u_m"]
    one["u_m"], other["u_m"] = other["u_m"], one["u_m"]
    rewrite(place, "budget.csv", budget)
    reseal(place)
    return "budget.csv: the contributions to 1 differ from its audit event"


def where_an_inset_came_from(place: Path) -> str:
    for name in ("measurements.csv", "revisions.csv"):
        edit(place, name, roof, inset_from="usual")
    reseal(place)
    return "differs from its audit event"


def a_flag_taken_out(place: Path) -> str:
    for name in ("measurements.csv", "revisions.csv"):
        edit(place, name, lambda row: row["flags"] != "", flags="", flags_code="")
    reseal(place)
    return "differs from its audit event"


def a_frame_s_time(place: Path) -> str:
    """In every table that tells it."""
    for name in ("measurements.csv", "revisions.csv", "frames.csv"):
        edit(place, name, lambda row: row["frame"] == "2", time_s="0.5")
    reseal(place)
    return "differs from its audit event"


def a_recording_s_name(place: Path) -> str:
    (row,) = rows(place, "recordings.csv")
    rewrite(place, "recordings.csv", [{**row, "name": "another.mp4"}])
    reseal(place)
    return "recordings.csv: name of row 1 differs from its audit events"


def a_recording_s_length(place: Path) -> str:
    edit(place, "recordings.csv", lambda row: True, duration_s="123.0")
    reseal(place)
    return "recordings.csv: duration_s of row 1 differs from its audit events"


def an_invented_survey(place: Path) -> str:
    edit(place, "survey.csv", lambda row: True, simulated="true")
    reseal(place)
    return "survey.csv: simulated of row 1 differs from its audit events"


def a_board_s_corners(place: Path) -> str:
    edit(place, "poses.csv", lambda row: row["id"] == "1", board_columns="10", board_rows="7")
    reseal(place)
    return "poses.csv: pose 1 differs from records/pose-1.json"


def a_cell_of_a_pose_emptied(place: Path) -> str:
    edit(place, "poses.csv", lambda row: row["id"] == "1", u_reference_height_m="")
    reseal(place)
    return "poses.csv: pose 1 differs from records/pose-1.json"


def a_pose_s_file(place: Path) -> str:
    edit(place, "poses.csv", lambda row: row["id"] == "1", document="poses/pose-2.json")
    reseal(place)
    return "poses.csv: pose 1 differs from records/pose-1.json"


def _of_clicks(place: Path, **cells: str) -> str:
    """What the clicks of m1 repeat of its vehicle, in every file of clicks."""
    for path in ("clicks.csv", "clicks/pose-1.csv"):
        edit(place, path, lambda row: row["id"] == "m1", **cells)
    reseal(place)
    return f"clicks.csv: m1 has another {min(cells)} than its vehicle in vehicles.csv"


def a_known_height_of_clicks(place: Path) -> str:
    """`sightline errors` would read it."""
    return _of_clicks(place, reference_height_m="1.310001")


def a_light_of_clicks(place: Path) -> str:
    return _of_clicks(place, lighting="low_light")


def clicks_that_do_not_count(place: Path) -> str:
    _of_clicks(place, counts="false")
    return "clicks.csv, line 2: counts, error_counts states false, true, the rows give true, true"


def a_rejected_height_that_counts(place: Path) -> str:
    """`sightline distribution` and `errors` would evaluate it."""
    for path in ("clicks.csv", "clicks/pose-1.csv"):
        edit(place, path, lambda row: row["target"] == "taillight", counts="true", error_counts="true")
    reseal(place)
    return "the rows give false, false"


def a_verdict(place: Path) -> str:
    for name in ("measurements.csv", "reviews.csv"):
        edit(place, name, lambda row: row["verdict"] == "rejected", verdict="accepted")
    edit(place, "vehicles.csv", lambda row: row["state"] == "rejected", state="accepted")
    reseal(place)
    return "differs from its audit event"


def an_event(place: Path) -> str:
    edit(place, "audit.csv", lambda row: row["action"] == "revise", action="create")
    reseal(place)
    return "is not the one that was hashed"


def an_event_and_its_hash(place: Path) -> str:
    """The event and its link: that of the one after it no longer holds."""
    events = rows(place, "audit.csv")
    at = next(at for at in range(len(events) // 2, len(events) - 1) if events[at]["actor_id"])
    events[at]["actor_id"] = str(int(events[at]["actor_id"]) + 1)
    only = rehash([dict(one) for one in events], at)
    rewrite(place, "audit.csv", [*only[: at + 1], *events[at + 1 :]])
    reseal(place)
    return "does not follow from the one before"


def an_event_left_out(place: Path) -> str:
    """A rejection, with every link after it, the seal and the sums made to fit."""
    events = rows(place, "audit.csv")
    at = next(n for n, one in enumerate(events) if '"verdict":"rejected"' in one["after"])
    del events[at]
    rewrite(place, "audit.csv", events)
    edit(place, "measurements.csv", lambda row: row["verdict"] == "rejected", verdict="to_review")
    drop(place, "reviews.csv", lambda row: row["verdict"] == "rejected")
    reseal(place)
    return "does not follow from the one before"


def a_statistic(place: Path) -> str:
    def one(row: Row) -> bool:
        return (row["heights"], row["group"], row["figure"]) == ("inset", "daytime", "bias_m")

    edit(place, "statistics/error_table.csv", one, value="0.001")
    reseal(place)
    return "statistics/error_table.csv, line"


def an_exclusion(place: Path) -> str:
    drop(place, "exclusions.csv", lambda row: row["state"] == "rejected")
    reseal(place)
    return "exclusions.csv"


def crops_exchanged(place: Path) -> str:
    first, second = sorted(place.glob("crops/*.jpg"))[:2]
    content = first.read_bytes()
    first.write_bytes(second.read_bytes())
    second.write_bytes(content)
    reseal(place)
    return "does not have the hash stated in crops.csv"


def a_foreign_key(place: Path) -> str:
    drop(place, "people.csv", lambda row: row["name"] == "Reviewer")
    reseal(place)
    return "is not in people.csv"


def a_frame(place: Path) -> str:
    edit(place, "frames.csv", lambda row: row["frame"] == "2", crc32="1")
    reseal(place)
    return "frames.csv: frame 2 of recording 1 differs from the audit events of its measurements"


def an_inset(place: Path) -> str:
    edit(place, "insets.csv", lambda row: row["target"] == "driver_eye_near", inset_m="0.100000")
    reseal(place)
    return "insets.csv: inset_m of row driver_eye_near differs from its audit events"


def a_standard(place: Path) -> str:
    edit(place, "standards.csv", lambda row: row["name"] == "France", height_m="0.900000")
    reseal(place)
    return "standards.csv: height_m of row "


def the_report(place: Path) -> str:
    path = place / "report.pdf"
    path.write_bytes(path.read_bytes().replace(b"Sightline", b"Sightlike", 1) + b"%")
    reseal(place)
    return "report.pdf is not what these rows and statistics give"


def another_time(place: Path) -> str:
    for name in ("measurements.csv", "revisions.csv"):
        edit(place, name, roof, created_at="2020-01-01T00:00:00.000000Z")
    reseal(place)
    return "differs from its audit event"


def another_version(place: Path) -> str:
    for name in ("measurements.csv", "revisions.csv"):
        edit(place, name, roof, code_version="9.9.9")
    reseal(place)
    return "differs from its audit event"


def a_repeat_s_time(place: Path) -> str:
    edit(place, "repeats.csv", lambda row: True, created_at="2020-01-01T00:00:00.000000Z")
    reseal(place)
    return "repeats.csv: "


def a_review_s_time(place: Path) -> str:
    early = "2020-01-01T00:00:00.000000Z"
    edit(place, "reviews.csv", lambda row: row["verdict"] == "accepted", at=early)
    edit(place, "measurements.csv", lambda row: row["verdict"] == "accepted", reviewed_at=early)
    reseal(place)
    return "differs from its audit event"


def a_pose_s_maker(place: Path) -> str:
    edit(place, "poses.csv", lambda row: True, created_at="2020-01-01T00:00:00.000000Z")
    reseal(place)
    return "has another author or time"


def tyres_at_another_time(place: Path) -> str:
    edit(place, "wheel_pairs.csv", lambda row: True, created_at="2020-01-01T00:00:00.000000Z")
    reseal(place)
    return "wheel_pairs.csv: created_at of row 1 differs from its audit event"


def a_camera_that_stood_still(place: Path) -> str:
    edit(place, "recordings.csv", lambda row: True, drift_state="still", drift_moved_px="")
    reseal(place)
    return "recordings.csv: drift_state of row 1 differs from its audit events"


def a_smaller_motion(place: Path) -> str:
    edit(place, "recordings.csv", lambda row: True, drift_height_m="0.001000")
    reseal(place)
    return "recordings.csv: drift_height_m of row 1 differs from its audit events"


def a_decision(place: Path) -> str:
    edit(place, "recordings.csv", lambda row: True, drift_decision="Nobody was there.")
    reseal(place)
    return "recordings.csv: drift_decision of row 1 differs from its audit events"


def a_figure(place: Path) -> str:
    path = next(place.glob("figures/*.svg"))
    path.write_text(path.read_text().replace("</svg>", "<!-- --></svg>"))
    reseal(place)
    return f"figures/{path.name} is not what these rows"


def a_parquet(place: Path) -> str:
    """A height in the columns alone: what programs read that do not read CSV."""
    path = place / "parquet" / "measurements.parquet"
    table = pq.read_table(path)
    at = table.schema.get_field_index("height_m")
    lower = pa.array([None if one is None else one - 0.1 for one in table["height_m"].to_pylist()])
    changed = table.set_column(at, table.schema.field("height_m"), lower)
    pq.write_table(changed, path)
    reseal(place)
    return "parquet/measurements.parquet differs from tables/measurements.csv: column height_m"


def a_unit_of_a_parquet(place: Path) -> str:
    path = place / "parquet" / "measurements.parquet"
    table = pq.read_table(path)
    at = table.schema.get_field_index("height_m")
    in_feet = table.schema.field(at).with_metadata({"description": "height", "unit": "ft"})
    changed = table.set_column(at, in_feet, table["height_m"])
    pq.write_table(changed.replace_schema_metadata(table.schema.metadata), path)
    reseal(place)
    return "parquet/measurements.parquet has other columns, units or meanings"


def the_description(place: Path) -> str:
    path = place / "datapackage.json"
    path.write_text(
        path.read_text().replace("standard uncertainty of height_m (k = 1)", "half of U95_height_m")
    )
    reseal(place)
    return "datapackage.json describes tables/measurements.csv differently"


def a_file_put_in(place: Path) -> str:
    (place / "notes.txt").write_text("Trust me.")
    return "notes.txt is not listed in SHA256SUMS"


def bytes_alone(place: Path) -> str:
    edit(place, "insets.csv", lambda row: row["target"] == "roof", note="none")
    return "insets.csv was changed after the export"


WAYS: tuple[Callable[[Path], str], ...] = (
    a_height,
    a_height_in_one_table,
    a_click_and_its_height,
    a_click_in_one_table,
    a_pose,
    a_pose_with_its_record,
    a_camera,
    a_row_taken_out,
    a_row_put_in,
    a_makers_height,
    a_vehicles_state,
    an_operator,
    an_uncertainty,
    a_share_of_u,
    where_an_inset_came_from,
    a_flag_taken_out,
    a_frame_s_time,
    a_recording_s_name,
    a_recording_s_length,
    an_invented_survey,
    a_board_s_corners,
    a_cell_of_a_pose_emptied,
    a_pose_s_file,
    a_known_height_of_clicks,
    a_light_of_clicks,
    clicks_that_do_not_count,
    a_rejected_height_that_counts,
    a_verdict,
    an_event,
    an_event_and_its_hash,
    an_event_left_out,
    a_statistic,
    an_exclusion,
    crops_exchanged,
    a_foreign_key,
    a_frame,
    an_inset,
    a_standard,
    another_time,
    another_version,
    a_repeat_s_time,
    a_review_s_time,
    a_pose_s_maker,
    tyres_at_another_time,
    a_camera_that_stood_still,
    a_smaller_motion,
    a_decision,
    the_report,
    a_figure,
    a_parquet,
    a_unit_of_a_parquet,
    the_description,
    a_file_put_in,
    bytes_alone,
)

#: Each is refused at a place in the code where none of those is that every run tries.
REFUSED_APART: tuple[Callable[[Path], str], ...] = (
    a_height_in_one_table,
    a_click_in_one_table,
    a_pose_with_its_record,
    a_row_taken_out,
    a_vehicles_state,
    a_share_of_u,
    an_event_and_its_hash,
    crops_exchanged,
    a_foreign_key,
    a_frame,
    a_pose_s_maker,
    a_parquet,
    a_unit_of_a_parquet,
    the_description,
)
