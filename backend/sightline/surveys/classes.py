"""What a survey makes of the classes of its vehicles: the set that each counts in, and its legal classes.

The usual table follows Regulation (EU) 2018/858 (M, N, O) and 168/2013 (L), and the 13 classes of FHWA's
Traffic Monitoring Guide, appendix C. Where a body may be of several classes (a lorry by its mass or its
axles), all of them are named. A sport utility vehicle counts as a passenger car, as in the EU (M1); who
counts it with the light trucks, as class 3 of FHWA may be read, changes its set.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Annotated, Any, get_args

from pydantic import Field

from sightline.enums import Category, ClassSet, EuClass
from sightline.errors import BadInput

FHWA_CLASSES = range(1, 14)


@dataclass(frozen=True, slots=True)
class VehicleClass:
    """What a survey makes of one class of vehicles."""

    category: Category
    class_set: Annotated[
        ClassSet | None,
        Field(description="The set of classes that it counts in; none where it counts in no set."),
    ]
    eu: Annotated[tuple[EuClass, ...], Field(description="Its classes in the EU.")] = ()
    fhwa: Annotated[tuple[int, ...], Field(description="Its classes among FHWA's 13.")] = ()


USUAL_CLASSES: tuple[VehicleClass, ...] = (
    VehicleClass("hatchback", "passenger_cars", ("M1",), (2,)),
    VehicleClass("saloon", "passenger_cars", ("M1",), (2,)),
    VehicleClass("estate", "passenger_cars", ("M1",), (2,)),
    VehicleClass("suv", "passenger_cars", ("M1",), (2, 3)),
    VehicleClass("multi_purpose", "light_trucks", ("M1",), (2, 3)),
    VehicleClass("pickup", "light_trucks", ("N1",), (3,)),
    VehicleClass("van", "light_trucks", ("N1",), (3,)),
    VehicleClass("lorry", "heavy", ("N2", "N3"), (5, 6, 7)),
    VehicleClass("tractor_unit", "heavy", ("N3",), (8, 9, 10, 11, 12, 13)),
    VehicleClass("bus", "heavy", ("M2", "M3"), (4,)),
    VehicleClass("recreational_vehicle", None, ("M1",), (3, 5)),
    VehicleClass("trailer", None, ("O1", "O2", "O3", "O4"), ()),
    VehicleClass("motorcycle", None, ("L",), (1,)),
    VehicleClass("other", None),
)


def chosen_classes(
    changes: Iterable[VehicleClass], before: Iterable[VehicleClass]
) -> tuple[VehicleClass, ...]:
    """The table with some classes changed, in its usual order. Raises BadInput for one that comes twice."""
    table = {one.category: one for one in before}
    changed: set[str] = set()
    for change in changes:
        if change.category in changed:
            raise BadInput("surveys-class-twice", category=change.category)
        if any(number not in FHWA_CLASSES for number in change.fhwa):
            raise BadInput("surveys-class-fhwa", category=change.category)
        changed.add(change.category)
        eu = tuple(word for word in get_args(EuClass) if word in change.eu)
        table[change.category] = VehicleClass(
            change.category, change.class_set, eu, tuple(sorted(set(change.fhwa)))
        )
    return tuple(table[category] for category in get_args(Category))


def stored_classes(table: Iterable[VehicleClass]) -> dict[str, Any]:
    """The table as its column and the audit chain hold it."""
    return {
        one.category: {"class_set": one.class_set, "eu": list(one.eu), "fhwa": list(one.fhwa)}
        for one in table
    }


def classes_of(stored: Mapping[str, Mapping[str, Any]]) -> tuple[VehicleClass, ...]:
    """The table of a column, in its usual order."""
    return tuple(
        VehicleClass(one, stored[one]["class_set"], tuple(stored[one]["eu"]), tuple(stored[one]["fhwa"]))
        for one in get_args(Category)
    )


def sets_of(table: Iterable[VehicleClass]) -> tuple[int, ...]:
    """The number of each class's set among the sets, by the number of the class; -1 for none."""
    names = get_args(ClassSet)
    of = {one.category: -1 if one.class_set is None else names.index(one.class_set) for one in table}
    return tuple(of[category] for category in get_args(Category))
