"""Building an export: every table in the order of the package, then what is drawn of them, and the seal."""

from dataclasses import dataclass

from sightline.export.contents import about_of, describe_package
from sightline.export.derived import draw_derived_files
from sightline.export.filling import Filling, Tell
from sightline.export.package_tables import PACKAGE, tables_of
from sightline.export.page import write_audit_script, write_page
from sightline.export.query import audit_pages, count_measurements, most_frames
from sightline.export.report.words import selection_words
from sightline.export.seal import CHECKPOINT, sealed_hashes
from sightline.export.store import seal_package
from sightline.infra.audit import trail
from sightline.infra.audit.checkpoints import checkpoint_of_chain, sign_checkpoint
from sightline.infra.audit.records import AuditHead, survey_chain
from sightline.infra.audit.signing import signing_key
from sightline.infra.csv_package.audit import AUDIT
from sightline.infra.csv_package.files import Staging
from sightline.infra.csv_package.parquet import write_parquet
from sightline.infra.csv_package.schema import DESCRIPTION, json_bytes
from sightline.infra.database import Session
from sightline.infra.services import Services
from sightline.media.store.local import check_room
from sightline.messages import SOURCE
from sightline.messages.said import Said
from sightline.results.selection import Selection
from sightline.surveys.store import get_survey

# Of one measurement with its revisions, budget and audit events, uncompressed; of one crop.
_ROW_BYTES, _CROP_BYTES = 6_000, 60_000


def ignore_progress(_fraction: float, _words: Said) -> None:
    """Progress that nobody follows."""


@dataclass(frozen=True)
class Built:
    """What was written; `head` is the end of the audit chain that the package carries."""

    head: AuditHead
    measurements: int
    vehicles: int
    crops: int


def build(
    staging: Staging,
    session: Session,
    survey_id: int,
    services: Services,
    tell: Tell = ignore_progress,
    *,
    crops: bool = True,
    selection: Selection = Selection(),
    language: str = SOURCE,
    actor: int | None = None,
) -> Built:
    """Write the whole package of a survey, as one transaction sees it, and seal it in the audit chain.

    Its tables are of the whole survey, statistics, figures and report of `selection`, the last
    two in `language`.

    `services` give photographs and, with `crops`, the pictures that were clicked on. Raises NotFound, NoRoom,
    Damaged for a photograph that is gone, and whatever `tell` raises to stop.
    """
    survey = get_survey(session, survey_id)
    count = count_measurements(session, survey_id)
    needed = count * (_ROW_BYTES + (_CROP_BYTES if crops else 0))
    check_room(staging.folder, needed)
    most = most_frames(session, survey_id)
    filling = Filling(
        staging=staging,
        session=session,
        survey=survey,
        services=services,
        tell=tell,
        selection=selection,
        most=most,
        count=count,
        with_crops=crops,
    )
    for part in PACKAGE:
        part.fill(filling)
    for path, content in draw_derived_files(staging.files(), filling.statistics, staging.written, language):
        staging.add(path, content)
    about = about_of(survey.name, survey.site, survey.description, filling.moment, selection_words(selection))
    tables = tables_of(most)
    write_parquet(staging, tables)
    write_page(staging, tables, language)
    staging.add(DESCRIPTION, json_bytes(describe_package(about, language, tables, staging.written)))
    key = signing_key(services.settings)
    ends = {name: one for name, one in trail.heads(session).items() if name in ("people", "catalogue")}
    with services.writing() as writing:
        head = _seal(filling, writing, ends, actor)
        signed = sign_checkpoint(writing, key, actor=actor)
        chain = survey_chain(survey_id)
        staging.add(CHECKPOINT, json_bytes(checkpoint_of_chain(writing, signed, chain)))
    write_audit_script(staging)
    staging.add_checksums()
    return Built(head, filling.measurements, filling.vehicles, filling.crops)


def _seal(filled: Filling, session: Session, ends: dict[str, AuditHead], actor: int | None) -> AuditHead:
    """What came into the chain meanwhile, then the event that names every file; the chain's end.

    `ends`: those of the chains of people and of the catalogue, whose names and sizes the tables repeat.
    """
    staging, survey_id, as_of = filled.staging, filled.survey.id, filled.as_of
    files_before = dict(staging.written)
    with staging.continued(AUDIT, filled.events) as table:
        for page in audit_pages(session, survey_id, as_of):
            for event in page:
                table.add(event)
        files = sealed_hashes(files_before, table.written().sha256)
        told = {"as_of": as_of, "files": files, "chains": ends}
        number = seal_package(session, survey_id, told, actor=actor)
        ((event,),) = audit_pages(session, survey_id, number - 1)
        table.add(event)
    return AuditHead(number, str(event["hash"]))
