"""Holding the verdicts of a package against the audit chain."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from sightline.errors import Damaged
from sightline.infra.csv_package.chain import stamp
from sightline.infra.csv_package.files import Files, read_columns, read_rows
from sightline.infra.csv_package.verify import says
from sightline.reviews.csv import REVIEWS

_DEFAULT_VERDICT = "to_review"


def check_verdicts(
    files: Files, reviews: Mapping[int, Mapping[str, Any]], is_gone: Callable[[int], bool]
) -> None:
    """Reviews are those of the chain, by number, and each measurement's verdict is its newest review's,
    of that revision or of the one whose verdict holds for it too.

    `is_gone`: whether a vehicle was deleted. Raises Damaged.
    """
    newest: dict[tuple[str, str], Mapping[str, str]] = {}
    there: set[int] = set()
    for row in read_rows(files, REVIEWS.path):
        made = reviews.get(int(row["id"]))
        if made is None or not says(REVIEWS, row, _of_review(made)):
            raise Damaged("reviews-reviews-csv-not-what-audit-event", id=row["id"])
        there.add(int(row["id"]))
        newest[row["measurement_id"], row["result_revision"]] = row
    for id_, made in reviews.items():
        if id_ not in there and not is_gone(int(made["vehicle_id"])):
            raise Damaged("reviews-reviews-csv-missing-though-audit-event", id=id_)
    names = ("verdict", "review_reason", "reviewer_id", "reviewed_at", "verdict_by", "lot_id")
    columns = ("id", "revision", "verdict_of_revision", *names)
    for one, revision, carried, *said in read_columns(files, "measurements.csv", columns):
        judged = [found for of in (revision, carried) if (found := newest.get((one, of))) is not None]
        review = max(judged, key=lambda row: int(row["id"]), default=None)
        wanted = [_DEFAULT_VERDICT, "", "", "", "", ""]
        if review is not None:
            wanted = [review[name] for name in ("verdict", "reason", "reviewer_id", "at")]
            wanted += ["lot" if review["lot_id"] else "individual", review["lot_id"]]
        if said != wanted:
            raise Damaged("reviews-measurements-csv-verdict-not-newest-review", one=one)


def _of_review(made: Mapping[str, Any]) -> dict[str, Any]:
    named: dict[str, Any] = {
        "measurement_id": made["series_id"],
        "reviewer_id": int(made["actor_id"]) if made["actor_id"] else None,
        "at": stamp(made["created_at"]),
    }
    return {**made, **named}
