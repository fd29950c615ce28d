"""Holding a survey's insets and classes in a package against the audit chain."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from functools import partial
from typing import Any

from sightline.errors import Damaged
from sightline.infra.csv_package.files import Files, read_rows
from sightline.infra.csv_package.schema import cell_text
from sightline.infra.csv_package.verify import says
from sightline.surveys.classes import classes_of
from sightline.surveys.csv import CLASSES, INSETS, QUOTAS, SAMPLING, SURVEY
from sightline.surveys.place import PLACE
from sightline.surveys.records import insets_of


def check_survey(files: Files, survey_id: int, survey: Mapping[str, Any]) -> None:
    """The survey's row is what its events say of it. Raises Damaged."""
    said = {"id": survey_id, **{name: survey.get(name) or None for name in ("name", "site", "description")}}
    said |= {name: survey.get(name) for name in PLACE}
    rows = list(read_rows(files, SURVEY.path))
    if len(rows) != 1 or not says(SURVEY, rows[0], said):
        raise Damaged("surveys-survey-csv-not-what-audit")


def check_insets(files: Files, insets: Mapping[str, Mapping[str, Any]]) -> None:
    """The insets in force are those of the survey's events, by target. Raises Damaged."""
    rows = {row["target"]: row for row in read_rows(files, INSETS.path)}
    told: Mapping[str, Mapping[str, Any]] = insets
    if set(rows) != set(insets):  # those of before roofs had insets by class
        told = {name: asdict(one) for name, one in insets_of(insets).items()}
    if set(rows) != set(told) or any(not says(INSETS, rows[one], told[one]) for one in rows):
        raise Damaged("surveys-insets-csv-not-what-surveys-audit")


def check_classes(files: Files, classes: Mapping[str, Mapping[str, Any]]) -> None:
    """The classes are those of the survey's events, in their order. Raises Damaged."""
    expected = [
        {column.name: cell_text(column, column.of(one)) for column in CLASSES.columns if column.of}
        for one in classes_of(classes)
    ]
    if list(read_rows(files, CLASSES.path)) != expected:
        raise Damaged("surveys-classes-csv-not-what-surveys-audit")


def check_sampling(files: Files, survey: Mapping[str, Any]) -> None:
    """Rule, targets and quotas are those of the survey's events. Raises Damaged."""
    rule, asked = survey["sampling"], survey["asked"]
    said = {"outside_counts": False} | {name: value for name, value in rule.items() if name != "quotas"}
    said |= {f"asked_{lighting}": " ".join(targets) for lighting, targets in asked.items()}
    rows, quotas = list(read_rows(files, SAMPLING.path)), list(read_rows(files, QUOTAS.path))
    if any("outside_counts" not in row for row in rows):  # of a version before it
        del said["outside_counts"]
    as_said = len(rows) == 1 and says(SAMPLING, rows[0], said)
    wanted = rule["quotas"]
    alike = len(quotas) == len(wanted) and all(map(partial(says, QUOTAS), quotas, wanted))
    if not as_said or not alike:
        raise Damaged("surveys-sampling-csv-not-what-audit")
