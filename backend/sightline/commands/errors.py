"""`sightline errors`: the error table of a heights.csv against its reference heights."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, cast, get_args

import click

from sightline.commands.distribution import Rows, length_in, sample_of
from sightline.commands.files import read_csv
from sightline.commands.options import FILE, choice_option, json_option, print_json
from sightline.enums import Lighting, Rounding, Target
from sightline.errors import BadInput

if TYPE_CHECKING:
    from sightline.statistics.errors import ErrorGroup
    from sightline.statistics.total_uncertainty import HeightSample

NEEDED = ("height_m", "reference_height_m", "status")
FEET = 1 / 0.3048
_ALL = "all"
Key = tuple[Target, bool]
_CHECK = ", check targets"


@click.command()
@click.argument("heights", type=FILE)
@choice_option(
    "--round",
    "rounding",
    of=Rounding,
    default="cm",
    help="Rounding of both heights: whole centimetres, as Dupuis et al., or none.",
)
@click.option("--by", metavar="COLUMN", help="Each value of this column alone; check targets apart.")
@json_option
def errors(heights: Path, rounding: Rounding, by: str | None, as_json: bool) -> None:
    """Compute the error table of HEIGHTS (heights.csv) against its reference heights, by lighting and
    overall.

    With several targets (column target) every table covers roofs, also with --by; --by target covers each.
    Intervals are total if these columns are present: shared_group and u_shared_m (error common to all rows of
    a group), site (a cluster). Without them they include sampling and the errors of each height.
    """
    groups = read_heights(heights, by)
    whole = None if by == "target" else _target_of(groups.values())
    if as_json:
        told = {name: _json(group, whole, rounding) for name, group in groups.items()}
        print_json(told[_ALL] if by is None else {"groups": told})
        return
    for name, group in groups.items():
        if by is not None:
            click.echo(f"{by} {name}".strip())
        _tell(group, whole, rounding)


@dataclass
class _Rows(Rows):
    """The rows with both heights, by column."""

    reference_m: list[float] = field(default_factory=list)
    lighting: list[str] = field(default_factory=list)


@dataclass
class _Group:
    """Rows that have both heights and count, by target and whether they are beside the traffic; how many
    others there are. `check`: all are beside the traffic.
    """

    check: bool
    rows: dict[Key, _Rows] = field(default_factory=dict)
    left_out: int = 0


def _target_of(groups: Iterable[_Group]) -> Target | None:
    """The target that all tables of a file cover: roofs, or the only one of the traffic; None where no row
    counts. Raises BadInput.
    """
    keys = dict.fromkeys(key for group in groups for key in group.rows)
    traffic = [target for target, check in keys if not check]
    if "roof" in traffic:
        return "roof"
    if keys and len(traffic) != 1:
        targets = ", ".join(dict.fromkeys(target for target, _ in keys))
        raise BadInput("commands-errors-several-targets", targets=targets)
    return traffic[0] if traffic else None


def _table(
    group: _Group, whole: Target | None, rounding: Rounding
) -> tuple[Target | None, dict[str, ErrorGroup], dict[str, int]]:
    """The target that a group's table covers (the whole file's, else its own), the table, and how many rows
    of which others it leaves out.
    """
    from sightline.statistics.errors import error_table

    target = whole or next((one for one, _ in group.rows), None)
    others = dict(group.rows)
    rows = _Rows() if target is None else others.pop((target, group.check), _Rows())
    table = error_table(rows.height_m, rows.reference_m, rows.lighting, rounding, _parts(rows))
    left = {one + _CHECK * check: len(rows.height_m) for (one, check), rows in sorted(others.items())}
    return target, table, left


def _json(group: _Group, whole: Target | None, rounding: Rounding) -> dict[str, object]:
    target, table, others = _table(group, whole, rounding)
    told: dict[str, object] = {"target": target, "rounding": rounding}
    told["groups"] = {name: group_json(one) for name, one in table.items()}
    return told | {"left_out": group.left_out, "other_targets": others}


def _tell(group: _Group, whole: Target | None, rounding: Rounding) -> None:
    target, table, others = _table(group, whole, rounding)
    if target is not None:
        click.echo(f"Target: {target}.")
    click.echo(as_text(table, rounding))
    if group.left_out:
        click.echo(
            f"{group.left_out} rows have no height or no reference height, or do not count: not in the table."
        )
    if others:
        said = "; ".join(f"{n} of {name}" for name, n in others.items())
        click.echo(f"Rows not in the table: {said}. --by target covers each.")


def read_heights(path: Path, by: str | None) -> dict[str, _Group]:
    """The rows by the value of a column, those of check targets under a name of their own; all as one group
    without. Raises BadInput, naming the row.
    """
    table = read_csv(path, (*NEEDED, *([] if by is None else [by])))
    if {"shared_group", "u_shared_m"} & set(table.header):
        table.require("shared_group", "u_shared_m")
    groups = {_ALL: _Group(check=False)} if by is None else {}
    for line, row in table.sound_rows():
        check = row.get("check_target") == "true"
        name = _ALL if by is None else row[by] + _CHECK * check
        group = groups.setdefault(name, _Group(check))
        has_both = row["height_m"] and row["reference_height_m"]
        counts = row.get("error_counts", "true" if check else row.get("counts"))
        if row["status"] != "ok" or counts == "false" or not has_both:
            group.left_out += 1
            continue
        target = row.get("target") or "roof"
        lighting = row.get("lighting", "")
        _require_word(line, "target", target, get_args(Target))
        _require_word(line, "lighting", lighting, ("", *get_args(Lighting)))
        rows = group.rows.setdefault((cast(Target, target), check), _Rows())
        rows.height_m.append(length_in(table, line, row, "height_m"))
        rows.u_random_m.append(0.0)
        rows.reference_m.append(length_in(table, line, row, "reference_height_m"))
        rows.lighting.append(lighting)
        shared = row.get("shared_group", "")
        rows.shared_group.append(shared)
        rows.u_shared_m.append(length_in(table, line, row, "u_shared_m") if shared else 0.0)
        if "site" in row:
            rows.site.append(row["site"])
    return groups


def _require_word(line: int, column: str, word: str, known: tuple[str, ...]) -> None:
    if word not in known:
        said = ", ".join(filter(None, known))
        raise BadInput("commands-errors-unknown-word", line=line, column=column, word=word, known=said)


def _parts(rows: _Rows) -> HeightSample:
    """The heights with what they share and their sites; errors have no random part taken out of them."""
    sample = sample_of(rows)
    return sample if any(rows.u_shared_m) else replace(sample, shared=())


def group_json(group: ErrorGroup) -> dict[str, object]:
    ci95 = {name: [i.low, i.high] if i else None for name, i in group.ci95.items()}
    out: dict[str, object] = {"n": group.n, **group.figures, "ci95": ci95, "holds": group.holds}
    return out | ({"reason": group.reason} if group.reason else {})


def as_text(table: dict[str, ErrorGroup], rounding: str) -> str:
    from sightline.statistics.errors import SHARES_WITHIN_M

    heads = {"daytime": "Daytime", "low_light": "Low light", "overall": "Overall"}
    lines = [f"{'':32}" + "".join(f"{heads[name]:>42}" for name in table)]
    lines.append(f"{'n':32}" + "".join(f"{group.n:>42}" for group in table.values()))
    labels = {
        "bias_m": "bias",
        "mae_m": "MAE",
        "rmse_m": "RMSE",
        "mse_m2": "MSE",
        "sd_m": "SD",
        "pearson_error_vs_height": "Pearson, error and height",
        "pearson_abs_error_vs_height": "Pearson, |error| and height",
        "skewness": "skewness of the error",
        **{name: f"share within {1000 * limit:g} mm" for name, limit in SHARES_WITHIN_M.items()},
    }
    for name, label in labels.items():
        lines.append(f"{label:32}" + "".join(f"{cell(group, name):>42}" for group in table.values()))
    said = "rounded to whole centimetres, as in the paper" if rounding == "cm" else "not rounded"
    lines.append(f"Errors are measured minus reference, {said}; in brackets 95 % intervals.")
    if words := next((group.words for group in reversed(table.values()) if group.words), None):
        lines.append(f"Intervals include {words}. Those of Pearson and skewness include sampling only.")
    lines += [f"{heads[name]}: {group.reason}." for name, group in table.items() if group.reason]
    return "\n".join(lines)


def cell(group: ErrorGroup, name: str) -> str:
    value, interval = group.figures[name], group.ci95[name]
    if value is None:
        return "-"
    if name.endswith("_m"):
        shown = f"{value:z.4f} m ({value * FEET:z.3f} ft)"
        return shown + (f" [{interval.low:z.4f}, {interval.high:z.4f}]" if interval else "")
    unit = " m2" if name == "mse_m2" else ""
    digits = "z.6f" if unit else "z.2f"
    return f"{value:{digits}}{unit}" + (
        f" [{interval.low:{digits}}, {interval.high:{digits}}]" if interval else ""
    )
