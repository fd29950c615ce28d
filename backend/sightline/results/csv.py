"""What a package is of, and the heights of standards that it is read against, as tables, and back."""

from operator import itemgetter
from typing import get_args

from sightline.enums import Category, ClassSet, Lighting, StandardHeight
from sightline.errors import Damaged
from sightline.infra.csv_package.columns import flag, integer, metres, number, text
from sightline.infra.csv_package.files import Files, read_columns, read_integer, read_rows, record_in
from sightline.infra.csv_package.schema import Table
from sightline.recordings.filming import FILMED
from sightline.results.selection import Selection, selection_of
from sightline.statistics.standards import Standard

STANDARDS: Table[Standard] = Table(
    "standards",
    "The heights of standards that the statistics are read against: shares of vehicles below each.",
    (
        text("what", "quantity that the standard specifies", required=True, enum=get_args(StandardHeight)),
        text("name", "the standard", required=True),
        metres("height_m", "its height above the road", required=True),
        text("edition", "edition of the standard"),
        integer("year", "year of that edition, or of the study"),
        number("percent", "percentile of its class that it represents", "%"),
        text("vehicle_class", "the class that the percentile is of"),
        text("source", "where the figure comes from"),
        text("cited_by", "who cites it; empty where the source itself was read"),
        flag("drawn", "whether distributions are read against it", required=True),
    ),
    primary=("what", "name"),
)


def standards_in(files: Files) -> tuple[Standard, ...]:
    """The table of a package, or the program's own, which has codes. Raises Damaged."""
    return tuple(_standard(row) for row in read_rows(files, STANDARDS.key))


def _standard(row: dict[str, str]) -> Standard:
    kinds: dict[str, StandardHeight] = {word: word for word in get_args(StandardHeight)}
    what = kinds.get(row["what"])
    if what is None or not row["height_m"] or row["drawn"] not in ("true", "false"):
        raise Damaged("results-cell-unreadable", path=STANDARDS.key, name=row["name"])
    return record_in(Standard, row, what=what, code=row.get("code"))


#: What is chosen by, and one word of it.
Chosen = tuple[str, str]
_WORDS: dict[str, tuple[str, ...]] = {
    "lighting": get_args(Lighting),
    "class_set": get_args(ClassSet),
    "category": get_args(Category),
}
SELECTION: Table[Chosen] = Table(
    "selection",
    "The vehicles that statistics, figures and report of this package are of: of the lighting named, of any "
    "set or class named, and filmed on those days and at those hours; what is not named is not limited, and "
    "where time is, what has no time of filming is left out. Traffic in intervals is limited by days and "
    "hours alone. The other tables are of the whole survey.",
    (
        text("by", "what is chosen by", itemgetter(0), required=True, enum=(*_WORDS, *FILMED)),
        text("word", "column-selection-word", itemgetter(1), required=True),
    ),
    primary=("by", "word"),
)


def selection_rows(selection: Selection) -> list[Chosen]:
    """A selection as rows; none for the whole survey."""
    lighting = [] if selection.lighting is None else [selection.lighting]
    return [
        *(("lighting", one) for one in lighting),
        *(("class_set", one) for one in selection.class_sets),
        *(("category", one) for one in selection.categories),
        *((name, str(word)) for name in FILMED if (word := selection.stored()[name]) is not None),
    ]


def selection_in(files: Files) -> Selection:
    """What a package is of. Raises Damaged."""
    rows = [(by, word) for by, word in read_columns(files, SELECTION.key, ("by", "word"))]
    chosen: dict[str, list[str]] = {
        name: [word for by, word in rows if by == name] for name in (*_WORDS, *FILMED)
    }
    selection = selection_of(
        {
            "lighting": chosen["lighting"][0] if chosen["lighting"] else None,
            "class_sets": chosen["class_set"],
            "categories": chosen["category"],
            **{name: chosen[name][0] for name in FILMED[:2] if chosen[name]},
            **{name: read_integer(chosen[name][0]) for name in FILMED[2:] if chosen[name]},
        }
    )
    if selection_rows(selection) != rows or any(word not in _WORDS[by] for by, word in rows if by in _WORDS):
        raise Damaged("results-cell-unreadable", path=SELECTION.key, name="word")
    return selection
