"""Exports: the CSV package for a standards body."""

import re
from dataclasses import dataclass
from datetime import date
from typing import Annotated, get_args

from fastapi import APIRouter
from fastapi.responses import FileResponse
from pydantic import Field

from sightline.enums import Category, ClassSet, LengthUnit, Lighting
from sightline.export import store
from sightline.export.export_job import request_export
from sightline.export.records import Export, ExportFacts
from sightline.export.report.conclusion import conclude
from sightline.export.report.said import speaking
from sightline.infra.audit.signing import signing_key
from sightline.infra.by_name import filled_from
from sightline.infra.web.bodies import In, JobBody, Out, example
from sightline.infra.web.deps import AskedIn, Exporter, PathId, Reading, SurveysSeen, Viewer, Wired, Writing
from sightline.recordings.bodies import HourFrom, HourTo
from sightline.results.overview.package_query import changes_since_packages
from sightline.results.overview.records import ChangesSince
from sightline.results.selection import selection_of
from sightline.results.survey_statistics import Filter, survey_statistics
from sightline.surveys.store import get_survey

router = APIRouter()


class WantedBody(In):
    """Statistics, figures and report are of the vehicles chosen; all where nothing is."""

    model_config = example(crops=True, lighting="daytime", class_sets=["passenger_cars"])

    crops: bool = Field(True, description="With the pictures that were clicked on.")
    lighting: Lighting | None = None
    class_sets: Annotated[tuple[ClassSet, ...], Field(max_length=len(get_args(ClassSet)))] = ()
    categories: Annotated[tuple[Category, ...], Field(max_length=len(get_args(Category)))] = ()
    filmed_from: Annotated[date | None, Field(description="By the clocks of the place.")] = None
    filmed_to: Annotated[date | None, Field(description="The last day, included.")] = None
    hour_from: HourFrom = None
    hour_to: HourTo = None
    language: Annotated[
        str | None,
        Field(max_length=20, description="Of figures and report; that of the request where it is not said."),
    ] = None


@dataclass(frozen=True, slots=True, kw_only=True)
class ExportBody(ExportFacts):
    signing_key: Annotated[str, Field(description="The installation's key in force, which signs packages.")]
    url: str
    filename: Annotated[str, Field(description="What the downloaded file is called.")]
    since: Annotated[ChangesSince, Field(description="Added or changed since: it is not in the package.")]


class ConclusionBody(Out):
    sentences: Annotated[tuple[str, ...], Field(description="As the report and the package open.")]


def filename_of(made: Export, survey: str) -> str:
    """The name of a package's file after its survey's, in plain letters."""
    plain = re.sub(r"[^A-Za-z0-9]+", "-", survey).strip("-").lower() or "survey"
    return f"sightline-{plain}-{made.id}.zip"


@router.post("/surveys/{survey_id}/exports", status_code=202)
def make_export(
    survey_id: PathId, who: Exporter, session: Writing, asked_in: AskedIn, wanted: WantedBody | None = None
) -> JobBody:
    """Build the package in the background."""
    wanted = wanted or WantedBody(crops=True)
    selection = selection_of(wanted.model_dump(exclude={"crops", "language"}))
    job = request_export(
        session,
        survey_id,
        crops=wanted.crops,
        selection=selection,
        language=wanted.language or asked_in,
        actor=who.id,
    )
    return JobBody.model_validate(job)


@router.get("/surveys/{survey_id}/conclusion")
def conclude_survey(
    survey_id: PathId,
    who: Viewer,
    session: Reading,
    seen: SurveysSeen,
    asked_in: AskedIn,
    unit: LengthUnit = "m",
) -> ConclusionBody:
    """What the accepted heights of a survey come to, in words."""
    found = survey_statistics(session, Filter(survey_ids=(survey_id,), seen=seen))
    with speaking(asked_in):
        return ConclusionBody(sentences=conclude(found, unit))


@router.get("/surveys/{survey_id}/exports")
def list_exports(survey_id: PathId, who: Viewer, services: Wired, session: Reading) -> list[ExportBody]:
    """The packages that were made of a survey, newest first."""
    name, key = get_survey(session, survey_id).name, signing_key(services.settings).public
    packages = store.list_exports(session, survey_id)
    since = changes_since_packages(session, [package.id for package in packages])
    return [
        filled_from(
            ExportBody,
            package,
            signing_key=key,
            url=f"/api/exports/{package.id}.zip",
            filename=filename_of(package, name),
            since=since[package.id],
        )
        for package in packages
    ]


@router.get("/exports/{export_id}.zip", response_class=FileResponse)
def download_export(export_id: PathId, who: Exporter, services: Wired) -> FileResponse:
    """One package as it was made."""
    with services.reading() as session:
        made = store.get_export(session, export_id)
        name = get_survey(session, made.survey_id).name
    path = services.media.local_path(made.media_key)
    return FileResponse(path, media_type="application/zip", filename=filename_of(made, name))
