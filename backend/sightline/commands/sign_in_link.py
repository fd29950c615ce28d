"""`sightline sign-in-link`: the way back in for somebody who is locked out."""

from pathlib import Path

import click

from sightline.commands.options import data_dir_option, opened_services


@click.command("sign-in-link")
@click.argument("email")
@data_dir_option
def sign_in_link(email: str, data_dir: Path | None) -> None:
    """Print a new one-time sign-in link for the account with this EMAIL; earlier links become invalid.

    Give it only to that person: whoever opens it is signed in and can set a new password. The audit trail
    records that it was made.
    """
    from sightline.people.service import new_sign_in_link

    with opened_services(data_dir) as services:
        link = new_sign_in_link(services, email)
        address = services.settings.address.rstrip("/")
    what = "Open this page of your Sightline"
    if not address:
        what = "Put the address of your Sightline before this, and open it"
    click.echo(f"{what}, once: {address}{link}")
