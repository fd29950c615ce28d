"""`sightline study`: many packages as one study, each verified first, without a server."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sightline.commands.files import read_text
from sightline.commands.options import FILE, json_option, output_option, tell
from sightline.errors import BadInput

if TYPE_CHECKING:
    from sightline.infra.csv_package.files import Files
    from sightline.studies.records import Study, TargetFigures


@click.command()
@click.argument("packages", metavar="PACKAGE...", nargs=-1, required=True, type=FILE)
@output_option("Folder to write; an earlier study there is replaced.")
@click.option(
    "--weights",
    type=FILE,
    help=(
        "Fleet by class (CSV): category,share or category,registrations; several "
        "variables: variable,class,share."
    ),
)
@click.option(
    "--sites",
    type=FILE,
    help="Sites (CSV): site,stratum and, if known, sites_there (in the stratum), traffic.",
)
@click.option("--goal", "goal_m", default=0.010, show_default=True, help="Target U95 of the plan, metres.")
@click.option(
    "--quick", is_flag=True, help="Only check that the files match their seals; do not recompute heights."
)
@json_option
def study(
    packages: tuple[Path, ...],
    output: Path,
    weights: Path | None,
    sites: Path | None,
    goal_m: float,
    quick: bool,
    as_json: bool,
) -> None:
    """Combine surveys of several sites into a study, from packages (folders, ZIPs, or a folder of them).

    Writes tables with percentiles, mean and SD of each target with total 95 % intervals, the error table,
    class shares, and the numbers of sites and vehicles that a further study needs. Sites are the sampling
    units.
    """
    from sightline.export.seal import check_sealed
    from sightline.infra.csv_package.files import Staging, fresh_folder
    from sightline.studies.fleet_csv import read_fleet, read_sites
    from sightline.studies.packages import found_places, read_packages, refuse_output
    from sightline.studies.query import READ, StudyTables
    from sightline.studies.service import Plan, make_study
    from sightline.studies.write import write_study

    def whole(files: Files) -> str | None:
        from sightline.export.verify.package import verify_package  # draws, which takes long to load

        return verify_package(files).problem

    def sealed(files: Files) -> str | None:
        return check_sealed(files, READ)

    if not 0.0 < goal_m < 1.0:
        raise BadInput("studies-goal-no-length", goal=goal_m)
    fleet = None if weights is None else read_fleet(weights, read_text(weights, "a table of the fleet"))
    facts = None if sites is None else read_sites(sites, read_text(sites, "a table of sites"))
    places = found_places(packages)
    refuse_output(output, places)
    with tempfile.TemporaryDirectory(prefix="sightline-study-") as scratch, fresh_folder(output) as folder:
        found = read_packages(places, sealed if quick else whole, Path(scratch))
        with StudyTables(found) as tables:
            made = make_study(found, tables, Plan(fleet, facts, goal_m))
        notes = ["Heights were not computed again (--quick)."] if quick else []
        write_study(Staging(folder), made, notes)
    tell(as_json, _json(made, notes), _describe_study(made, output, notes))


def _json(joint_study: Study, notes: list[str]) -> dict[str, object]:
    from sightline.studies.csv import TABLES, study_rows

    rows = study_rows(joint_study)
    return {
        "heights": joint_study.heights,
        "vehicles": joint_study.vehicles,
        **{table.name: list(rows[table.path]) for table in TABLES},
        "notes": [*joint_study.notes, *notes],
    }


def _describe_study(joint_study: Study, output: Path, notes: list[str]) -> str:
    sites = len({one.site for one in joint_study.surveys})
    lines = [
        f"{len(joint_study.surveys)} packages verified: {joint_study.heights} accepted heights "
        f"of {joint_study.vehicles} vehicles at {sites} sites. Written to {output}."
    ]
    lines += [line for one in joint_study.targets for line in _target_lines(one)]
    return "\n".join([*lines, *map(str, joint_study.notes), *notes])


def _target_lines(figures: TargetFigures) -> list[str]:
    from sightline.export.report.units import HEIGHT

    if figures.reason is not None:
        return [f"{figures.target}: {figures.reason}."] if figures.n else []
    lines = [f"{figures.target}: {figures.n} heights at {figures.sites} sites"]
    for percentile in figures.percentiles:
        value, low, high = (
            HEIGHT["m"].length(one) for one in (percentile.value, percentile.U95_low, percentile.U95_high)
        )
        lines.append(f"  P{percentile.percent:<5g}{value}  {percentile.reason or f'{low} to {high}'}")
    return lines
