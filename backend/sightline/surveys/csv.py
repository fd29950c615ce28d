"""The tables of a survey's insets and of its classes of vehicles in the package."""

from operator import itemgetter
from typing import get_args

from sightline.enums import AskedTarget, Category, ClassSet, InsetName, Lighting, SamplingMethod, StreetLamps
from sightline.infra.csv_package.columns import (
    columns_for,
    columns_within,
    flag,
    integer,
    metres,
    number,
    text,
)
from sightline.infra.csv_package.files import Files, read_columns, read_rows, record_in, undo_safe_text
from sightline.infra.csv_package.files import number as figure
from sightline.infra.csv_package.schema import Table
from sightline.statistics.sampling import Quota, Sampling
from sightline.surveys.classes import VehicleClass
from sightline.surveys.place import PLACE, Place
from sightline.surveys.records import Asked, Inset, Survey, insets_of

#: A target and the inset that is in force for it.
InForce = tuple[str, Inset]

SURVEY: Table[Survey] = Table(
    "survey",
    "The survey that this package is of: one row.",
    (
        *columns_for(Survey, "id"),
        *columns_for(Survey, "name", required=True),
        *columns_for(Survey, "site description simulated"),
        *columns_within("place", *columns_for(Place, " ".join(PLACE))),
    ),
    primary=("id",),
)

INSETS: Table[InForce] = Table(
    "insets",
    "The insets in force in this survey: used for every measurement that does not carry its own.",
    (
        text("target", "column-insets-target", itemgetter(0), required=True, enum=get_args(InsetName)),
        *columns_within(
            itemgetter(1),
            metres("inset_m", "column-measurements-inset-m"),
            metres("u_inset_m", "standard uncertainty of the inset (k = 1)"),
            text("note", "where the figure comes from"),
        ),
    ),
    primary=("target",),
)


def insets_in(files: Files) -> dict[str, Inset]:
    """The insets of a package, by name."""
    return insets_of(
        {
            row["target"]: {
                "inset_m": float(row["inset_m"]),
                "u_inset_m": float(row["u_inset_m"]),
                "note": undo_safe_text(row["note"]),
            }
            for row in read_rows(files, INSETS.key)
        }
    )


CLASSES: Table[VehicleClass] = Table(
    "classes",
    "The classes of vehicles: the set that each counts in, and what the EU and FHWA call it.",
    (
        text("category", "class", required=True, enum=get_args(Category)),
        *columns_for(VehicleClass, "class_set"),
        text(
            "eu_classes", "its classes in the EU (M1, N1 ...), a space between them", lambda c: " ".join(c.eu)
        ),
        text(
            "fhwa_classes",
            "its classes among the 13 of FHWA, a space between them",
            lambda c: " ".join(map(str, c.fhwa)),
        ),
    ),
    primary=("category",),
)


def class_sets_in(files: Files) -> dict[str, str]:
    """The set of each class by the class, as a package has it; empty for none."""
    return dict(read_columns(files, CLASSES.key, ("category", "class_set")))


SAMPLING: Table[Survey] = Table(
    "sampling",
    "Which passes are to be measured: one row. A pass of number N is taken with every; with nth where N >= "
    "start and N - start is a multiple of step; with share where SplitMix64 of 2^32 * seed + N, over 2^64, "
    "is below share_percent over 100; and with free_flowing_s only where the pass before in its direction "
    "began at least so many seconds earlier.",
    (
        *columns_within(
            "sampling",
            text(
                "method",
                "every pass, each step-th, or a share that the seed draws",
                required=True,
                enum=get_args(SamplingMethod),
            ),
            integer("step", "with nth: every so many-th", required=True),
            integer("start", "with nth: the first", required=True),
            number("share_percent", "with share: how many of 100", "%"),
            integer("seed", "with share: what draws them", required=True),
            number("free_flowing_s", "least time behind the pass before; empty: any", "s"),
            flag(
                "outside_counts",
                "whether heights of passes out of the sample count in results",
                required=True,
            ),
        ),
        text("asked_daytime", "targets asked for by day", lambda s: " ".join(s.asked.daytime)),
        text("asked_low_light", "targets asked for in low light", lambda s: " ".join(s.asked.low_light)),
    ),
)
QUOTAS: Table[Quota] = Table(
    "quotas",
    "How many vehicles are wanted of each lighting and set of classes.",
    (
        text("lighting", "lighting", required=True, enum=get_args(Lighting)),
        text("class_set", "set of classes; empty: any class", enum=get_args(ClassSet)),
        integer("wanted", "how many vehicles", required=True, minimum=1),
    ),
    primary=("lighting", "class_set"),
)


def sampling_in(files: Files) -> Sampling:
    """The rule of a package, without its quotas."""
    (row,) = read_rows(files, SAMPLING.key)
    methods: dict[str, SamplingMethod] = {word: word for word in get_args(SamplingMethod)}
    return Sampling(
        method=methods[row["method"]],
        step=int(row["step"]),
        start=int(row["start"]),
        share_percent=float(row["share_percent"]),
        seed=int(row["seed"]),
        free_flowing_s=figure(row["free_flowing_s"]),
        outside_counts=row.get("outside_counts", "true") == "true",  # before the column, all counted
    )


def asked_in(files: Files) -> Asked:
    """The targets that the survey of a package asks for."""
    (row,) = read_rows(files, SAMPLING.key)
    known: dict[str, AskedTarget] = {word: word for word in get_args(AskedTarget)}
    by_day, in_low_light = (
        tuple(known[word] for word in row[f"asked_{lighting}"].split()) for lighting in get_args(Lighting)
    )
    return Asked(by_day, in_low_light)


def place_in(files: Files) -> Place:
    """The place of a package's survey."""
    (row,) = read_rows(files, SURVEY.key)
    lamps: dict[str, StreetLamps] = {word: word for word in get_args(StreetLamps)}
    return record_in(Place, row, street_lamps=lamps.get(row["street_lamps"]))
