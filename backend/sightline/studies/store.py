"""Studies and their results; a result is written once, a study is removed softly."""

from collections.abc import Collection, Mapping
from dataclasses import asdict
from typing import Any

from sqlalchemy import ColumnElement, func, select
from sqlalchemy.orm import Session

from sightline.enums import JsonObject
from sightline.errors import Conflict
from sightline.infra.audit import trail
from sightline.infra.audit.changing import alter_row, change_since, make_rows, take_out_row
from sightline.infra.audit.written import written_once, written_rows
from sightline.infra.by_name import record_of
from sightline.infra.database.rows import change_row, get_row, the_one
from sightline.infra.version import code_version
from sightline.studies.records import StoredStudy, StudyFacts, StudyResult, StudySurvey
from sightline.studies.tables import studies, study_results
from sightline.surveys.store import simulated_surveys

_EDITABLE = ("name", "description", "surveys", "fleet_csv", "sites_csv", "goal_m")


def create_study(
    session: Session, facts: StudyFacts, *, simulated: bool = False, actor: int | None
) -> StoredStudy:
    """A new study of facts that hold together (`stored.check_study_facts`); a simulated one is open to
    all.
    """
    content = {**_content(facts), "simulated": simulated, "open_to_all": simulated}
    (study_id,) = make_rows(session, studies, [content], survey_id=None, actor=actor)
    return get_study(session, study_id)


def get_study(session: Session, study_id: int) -> StoredStudy:
    """One study. Raises NotFound, also for a removed one."""
    row = get_row(session, studies, study_id, "study", studies.c.deleted_at.is_(None))
    return _study(row, simulated_surveys(session))


def list_studies(session: Session) -> tuple[StoredStudy, ...]:
    """Every study, newest first."""
    query = select(studies).where(studies.c.deleted_at.is_(None)).order_by(studies.c.id.desc())
    invented = simulated_surveys(session)
    return tuple(_study(row, invented) for row in session.execute(query).mappings())


def simulated_study(session: Session) -> int | None:
    """The demonstration study, also a removed one, if it was made."""
    query = select(studies.c.id).where(studies.c.simulated).limit(1)
    return session.execute(query).scalar_one_or_none()


def update_study(
    session: Session, study_id: int, facts: StudyFacts, *, version: int, actor: int | None
) -> StoredStudy:
    """Change it. Raises Conflict, naming who and when, if `version` is not the current one; NotFound."""
    alter_row(session, studies, _require_version(session, study_id, version), _content(facts), actor=actor)
    return get_study(session, study_id)


def remove_study(session: Session, study_id: int, *, version: int, actor: int | None) -> None:
    """Take it from the list; what was computed of it stays stored. Raises Conflict, NotFound."""
    take_out_row(session, studies, _require_version(session, study_id, version), actor=actor)


def note_study_job(session: Session, study_id: int, job_id: int, *, actor: int | None) -> None:
    """Its newest computing that was asked for."""
    before = get_row(session, studies, study_id, "study")
    change_row(session, studies, study_id, {"job_id": job_id})
    then = {"job_id": before["job_id"]}
    trail.record(session, actor, "request", "study", study_id, None, then, {"job_id": job_id})


def add_study_result(
    session: Session,
    study: StoredStudy,
    *,
    heads: Mapping[int, str],
    document: JsonObject,
    media_key: str,
    size_bytes: int,
    sha256: str,
    report_key: str,
    report_sha256: str,
    actor: int | None,
) -> StudyResult:
    """What was computed of a study as it stood."""
    content: dict[str, Any] = {
        "study_id": study.id,
        "study_version": study.version,
        "heads": {str(survey_id): head for survey_id, head in heads.items()},
        "document": document,
        "media_key": media_key,
        "size_bytes": size_bytes,
        "sha256": sha256,
        "report_key": report_key,
        "report_sha256": report_sha256,
        "code_version": code_version(),
    }
    result_id = written_once(session, study_results, content, "create", untold=("document",), actor=actor)
    return get_study_result(session, study.id, result_id)


def get_study_result(session: Session, study_id: int, result_id: int) -> StudyResult:
    """One result of a study. Raises NotFound."""
    return the_one(_results(session, study_id, study_results.c.id == result_id), "result", result_id)


def newest_result(session: Session, study_id: int) -> StudyResult | None:
    """What was computed last, if anything."""
    of_study = select(func.max(study_results.c.id)).where(study_results.c.study_id == study_id)
    return next(iter(_results(session, study_id, study_results.c.id == of_study.scalar_subquery())), None)


def surveys_of_results(session: Session, study_id: int) -> frozenset[int]:
    """Every survey that went into any result of a study."""
    query = select(study_results.c.heads).where(study_results.c.study_id == study_id)
    return frozenset(int(one) for heads in session.execute(query).scalars() for one in heads)


def _require_version(session: Session, study_id: int, version: int) -> dict[str, Any]:
    before = get_row(session, studies, study_id, "study", studies.c.deleted_at.is_(None))
    if changed := change_since(session, before, version):
        name, when = changed
        raise Conflict("studies-changed-meanwhile", name=name, when=when)
    return before


def _content(facts: StudyFacts) -> dict[str, Any]:
    return {**asdict(facts), "surveys": [asdict(one) for one in facts.surveys]}


def _study(row: Mapping[Any, Any], invented: Collection[int]) -> StoredStudy:
    """invented: the surveys that are simulated; a study that takes one is so too."""
    told = {name: row[name] for name in _EDITABLE}
    facts = StudyFacts(**{**told, "surveys": tuple(StudySurvey(**one) for one in row["surveys"])})
    simulated = bool(row["simulated"]) or any(one.survey_id in invented for one in facts.surveys)
    kept = ("id", "job_id", "version", "created_at", "updated_at")
    return StoredStudy(facts=facts, simulated=simulated, **{name: row[name] for name in kept})


def _results(session: Session, study_id: int, which: ColumnElement[bool]) -> list[StudyResult]:
    return [
        record_of(StudyResult, row, heads={int(survey_id): head for survey_id, head in row["heads"].items()})
        for row in written_rows(session, study_results, study_results.c.study_id == study_id, which)
    ]
