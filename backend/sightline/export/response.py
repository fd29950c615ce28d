"""The response of a package's survey: what became of its passes, by lighting, set and target."""

from collections.abc import Iterator
from dataclasses import asdict
from typing import cast, get_args

from sightline.enums import AskedTarget, ClassSet, Lighting
from sightline.export.chosen import chosen_vehicles
from sightline.export.statistics_rows import statistics_table
from sightline.infra.csv_package.columns import integer, number, text
from sightline.infra.csv_package.files import Files, read_columns, read_rows
from sightline.infra.csv_package.schema import Cell
from sightline.statistics.sampling import PassAnswers, Response, response
from sightline.surveys.csv import asked_in, class_sets_in
from sightline.vehicles.records import NOT_VISIBLE

RESPONSE = statistics_table(
    "response",
    "What became of the passes of the survey. in_sample are those that the rule of sampling.csv takes, but "
    "for discarded ones; each is measured (all that is asked for is answered, something measured and not "
    "rejected), not visible, or open.",
    text("lighting", "all, daytime, low_light, or unknown", required=True),
    text("class_set", "all, a set of classes (classes.csv), or none", required=True),
    text("target", "what is asked for; empty: the vehicle as a whole", enum=get_args(AskedTarget)),
    integer("passes", "passes found", required=True),
    integer("discarded", "of them discarded (vehicles.csv says why)", required=True),
    integer("out_of_sample", "of them out of the sample", required=True),
    integer("in_sample", "of them in the sample", required=True),
    integer("measured", "of the sample measured", required=True),
    integer("not_visible", "of the sample not visible", required=True),
    integer("open", "of the sample open", required=True),
    integer("outside", "measured though out of the sample", required=True),
    number("rate", "response rate: measured over in_sample"),
    number("low", "lower end of its exact 95 % interval"),
    number("high", "upper end of its exact 95 % interval"),
    primary=("lighting", "class_set", "target"),
)


def response_rows(files: Files) -> Iterator[dict[str, Cell]]:
    """Rows of statistics/response.csv."""
    for one in response_in(files):
        yield asdict(one)


def response_in(files: Files) -> list[Response]:
    """The response of the vehicles that a package is of."""
    return response(_passes(files))


def _passes(files: Files) -> Iterator[PassAnswers]:
    measured: dict[str, set[str]] = {}
    names = ("vehicle_id", "target", "withdrawn", "verdict", "status")
    for vehicle, target, withdrawn, verdict, status in read_columns(files, "measurements.csv", names):
        if withdrawn == "false" and verdict != "rejected" and status == "ok":
            measured.setdefault(vehicle, set()).add(target)
    lit = dict(read_columns(files, "recordings.csv", ("id", "lighting")))
    sets, asked, chosen = class_sets_in(files), asked_in(files), chosen_vehicles(files).of
    for row in read_rows(files, "vehicles.csv"):
        if row["id"] not in chosen or row["check_target"] == "true":
            continue
        lighting = cast(Lighting | None, row["lighting"] or lit.get(row["recording_id"]) or None)
        yield PassAnswers(
            lighting=lighting,
            class_set=cast(ClassSet | None, sets.get(row["category"]) or None),
            in_sample=row["in_sample"] == "true",
            discarded=row["discarded"] != "",
            asked=asked.of(lighting),
            measured=frozenset(measured.get(row["id"], ())) & set(NOT_VISIBLE),
            not_visible=frozenset(target for target, name in NOT_VISIBLE.items() if row[name]),
        )
