"""The job that computes a study: its figures, its package and its report, stored together or not at all."""

import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from sightline.infra.database import Session
from sightline.infra.jobs import registry
from sightline.media.store.local import key_of, sha256_of
from sightline.messages import SOURCE
from sightline.messages.said import Said
from sightline.people.store import get_person
from sightline.studies.members_store import require_surveys
from sightline.studies.store import add_study_result, get_study
from sightline.studies.stored import KIND

_COMPUTED, _PACKED = 0.85, 0.92  # of the whole work, by progress


@registry.handler(KIND, long=True)
def compute_study(context: registry.JobContext) -> registry.Outcome:
    """Compute the study that was asked for."""
    language = str(context.payload.get("language", SOURCE))
    return result_of(context, int(context.payload["study_id"]), language)


def result_of(context: registry.JobContext, study_id: int, language: str = SOURCE) -> registry.Finish:
    """Figures from one state of the database and what is made of them; what stores them; the report is in
    a language.

    Raises BadInput in one sentence where surveys, fleet and sites do not fit, NotAllowed where who asked for
    it does not see each survey any more.
    """
    # the figures' and the report's libraries: a server that starts has no use for them.
    from sightline.infra.csv_package.files import Staging, zip_folder
    from sightline.infra.database.types import now
    from sightline.studies.document import document_of
    from sightline.studies.report.report import study_report
    from sightline.studies.stored import compute
    from sightline.studies.write import write_study

    services = context.services
    with services.reading() as session:
        stored = get_study(session, study_id)
        if context.actor is not None:
            asked_by = get_person(session, context.actor)
            require_surveys(session, asked_by, (one.survey_id for one in stored.facts.surveys))
        computed = compute(
            session, stored, lambda part: context.progress(_COMPUTED * part, Said("job-study-figures"))
        )
    with tempfile.TemporaryDirectory(prefix="study-", dir=services.scratch) as name:
        folder = Path(name)
        context.progress(_COMPUTED, Said("job-study-package"))
        staging = Staging(folder / "study")
        staging.folder.mkdir()
        write_study(staging, computed.study, [])
        package = folder / "study.zip"
        zip_folder(staging, package)
        size, sha256 = package.stat().st_size, sha256_of(package)
        context.progress(_PACKED, Said("job-study-report"))
        report = folder / "report.pdf"
        report.write_bytes(study_report(stored, computed, sha256, now(), language))
        report_sha256 = sha256_of(report)
        media_key, report_key = key_of(sha256, ".zip"), key_of(report_sha256, ".pdf")
        services.media.put_file(media_key, package)
        services.media.put_file(report_key, report)
    document = {**document_of(computed), "language": language}

    def store(session: Session) -> Mapping[str, Any]:
        result = add_study_result(
            session,
            stored,
            heads=computed.heads,
            document=document,
            media_key=media_key,
            size_bytes=size,
            sha256=sha256,
            report_key=report_key,
            report_sha256=report_sha256,
            actor=context.actor,
        )
        return {"study_id": study_id, "result_id": result.id, "heights": computed.study.heights}

    return store
