"""`sightline errors`: the error table of a heights.csv against its reference heights."""

from __future__ import annotations

import csv
import io
import json
import math
from pathlib import Path
from typing import TYPE_CHECKING, get_args

import click

from sightline.enums import Rounding
from sightline.errors import BadInput

if TYPE_CHECKING:
    from sightline.statistics.errors import ErrorGroup

NEEDED = ("height_m", "reference_height_m", "status")
FEET = 1 / 0.3048


@click.command()
@click.argument("heights", type=click.Path(path_type=Path))
@click.option("--round", "rounding", type=click.Choice(get_args(Rounding)), default="cm", show_default=True)
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
def errors(heights: Path, rounding: Rounding, as_json: bool) -> None:
    """Error table of HEIGHTS (a heights.csv) against its reference heights, by lighting and overall."""
    from sightline.statistics.errors import error_table

    measured, reference, lighting, left_out = read_heights(heights)
    table = error_table(measured, reference, lighting, rounding)
    if as_json:
        groups = {name: group_json(group) for name, group in table.items()}
        click.echo(json.dumps({"rounding": rounding, "groups": groups}))
        return
    click.echo(as_text(table, rounding))
    if left_out:
        click.echo(f"{left_out} rows have no height or no reference height and are not in the table.")


def read_heights(path: Path) -> tuple[list[float], list[float], list[str], int]:
    """(heights, references, lighting, rows left out) of the rows that have both heights."""
    try:
        text = path.read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise BadInput("commands-cannot-read-csv-text-give-heights", path=path) from error
    rows = csv.DictReader(io.StringIO(text, newline=""))
    missing = [name for name in NEEDED if name not in (rows.fieldnames or ())]
    if missing:
        raise BadInput("commands-no-column-give-heights-csv-made", path=path, missing=missing[0])
    measured, reference, lighting, left_out = [], [], [], 0
    for row in rows:
        pair = (number(row["height_m"]), number(row["reference_height_m"]))
        if row["status"] != "ok" or pair[0] is None or pair[1] is None:
            left_out += 1
            continue
        measured.append(pair[0])
        reference.append(pair[1])
        lighting.append((row.get("lighting") or "").strip())
    return measured, reference, lighting, left_out


def number(cell: str | None) -> float | None:
    try:
        value = float(cell or "")
    except ValueError:
        return None
    return value if math.isfinite(value) else None


def group_json(group: ErrorGroup) -> dict[str, object]:
    ci95 = {name: [i.low, i.high] if i else None for name, i in group.ci95.items()}
    out: dict[str, object] = {"n": group.n, **group.figures, "ci95": ci95}
    return out | ({"reason": group.reason} if group.reason else {})


def as_text(table: dict[str, ErrorGroup], rounding: str) -> str:
    from sightline.statistics.errors import SHARES_WITHIN_M

    heads = {"daytime": "Daytime", "low_light": "Low light", "overall": "Overall"}
    lines = [f"{'':32}" + "".join(f"{heads[name]:>36}" for name in table)]
    lines.append(f"{'n':32}" + "".join(f"{group.n:>36}" for group in table.values()))
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
        lines.append(f"{label:32}" + "".join(f"{cell(group, name):>36}" for group in table.values()))
    said = "rounded to whole centimetres, as in the paper" if rounding == "cm" else "not rounded"
    lines.append(f"Errors are measured minus reference, {said}; in brackets 95 % intervals (BCa bootstrap).")
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
