"""`sightline worker`: does queued jobs, on this machine or another."""

import importlib
from pathlib import Path

import click

from sightline.commands.options import data_dir_option, settings_of


@click.command()
@click.option("--workers", type=click.IntRange(1, 64), help="Number of worker processes (SIGHTLINE_WORKERS).")
@click.option("--parent", type=int, hidden=True, help="Stop when the process with this number ends.")
@data_dir_option
def worker(workers: int | None, parent: int | None, data_dir: Path | None) -> None:
    """Run queued jobs until stopped. Several machines must share the database and the media."""
    import logging

    from sightline.infra.jobs.workers import run_workers
    from sightline.infra.log import begin_log
    from sightline.infra.web.secret import require_secrets

    settings = settings_of(data_dir=data_dir, workers=workers)
    require_secrets(settings)
    begin_log(settings.log_format, logging.INFO if parent is None else logging.WARNING)
    run_workers(settings, parent=parent, load_handlers=load_job_handlers)


def load_job_handlers() -> None:
    """Register all handlers, in the process that is to run them."""
    importlib.import_module("sightline.job_handlers")
