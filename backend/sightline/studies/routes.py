"""Studies: surveys of this installation joined, their figures, packages and reports."""

import re

from fastapi import APIRouter, Response
from fastapi.responses import FileResponse

from sightline.errors import BadInput
from sightline.infra.by_name import filled_from
from sightline.infra.database import Session
from sightline.infra.database.rows import missing
from sightline.infra.jobs.store import get_job
from sightline.infra.services import Services
from sightline.infra.web.bodies import JobBody
from sightline.infra.web.deps import (
    AskedIn,
    Exporter,
    Operator,
    OperatorInPerson,
    PathId,
    Reading,
    Viewer,
    Wired,
    Writing,
)
from sightline.infra.web.person import Person
from sightline.studies import store
from sightline.studies.beside import shared_surveys, study_differences
from sightline.studies.bodies import (
    BesideBody,
    FiguresBody,
    ListedStudy,
    NewStudy,
    Openness,
    ResultBody,
    StudyBody,
    StudyChange,
    StudyMembersBody,
    StudyPage,
    StudySurveyBody,
)
from sightline.studies.document import consequence_in
from sightline.studies.members_store import (
    add_study_member,
    is_open_to_all,
    list_study_members,
    list_study_others,
    open_study_to_all,
    remove_study_member,
    require_surveys,
    sees_result,
)
from sightline.studies.records import StoredStudy, StudyFacts, StudyResult
from sightline.studies.stored import ask_to_compute, check_study_facts, heads_of
from sightline.surveys.members.store import roles_by_thing, seen_studies
from sightline.surveys.store import survey_names

router = APIRouter()


@router.get("/studies")
def list_studies(who: Viewer, session: Reading) -> list[ListedStudy]:
    """The studies that the person sees, newest first."""
    seen = seen_studies(session, who)
    return [
        _listed(session, who, one) for one in store.list_studies(session) if seen is None or one.id in seen
    ]


@router.post("/studies", status_code=201)
def add_study(body: NewStudy, who: Operator, session: Writing) -> StudyBody:
    """A new study of surveys that the person sees, seen by whoever made it; nothing is computed yet."""
    made = store.create_study(
        session, check_study_facts(session, _require_seen_surveys(session, who, body.record())), actor=who.id
    )
    add_study_member(session, made.id, who.id, actor=who.id)
    return _body(session, made)


@router.get("/studies/{study_id}")
def get_study(study_id: PathId, who: Viewer, session: Reading, asked_in: AskedIn) -> StudyPage:
    """A study with what was computed of it last."""
    study = store.get_study(session, study_id)
    result = _newest(session, who, study_id)
    job = None if study.job_id is None else JobBody.model_validate(get_job(session, study.job_id))
    return StudyPage(
        study=_body(session, study),
        result=None if result is None else _result(session, study, result, asked_in),
        job=job,
    )


@router.put("/studies/{study_id}")
def change_study(study_id: PathId, body: StudyChange, who: Operator, session: Writing) -> StudyBody:
    """Put other facts in their place; what was computed stays until it is computed again."""
    before = _worked_on(session, who, study_id)
    facts = check_study_facts(session, _require_seen_surveys(session, who, body.record()))
    if is_open_to_all(session, study_id):
        known = {one.survey_id for one in before.facts.surveys}
        added = [one.survey_id for one in facts.surveys if one.survey_id not in known]
        require_surveys(session, who, added, "manager")
    return _body(session, store.update_study(session, study_id, facts, version=body.version, actor=who.id))


@router.delete("/studies/{study_id}", status_code=204)
def remove_study(study_id: PathId, version: int, who: Operator, session: Writing) -> Response:
    """Take it from the list; its results stay stored."""
    _worked_on(session, who, study_id)
    store.remove_study(session, study_id, version=version, actor=who.id)
    return Response(status_code=204)


@router.post("/studies/{study_id}/computings", status_code=202)
def compute_study(study_id: PathId, who: Operator, session: Writing, asked_in: AskedIn) -> JobBody:
    """Compute figures, package and report in the background, the report in the language of the request."""
    _worked_on(session, who, study_id)
    return JobBody.model_validate(ask_to_compute(session, study_id, language=asked_in, actor=who.id))


@router.get("/studies/{study_id}/beside/studies/{other_id}")
def compare_studies(study_id: PathId, other_id: PathId, who: Viewer, session: Reading) -> BesideBody:
    """A study's figures less those of another, both as they were computed last, with total intervals."""
    (second, newer), (first, older) = (_computed(session, who, one) for one in (study_id, other_id))
    if study_id == other_id:
        raise BadInput("studies-compared-with-itself", name=second.facts.name)
    names = survey_names(session)
    return BesideBody(
        first=first.facts.name,
        second=second.facts.name,
        shared_surveys=[names[one][0] for one in shared_surveys(older, newer)],
        differences=study_differences(older, newer),
    )


@router.get("/studies/{study_id}/results/{result_id}.zip", response_class=FileResponse)
def download_study(study_id: PathId, result_id: PathId, who: Exporter, services: Wired) -> FileResponse:
    """The study as `sightline study` writes it."""
    study, result = _get_seen_result(services, who, study_id, result_id)
    return _file(services, result.media_key, "application/zip", f"{_file_name(study)}-{result_id}.zip")


@router.get("/studies/{study_id}/results/{result_id}.pdf", response_class=FileResponse)
def download_report(study_id: PathId, result_id: PathId, who: Exporter, services: Wired) -> FileResponse:
    """The report of the study."""
    study, result = _get_seen_result(services, who, study_id, result_id)
    return _file(services, result.report_key, "application/pdf", f"{_file_name(study)}-{result_id}.pdf")


def _require_seen_surveys(session: Session, who: Person, facts: StudyFacts) -> StudyFacts:
    """The same. Raises NotFound for a survey that the person does not see."""
    roles = roles_by_thing(session, who, "surveys", [one.survey_id for one in facts.surveys])
    for one in facts.surveys:
        if one.survey_id not in roles:
            raise missing("survey", one.survey_id)
    return facts


@router.get("/studies/{study_id}/members")
def list_members_of_study(study_id: PathId, who: Viewer, session: Reading) -> StudyMembersBody:
    """Who sees the study beside administrators."""
    return _members(session, study_id)


@router.put("/studies/{study_id}/members/{person_id}")
def add_member_of_study(
    study_id: PathId, person_id: PathId, who: OperatorInPerson, session: Writing
) -> StudyMembersBody:
    """Let a person see the study while they see each of its surveys; their account's role counts there."""
    _worked_on(session, who, study_id)
    add_study_member(session, study_id, person_id, actor=who.id)
    return _members(session, study_id)


@router.delete("/studies/{study_id}/members/{person_id}")
def remove_member_of_study(
    study_id: PathId, person_id: PathId, who: OperatorInPerson, session: Writing
) -> StudyMembersBody:
    """Take a person out; what they did stays theirs."""
    _worked_on(session, who, study_id)
    remove_study_member(session, study_id, person_id, actor=who.id)
    return _members(session, study_id)


@router.put("/studies/{study_id}/open-to-all")
def open_study(study_id: PathId, body: Openness, who: OperatorInPerson, session: Writing) -> StudyMembersBody:
    """Open it to everybody who signs in, or close it to all but members and administrators.

    Who opens it manages each survey that it takes or that went into a result of it.
    """
    study = _worked_on(session, who, study_id)
    if body.open_to_all:
        shown = {one.survey_id for one in study.facts.surveys} | store.surveys_of_results(session, study_id)
        require_surveys(session, who, sorted(shown), "manager")
    open_study_to_all(session, study_id, body.open_to_all, actor=who.id)
    return _members(session, study_id)


def _members(session: Session, study_id: int) -> StudyMembersBody:
    return StudyMembersBody(
        open_to_all=is_open_to_all(session, study_id),
        members=list_study_members(session, study_id),
        others=list_study_others(session, study_id),
    )


def _worked_on(session: Session, who: Person, study_id: int) -> StoredStudy:
    """A study that is changed or computed. Raises NotAllowed for who does not see all its surveys."""
    study = store.get_study(session, study_id)
    require_surveys(session, who, (one.survey_id for one in study.facts.surveys))
    return study


def _newest(session: Session, who: Person, study_id: int) -> StudyResult | None:
    """What was computed last, if anything, and the person sees each survey that went into it."""
    found = store.newest_result(session, study_id)
    return found if found is not None and sees_result(session, who, found) else None


def _computed(session: Session, who: Person, study_id: int) -> tuple[StoredStudy, StudyResult]:
    """Raises BadInput for a study without figures."""
    study, result = store.get_study(session, study_id), _newest(session, who, study_id)
    if result is None:
        raise BadInput("studies-compared-without-figures", name=study.facts.name)
    return study, result


def _get_seen_result(
    services: Services, who: Person, study_id: int, result_id: int
) -> tuple[StoredStudy, StudyResult]:
    with services.reading() as session:
        study = store.get_study(session, study_id)
        result = store.get_study_result(session, study_id, result_id)
        if not sees_result(session, who, result):
            raise missing("result", result_id)
        return study, result


def _file(services: Services, key: str, kind: str, name: str) -> FileResponse:
    return FileResponse(services.media.local_path(key), media_type=kind, filename=name)


def _file_name(study: StoredStudy) -> str:
    """A file's name after the study's, in plain letters."""
    plain = re.sub(r"[^A-Za-z0-9]+", "-", study.facts.name).strip("-").lower() or "study"
    return f"sightline-study-{plain}"


def _body(session: Session, study: StoredStudy) -> StudyBody:
    names = survey_names(session)
    surveys = (filled_from(StudySurveyBody, one, name=names[one.survey_id][0]) for one in study.facts.surveys)
    return filled_from(StudyBody, study, study.facts, surveys=tuple(surveys))


def _listed(session: Session, who: Person, study: StoredStudy) -> ListedStudy:
    result = _newest(session, who, study.id)
    return filled_from(
        ListedStudy,
        study,
        study.facts,
        surveys=len(study.facts.surveys),
        sites=len({one.site for one in study.facts.surveys}),
        heights=None if result is None else int(result.document["heights"]),
        computed_at=None if result is None else result.created_at,
    )


def _result(session: Session, study: StoredStudy, result: StudyResult, language: str) -> ResultBody:
    names, heads = survey_names(session), heads_of(session, result.heads)
    changed = [names[one][0] for one, head in result.heads.items() if heads[one] != head]
    base = f"/api/studies/{study.id}/results/{result.id}"
    sentence = consequence_in(result.document, language)
    return filled_from(
        ResultBody,
        result,
        study_changed=result.study_version != study.version,
        surveys_changed=changed,
        package_url=f"{base}.zip",
        report_url=f"{base}.pdf",
        found=FiguresBody.model_validate({**result.document, "consequence": sentence}),
    )
