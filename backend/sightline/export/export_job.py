"""Exports: the package of a survey as one transaction saw it, built in the background, kept and listed."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sightline.errors import BadInput
from sightline.export.store import add_export
from sightline.infra.csv_package.files import Staging, zip_folder
from sightline.infra.database import Session
from sightline.infra.jobs import registry
from sightline.infra.jobs.records import Job
from sightline.media.store.local import check_room, key_of, sha256_of
from sightline.messages import SOURCE, languages
from sightline.messages.said import Said
from sightline.results.selection import Selection, selection_of
from sightline.surveys.records import Survey
from sightline.surveys.store import get_survey, list_surveys

if TYPE_CHECKING:
    from sightline.export.build import Built
    from sightline.export.filling import Tell

KIND = "export"
_BUILT, _ZIPPED = 0.85, 0.97  # of the whole work, by progress


def find_survey(session: Session, name: str) -> Survey:
    """A survey by its name, or by its number where no survey has that name. Raises BadInput, also where
    several have it, and NotFound.
    """
    known = [survey for survey in list_surveys(session) if survey.name == name]
    if len(known) > 1:
        numbers = ", ".join(str(one.id) for one in known)
        raise BadInput("import-survey-name-twice", survey=name, numbers=numbers)
    if not known and name.isdigit():
        return get_survey(session, int(name))
    if not known:
        raise BadInput("surveys-no-survey", name=name)
    return known[0]


def request_export(
    session: Session,
    survey_id: int,
    *,
    crops: bool = True,
    selection: Selection = Selection(),
    language: str = SOURCE,
    actor: int | None,
) -> Job:
    """Queue an export, with or without pictures of the clicks, of all vehicles or some, its report in a
    language of the catalogue. Raises NotFound, BadInput.
    """
    check_language(language)
    selection.require_sense()
    get_survey(session, survey_id)
    payload = {"survey_id": survey_id, "crops": crops, "selection": selection.stored(), "language": language}
    return registry.enqueue(session, KIND, payload, survey_id=survey_id, actor=actor)


def check_language(language: str) -> None:
    """Raises BadInput for a language that the catalogue is not written in."""
    if language not in languages():
        raise BadInput("no-such-language", language=language, known=", ".join(languages()))


@registry.handler(KIND, long=True)
def export(context: registry.JobContext) -> registry.Outcome:
    """Build the package, keep it in the media store, and note it with the head of the audit chain."""
    survey_id = int(context.payload["survey_id"])
    services = context.services
    asked: dict[str, Any] = {
        "selection": selection_of(context.payload.get("selection", {})),
        "language": str(context.payload.get("language", SOURCE)),
    }
    context.progress(0.0, Said("job-export-reading"))
    with tempfile.TemporaryDirectory(prefix="export-", dir=services.scratch) as folder:
        built, package = _package(context, survey_id, asked, Path(folder))
        context.progress(_ZIPPED, Said("job-export-storing"))
        size, sha256 = package.stat().st_size, sha256_of(package)
        key = key_of(sha256, ".zip")
        services.media.put_file(key, package, link=True)
    result = {"measurements": built.measurements, "vehicles": built.vehicles, "crops": built.crops}

    def store(session: Session) -> Mapping[str, Any]:
        stored = add_export(
            session,
            survey_id,
            media_key=key,
            size_bytes=size,
            sha256=sha256,
            head=built.head,
            **asked,
            actor=context.actor,
        )
        return {"export_id": stored.id, **result}

    return store


def _package(
    context: registry.JobContext, survey_id: int, asked: Mapping[str, Any], folder: Path
) -> tuple[Built, Path]:
    """Build and pack; the ZIP is written beside the files and takes their place.

    Here the figures' and the report's libraries are loaded: a server that starts has no use for them.
    """
    from sightline.export.build import build

    services, tell = context.services, _within(context.progress, _BUILT)
    staging = Staging(folder / "package")
    staging.folder.mkdir()
    with services.reading() as session:
        built = build(
            staging,
            session,
            survey_id,
            services,
            tell,
            crops=bool(context.payload.get("crops", True)),
            **asked,
            actor=context.actor,
        )
    check_room(folder, 2 * sum(one.size for one in staging.written.values()))
    package = folder / "package.zip"
    zip_folder(
        staging, package, lambda part: tell(1.0 + part * (_ZIPPED / _BUILT - 1.0), Said("job-export-packing"))
    )
    return built, package


def _within(tell: Tell, most: float) -> Tell:
    return lambda fraction, words: tell(most * fraction, words)
