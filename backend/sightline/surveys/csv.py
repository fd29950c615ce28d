"""The tables of a survey's insets and of its classes of vehicles in the package."""

from __future__ import annotations

from typing import get_args

from sightline.enums import Category, ClassSet, InsetName
from sightline.infra.csv_package.columns import key, metres, text
from sightline.infra.csv_package.files import Files, read_columns
from sightline.infra.csv_package.schema import Table
from sightline.surveys.classes import VehicleClass
from sightline.surveys.records import Inset, Survey

#: A target and the inset that is in force for it.
InForce = tuple[str, Inset]

SURVEY: Table[Survey] = Table(
    "survey",
    "The survey that this package is of: one row.",
    (
        key("id", "survey, in the database that it comes from", lambda s: s.id),
        text("name", "name of the survey", lambda s: s.name, required=True),
        text(
            "site", "where it was filmed; a study takes surveys of one site as one cluster", lambda s: s.site
        ),
        text("description", "what was said of the survey", lambda s: s.description),
    ),
    primary=("id",),
)

INSETS: Table[InForce] = Table(
    "insets",
    "The insets in force in this survey: used for every measurement that does not carry its own.",
    (
        text(
            "target",
            "what is measured; of a driver's eye for the driver on the near or on the far side",
            lambda i: i[0],
            required=True,
            enum=get_args(InsetName),
        ),
        metres(
            "inset_m",
            "how far the target lies behind the vertical plane through the contact point, along road Y",
            lambda i: i[1].inset_m,
        ),
        metres("u_inset_m", "standard uncertainty of the inset (k = 1)", lambda i: i[1].u_inset_m),
        text("note", "where the figure comes from", lambda i: i[1].note),
    ),
    primary=("target",),
)


def insets_in_force(survey: Survey) -> list[InForce]:
    """The survey's insets by target."""
    return sorted(survey.insets.items())


CLASSES: Table[VehicleClass] = Table(
    "classes",
    "The classes of vehicles: the set that each counts in, and what the EU and FHWA call it.",
    (
        text("category", "class", lambda c: c.category, required=True, enum=get_args(Category)),
        text(
            "class_set",
            "the set of classes that it counts in; empty: in none",
            lambda c: c.class_set,
            enum=get_args(ClassSet),
        ),
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
    return dict(read_columns(files, CLASSES.path, ("category", "class_set")))
