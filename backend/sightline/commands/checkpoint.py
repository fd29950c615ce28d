"""`sightline checkpoint`: sign the ends of all audit chains, keep what was signed, change the key."""

from pathlib import Path

import click

from sightline.commands.files import write_whole
from sightline.commands.options import data_dir_option, opened_services, output_option
from sightline.settings import Settings


@click.command("checkpoint")
@output_option("JSON file to write.", required=False)
@click.option("--new-key", is_flag=True, help="First make a new signing key, signed by the old one.")
@data_dir_option
def checkpoint(output: Path | None, new_key: bool, data_dir: Path | None) -> None:
    """Sign the ends of all audit chains with the installation's key; print what was signed and the keys.

    Keep the output in another place: it reveals a chain that is cut or rewritten later, and its key reveals a
    forged package (`sightline verify --key`). Every package is signed in the same way.
    """
    from sightline.infra.audit.checkpoints import hand_on, known_keys, sign_checkpoint
    from sightline.infra.audit.signing import key_file, replacing_key, signing_key
    from sightline.infra.csv_package.schema import json_bytes

    with opened_services(data_dir) as services:
        settings = services.settings
        key = signing_key(settings)
        with services.reading() as session:
            last = [one["key"] for one in known_keys(session)][-1:]
        if last not in ([], [key.public]) and (left := key_file(settings.data_dir, last[0])):
            _take_up(settings, left)  # a run was killed behind its commit
            key = signing_key(settings)
        waiting = None
        with services.writing() as session:
            if new_key:
                after, waiting = replacing_key(settings.data_dir)
                hand_on(session, key, after, actor=None)
                key = after
            signed = sign_checkpoint(session, key, actor=None)
            document = json_bytes({**signed, "keys": known_keys(session)}).decode()
        if waiting is not None:
            _take_up(settings, waiting)  # after the commit: until then the file waits beside the key in force
    if output is None:
        click.echo(document, nl=False)
    else:
        write_whole(output, document)
        click.echo(f"Signed with key {signed['key']}.")


def _take_up(settings: Settings, waiting: Path) -> None:
    from sightline.infra.audit.signing import put_in_force

    if settings.signing_key is None:
        put_in_force(settings.data_dir, waiting)
    else:
        click.echo(f"Set SIGHTLINE_SIGNING_KEY on all machines to the key in {waiting}.", err=True)
