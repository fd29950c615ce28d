"""`sightline errors`: the error table of a heights.csv against its reference heights."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, cast, get_args

import click
import numpy as np

from sightline.commands.distribution import Rows, length_in, sample_of
from sightline.commands.files import read_csv
from sightline.commands.options import FILE, choice_option, json_option, print_json
from sightline.enums import Rounding, Target
from sightline.errors import BadInput

if TYPE_CHECKING:
    from sightline.statistics.errors import ErrorGroup
    from sightline.statistics.total_uncertainty import HeightSample

NEEDED = ("height_m", "reference_height_m", "status")
FEET = 1 / 0.3048
Key = tuple[Target, bool]
_ROOFS: Key = ("roof", False)


@click.command()
@click.argument("heights", type=FILE)
@choice_option(
    "--round",
    "rounding",
    of=Rounding,
    default="cm",
    help="Rounding of both heights: whole centimetres, as Dupuis et al., or none.",
)
@click.option(
    "--by",
    type=click.Choice(["target"]),
    help="Each target alone, by lighting and class, not rounded; check targets have their own rows.",
)
@json_option
def errors(heights: Path, rounding: Rounding, by: str | None, as_json: bool) -> None:
    """Compute the error table of HEIGHTS (heights.csv) against its reference heights, by lighting and
    overall.

    With several targets (column target) the table covers roofs; --by target covers each target. Intervals
    are total if these columns are present: shared_group and u_shared_m (error common to all rows of a group),
    site (a cluster). Without them they include sampling and the errors of each height.
    """
    from sightline.statistics.errors import error_table

    found, left_out = read_heights(heights)
    if by is not None:
        _by_target(found, left_out, as_json)
        return
    traffic = [key for key in found if not key[1]]
    key = _ROOFS if _ROOFS in found else next(iter(traffic)) if len(traffic) == 1 else None
    if key is None and found:
        raise BadInput("commands-errors-several-targets", targets=", ".join(target for target, _ in found))
    rows = found[key] if key is not None else _Rows()
    table = error_table(rows.height_m, rows.reference_m, rows.lighting, rounding, _parts(rows))
    if as_json:
        groups = {name: group_json(group) for name, group in table.items()}
        print_json({"rounding": rounding, "groups": groups, "left_out": left_out})
        return
    click.echo(as_text(table, rounding))
    _tell_left_out(left_out)
    others = sorted({target for target, _ in found if target != (key or ("",))[0]})
    if others:
        click.echo(f"Not in the table: {', '.join(others)}; --by target covers each.")


def _tell_left_out(left_out: int) -> None:
    if left_out:
        click.echo(
            f"{left_out} rows have no height or no reference height, or do not count: not in the table."
        )


def _by_target(found: dict[Key, _Rows], left_out: int, as_json: bool) -> None:
    from sightline.statistics.known_errors import COMPARED, Compared, known_errors, shown_groups

    told = []
    for target, check in sorted(found, key=lambda key: (key[1], COMPARED.index(key[0]))):
        rows = found[target, check]
        unknown = np.full(len(rows.height_m), np.nan)
        compared = Compared(
            measured=_parts(rows),
            u_measured_m=unknown,
            known_m=np.array(rows.reference_m),
            u_known_m=unknown,
            lighting=rows.lighting,
            category=rows.category,
        )
        told.append(known_errors(target, check, compared))
    if as_json:
        listed = [
            {
                "target": one.target,
                "check_target": one.check_target,
                "groups": [
                    {"grouping": part.grouping, "group": part.group, **group_json(part.errors)}
                    for part in one.groups
                ],
            }
            for one in told
        ]
        print_json({"rounding": "none", "targets": listed, "left_out": left_out})
        return
    heads = {"bias_m": "bias", "mae_m": "MAE", "rmse_m": "RMSE", "sd_m": "SD"}
    lines = [f"{'':34}{'n':>6}" + "".join(f"{head:>42}" for head in heads.values())]
    for one in told:
        for part in shown_groups(one.groups):
            name = one.target + (", check targets" if one.check_target else "")
            name = name if part.grouping == "all" else f"  {part.group}"
            cells = "".join(f"{cell(part.errors, figure):>42}" for figure in heads)
            lines.append(f"{name.replace('_', ' '):34}{part.errors.n:>6}{cells}")
    lines.append("Errors are measured minus known, not rounded; in brackets 95 % intervals.")
    if words := next((one.overall.words for one in told if one.overall.words), None):
        lines.append(f"Intervals include {words}.")
    click.echo("\n".join(lines))
    _tell_left_out(left_out)


@dataclass
class _Rows(Rows):
    """The rows with both heights, by column."""

    reference_m: list[float] = field(default_factory=list)
    lighting: list[str] = field(default_factory=list)
    category: list[str] = field(default_factory=list)


def read_heights(path: Path) -> tuple[dict[Key, _Rows], int]:
    """The rows that have both heights and count, by target (a roof where none is named) and whether of check
    targets, and how many others there are. Raises BadInput, naming the row.
    """
    table = read_csv(path, NEEDED)
    if {"shared_group", "u_shared_m"} & set(table.header):
        table.require("shared_group", "u_shared_m")
    found_of: dict[Key, _Rows] = {}
    left_out = 0
    for line, row in table.sound_rows():
        has_both = row["height_m"] and row["reference_height_m"]
        check = row.get("check_target") == "true"
        counts = row.get("error_counts", "true" if check else row.get("counts"))
        if row["status"] != "ok" or counts == "false" or not has_both:
            left_out += 1
            continue
        target = row.get("target") or "roof"
        if target not in get_args(Target):
            known = ", ".join(get_args(Target))
            raise BadInput("commands-errors-unknown-target", line=line, target=target, known=known)
        found = found_of.setdefault((cast(Target, target), check), _Rows())
        found.height_m.append(length_in(table, line, row, "height_m"))
        found.u_random_m.append(0.0)
        found.reference_m.append(length_in(table, line, row, "reference_height_m"))
        found.lighting.append(row.get("lighting", ""))
        found.category.append(row.get("category", ""))
        group = row.get("shared_group", "")
        found.shared_group.append(group)
        found.u_shared_m.append(length_in(table, line, row, "u_shared_m") if group else 0.0)
        if "site" in row:
            found.site.append(row["site"])
    return found_of, left_out


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
        shown = f"{value:.4f} m ({value * FEET:.3f} ft)"
        return shown + (f" [{interval.low:.4f}, {interval.high:.4f}]" if interval else "")
    unit = " m2" if name == "mse_m2" else ""
    digits = ".6f" if unit else ".2f"
    return f"{value:{digits}}{unit}" + (
        f" [{interval.low:{digits}}, {interval.high:{digits}}]" if interval else ""
    )
