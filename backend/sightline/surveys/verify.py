"""Holding what a package says of its survey against the audit chain: place, insets, classes, sampling."""

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

from sightline.infra.csv_package.files import Files, read_columns
from sightline.infra.csv_package.replay import hold_all, values_of
from sightline.surveys.classes import classes_of
from sightline.surveys.csv import CLASSES, INSETS, QUOTAS, SAMPLING, SURVEY
from sightline.surveys.place import PLACE
from sightline.surveys.records import insets_of


def check_survey(files: Files, survey: Mapping[str, Any]) -> None:
    """The tables about the survey are what its events say, classes and quotas in order. Raises Damaged."""
    words = {name: survey.get(name) or None for name in ("name", "site", "description")}
    place = {name: survey.get(name) for name in PLACE}
    invented = {name: survey[name] for name in ("simulated",) if name in survey}  # not of the earliest
    hold_all(files, SURVEY, [{"id": survey["id"], **words, **place, **invented}])
    insets: Mapping[str, Mapping[str, Any]] = survey.get("insets", {})
    if {target for (target,) in read_columns(files, INSETS.key, ("target",))} != set(insets):
        # those of before roofs had insets by class
        insets = {name: asdict(one) for name, one in insets_of(insets).items()}
    hold_all(files, INSETS, ({**values, "target": name} for name, values in insets.items()))
    classes = (values_of(CLASSES, one) for one in classes_of(survey["classes"]))
    hold_all(files, CLASSES, classes, in_order=True)
    rule = survey["sampling"]
    asked = {f"asked_{lighting}": " ".join(targets) for lighting, targets in survey["asked"].items()}
    hold_all(files, SAMPLING, [{"outside_counts": False, **rule, **asked}], in_order=True)
    hold_all(files, QUOTAS, rule["quotas"], in_order=True)
