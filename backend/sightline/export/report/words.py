"""The words that figures and report call things by."""

from collections.abc import Sequence
from datetime import date
from functools import reduce

from sightline.export.report.said import Called, day_parts, sentence_of_key
from sightline.recordings.filming import FilmedWithin
from sightline.results.selection import Selection

TARGETS = Called("report-target-")
MANY = Called("report-many-")
LIGHTING = Called("report-light-")
CATEGORIES = Called("report-category-")
LANES = Called("report-heading-")
CLASS_SETS = Called("report-set-")
GROUPINGS = Called("report-divided-by-")
QUANTITIES = Called("report-quantity-of-")


def heading(word: str) -> str:
    """With a capital."""
    return word[:1].upper() + word[1:]


def group_word(grouping: str, word: str) -> str:
    """A group of vehicles, for people."""
    known = {"lighting": LIGHTING, "category": CATEGORIES, "class_set": CLASS_SETS, "lane": LANES}
    return known[grouping].get(word, word) if grouping in known else word


def join_with_semicolons(words: Sequence[str]) -> str:
    """Words or sentences with semicolons between, as the language writes them."""
    return reduce(lambda first, second: sentence_of_key("report-apart", first=first, second=second), words)


def date_words(day: date) -> str:
    """A day as the language writes it."""
    return sentence_of_key("report-date", **day_parts(day))


def selection_words(selection: Selection) -> str | None:
    """What a package or report is of: "low light; passenger cars, SUV"; None for the whole survey."""
    if selection.is_all:
        return None
    classes = [
        *(CLASS_SETS[one] for one in selection.class_sets),
        *(CATEGORIES[one] for one in selection.categories),
    ]
    lighting = [] if selection.lighting is None else [LIGHTING[selection.lighting]]
    return join_with_semicolons(
        [*lighting, *([", ".join(classes)] if classes else []), *_filmed_words(selection)]
    )


def _filmed_words(filmed: FilmedWithin) -> list[str]:
    """On which days and at which hours."""
    first, last = (day and date_words(day) for day in (filmed.filmed_from, filmed.filmed_to))
    begins, ends = (f"{hour:02d}:00" for hour in filmed.hours)
    if (first or last) and filmed.hours[0] > filmed.hours[1]:
        days = ("one" if first == last else "several") if first and last else "since" if first else "until"
        said = {"days": days, "first": first or "", "last": last or "", "begins": begins, "ends": ends}
        return [sentence_of_key("report-filmed-nights", **said)]
    days_said = (("report-filmed-since", first), ("report-filmed-until", last))
    words = [sentence_of_key(key, day=day) for key, day in days_said if day]
    if filmed.hour_from is not None or filmed.hour_to is not None:
        words.append(sentence_of_key("report-filmed-hours", begins=begins, ends=ends))
    return words
