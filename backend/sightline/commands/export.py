"""`sightline export`: the package of a survey as a folder."""

from pathlib import Path
from typing import Any

import click

from sightline.commands.options import (
    choice_option,
    data_dir_option,
    opened_services,
    output_option,
    progress_told,
    survey_option,
)
from sightline.enums import Category, ClassSet, Lighting
from sightline.errors import BadInput
from sightline.messages import SOURCE

_DAY = click.DateTime(["%Y-%m-%d"])


@click.command()
@survey_option
@output_option("Folder to write; an earlier package there is replaced.")
@click.option("--crops/--no-crops", default=True, help="Include crops of the clicked frames (default).")
@choice_option("--lighting", of=Lighting, help="Limit statistics and report to this lighting.")
@choice_option(
    "--set",
    "class_sets",
    multiple=True,
    of=ClassSet,
    help="Limit statistics and report to this set of classes. May be repeated.",
)
@choice_option(
    "--category",
    "categories",
    multiple=True,
    of=Category,
    help="Limit statistics and report to this class. May be repeated.",
)
@click.option(
    "--filmed-from",
    type=_DAY,
    help="Limit statistics and report to recordings from this day on (local time).",
)
@click.option(
    "--filmed-to",
    type=_DAY,
    help="Limit statistics and report to recordings up to and including this day (local time).",
)
@click.option(
    "--hour-from",
    type=click.IntRange(0, 23),
    help="Limit statistics and report to vehicles filmed from this hour of the day on (local time).",
)
@click.option(
    "--hour-to",
    type=click.IntRange(1, 24),
    help="Limit them to vehicles filmed before this hour of the day; below --hour-from: on the next day.",
)
@click.option("--language", default=SOURCE, help="Language of figures and report: en (default) or fr.")
@data_dir_option
def export(
    survey: str, output: Path, crops: bool, language: str, data_dir: Path | None, **chosen: Any
) -> None:
    """Write the package of a survey: tables, poses, crops, audit chain, statistics, figures and report.

    Progress goes to standard error.
    """
    from sightline.export.build import build
    from sightline.export.export_job import check_language, find_survey
    from sightline.infra.csv_package.files import Staging, fresh_folder
    from sightline.results.selection import selection_of

    check_language(language)
    days = {name: chosen[name] and chosen[name].date() for name in ("filmed_from", "filmed_to")}
    selection = selection_of(chosen | days)
    selection.require_sense()
    with (
        opened_services(data_dir) as services,
        services.reading() as session,
        fresh_folder(output) as folder,
    ):
        if services.read_only:
            raise BadInput("export-read-only", folder=services.settings.data_dir)
        staging = Staging(folder)
        survey_id = find_survey(session, survey).id
        built = build(
            staging,
            session,
            survey_id,
            services,
            progress_told(),
            crops=crops,
            selection=selection,
            language=language,
        )
    click.echo(
        f"{built.measurements} measurements of {built.vehicles} vehicles written to {output} "
        f"({len(staging.written)} files). Audit head of the package {built.head.hash}; keep it in another "
        "place, for `sightline verify --head`."
    )
