"""Values of the report about results: at a glance, errors against reference heights, distributions."""

from sightline.enums import LengthUnit, StatisticsTarget
from sightline.export.report import words
from sightline.export.report.conclusion import verdict_of, whose_words
from sightline.export.report.facts import ReportFacts
from sightline.export.report.pictures import Pictures
from sightline.export.report.said import sentence_of_key, sentence_of_said, spoken_language
from sightline.export.report.settable import Values
from sightline.export.report.units import decimal, limit
from sightline.messages.said import Said
from sightline.results.survey_statistics import RULE_OF, standards_of
from sightline.results.usual_standards import in_language
from sightline.statistics.distributions import Share
from sightline.statistics.errors import GROUPS
from sightline.statistics.figures import TotalFigure
from sightline.statistics.known_errors import KnownErrors, KnownGroup, shown_groups
from sightline.statistics.paper import PAPER
from sightline.statistics.rules import RuleToday
from sightline.statistics.standards import Standard
from sightline.statistics.summary import Errors, Target

_ERROR_FIGURES = (
    "absolute-error-ecdf",
    "relative-error-ecdf",
    "signed-error-density",
    "error-against-height",
)
_GROUPINGS = ("category", "class_set", "site", "operator")


def rule_values(rule: RuleToday, of_chosen: bool) -> Values:
    """The rule of a standard on heights, those of chosen classes alone or of all, with its verdict."""
    standard = in_language(rule.standard, spoken_language())
    return {
        "name": standard.name,
        "rule": sentence_of_key(
            "statistics-rule-of",
            what=words.heading(words.TARGETS[RULE_OF[standard.what][0]]),
            percent=decimal(f"{standard.percent:g}"),
            **{"class": standard.vehicle_class},
        ),
        "read": sentence_of_key("statistics-rule-read", whose=whose_words(rule, of_chosen), n=rule.n),
        "today": rule,
        "verdict": verdict_of(rule),
    }


def known_errors(facts: ReportFacts) -> list[Values]:
    """The errors of each target with known heights, of the traffic and of check targets."""
    return [
        {
            "name": _known_group(known, part),
            "of": part.grouping,
            "check": known.check_target,
            "errors": part.errors,
            "inside": _inside(known) if part.grouping == "all" else "",
        }
        for known in facts.statistics.known_errors
        for part in shown_groups(known.groups)
    ]


def _known_group(known: KnownErrors, part: KnownGroup) -> str:
    if part.grouping != "all":
        return words.group_word(part.grouping, part.group)
    word = words.TARGETS[known.target]
    return sentence_of_key("report-check-targets", target=word) if known.check_target else word


def _inside(known: KnownErrors) -> str:
    if isinstance(known.inside, Said):
        return sentence_of_said(known.inside)
    return sentence_of_key("report-of-all", part=known.inside.inside, all=known.inside.n)


def errors(facts: ReportFacts, pictures: Pictures) -> Values | None:
    """The error table and its figures; None where no vehicle has a reference height."""
    error_table = facts.statistics.errors
    if error_table.groups["overall"].n == 0:
        return None
    part, limits = error_table.reference_part, error_table.bland_altman
    return {
        "groups": _error_groups(error_table),
        "reference_part": sentence_of_said(part) if isinstance(part, Said) else part,
        "limits": sentence_of_said(limits) if isinstance(limits, Said) else limits,
        "figures": pictures.figures(_ERROR_FIGURES),
    }


def _error_groups(found: Errors) -> list[Values]:
    return [{"name": words.LIGHTING[name], "errors": found.groups[name]} for name in GROUPS]


def as_in_the_paper(facts: ReportFacts) -> Values | None:
    """What stands apart, for comparison with the paper alone; None where nothing of it is known."""
    if facts.as_in_the_paper is None:
        return None
    found = facts.as_in_the_paper.errors
    return {
        "groups": _error_groups(found) if found.groups["overall"].n else None,
        "printed": PAPER,
        "targets": [
            {
                "name": words.TARGETS[name],
                "n_corrected": target.corrected.n,
                "n_raw": target.raw.n,
                "raw": target.raw.percentiles,
                "corrected": target.corrected.percentiles,
            }
            for name, target in facts.statistics.targets.items()
            if target.raw.n
        ],
    }


def heights(facts: ReportFacts, pictures: Pictures) -> Values:
    """The rules of standards, then each target's percentiles, and who sits below the standards."""
    targets = facts.statistics.targets
    there = [name for name, target in targets.items() if target.raw.n or target.corrected.n]
    rules = [one for one in facts.statistics.rules if one.n]
    return {
        "rules": [rule_values(one, facts.statistics.of_chosen) for one in rules],
        "targets": [_target(facts, name, targets[name], pictures) for name in there],
        "absent": [words.TARGETS[name] for name in targets if name not in there],
    }


def _target(facts: ReportFacts, name: StatisticsTarget, target: Target, pictures: Pictures) -> Values:
    done = target.correction
    return {
        "name": words.TARGETS[name],
        "many": words.MANY[name],
        "correction": sentence_of_said(done) if isinstance(done, Said) else done,
        "n": target.corrected.n,
        "total": target.total,
        "standards": _standards(facts, name, target),
        "groupings": [] if name == "roof" else pictures.figures(f"{name}-by-{word}" for word in _GROUPINGS),
    }


def _standards(facts: ReportFacts, name: StatisticsTarget, target: Target) -> list[Values]:
    """The standards that speak of a target, with the share below each."""
    if not target.corrected.shares:
        return []
    standards = [
        in_language(one, spoken_language()) for one in standards_of(facts.statistics.standards, name)
    ]
    totals = [None] * len(standards) if target.total is None else target.total.shares
    each = zip(standards, target.corrected.shares, totals, strict=True)
    return [_standard(standard, share, total, facts.unit) for standard, share, total in each]


def _source(standard: Standard) -> str:
    """Where a value comes from, by what rule, and who cites it."""
    edition = standard.edition or (str(standard.year) if standard.year else "")
    rule = standard.vehicle_class
    if standard.percent is not None:
        percentile = decimal(f"{standard.percent:g}")
        rule = (
            sentence_of_key("report-percentile-of", percent=percentile, of=rule) if rule else f"P{percentile}"
        )
    cited = sentence_of_key("report-cited-by", who=standard.cited_by) if standard.cited_by else ""
    source = standard.source
    named = f"{source}{f', {edition}' if edition and edition not in source else ''}"
    return words.join_with_semicolons([one for one in (named, rule, cited) if one])


def _standard(standard: Standard, share: Share, total: TotalFigure | None, unit: LengthUnit) -> Values:
    """A share of the true heights with its total interval; of the corrected ones where that has none."""
    known = total is not None and total.U95_low is not None and total.U95_high is not None
    return {
        "name": standard.name,
        "height": limit(standard.height_m, unit),
        "below": share.below,
        "n": share.n,
        "value": total.value if known and total is not None else share.share,
        "ci95": total if known else share,
        "source": _source(standard),
    }
