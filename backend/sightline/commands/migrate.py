"""`sightline migrate`: bring the database up to date before the processes that use it start."""

from pathlib import Path

import click

from sightline.commands.options import data_dir_option, settings_of


@click.command("migrate")
@data_dir_option
def migrate(data_dir: Path | None) -> None:
    """Migrate the database to this version. `serve` also does this, if its account has the rights.

    On PostgreSQL, run this with the account that owns the tables. SIGHTLINE_SERVING_ROLE, which owns no
    table and cannot switch off triggers, then gets the rights that the server needs; with
    SIGHTLINE_SERVING_PASSWORD the role is created.
    """
    from sightline.infra.database.engine import make_engine, translate_database_errors
    from sightline.infra.database.engine import migrate as bring_up_to_date
    from sightline.infra.database.pages import require_whole_pages

    settings = settings_of(data_dir=data_dir)
    engine = make_engine(settings.database_url)
    with translate_database_errors(), engine.connect() as connection:
        require_whole_pages(connection, quick=True)
    bring_up_to_date(engine)
    if settings.serving_role and engine.dialect.name == "postgresql":
        from sightline.infra.database.serving_role import give_rights

        with translate_database_errors(), engine.begin() as connection:
            give_rights(connection, settings.serving_role, settings.serving_password)
    engine.dispose()
    click.echo("The database is up to date.")
