"""The table of surveys."""

from sightline.geometry.sides import TrafficFacts
from sightline.infra.database.types import changed_columns, columns_for, numbered_table
from sightline.surveys.place import Place
from sightline.surveys.records import Survey

_CHARACTERS = {"road_class": 100, "lane": 100, "travel_direction": 100, "time_zone": 60}

surveys = numbered_table(
    "surveys",
    # simulated: no figure of it says anything of real roads, which is said of each study that takes it;
    # open_to_all: everybody who signs in acts here with the role of the account; else members alone
    *columns_for(
        Survey,
        {"name": 200, "site": 200},
        only="name site description is_demo simulated open_to_all",
    ),
    # how traffic goes here and where the camera stands; empty while nobody has said
    *columns_for(TrafficFacts),
    # where it lies, what road it is, whose clocks are told; empty while nobody has said
    *columns_for(Place, _CHARACTERS),
    *columns_for(Survey, only="asked classes sampling insets"),
    *changed_columns(),
)
