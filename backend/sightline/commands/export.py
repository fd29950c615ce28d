"""`sightline export`: the package of a survey as a folder."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path
from typing import Any, get_args

import click

from sightline.commands.options import data_dir_option, progress_told, require_database, settings_of
from sightline.enums import Category, ClassSet, Lighting

_DAY = click.DateTime(["%Y-%m-%d"])


@click.command()
@click.option("--survey", required=True, help="Name (or number) of the survey.")
@click.option(
    "-o",
    "--output",
    required=True,
    type=click.Path(path_type=Path),
    help="Folder to write; an earlier export there is replaced.",
)
@click.option("--crops/--no-crops", default=True, help="Cut out the pictures that were clicked on (default).")
@click.option("--lighting", type=click.Choice(get_args(Lighting)), help="Statistics and report only of this.")
@click.option(
    "--set",
    "class_sets",
    multiple=True,
    type=click.Choice(get_args(ClassSet)),
    help="Statistics and report only of this set of classes; several add up.",
)
@click.option(
    "--category",
    "categories",
    multiple=True,
    type=click.Choice(get_args(Category)),
    help="Statistics and report only of this class; several add up.",
)
@click.option("--filmed-from", type=_DAY, help="Statistics and report only of what was filmed from this day.")
@click.option("--filmed-to", type=_DAY, help="... up to this day, included, by the clocks of the place.")
@data_dir_option
def export(
    survey: str,
    output: Path,
    crops: bool,
    lighting: str | None,
    class_sets: tuple[str, ...],
    categories: tuple[str, ...],
    filmed_from: datetime | None,
    filmed_to: datetime | None,
    data_dir: Path | None,
) -> None:
    """Write the package of a survey: tables, poses, crops, audit chain, statistics, figures and report.

    Progress goes to standard error.
    """
    from sightline.export.build import build
    from sightline.export.export_job import find_survey
    from sightline.infra.csv_package.files import Staging, fresh_folder
    from sightline.infra.database.engine import migrate
    from sightline.infra.services import open_services
    from sightline.results.selection import selection_of

    chosen: dict[str, Any] = {"lighting": lighting, "class_sets": class_sets, "categories": categories}
    chosen |= {"filmed_from": filmed_from and filmed_from.date(), "filmed_to": filmed_to and filmed_to.date()}
    settings = settings_of(data_dir=data_dir)
    require_database(settings)
    services = open_services(settings)
    try:
        migrate(services.engine)
        with services.reading() as session, fresh_folder(output) as folder:
            staging = Staging(folder)
            survey_id = find_survey(session, survey).id
            built = build(
                staging,
                session,
                survey_id,
                services,
                progress_told(),
                crops=crops,
                selection=selection_of(chosen),
            )
    finally:
        services.close()
    click.echo(
        f"{built.measurements} measurements of {built.vehicles} vehicles written to {output} "
        f"({len(staging.written)} files). Audit head {built.head.hash}; keep it elsewhere, for "
        "`sightline verify --head`."
    )
