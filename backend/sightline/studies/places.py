"""The sites of a study and how they were drawn: strata, how many sites each has, their traffic."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from sightline.arrays import Floats, Ints
from sightline.errors import BadInput
from sightline.statistics.survey_design import Design
from sightline.studies.records import SiteFacts, StudiedSurvey

_ONE_STRATUM = "all"


@dataclass(frozen=True, eq=False)
class Places:
    """The sites of the study: names (J,), the site of each survey (P,), the stratum of each site (J,), how
    many sites each stratum has (H,), each site's traffic (J,) or None.
    """

    names: list[str]
    strata: list[str]
    of_survey: Ints
    stratum: Ints
    sites_there: Floats
    traffic: Floats | None


def places_of(surveys: Sequence[StudiedSurvey], sites: Mapping[str, SiteFacts] | None) -> Places:
    """Where the surveys stand; without facts all sites are one stratum of very many. Raises BadInput."""
    names = sorted({one.site for one in surveys})
    facts = {name: SiteFacts(_ONE_STRATUM, np.inf, None) for name in names} if sites is None else dict(sites)
    for name in names:
        if name not in facts:
            raise BadInput("studies-site-missing", site=name)
    strata = sorted({facts[name].stratum for name in names})
    stratum = np.array([strata.index(facts[name].stratum) for name in names], dtype=np.int64)
    there = np.array([next(facts[n].sites_there for n in names if facts[n].stratum == s) for s in strata])
    for h, count in enumerate(np.bincount(stratum)):
        if count > there[h]:
            raise BadInput("studies-too-many-sites", stratum=strata[h], count=int(count), there=there[h])
    traffic = [facts[name].traffic for name in names]
    return Places(
        names=names,
        strata=strata,
        of_survey=np.array([names.index(one.site) for one in surveys], dtype=np.int64),
        stratum=stratum,
        sites_there=there,
        traffic=None if any(one is None for one in traffic) else np.array(traffic, dtype=np.float64),
    )


def design_of(package: Ints, places: Places) -> Design:
    """Each vehicle stands for the traffic of its site and the sites that its stratum has to each one seen."""
    site = places.of_survey[package]
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
