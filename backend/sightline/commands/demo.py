"""`sightline demo`: the demonstration survey, and the server."""

from pathlib import Path

import click

from sightline.commands.options import data_dir_option
from sightline.commands.serve import run


@click.command()
@click.option("--host", help="Address to listen on (SIGHTLINE_HOST; default 127.0.0.1).")
@click.option("--port", type=click.IntRange(0, 65535), help="Port (SIGHTLINE_PORT; default 8000).")
@data_dir_option
def demo(host: str | None, port: int | None, data_dir: Path | None) -> None:
    """Start the server with the demonstration survey, which is created in the background on the first
    start.
    """
    run(host, port, None, True, data_dir)
