"""Holding what was computed again in a package against the audit chain, and the verdicts that went over."""

import re
from collections import Counter
from collections.abc import Callable, Mapping, Sequence, Set
from dataclasses import fields
from itertools import groupby
from typing import Any

from sightline.enums import Target
from sightline.errors import Damaged
from sightline.geometry.sides import TrafficFacts, driver_side
from sightline.infra.csv_package.columns import join_sentences
from sightline.infra.csv_package.files import Files, read_columns, read_rows
from sightline.infra.csv_package.files import number as figure_of
from sightline.infra.csv_package.replay import Replay, Replayed
from sightline.measurements.again.csv import COMPUTINGS
from sightline.measurements.again.differences import Facts, causes_now
from sightline.surveys.records import insets_of

# Three lengths of six decimals, each rounded.
_ROUNDING_M = 2e-6
_SAME = ("target", "status", "followed", "sigma_px", "pose_id")
_POINT = re.compile(r"(frame|contact|target)\d*(_[xy]_px)?")
Row = Mapping[str, str]


REPLAYED = Replayed(
    COMPUTINGS,
    "computing",
    cells=lambda told: {
        **dict.fromkeys(("by_pose", "by_inset", "by_side", "by_program"), 0),
        **told,
        **{f"by_{cause}": count for cause, count in told["causes"].items()},
    },
)


def check_computings(files: Files, replay: Replay, revisions: Mapping[int, int]) -> dict[str, str]:
    """Computings are those of their events, made as many `revisions` as they say, and a verdict
    went over only to a measurement that hardly moved, to one put back, or was a rejection, and without a
    computing only to the height that it stood on; the kind of each by its number, for what else they
    computed. Raises Damaged.
    """
    kinds: dict[str, str] = {}
    for row in replay.hold(files, REPLAYED):
        if revisions.get(int(row["id"]), 0) != int(row["heights"]):
            raise Damaged("computing-revision-count", id=row["id"])
        kinds[row["id"]] = row["kind"]
    rejected = _rejections(files)
    for name, group in groupby(read_rows(files, "revisions.csv"), key=lambda row: row["measurement_id"]):
        of_one = list(group)
        judged = [int(row["verdict_of_revision"] or 0) for row in of_one]
        refused = {int(n) for one, n in rejected if one == name}
        bad = verdict_gone_over(of_one, judged, kinds, refused, put_back)
        if bad is not None:
            raise Damaged("computing-verdict-went-over", name=name, revision=bad["revision"])
    return kinds


def check_out_of_date(
    files: Files,
    path: str,
    follows_from: Mapping[int, tuple[Target, Facts]],
    survey: Mapping[str, Any],
    vehicles: Mapping[int, Mapping[str, Any]],
    pose_in_force: Callable[[int], int | None],
) -> None:
    """Each measurement or repeat of a table is marked as out of date for what its events say, and no other.
    All from the audit chain: `follows_from` of each, the survey's traffic and insets, the vehicles by number
    and the road pose in force of a recording. Raises Damaged.
    """
    traffic = TrafficFacts(**{one.name: survey.get(one.name) for one in fields(TrafficFacts)})
    insets = insets_of(survey["insets"])
    names = ("id", "vehicle_id", "recording_id", "withdrawn", "out_of_date")
    for id_, vehicle, recording, withdrawn, marked in read_columns(files, path, names):
        car, pose_id = vehicles.get(int(vehicle), {}), pose_in_force(int(recording))
        target, then = follows_from[int(id_)]
        side = driver_side(car.get("driver_side"), car.get("direction"), traffic)
        stands = withdrawn != "true" and pose_id is not None
        category = car.get("category")
        causes = (
            causes_now(target, then, pose_id=pose_id, side=side, category=category, insets=insets)
            if stands
            else ()
        )
        if marked != join_sentences(causes):
            raise Damaged("computing-mark-wrong", path=path, id=id_)


def _rejections(files: Files) -> set[tuple[str, str]]:
    """The revisions whose last verdict is a rejection."""
    newest: dict[tuple[str, str], str] = {}
    for measurement_id, revision, verdict in read_columns(
        files, "reviews.csv", ("measurement_id", "result_revision", "verdict")
    ):
        newest[measurement_id, revision] = verdict
    return {key for key, verdict in newest.items() if verdict == "rejected"}


def verdict_gone_over(
    rows: Sequence[Row],
    judged: Sequence[int],
    kinds: Mapping[str, str],
    rejected: Set[int],
    same: Callable[[Row, Row], bool] | None = None,
) -> Row | None:
    """The first of one height's revisions, oldest first, whose verdict was given to another height.

    `judged`: of each the revision whose verdict holds for it too, 0 for none; `kinds`: of each computing by
    its number; `rejected`: the revisions whose last verdict is a rejection; `same`: whether a row, made by no
    computing, is an earlier one put back; None: no verdict goes over to such a row.
    """
    for at, (row, of) in enumerate(zip(rows, judged, strict=True)):
        if not of:
            continue
        computing = row.get("computing_id")
        if not computing:
            stood_on = [
                then for then, its in zip(rows[:at], judged, strict=False) if of in (_number(then), its)
            ]
            holds = same is not None and any(same(then, row) for then in stood_on)
        else:
            holds = (
                at > 0
                and computing in kinds
                and of < _number(row)
                and (kinds[computing] == "undo" or of in rejected or _hardly_moved(rows[at - 1], row))
            )
        if not holds:
            return row
    return None


def _number(row: Row) -> int:
    return int(row["revision"])


def put_back(then: Row, row: Row) -> bool:
    """Whether a height stands on the very clicks and numbers of an earlier revision."""
    if any(then[name] != row[name] for name in row if name in _SAME or _POINT.fullmatch(name)):
        return False
    return same_figures(then, row)


def same_figures(then: Row, row: Row) -> bool:
    """Whether two rows have one height with one uncertainty, or both none."""
    lengths = ((figure_of(one["height_m"]), figure_of(one["u_height_m"])) for one in (then, row))
    return all(
        a is b if a is None or b is None else abs(a - b) <= _ROUNDING_M for a, b in zip(*lengths, strict=True)
    )


def _hardly_moved(before: Row, row: Row) -> bool:
    then, now = figure_of(before["height_m"]), figure_of(row["height_m"])
    if then is None or now is None:
        return then is now
    return abs(now - then) <= (figure_of(before["u_height_m"]) or 0.0) + _ROUNDING_M


def count_revisions(counted: Counter[int], content: Mapping[str, Any]) -> None:
    """Note the event of a revision, with this content, that was made by a computing."""
    if content["computing_id"] is not None:
        counted[int(content["computing_id"])] += 1
