"""`sightline worker`: does queued jobs, on this machine or another."""

from __future__ import annotations

from pathlib import Path

import click

from backend.commands.options import data_dir_option, settings_of


@click.command()
@click.option("--workers", type=click.IntRange(1, 64), help="Jobs side by side (SIGHTLINE_WORKERS).")
@data_dir_option
def worker(workers: int | None, data_dir: Path | None) -> None:
    """Do queued jobs until stopped. On several machines, database and media are shared ones."""
    import logging

    from backend.work.worker import run_worker

    logging.basicConfig(level=logging.INFO, format="%(asctime)s %(name)s: %(message)s")
    run_worker(settings_of(data_dir=data_dir, workers=workers))
