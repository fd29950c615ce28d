"""Studies of this installation's own surveys: what they say held together, and what comes out of them."""

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from sightline.errors import BadInput
from sightline.infra.audit import trail
from sightline.infra.database import Session
from sightline.infra.jobs import registry
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.store import get_job
from sightline.infra.version import code_version
from sightline.messages import SOURCE
from sightline.results.standards_store import get_standards
from sightline.studies.fleet_csv import read_fleet, read_sites
from sightline.studies.records import SiteFacts, StoredStudy, StudiedSurvey, Study, StudyFacts
from sightline.studies.service import Plan, make_study
from sightline.studies.store import get_study, note_study_job
from sightline.studies.stored_query import StoredTables, surveys_with_poses
from sightline.surveys.records import Survey
from sightline.surveys.store import get_survey

KIND = "study"
#: What a sentence calls the tables that were uploaded.
FLEET, SITES = Path("fleet.csv"), Path("sites.csv")
_FIRST_YEAR, _LAST_YEAR = 1900, 2100
Tell = Callable[[float], None]


@dataclass(frozen=True, eq=False)
class Computed:
    """What a study's computing found, and the heads of its surveys' chains."""

    study: Study
    heads: dict[int, str]


def check_study_facts(session: Session, facts: StudyFacts) -> StudyFacts:
    """The same with a site for every survey.

    Raises BadInput where it does not hold together, NotFound for a survey that is not there.
    """
    if not facts.name.strip():
        raise BadInput("studies-needs-a-name")
    if not 0.0 < facts.goal_m < 1.0:
        raise BadInput("studies-goal-of-study", goal=f"{facts.goal_m:g}")
    surveys = {one.survey_id: get_survey(session, one.survey_id) for one in facts.surveys}
    ids = [one.survey_id for one in facts.surveys]
    twice = next((one for one in ids if ids.count(one) > 1), None)
    if twice is not None:
        raise BadInput("studies-survey-stands-twice", name=surveys[twice].name)
    for one in facts.surveys:
        if one.year is not None and not _FIRST_YEAR <= one.year <= _LAST_YEAR:
            raise BadInput("studies-no-year", name=surveys[one.survey_id].name, year=one.year)
    placed = tuple(
        replace(one, site=one.site.strip() or _site(surveys[one.survey_id]), stratum=one.stratum.strip())
        for one in facts.surveys
    )
    found = replace(facts, name=facts.name.strip(), description=facts.description.strip(), surveys=placed)
    plan_of(found)
    return found


def plan_of(facts: StudyFacts) -> Plan:
    """What is asked of it. Raises BadInput for tables or strata that do not hold together."""
    fleet = read_fleet(FLEET, facts.fleet_csv) if facts.fleet_csv.strip() else None
    return Plan(fleet, _sites(facts), facts.goal_m)


def _site(survey: Survey) -> str:
    """As a package calls it."""
    return survey.site or survey.name


def _sites(facts: StudyFacts) -> Mapping[str, SiteFacts] | None:
    """By the table of sites where there is one, else by the strata that the surveys were given."""
    strata: dict[str, str] = {}
    for survey in facts.surveys:
        before = strata.setdefault(survey.site, survey.stratum)
        if before != survey.stratum:
            raise BadInput(
                "studies-two-strata", site=survey.site, first=before or "–", second=survey.stratum or "–"
            )
    if facts.sites_csv.strip():
        sites = read_sites(SITES, facts.sites_csv)
        for site, stratum in strata.items():
            if site not in sites:
                raise BadInput("studies-site-missing", site=site)
            if stratum and sites[site].stratum != stratum:
                raise BadInput("studies-two-strata", site=site, first=sites[site].stratum, second=stratum)
        return sites
    if not any(strata.values()):
        return None
    without = next((site for site, stratum in strata.items() if not stratum), None)
    if without is not None:
        raise BadInput("studies-site-without-stratum", site=without)
    return {site: SiteFacts(stratum, math.inf, None) for site, stratum in strata.items()}


def ask_to_compute(session: Session, study_id: int, *, language: str = SOURCE, actor: int | None) -> Job:
    """Queue its computing, with a report in a language; the job that waits already, where there is one.

    Raises NotFound, BadInput for a study without surveys.
    """
    study = get_study(session, study_id)
    if not study.facts.surveys:
        raise BadInput("studies-has-no-survey")
    if study.job_id is not None:
        before = get_job(session, study.job_id)
        if before.state == "queued":
            return before
    payload = {"study_id": study_id, "language": language}
    job = registry.enqueue(session, KIND, payload, survey_id=None, study_id=study_id, actor=actor)
    note_study_job(session, study_id, job.id, actor=actor)
    return job


def compute(session: Session, stored: StoredStudy, tell: Tell) -> Computed:
    """All that comes out of a study. Raises BadInput where surveys, fleet and sites do not fit."""
    ids = [one.survey_id for one in stored.facts.surveys]
    if not ids:
        raise BadInput("studies-has-no-survey")
    heads = heads_of(session, ids)
    surveys = _surveys(session, stored.facts, heads)
    asked = replace(plan_of(stored.facts), curves=True)
    tell(0.0)
    tables = StoredTables(session, ids)
    return Computed(make_study(surveys, tables, asked, tell), heads)


def heads_of(session: Session, survey_ids: Iterable[int]) -> dict[int, str]:
    """The last hash of each survey's audit chain."""
    return {survey_id: trail.head(session, survey_id).hash for survey_id in survey_ids}


def _surveys(session: Session, facts: StudyFacts, heads: Mapping[int, str]) -> list[StudiedSurvey]:
    posed = surveys_with_poses(session, [entry.survey_id for entry in facts.surveys])
    studied = []
    for entry in facts.surveys:
        survey = get_survey(session, entry.survey_id)
        name = survey.name
        if entry.survey_id not in posed:
            raise BadInput("studies-survey-without-poses", place=name)
        studied.append(
            StudiedSurvey(
                place=f"survey {entry.survey_id}",
                name=name,
                site=entry.site,
                made_with=code_version(),
                standards=get_standards(session, entry.survey_id).standards,
                head=heads[entry.survey_id],
                year=entry.year,
                simulated=survey.simulated,
            )
        )
    return studied
