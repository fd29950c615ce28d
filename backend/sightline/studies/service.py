"""A study: heights of many packages as one designed sample, weighted to a fleet, with total intervals."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import get_args

import numpy as np
from numpy.typing import NDArray

from sightline.enums import Category, Lighting, StatisticsTarget
from sightline.errors import BadInput
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.study_figures import Drawn, StudyFigure, StudyFigures, lonely_strata, share_of
from sightline.statistics.study_plan import Components, U95_of, plan
from sightline.statistics.survey_design import Design, weighting_effect
from sightline.statistics.survey_weights import Margin, calibrated
from sightline.statistics.total_uncertainty import HeightSample, sample_of_measurements
from sightline.studies.query import StudyTables
from sightline.studies.records import (
    ClassShare,
    ErrorFigure,
    Fleet,
    Floats,
    Ints,
    PlannedStudy,
    SiteFacts,
    StudiedHeights,
    StudiedPackage,
    Study,
    TargetFigures,
)

CATEGORIES: tuple[str, ...] = get_args(Category)
LIGHTING: tuple[str, ...] = get_args(Lighting)
TARGETS: tuple[StatisticsTarget, ...] = get_args(StatisticsTarget)
PERCENTS = (2.5, 5.0, 10.0, 15.0, 50.0, 85.0, 90.0, 95.0, 97.5)
_LEAST = 2
_PLANNED_PERCENT = 10.0
_PLANNED_SITES = (2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 30, 50)
_ONE_STRATUM = "all"


@dataclass(frozen=True, eq=False)
class _Places:
    """The sites of the study: names (J,), the site of each package (P,), the stratum of each site (J,), how
    many sites each stratum has (H,), each site's traffic (J,) or None.
    """

    names: list[str]
    strata: list[str]
    of_package: Ints
    stratum: Ints
    sites_there: Floats
    traffic: Floats | None


def make_study(
    packages: Sequence[StudiedPackage],
    fleet: Fleet | None,
    sites: Mapping[str, SiteFacts] | None,
    goal_m: float,
) -> Study:
    """Figures, error table, class shares and a plan from the packages' own tables.

    Raises BadInput where packages, fleet and sites do not fit, in one sentence.
    """
    places = _places_of(packages, sites)
    notes = _notes(packages, places)
    with StudyTables(packages, CATEGORIES, LIGHTING) as tables:
        counted, outside = tables.counted()
        notes += _notes_of_counts(packages, counted, outside)
        if not counted.sum():
            raise BadInput("studies-no-height-counts")
        cars = tables.vehicles()
        _refuse_fleet(fleet, cars, places)
        classes = _class_shares(cars, places, fleet)
        targets, plans, errors = [], [], []
        for target in TARGETS:
            found = tables.heights(target)
            figures, of_plan = _target_figures(target, found, places, fleet, goal_m, notes)
            targets.append(figures)
            plans += of_plan
            if target == "roof":
                errors = _error_figures(found, places)
    return Study(
        packages=list(packages),
        counted=counted.tolist(),
        out_of_sample=outside.tolist(),
        heights=int(counted.sum()),
        vehicles=len(cars[0]),
        targets=targets,
        errors=errors,
        classes=classes,
        plans=plans,
        notes=notes,
    )


def _places_of(packages: Sequence[StudiedPackage], sites: Mapping[str, SiteFacts] | None) -> _Places:
    names = sorted({one.site for one in packages})
    facts = {name: SiteFacts(_ONE_STRATUM, np.inf, None) for name in names} if sites is None else dict(sites)
    for name in names:
        if name not in facts:
            raise BadInput("studies-site-not-in-sites", site=name)
    strata = sorted({facts[name].stratum for name in names})
    stratum = np.array([strata.index(facts[name].stratum) for name in names], dtype=np.int64)
    there = np.array([next(facts[n].sites_there for n in names if facts[n].stratum == s) for s in strata])
    for h, count in enumerate(np.bincount(stratum)):
        if count > there[h]:
            raise BadInput(
                "studies-more-sites-than-there", stratum=strata[h], count=int(count), there=there[h]
            )
    traffic = [facts[name].traffic for name in names]
    return _Places(
        names=names,
        strata=strata,
        of_package=np.array([names.index(one.site) for one in packages], dtype=np.int64),
        stratum=stratum,
        sites_there=there,
        traffic=None if any(one is None for one in traffic) else np.array(traffic, dtype=np.float64),
    )


def _notes(packages: Sequence[StudiedPackage], places: _Places) -> list[str]:
    made_with = sorted({one.made_with for one in packages})
    notes = []
    if len(made_with) > 1:
        notes.append(
            f"Packages come from {len(made_with)} versions whose tables are alike: {', '.join(made_with)}."
        )
    if len(places.names) == 1:
        notes.append("One site: intervals speak of that place alone.")
    return notes


def _notes_of_counts(packages: Sequence[StudiedPackage], counted: Ints, outside: Ints) -> list[str]:
    notes = [
        f"{one.name} has no accepted height in its sample; it says nothing here."
        for one, n in zip(packages, counted.tolist(), strict=True)
        if n == 0
    ]
    if outside.any():
        notes.append(
            f"{int(outside.sum())} accepted heights are of vehicles outside their survey's sample; they do "
            "not count."
        )
    return notes


def _refuse_fleet(fleet: Fleet | None, cars: tuple[Ints, Ints, Ints], places: _Places) -> None:
    """Every class of the fleet was seen, and every class seen is in the fleet."""
    for variable, shares in (fleet.margins if fleet else {}).items():
        words, code = _coded(variable, cars[0], cars[1], cars[2], places)
        seen = {words[n] for n in np.unique(code[code >= 0]).tolist()}
        for name, share in shares.items():
            if name not in words and variable in ("category", "lighting"):
                raise BadInput("studies-class-unknown", variable=variable, name=name, known=", ".join(words))
            if share > 0.0 and name not in seen:
                raise BadInput("studies-class-never-seen", variable=variable, name=name)
        for name in sorted(seen - set(shares)):
            count = int(np.count_nonzero(code == words.index(name)))
            raise BadInput("studies-class-not-in-fleet", variable=variable, name=name, count=count)


def _coded(
    variable: str, package: Ints, category: Ints, lighting: Ints, places: _Places
) -> tuple[Sequence[str], Ints]:
    """Words of what divides the fleet, and the code of each row (N,), -1 for none."""
    site = places.of_package[package]
    return {
        "category": (CATEGORIES, category),
        "lighting": (LIGHTING, lighting),
        "site": (places.names, site),
        "stratum": (places.strata, places.stratum[site]),
    }[variable]


def _design(package: Ints, places: _Places) -> Design:
    """Each vehicle stands for the traffic of its site and the sites that its stratum has to each one seen."""
    site = places.of_package[package]
    each = np.ones(len(places.names))
    known = np.isfinite(places.sites_there)
    if known.all():
        seen = np.bincount(places.stratum, minlength=len(places.sites_there))
        each = (places.sites_there / seen)[places.stratum]
    if places.traffic is not None:
        count = np.bincount(site, minlength=len(places.names))
        each = each * np.divide(places.traffic, count, out=np.zeros(len(count)), where=count > 0)
    there = np.bincount(site, minlength=len(places.names)) > 0
    code = (np.cumsum(there) - 1)[site]  # sites without a row here have no code
    return Design(each[site], places.stratum[site], code, places.sites_there)


def _to_fleet(design: Design, rows: StudiedHeights, places: _Places, fleet: Fleet) -> Design | str:
    """The design with weights that meet the fleet, or the reason why there are none."""
    margins = []
    for variable, shares in fleet.margins.items():
        words, code = _coded(variable, rows.package, rows.category, rows.lighting, places)
        there = np.bincount(code, minlength=len(words))
        share = np.array([shares.get(word, 0.0) for word in words])
        for n in np.flatnonzero((share > 0.0) & (there == 0)).tolist():
            return f"no height of {variable} {words[n]} counts, which the fleet has"
        margins.append(Margin(code, share))
    weight = calibrated(design.weight, margins)
    if weight is None:
        return "no weights meet all shares of the fleet at once"
    return Design(
        weight, design.stratum, design.site, design.sites_there, margins=tuple(margins), drawn=design.weight
    )


def _with_class(rows: StudiedHeights, fleet: Fleet | None) -> NDArray[np.bool_]:
    keep = np.ones(len(rows.height_m), dtype=np.bool_)
    for variable in fleet.margins if fleet else ():
        if variable in ("category", "lighting"):
            keep &= getattr(rows, variable) >= 0
    return keep


def _target_figures(
    target: str,
    rows: StudiedHeights,
    places: _Places,
    fleet: Fleet | None,
    goal_m: float,
    notes: list[str],
) -> tuple[TargetFigures, list[PlannedStudy]]:
    keep = _with_class(rows, fleet)
    if not keep.all():
        notes.append(
            f"{int((~keep).sum())} heights of {target} have no class of the fleet; they do not count."
        )
        rows = _where(rows, keep)
    n = len(rows.height_m)
    at = int(np.count_nonzero(np.bincount(places.of_package[rows.package]))) if n else 0
    if n < _LEAST:
        return TargetFigures(target, n, at, reason=f"its figures need at least {_LEAST} heights"), []
    design: Design | str = _design(rows.package, places)
    assert isinstance(design, Design)
    alone = lonely_strata(design)
    if len(places.names) > 1 and alone:
        why = (
            f"{places.strata[alone[0]]} has one site: join it with another stratum, so that sites can differ"
        )
        return TargetFigures(target, n, at, reason=why), []
    if fleet is not None:
        design = _to_fleet(design, rows, places, fleet)
        if isinstance(design, str):
            return TargetFigures(target, n, at, reason=design), []
    figures = StudyFigures(_sample(rows), design)
    found = TargetFigures(
        target=target,
        n=n,
        sites=at,
        weighting_effect=weighting_effect(design.weight),
        mean=figures.mean(),
        sd=figures.sd(),
        percentiles=[figures.percentile(percent) for percent in PERCENTS],
    )
    return found, _plans(target, figures, goal_m, float(places.sites_there.sum()))


def _plans(target: str, figures: StudyFigures, goal_m: float, sites_there: float) -> list[PlannedStudy]:
    told = figures.components(_PLANNED_PERCENT)
    if told is None:
        return []
    components = Components(told.sampling_m, told.between_m, told.common_m, sites_there)
    found = []
    for sites, vehicles in plan(components, _PLANNED_SITES, goal_m):
        reached = None if vehicles is None else U95_of(components, sites, vehicles)
        found.append(
            PlannedStudy(
                target=target,
                percent=_PLANNED_PERCENT,
                goal_U95_m=goal_m,
                sites=sites,
                vehicles=vehicles,
                U95_m=reached,
            )
        )
    return found


def _sample(rows: StudiedHeights) -> HeightSample:
    """As the statistics of a survey take them; poses of one package are no other package's."""
    inset = np.rint(np.nan_to_num(rows.inset_m) * 1e4) * 100_000
    inset = inset + np.rint(np.nan_to_num(rows.u_inset_m) * 1e4)
    alike = bool(np.all(inset == inset[0]))
    return sample_of_measurements(
        height_m=rows.height_m,
        u_height_m=rows.u_height_m,
        u_clicks_m=rows.u_clicks_m,
        u_by_inset_m=rows.u_by_inset_m,
        pose=_pose_codes(rows),
        inset=np.zeros(len(inset), np.int64) if alike else _codes(inset),
    )


def _pose_codes(rows: StudiedHeights) -> Ints:
    """A number for each pose of each package, from 0."""
    most = int(rows.pose.max()) + 1
    both = rows.package * most + rows.pose
    if (int(rows.package.max()) + 1) * most > 8 * len(both) + 1_000_000:
        return _codes(both)
    return np.asarray((np.cumsum(np.bincount(both) > 0) - 1)[both], dtype=np.int64)


def _codes(values: NDArray[np.generic]) -> Ints:
    return np.asarray(np.unique(values, return_inverse=True)[1], dtype=np.int64)


def _where(rows: StudiedHeights, keep: NDArray[np.bool_]) -> StudiedHeights:
    return StudiedHeights(**{name: getattr(rows, name)[keep] for name in StudiedHeights.__dataclass_fields__})


def _class_shares(cars: tuple[Ints, Ints, Ints], places: _Places, fleet: Fleet | None) -> list[ClassShare]:
    """Shares of classes on the road, by the draw alone: the fleet's own stand beside them."""
    package, category, lighting = cars
    of_fleet = fleet.margins.get("category", {}) if fleet else {}
    found = []
    for group, rows in [
        ("all", category >= 0),
        *((w, (category >= 0) & (lighting == n)) for n, w in enumerate(LIGHTING)),
    ]:
        if np.count_nonzero(rows) < _LEAST:
            continue
        drawn = Drawn(_design(package[rows], places))
        for n, word in enumerate(CATEGORIES):
            chosen = category[rows] == n
            if chosen.any():
                share = share_of(drawn, chosen)
                found.append(ClassShare(group, word, int(chosen.sum()), share, of_fleet.get(word)))
    return found


def _error_figures(rows: StudiedHeights, places: _Places) -> list[ErrorFigure]:
    """Bias, MAE, RMSE and SD of roofs against their makers' heights, by the draw: of errors, not fleets."""
    known = np.isfinite(rows.reference_m)
    found = []
    for group, wanted in [
        ("overall", known),
        *((w, known & (rows.lighting == n)) for n, w in enumerate(LIGHTING)),
    ]:
        chosen = _where(rows, wanted)
        n = len(chosen.height_m)
        if n < _LEAST:
            continue
        error = chosen.height_m - chosen.reference_m
        sample = _sample(chosen)
        shared: tuple[SharedErrors, ...] = sample.shared
        drawn = Drawn(_design(chosen.package, places), shared)
        found += [ErrorFigure(group, name, n, value) for name, value in _figures_of(error, drawn).items()]
    return found


def _figures_of(error: Floats, drawn: Drawn) -> dict[str, StudyFigure]:
    share = drawn.design.weight / drawn.design.weight.sum()
    bias, mae = float(share @ error), float(share @ np.abs(error))
    square = float(share @ error**2)
    sd2 = max(square - bias**2, 1e-18)
    return {
        "bias_m": drawn.figure(bias, error - bias, height=True),
        "mae_m": drawn.figure(mae, np.abs(error) - mae),
        "rmse_m": drawn.figure(np.sqrt(square), (error**2 - square) / (2.0 * np.sqrt(max(square, 1e-18)))),
        "sd_m": drawn.figure(np.sqrt(sd2), ((error - bias) ** 2 - sd2) / (2.0 * np.sqrt(sd2))),
    }
