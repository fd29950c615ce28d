"""The tables of a study."""

from collections.abc import Iterator
from typing import get_args

from sightline.enums import ComparisonVerdict, RuleVerdict
from sightline.export.statistics_rows import INTERVAL, INTERVAL_M, REASON, TOTAL_M
from sightline.infra.csv_package.columns import flag, integer, metres, number, text
from sightline.infra.csv_package.schema import CODE, Cell, Cells, Column, Table
from sightline.results.survey_statistics import RULE_OF
from sightline.statistics.figures import TotalFigure
from sightline.studies.records import Study

_N = integer("n", "how many heights (of classes: vehicles) it rests on", required=True, minimum=0)
_EFFECT = number("design_effect", "variance by the design over that of as many vehicles drawn one by one")
_EFFECTIVE = number(
    "effective_n", "n over the design effect: vehicles drawn one by one that would tell as much"
)


def study_table(name: str, meaning: str, *columns: Column) -> Table:
    """A table of a study's package, which has no folder of its own."""
    return Table(name, meaning, columns, folder="")


PACKAGES = study_table(
    "packages",
    "The surveys of the study: packages, each verified before it was read, or surveys of an installation.",
    text("place", "folder or ZIP as it was named, or which survey of the installation", required=True),
    text("survey", "name of the survey"),
    text("site", "site: surveys of one site are one cluster"),
    flag("simulated", "true: invented, so that no figure says anything of real roads", required=True),
    integer("year", "year that it stands for, where years are compared"),
    text("made_with", "version that made the package, or read the installation's database"),
    text("chain_sha256", "of a package: SHA-256 of its audit chain without its seal"),
    text("audit_head", "of an installation's survey: last hash of its audit chain when it was read"),
    integer("counted", "accepted heights that count by what the survey says of its sample"),
    integer("out_of_sample", "accepted heights of vehicles out of the sample, which do not count"),
)
FIGURES = study_table(
    "figures",
    "Figures of the true heights of each target, weighted to the fleet where one was given: 95 % intervals "
    "hold sampling, differences between sites, errors that heights share, and random error (taken out).",
    text("target", "what was measured", required=True),
    text("figure", "name of the value", required=True, enum=("percentile", "mean", "sd")),
    number("percent", "of a percentile: which", "%"),
    _N,
    integer("sites", "at how many sites", required=True),
    metres("value_m", "value"),
    *TOTAL_M,
    metres("raw_m", "of a percentile: that of the measured heights, random error left in"),
    _EFFECT,
    _EFFECTIVE,
    number("weighting_effect", "how much unequal weights alone widen an interval's square"),
    *REASON,
)
ERRORS = study_table(
    "errors",
    "Errors (measured minus maker's height) of roofs, not rounded, by lighting and overall. Intervals hold "
    "sampling, sites and the errors that heights share; random errors, and those of the makers' heights, are "
    "in the errors themselves.",
    text("group", "lighting, or overall", required=True),
    text("figure", "name of the value", required=True),
    _N,
    metres("value_m", "value"),
    *INTERVAL_M,
)
CLASSES = study_table(
    "classes",
    "Shares of the classes of vehicles on the road as they were drawn, beside the fleet's that was given.",
    text("group", "lighting, or all", required=True),
    text("category", "class of vehicle", required=True),
    _N,
    number("share", "its share"),
    *INTERVAL,
    _EFFECT,
    number("fleet_share", "its share in the fleet that was given"),
)
PLANS = study_table(
    "plan",
    "How many sites, with how many vehicles each, a further study would need for the U95 that was asked for, "
    "if its sites and vehicles differ as these do.",
    text("target", "what is measured", required=True),
    number("percent", "which percentile", "%"),
    metres("goal_U95_m", "the U95 that is wanted"),
    integer("sites", "at so many sites", required=True),
    integer("vehicles_each", "so many vehicles each; empty: no number is enough"),
    metres("U95_m", "the U95 that is then expected"),
)
RULES = study_table(
    "rules",
    "The same rule today: the percentile that a standard is set by, of its class, with a verdict.",
    text("target", "what was measured", required=True),
    text("standard", "the standard", required=True),
    text("what", "what its height is of", required=True),
    number("percent", "the percentile of its rule", "%", required=True),
    text("vehicle_class", "the class that its percentile is of"),
    flag("by_class", "whether heights of other classes could be left out", required=True),
    _N,
    metres("standard_m", "the standard's height", required=True),
    metres("value_m", "the percentile today, of true heights"),
    *TOTAL_M,
    metres("difference_m", "today less the standard"),
    number("lower", "probability that the true percentile lies below the standard's height"),
    number("risk", "probability that the verdict is wrong"),
    text("verdict", "verdict", required=True, enum=get_args(RuleVerdict)),
    *REASON,
)
YEARS = study_table(
    "years",
    "A later year less the first one, where the surveys of a study were given years: differences of true "
    "heights with total 95 % intervals, and whether each is more than noise.",
    text("target", "what was measured", required=True),
    integer("first_year", "the first year", required=True),
    integer("second_year", "the later year", required=True),
    text("figure", "name of the value", required=True, enum=("percentile", "mean")),
    number("percent", "of a percentile: which", "%"),
    integer("n_first", "heights of the first year", required=True, minimum=0),
    integer("n_second", "heights of the later year", required=True, minimum=0),
    metres("value_m", "the difference"),
    *TOTAL_M,
    text("verdict", "more than noise, or not", enum=get_args(ComparisonVerdict)),
    *REASON,
)
TABLES = (PACKAGES, FIGURES, RULES, YEARS, ERRORS, CLASSES, PLANS)


def study_rows(study: Study) -> dict[str, Iterator[Cells]]:
    """The rows of every table by its path."""
    return {
        PACKAGES.path: _packages(study),
        FIGURES.path: _figures(study),
        RULES.path: _rules(study),
        YEARS.path: _years(study),
        ERRORS.path: _errors(study),
        CLASSES.path: _classes(study),
        PLANS.path: (_cells_of(PLANS, one) for one in study.plans),
    }


def _packages(study: Study) -> Iterator[Cells]:
    for survey, n, outside in zip(study.surveys, study.counted, study.out_of_sample, strict=True):
        told: Cells = {"place": survey.place, "survey": survey.name, "site": survey.site, "year": survey.year}
        told["simulated"] = survey.simulated
        told |= {"counted": n, "out_of_sample": outside, "made_with": survey.made_with}
        yield {**told, "chain_sha256": survey.seal or None, "audit_head": survey.head or None}


def _figures(study: Study) -> Iterator[Cells]:
    for figures in study.targets:
        key: Cells = {"target": figures.target, "n": figures.n, "sites": figures.sites}
        key["weighting_effect"] = figures.weighting_effect
        if figures.mean is None or figures.sd is None:
            yield {**key, "figure": "mean", "reason": figures.reason}
            continue
        for percentile in figures.percentiles:
            row = {**key, "figure": "percentile", "percent": percentile.percent, "raw_m": percentile.raw}
            yield row | _cells_of_figure(percentile, figures.n)
        yield {**key, "figure": "mean"} | _cells_of_figure(figures.mean, figures.n)
        yield {**key, "figure": "sd"} | _cells_of_figure(figures.sd, figures.n)


def _rules(study: Study) -> Iterator[Cells]:
    for rule in study.rules:
        standard = rule.standard
        yield _cells_of(
            RULES,
            rule,
            target=RULE_OF[standard.what][0],
            standard=standard.name,
            what=standard.what,
            percent=standard.percent,
            vehicle_class=standard.vehicle_class,
            standard_m=standard.height_m,
            low_m=rule.U95_low_m,
            high_m=rule.U95_high_m,
        )


def _years(study: Study) -> Iterator[Cells]:
    for one in study.years:
        yield _cells_of(YEARS, one, figure="mean" if one.percent is None else "percentile")


def _cells_of(table: Table, record: object, **also: Cell) -> Cells:
    """A row: `also`, and what the record has under the columns' names; of what is said its codes follow."""
    names = (name for name in table.header if not name.endswith(CODE))
    return {name: also[name] if name in also else getattr(record, name) for name in names}


def _cells_of_figure(figure: TotalFigure, n: int, unit: str = "_m") -> Cells:
    cells: Cells = {
        (f"value{unit}" if unit else "share"): figure.value,
        f"low{unit}": figure.U95_low,
        f"high{unit}": figure.U95_high,
        "reason": figure.reason,
    }
    if figure.effect is not None:
        cells |= {
            "design_effect": figure.effect,
            "effective_n": n / figure.effect if figure.effect > 0.0 else None,
        }
    return cells


def _errors(study: Study) -> Iterator[Cells]:
    for one in study.errors:
        key: Cells = {"group": one.group, "figure": one.figure, "n": one.n}
        yield key | _cells_of_figure(one.value, one.n)


def _classes(study: Study) -> Iterator[Cells]:
    for one in study.classes:
        key: Cells = {"group": one.group, "category": one.category, "n": one.n, "fleet_share": one.fleet}
        yield key | _cells_of_figure(one.share, one.n, "")
