"""`sightline catalogue`: the catalogue of models from a CSV, and as one."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sightline.commands.files import read_bytes, write_whole
from sightline.commands.options import (
    FILE,
    choice_option,
    data_dir_option,
    json_option,
    opened_services,
    output_option,
    print_json,
)
from sightline.enums import OnConflict, SizeUnit
from sightline.errors import BadInput

if TYPE_CHECKING:
    from sightline.vehicles.catalogue.records import Imported, ImportPlan

_SHOWN = 40


@click.group()
def catalogue() -> None:
    """The catalogue of vehicle models: manufacturers' sizes with their sources."""


@catalogue.command("import")
@click.argument("file", type=FILE)
@click.option("--dry-run", is_flag=True, help="Show the result for each line without storing anything.")
@choice_option("--unit", of=SizeUnit, help="Unit of columns that state none (default: metres).")
@click.option(
    "--column",
    "columns",
    multiple=True,
    metavar="FIELD=HEADER",
    help="Meaning of a column (height_m=Roof); =HEADER skips it. May be repeated.",
)
@choice_option(
    "--on-conflict",
    of=OnConflict,
    default="keep",
    help="What to do with sizes that differ from the catalogue's.",
)
@json_option
@data_dir_option
def import_(
    file: Path,
    dry_run: bool,
    unit: SizeUnit | None,
    columns: tuple[str, ...],
    on_conflict: OnConflict,
    as_json: bool,
    data_dir: Path | None,
) -> None:
    """Import FILE into the catalogue (CSV with a header: make, model, year_from, height_m, ...).

    Lists every line that cannot be used, is a duplicate, or contradicts the catalogue.
    """
    from sightline.vehicles.catalogue.import_csv import (
        MOST_BYTES,
        Choices,
        columns_chosen,
        import_csv,
        plan_import,
    )

    content = read_bytes(file, "a CSV of models", MOST_BYTES + 1)
    choices = Choices(columns_chosen(columns), unit, on_conflict)
    with opened_services(data_dir) as services:
        if dry_run:
            with services.reading() as session:
                plan = plan_import(session, content, str(file), choices)
            if plan.problem is not None and not as_json:
                raise BadInput(plan.problem.code, **plan.problem.values)
            _tell(plan, None, as_json)
            return
        with services.writing() as session:
            done = import_csv(session, content, str(file), choices, actor=None)
    _tell(done.plan, done, as_json)


@catalogue.command("export")
@output_option("CSV to write.")
@data_dir_option
def export_(output: Path, data_dir: Path | None) -> None:
    """Export the catalogue, without retired models, as a CSV that `import` can read."""
    from sightline.vehicles.catalogue.csv import catalogue_csv
    from sightline.vehicles.catalogue.store import all_of_catalogue

    with opened_services(data_dir) as services, services.reading() as session:
        entries = all_of_catalogue(session)
    write_whole(output, catalogue_csv(entries).decode())
    click.echo(f"{len(entries)} models written to {output}.")


def _tell(plan: ImportPlan, done: Imported | None, as_json: bool) -> None:
    """What was done, or what a dry run would do."""
    if as_json:
        stored = (
            {"added": 0, "updated": 0} if done is None else {"added": done.added, "updated": done.updated}
        )
        print_json({**asdict(plan), **stored, "dry_run": done is None})
        return
    for one in plan.columns:
        taken = "left out" if one.field is None else f"{one.field}{f' in {one.unit}' if one.unit else ''}"
        click.echo(f"column {one.header}: {taken}")
    noted = [one for one in plan.rows if one.change not in ("new", "same")]
    for row in noted[:_SHOWN]:
        year = f" {row.year_from}" if row.year_from else ""
        click.echo(f"line {row.line}, {row.make} {row.model}{year}: {row.change}. {row.words or ''}")
    rest = sum(plan.counts[word] for word in plan.counts if word not in ("new", "same")) - len(noted[:_SHOWN])
    if rest > 0:
        click.echo(f"... and {rest} more lines to check (--json lists up to 500).")
    click.echo(", ".join(f"{count} {word}" for word, count in plan.counts.items() if count) + ".")
    if done is None:
        click.echo("Dry run: nothing was saved.")
    else:
        click.echo(f"{done.added} models added, {done.updated} updated.")
