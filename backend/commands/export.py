"""`sightline export`: the CSV package of a survey as a folder."""

from __future__ import annotations

from pathlib import Path

import click

from backend.commands.options import data_dir_option, require_database, settings_of


@click.command()
@click.option("--survey", required=True, help="Name (or number) of the survey.")
@click.option(
    "-o",
    "--output",
    required=True,
    type=click.Path(path_type=Path),
    help="Folder to write; an earlier export there is replaced.",
)
@data_dir_option
def export(survey: str, output: Path, data_dir: Path | None) -> None:
    """Write the CSV package of a survey: measurements, vehicles, poses, calibrations, reviews, audit."""
    from backend.storage import database
    from backend.work.exporting import find_survey, package_of, state_of
    from backend.work.packaging import write_directory

    settings = settings_of(data_dir=data_dir)
    require_database(settings)
    engine = database.make_engine(settings.database_url)
    try:
        database.migrate(engine)
        with database.reading(database.session_factory(engine)) as session:
            state = state_of(session, find_survey(session, survey).id)
    finally:
        engine.dispose()
    package = package_of(state)
    write_directory(package, output)
    click.echo(
        f"{len(state.current)} measurements of {len(state.vehicles)} vehicles written to {output} "
        f"({len(package.files)} files)."
    )
