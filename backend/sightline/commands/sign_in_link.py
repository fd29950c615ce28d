"""`sightline sign-in-link`: the way back in for somebody who is locked out."""

from __future__ import annotations

from pathlib import Path

import click

from sightline.commands.options import data_dir_option, require_database, settings_of


@click.command("sign-in-link")
@click.argument("email")
@data_dir_option
def sign_in_link(email: str, data_dir: Path | None) -> None:
    """Print a new one-time sign-in link for the account with this EMAIL; older ones end.

    Give it to that person only: whoever opens it is signed in and may set a new password. The audit trail
    tells that it was made.
    """
    from sightline.infra.database.engine import migrate
    from sightline.infra.services import open_services
    from sightline.people.service import new_sign_in_link

    settings = settings_of(data_dir=data_dir)
    require_database(settings)
    services = open_services(settings)
    try:
        migrate(services.engine)
        link = new_sign_in_link(services, email)
    finally:
        services.close()
    click.echo(f"Open this page of your Sightline, once: {link}")
