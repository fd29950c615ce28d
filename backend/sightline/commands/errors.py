"""`sightline errors`: the error table of a heights.csv against its reference heights."""

from __future__ import annotations

import json
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, get_args

import click

from sightline.commands.distribution import Rows, length_in, sample_of
from sightline.commands.files import read_csv
from sightline.enums import Rounding

if TYPE_CHECKING:
    from sightline.statistics.errors import ErrorGroup
    from sightline.statistics.total_uncertainty import HeightSample

NEEDED = ("height_m", "reference_height_m", "status")
FEET = 1 / 0.3048


@click.command()
@click.argument("heights", type=click.Path(path_type=Path))
@click.option("--round", "rounding", type=click.Choice(get_args(Rounding)), default="cm", show_default=True)
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
def errors(heights: Path, rounding: Rounding, as_json: bool) -> None:
    """Compute the error table of HEIGHTS (heights.csv) against its reference heights, by lighting and
    overall.

    Intervals are total where these columns are there: shared_group and u_shared_m (error common to all rows
    of a group), site (a cluster). Without them they hold sampling, and the errors of each height with it.
    """
    from sightline.statistics.errors import error_table

    rows, left_out = read_heights(heights)
    table = error_table(rows.height_m, rows.reference_m, rows.lighting, rounding, _parts(rows))
    if as_json:
        groups = {name: group_json(group) for name, group in table.items()}
        click.echo(json.dumps({"rounding": rounding, "groups": groups}))
        return
    click.echo(as_text(table, rounding))
    if left_out:
        click.echo(f"{left_out} rows have no height or no reference height and are not in the table.")


@dataclass
class _Rows(Rows):
    """The rows with both heights, by column."""

    reference_m: list[float] = field(default_factory=list)
    lighting: list[str] = field(default_factory=list)


def read_heights(path: Path) -> tuple[_Rows, int]:
    """The rows that have both heights, and how many have not. Raises BadInput, naming the row."""
    table = read_csv(path, NEEDED)
    if {"shared_group", "u_shared_m"} & set(table.header):
        table.require("shared_group", "u_shared_m")
    found, left_out = _Rows(), 0
    for line, row in table.sound_rows():
        has_both = row["height_m"] and row["reference_height_m"]
        if row["status"] != "ok" or row.get("counts") == "false" or not has_both:
            left_out += 1
            continue
        found.height_m.append(length_in(table, line, row, "height_m"))
        found.u_random_m.append(0.0)
        found.reference_m.append(length_in(table, line, row, "reference_height_m"))
        found.lighting.append(row.get("lighting", ""))
        group = row.get("shared_group", "")
        found.shared_group.append(group)
        found.u_shared_m.append(length_in(table, line, row, "u_shared_m") if group else 0.0)
        if "site" in row:
            found.site.append(row["site"])
    return found, left_out


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
        lines.append(f"Intervals hold {words}. Those of Pearson and skewness hold sampling alone.")
    lines += [f"{heads[name]}: {group.reason}." for name, group in table.items() if group.reason]
    return "\n".join(lines)


def cell(group: ErrorGroup, name: str) -> str:
    value, interval = group.figures[name], group.ci95[name]
    if value is None:
        return "-"
    if name.endswith("_m"):
        shown = f"{value:.4f} m ({value * FEET:.3f} ft)"
        return shown + (f" [{interval.low:.4f}, {interval.high:.4f}]" if interval else "")
    unit = " m2" if name == "mse_m2" else ""
    digits = ".6f" if unit else ".2f"
    return f"{value:{digits}}{unit}" + (
        f" [{interval.low:{digits}}, {interval.high:{digits}}]" if interval else ""
    )
