"""`sightline distribution`: percentiles, mean and spread of a heights.csv with their total uncertainty."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from sightline.commands.files import read_csv
from sightline.commands.options import FILE, json_option, print_json
from sightline.errors import BadInput
from sightline.infra.given_csv import GivenTable, given_number

if TYPE_CHECKING:
    from sightline.statistics.comparison import Compared
    from sightline.statistics.figures import TotalFigure
    from sightline.statistics.total_uncertainty import HeightSample, TotalUncertainty

_USUAL = "2.5,5,10,15,50,85,90,95,97.5"
_ALL = "all"


@dataclass
class Rows:
    """Heights by column, with what their errors are of."""

    height_m: list[float] = field(default_factory=list)
    u_random_m: list[float] = field(default_factory=list)
    shared_group: list[str] = field(default_factory=list)
    u_shared_m: list[float] = field(default_factory=list)
    site: list[str] = field(default_factory=list)
    targets: set[str] = field(default_factory=set)


@click.command()
@click.argument("heights", type=FILE)
@click.option("--by", "by", metavar="COLUMN", help="Compute each value of this column separately.")
@click.option(
    "--percentile",
    "percents",
    metavar="P,P,...",
    default=_USUAL,
    show_default=True,
    help="Percentiles to compute.",
)
@click.option(
    "--compare",
    metavar="FIRST,SECOND",
    help=("Two values of --by (two surveys, two years): difference of the second minus the first."),
)
@json_option
def distribution(heights: Path, by: str | None, percents: str, compare: str | None, as_json: bool) -> None:
    """Compute percentiles, mean and SD of the heights in HEIGHTS (heights.csv), with total uncertainty.

    Besides height_m, u_height_m and status, these columns are used: u_random_m (error of this row only;
    usually u_height_m), shared_group and u_shared_m (error common to all rows of a group), site (a cluster),
    counts (rows with "false" are excluded; a package sets it to what its statistics evaluate).
    """
    from sightline.statistics.total_uncertainty import TotalUncertainty

    wanted = percents_of(percents)
    groups, left_out = read_groups(heights, by)
    pair = None if compare is None else _pair(compare, by, groups)
    totals = {name: TotalUncertainty(sample_of(rows)) for name, rows in groups.items()}
    notes = [
        f"{name} mixes heights of {', '.join(sorted(rows.targets))}; --by target computes each separately."
        for name, rows in groups.items()
        if len(rows.targets) > 1
    ]
    if as_json:
        told: dict[str, Any] = {"groups": {name: _json(one, wanted) for name, one in totals.items()}}
        told |= {"left_out": left_out} | ({"notes": notes} if notes else {})
        if pair is not None:
            told["comparison"] = _compared_json(pair, totals, wanted)
        print_json(told)
        return
    click.echo("\n\n".join(_describe_distribution(name, one, wanted) for name, one in totals.items()))
    if pair is not None:
        click.echo("\n" + _compared_text(pair, totals, wanted))
    for note in notes:
        click.echo(f"\n{note}")
    if left_out:
        click.echo(f"\n{left_out} rows are excluded: no height, or counts is false.")


def percents_of(text: str) -> list[tuple[str, float]]:
    """Percentiles as they were written, and as numbers, each once. Raises BadInput."""
    percents = {}
    for part in text.split(","):
        percent = given_number(part)
        if percent is None or not 0.0 < percent < 100.0:
            raise BadInput("commands-not-percentile", part=part.strip())
        percents[format(percent, "g")] = percent
    return list(percents.items())


def read_groups(path: Path, by: str | None) -> tuple[dict[str, Rows], int]:
    """The rows with a height that counts by the value of a column, in order of appearance, and how many
    others there are. Raises BadInput naming the row.
    """
    table = read_csv(path, ())
    _refuse_header(table, by)
    groups: dict[str, Rows] = {}
    left_out = 0
    for line, row in table.sound_rows():
        if row.get("status", "ok") != "ok" or row.get("counts") == "false":
            left_out += 1
            continue
        _add(groups.setdefault(_ALL if by is None else row[by], Rows()), table, line, row)
    if not groups:
        raise BadInput("commands-no-heights", path=path)
    return groups, left_out


def _refuse_header(table: GivenTable, by: str | None) -> None:
    if "verdict" in table.header and "counts" not in table.header:
        raise BadInput("commands-heights-without-counts", name=table.name)
    own_u = "u_height_m" if "u_random_m" not in table.header else "height_m"
    needed = ["height_m", own_u, *([] if by is None else [by])]
    if "u_shared_m" in table.header or "shared_group" in table.header:
        needed += ["shared_group", "u_shared_m"]
    table.require(*dict.fromkeys(needed))


def _add(rows: Rows, table: GivenTable, line: int, row: Mapping[str, str]) -> None:
    height_m = length_in(table, line, row, "height_m")
    random_m = length_in(table, line, row, "u_random_m" if row.get("u_random_m") else "u_height_m")
    group = row.get("shared_group", "")
    shared_m = length_in(table, line, row, "u_shared_m") if row.get("u_shared_m") or group else 0.0
    if not group:  # an error that is shared with nobody is random
        random_m, shared_m = math.hypot(random_m, shared_m), 0.0
    rows.height_m.append(height_m)
    rows.u_random_m.append(random_m)
    rows.shared_group.append(group)
    rows.u_shared_m.append(shared_m)
    if "site" in row:
        rows.site.append(row["site"])
    if row.get("target"):
        rows.targets.add(row["target"])


def length_in(table: GivenTable, line: int, row: Mapping[str, str], name: str) -> float:
    """A cell in metres: a known or measured height, or an uncertainty. Raises BadInput naming the line."""
    cell = row.get(name, "")
    if name.startswith("u_"):
        return table.u_length_m(line, name, cell)
    if name.startswith("reference_"):
        return table.size_m(line, name, cell)
    return table.length_m(line, name, cell)


def sample_of(rows: Rows, named: dict[str, int] | None = None) -> HeightSample:
    """The columns as the statistics take them; rows without a word of their site are of one site. `named`:
    the groups of several files by number, to which those of these rows are added: one name is one error.
    """
    import numpy as np

    from sightline.statistics.shared_errors import SharedErrors
    from sightline.statistics.total_uncertainty import HeightSample

    code = codes(rows.shared_group, named)
    group = np.where([bool(one) for one in rows.shared_group], code, -1)
    names = None if named is None else np.arange(len(named))
    shared = SharedErrors(group, np.array(rows.u_shared_m), names)
    return HeightSample(
        height_m=np.array(rows.height_m),
        u_random_m=np.array(rows.u_random_m),
        shared=(shared,) if np.any(group >= 0) else (),
        site=np.array(codes(rows.site)) if rows.site else None,
    )


def codes(words: Iterable[str], known: dict[str, int] | None = None) -> list[int]:
    """A number for each different word, in order of appearance; `known` ones keep theirs."""
    known = {} if known is None else known
    return [known.setdefault(word, len(known)) for word in words]


def _json(total: TotalUncertainty, percents: Sequence[tuple[str, float]]) -> dict[str, Any]:
    percentiles = {}
    for name, percent in percents:
        one = total.percentile(percent)
        percentiles[name] = {**_figure(one), "raw": one.raw}
    return {
        "n": total.n,
        "mean_m": _figure(total.mean()),
        "sd_m": _figure(total.sd()),
        "percentiles": percentiles,
        "holds": list(total.holds),
    }


def _figure(figure: TotalFigure) -> dict[str, Any]:
    ends: dict[str, Any] = {
        "value": figure.value,
        "U95_low": figure.U95_low,
        "U95_high": figure.U95_high,
    }
    return ends if figure.reason is None else {**ends, "reason": figure.reason}


def _pair(text: str, by: str | None, groups: Mapping[str, Rows]) -> tuple[str, str]:
    """The two groups to compare. Raises BadInput."""
    names = [part.strip() for part in text.split(",")]
    if by is None or len(names) != 2 or names[0] == names[1]:
        raise BadInput("commands-compare-two-values", text=text)
    for name in names:
        if name not in groups:
            raise BadInput(
                "commands-compare-value-unknown", name=name, by=by, known=", ".join(sorted(groups))
            )
    return names[0], names[1]


def _compared(
    pair: tuple[str, str], totals: Mapping[str, TotalUncertainty], percents: Sequence[tuple[str, float]]
) -> Iterator[tuple[str, Compared]]:
    """Each figure's name with what was found."""
    from sightline.statistics.comparison import compare

    told = compare(totals[pair[0]], totals[pair[1]], [percent for _, percent in percents])
    for (name, _), one in zip(percents, told.percentiles, strict=True):
        yield name, one
    yield "mean", told.mean


def _compared_json(
    pair: tuple[str, str], found: Mapping[str, TotalUncertainty], percents: Sequence[tuple[str, float]]
) -> dict[str, Any]:
    differences = {
        name: {**_figure(one.difference), "verdict": one.verdict}
        for name, one in _compared(pair, found, percents)
    }
    mean = differences.pop("mean")
    return {"first": pair[0], "second": pair[1], "percentiles": differences, "mean_m": mean}


def _compared_text(
    pair: tuple[str, str], found: Mapping[str, TotalUncertainty], percents: Sequence[tuple[str, float]]
) -> str:
    lines = [f"{pair[1]} less {pair[0]}:"]
    for name, comparison in _compared(pair, found, percents):
        label = name if name == "mean" else f"P{name}"
        value = "-" if comparison.verdict is None else f"{comparison.difference.value:+z.4f}"
        said = str(comparison.verdict or comparison.difference.reason or "").replace("_", " ")
        lines.append(f"{label:>8} {value:>9} {_ends(comparison.difference, '{:z.4f}'.format):>20}  {said}")
    lines.append("Higher or lower: the 95 % interval of the difference excludes 0 (risk at most 2.5 %).")
    return "\n".join(
        [*lines, "Errors that both share (a pose, a site, an inset) make the intervals too wide."]
    )


def _describe_distribution(name: str, found: TotalUncertainty, percents: Sequence[tuple[str, float]]) -> str:
    lines = [f"{name}: {found.n} heights", f"{'':>8} {'value m':>9} {'95 % interval m':>20} {'raw m':>9}"]
    lines += _lines(found, percents)
    return "\n".join([*lines, f"Intervals include {found.holds_in_words}."])


def _lines(found: TotalUncertainty, percents: Sequence[tuple[str, float]]) -> Iterator[str]:
    for name, percent in percents:
        one = found.percentile(percent)
        yield f"{'P' + name:>8} {_height(one.value):>9} {_ends(one):>20} {_height(one.raw):>9}{_reason(one)}"
    for label, figure in (("mean", found.mean()), ("SD", found.sd())):
        yield f"{label:>8} {_height(figure.value):>9} {_ends(figure):>20} {'':>9}{_reason(figure)}".rstrip()


def _ends(figure: TotalFigure, printed: Callable[[float], str] | None = None) -> str:
    if figure.U95_low is None or figure.U95_high is None:
        return "-"
    printed = _height if printed is None else printed
    return f"{printed(figure.U95_low)} to {printed(figure.U95_high)}"


def _height(value_m: float | None) -> str:
    """As every page and report prints a height."""
    from sightline.export.report.units import HEIGHT

    return HEIGHT["m"].number(value_m)


def _reason(one: TotalFigure) -> str:
    return "" if one.reason is None else f"  {one.reason}"
