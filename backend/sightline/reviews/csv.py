"""The table of verdicts in the package."""

from typing import get_args

from sightline.enums import ReviewVerdict
from sightline.infra.csv_package.columns import integer, key
from sightline.infra.csv_package.schema import Table, ids_of
from sightline.measurements.csv import given_verdict
from sightline.measurements.records import Review

_GIVEN = given_verdict(get_args(ReviewVerdict))
REVIEWS: Table[Review] = Table(
    "reviews",
    "Every verdict, in the order in which they were given.",
    (
        key("id", "review"),
        key("measurement_id", "measurement that was reviewed"),
        key("revision", "revision that the reviewer saw"),
        key("result_revision", "revision to which the verdict applies (a fix creates a new one)"),
        *_GIVEN[:2],
        integer("lot_id", "of a verdict by lot: the lot; else the verdict is individual"),
        *_GIVEN[2:],
    ),
    primary=("id",),
    foreign=ids_of(measurement_id="measurements", lot_id="lots"),
)
