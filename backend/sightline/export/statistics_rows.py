"""What the tables of statistics have in common: columns of intervals, and rows of errors and of curves."""

from collections.abc import Iterator, Mapping
from typing import Any

from sightline.infra.csv_package.columns import metres, number, said_columns
from sightline.infra.csv_package.schema import Cell, Column, Row, Table
from sightline.messages.said import Said
from sightline.statistics.errors import ErrorGroup

Cells = dict[str, Cell]
INTERVAL = (
    number("low", "lower end of its 95 % interval"),
    number("high", "upper end of its 95 % interval"),
)
INTERVAL_M = (
    metres("low_m", "lower end of its 95 % interval"),
    metres("high_m", "upper end of its 95 % interval"),
)
#: Of the true heights, with all that makes them uncertain.
TOTAL_M = (
    metres("low_m", "lower end of its total 95 % interval"),
    metres("high_m", "upper end of its total 95 % interval"),
)
BAND = (
    number("low", "lower edge of the 95 % band, which includes sampling only"),
    number("high", "upper edge of the 95 % band, which includes sampling only"),
)


def statistics_table(name: str, meaning: str, *columns: Column, **keys: Any) -> Table:
    """A table of the folder of statistics, with the keys that it has."""
    return Table(name, meaning, columns, folder="statistics/", **keys)


def said_of(name: str, meaning: str) -> tuple[Column, Column]:
    """What is said in a cell of a row, which may leave it out, and beside it its codes and values."""
    return said_columns(name, meaning, lambda row: row.get(name))


REASON = said_of("reason", "why a value or its interval is missing")


def error_rows(key: Row, groups: Mapping[str, ErrorGroup]) -> Iterator[Cells]:
    """Each figure of each group, with its interval and what that holds."""
    for name, group in groups.items():
        for figure, value in group.figures.items():
            interval = group.ci95[figure]
            row = {**key, "group": name, "figure": figure, "n": group.n, "value": value}
            if interval is not None:
                row |= {**vars(interval), "holds": " ".join(group.holds.get(figure, ()))}
            yield {**row, "reason": group.reason}


def curve_rows(key: Row, curve: object, **cells: str) -> Iterator[Cells]:
    """Each point of a curve, if there is one and not its reason; `cells`: the array (N,) that fills each."""
    if curve is None or isinstance(curve, Said):
        return
    for point in zip(*(getattr(curve, name).tolist() for name in cells.values()), strict=True):
        yield {**key, **dict(zip(cells, point, strict=True))}
