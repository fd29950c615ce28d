"""The table of the people that other tables name, in the package."""

from sightline.infra.audit.records import Who
from sightline.infra.csv_package.columns import key, text
from sightline.infra.csv_package.schema import Table

PEOPLE: Table[Who] = Table(
    "people",
    "The people named in the other tables, by number and name only. The audit chain holds their numbers; "
    "their names are covered by the checksums alone.",
    (key("id", "person"), text("name", "name", required=True)),
    primary=("id",),
)
