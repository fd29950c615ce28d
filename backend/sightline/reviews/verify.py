"""Holding the verdicts of a package against the audit chain."""

from collections.abc import Mapping

from sightline.errors import Damaged
from sightline.infra.csv_package.files import Files, read_columns
from sightline.infra.csv_package.replay import Replay, Replayed
from sightline.reviews.csv import REVIEWS

_DEFAULT_VERDICT = "to_review"


REPLAYED = Replayed(
    REVIEWS,
    "review",
    ("vehicle_id", "vehicle"),
    cells=lambda told: {
        **told,
        "measurement_id": told["series_id"],
        "reviewer_id": told["actor_id"],
        "at": told["created_at"],
    },
)


def check_verdicts(files: Files, replay: Replay) -> None:
    """Reviews are those of the chain, and each measurement's verdict is its newest review's, of that revision
    or of the one whose verdict holds for it too. Raises Damaged.
    """
    newest: dict[tuple[str, str], Mapping[str, str]] = {}
    for row in replay.hold(files, REPLAYED):
        newest[row["measurement_id"], row["result_revision"]] = row
    names = ("verdict", "review_reason", "reviewer_id", "reviewed_at", "verdict_by", "lot_id")
    columns = ("id", "revision", "verdict_of_revision", *names)
    for measurement_id, revision, carried, *stated in read_columns(files, "measurements.csv", columns):
        judged = [
            found for of in (revision, carried) if (found := newest.get((measurement_id, of))) is not None
        ]
        review = max(judged, key=lambda row: int(row["id"]), default=None)
        wanted = [_DEFAULT_VERDICT, "", "", "", "", ""]
        if review is not None:
            wanted = [review[name] for name in ("verdict", "reason", "reviewer_id", "at")]
            wanted += ["lot" if review["lot_id"] else "individual", review["lot_id"]]
        if stated != wanted:
            raise Damaged("reviews-verdict-differs", one=measurement_id)
