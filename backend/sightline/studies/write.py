"""A study on the disk: its tables as CSV and Parquet, described, with the sums of all files."""

from collections.abc import Sequence

from sightline.infra.csv_package.files import Staging
from sightline.infra.csv_package.parquet import write_parquet
from sightline.infra.csv_package.schema import (
    DESCRIPTION,
    About,
    Other,
    description_of,
    json_bytes,
    parquet_path,
)
from sightline.infra.version import code_version
from sightline.studies.csv import TABLES, study_rows
from sightline.studies.records import Study

_ABOUT = (
    "A study of heights of vehicles made from {surveys} surveys by Sightline, {heights} accepted heights. "
    "Lengths are in metres. {notes}"
)


def write_study(staging: Staging, study: Study, notes: Sequence[str]) -> None:
    """Write every table, its Parquet, the description and SHA256SUMS. Raises NoRoom."""
    rows = study_rows(study)
    for table in TABLES:
        staging.fill(table, rows[table.path])
    write_parquet(staging, TABLES)
    told = " ".join([*map(str, study.notes), *notes])
    words = _ABOUT.format(surveys=len(study.surveys), heights=study.heights, notes=told).strip()
    about = About("Study", words, None, {"sightline": code_version()})
    columns = [
        Other(parquet_path(table.path), "application/vnd.apache.parquet", "A table as Parquet.")
        for table in TABLES
    ]
    described = description_of(about, TABLES, columns, staging.written)
    staging.add(DESCRIPTION, json_bytes({**described, "name": "sightline-study"}))
    staging.add_checksums()
