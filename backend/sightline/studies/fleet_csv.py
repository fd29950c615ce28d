"""The tables that a person gives a study: shares of the fleet (`--weights`), facts of sites (`--sites`)."""

import math
from collections.abc import Mapping
from pathlib import Path

from sightline.errors import BadInput
from sightline.infra.given_csv import GivenTable, read_table
from sightline.studies.records import Fleet, SiteFacts

#: What may divide a fleet.
KINDS = ("category", "lighting", "stratum", "site")
_CLOSE = 1e-3  # of a sum of shares, or of two sums of registrations
_MOST = 1e12  # of any number in these tables


def read_fleet(path: Path, text: str) -> Fleet:
    """Shares by class. Columns: `category` (or another kind), or `variable` and `class` for several kinds;
    then `share`, which sums to 1 for each kind, or `registrations`, which sums to the same for each.

    Raises BadInput in one sentence that names the row or the sum.
    """
    table, rows = _read_sound_rows(path, text)
    header = table.header
    kind = next((one for one in KINDS if one in header), None)
    several = {"variable", "class"} <= set(header)
    amounts = [one for one in ("share", "registrations") if one in header]
    if not amounts or (kind is None and not several):
        raise BadInput("studies-fleet-header", path=path)
    if len(amounts) == 2:
        raise BadInput("studies-fleet-two-amounts", path=path)
    amount = amounts[0]
    by_variable: dict[str, dict[str, float]] = {}
    for at, row in rows:
        variable = row["variable"] if several else str(kind)
        name = _require_cell(path, at, row, "class" if several else str(kind))
        if variable not in KINDS:
            raise BadInput("studies-fleet-variable", path=path, row=at, cell=variable, known=", ".join(KINDS))
        of = by_variable.setdefault(variable, {})
        if name in of:
            raise BadInput("studies-fleet-class-twice", path=path, row=at, name=name)
        of[name] = _amount(path, table, at, row[amount], amount)
    return Fleet(_shares(path, by_variable, amount))


def _shares(path: Path, by_variable: dict[str, dict[str, float]], amount: str) -> dict[str, dict[str, float]]:
    if not by_variable:
        raise BadInput("studies-fleet-empty", path=path)
    sums = {variable: math.fsum(of.values()) for variable, of in by_variable.items()}
    first = next(iter(sums))
    for variable, total in sums.items():
        if amount == "share" and abs(total - 1.0) > _CLOSE:
            raise BadInput("studies-shares-sum", path=path, variable=variable, total=f"{total:.4g}")
        if total <= 0.0:
            raise BadInput("studies-registrations-of-nobody", path=path, variable=variable)
        if abs(total - sums[first]) > _CLOSE * max(sums[first], 1e-300):
            raise BadInput(
                "studies-registrations-sum",
                path=path,
                first=first,
                first_sum=f"{sums[first]:.8g}",
                other=variable,
                other_sum=f"{total:.8g}",
            )
    return {
        variable: {name: value / sums[variable] for name, value in of.items()}
        for variable, of in by_variable.items()
    }


def read_sites(path: Path, text: str) -> dict[str, SiteFacts]:
    """What is known of each site: `site`, `stratum`; optional `sites_there` (of its stratum; empty: not
    known) and `traffic` (vehicles in any one unit of time, for all sites or none). Raises BadInput.
    """
    table, rows = _read_sound_rows(path, text)
    if not {"site", "stratum"} <= set(table.header):
        raise BadInput("studies-sites-header", path=path)
    sites: dict[str, SiteFacts] = {}
    there: dict[str, float] = {}
    for at, row in rows:
        site, stratum = (_require_cell(path, at, row, column) for column in ("site", "stratum"))
        told = row.get("sites_there", "")
        sites_there = _read_count(path, table, at, told, "sites_there") if told else math.inf
        if there.setdefault(stratum, sites_there) != sites_there:
            raise BadInput("studies-sites-there-differ", path=path, row=at, stratum=stratum)
        if site in sites:
            raise BadInput("studies-fleet-class-twice", path=path, row=at, name=site)
        traffic = row.get("traffic", "")
        sites[site] = SiteFacts(
            stratum, sites_there, _amount(path, table, at, traffic, "traffic") if traffic else None
        )
    if len({one.traffic is None for one in sites.values()}) > 1 or any(
        one.traffic == 0 for one in sites.values()
    ):
        raise BadInput("studies-traffic-of-some", path=path)
    return sites


def _read_sound_rows(path: Path, text: str) -> tuple[GivenTable, list[tuple[int, dict[str, str]]]]:
    table = read_table(text, path)
    return table, list(table.sound_rows())


def _require_cell(path: Path, at: int, row: Mapping[str, str], column: str) -> str:
    if not row[column]:
        raise BadInput("csv-empty-cell", name=path, line=at, column=column)
    return row[column]


def _read_count(path: Path, table: GivenTable, at: int, cell: str, name: str) -> float:
    value = _amount(path, table, at, cell, name)
    if value < 1.0 or value != math.floor(value):
        raise BadInput("studies-not-a-count", path=path, row=at, name=name, cell=cell)
    return value


def _amount(path: Path, table: GivenTable, at: int, cell: str, name: str) -> float:
    value = table.number(at, name, cell)
    if not 0.0 <= value <= _MOST:
        raise BadInput("studies-not-an-amount", path=path, row=at, name=name, cell=cell)
    return value
