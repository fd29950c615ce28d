"""Surveys: their words, traffic, place and insets."""

from collections.abc import Mapping
from dataclasses import asdict, replace
from typing import Any

from sqlalchemy import select
from sqlalchemy.orm import Session

from sightline.enums import AskedTarget
from sightline.errors import BadInput, Conflict
from sightline.geometry.sides import TrafficFacts
from sightline.infra.audit import trail
from sightline.infra.audit.changing import change_since
from sightline.infra.by_name import record_of
from sightline.infra.database.rows import add_row, change_row, get_row
from sightline.infra.database.types import now
from sightline.infra.web.person import Seen
from sightline.statistics.sampling import MOST_HEADWAY_S, MOST_STEP, Quota, Sampling
from sightline.surveys.classes import USUAL_CLASSES, VehicleClass, classes_of, stored_classes
from sightline.surveys.place import PLACE, Place, checked_place
from sightline.surveys.records import USUAL, Asked, Inset, Survey, SurveyContent, insets_of
from sightline.surveys.tables import surveys

TRAFFIC = ("traffic_side", "steering_side", "camera_place")
EDITABLE = ("name", "site", "description", *TRAFFIC, *PLACE, "asked", "classes", "sampling", "insets")


def create_survey(
    session: Session,
    *,
    name: str,
    site: str = "",
    description: str = "",
    traffic: TrafficFacts = TrafficFacts(),
    place: Place = Place(),
    asked: Asked = Asked(),
    is_demo: bool = False,
    simulated: bool = False,
    open_to_all: bool = False,
    actor: int | None,
) -> Survey:
    """A new, empty survey without members, with the usual classes, sample and insets; simulated: no figure of
    it says anything of real roads. Raises BadInput without a name.
    """
    moment = now()
    survey = SurveyContent(
        name=name,
        site=site,
        description=description,
        traffic=traffic,
        place=place,
        asked=asked,
        classes=USUAL_CLASSES,
        sampling=Sampling(),
    )
    content = _content(survey, {})
    stamps = {"created_at": moment, "created_by": actor, "updated_at": moment, "updated_by": actor}
    content |= {"open_to_all": open_to_all, "simulated": simulated}
    survey_id = add_row(session, surveys, {**content, **stamps, "is_demo": is_demo, "version": 1})
    trail.record(session, actor, "create", "survey", survey_id, survey_id, None, content)
    return get_survey(session, survey_id)


def get_survey(session: Session, survey_id: int) -> Survey:
    """One survey. Raises NotFound."""
    return _survey(get_row(session, surveys, survey_id, "survey"))


def list_surveys(session: Session, seen: Seen = None) -> tuple[Survey, ...]:
    """Every survey that a person sees, newest first."""
    query = select(surveys).order_by(surveys.c.id.desc())
    if seen is not None:
        query = query.where(surveys.c.id.in_(seen))
    return tuple(_survey(dict(row)) for row in session.execute(query).mappings())


def simulated_surveys(session: Session) -> set[int]:
    """Those of whom no figure says anything of real roads."""
    return set(session.execute(select(surveys.c.id).where(surveys.c.simulated)).scalars())


def survey_names(session: Session) -> dict[int, tuple[str, str]]:
    """(name, site) of every survey by id, newest first."""
    query = select(surveys.c.id, surveys.c.name, surveys.c.site).order_by(surveys.c.id.desc())
    return {row.id: (row.name, row.site) for row in session.execute(query)}


def classes_of_surveys(session: Session) -> dict[int, tuple[VehicleClass, ...]]:
    """The classes of vehicles of every survey by id."""
    rows = session.execute(select(surveys.c.id, surveys.c.classes))
    return {row.id: classes_of(row.classes) for row in rows}


def demo_survey_id(session: Session) -> int | None:
    """The demonstration survey, if it was made."""
    query = select(surveys.c.id).where(surveys.c.is_demo).order_by(surveys.c.id.desc()).limit(1)
    return session.execute(query).scalar_one_or_none()


def update_survey(session: Session, changed: Survey, *, actor: int | None) -> Survey:
    """Change what people say of it. Raises Conflict, naming who and when, where `changed` is not current."""
    before = get_row(session, surveys, changed.id, "survey")
    if by := change_since(session, before, changed.version):
        raise Conflict("surveys-changed-meanwhile", name=by[0], when=by[1])
    content = _content(changed, _with_codes_of(changed.insets, insets_of(before["insets"])))
    stamps = {"version": changed.version + 1, "updated_at": now(), "updated_by": actor}
    change_row(session, surveys, changed.id, {**content, **stamps})
    what = trail.changed_fields(before, content, EDITABLE)
    trail.record(session, actor, "update", "survey", changed.id, changed.id, *what)
    return get_survey(session, changed.id)


def _content(survey: SurveyContent, insets: Mapping[str, Inset]) -> dict[str, Any]:
    if not survey.name.strip():
        raise BadInput("surveys-no-name")
    if not survey.asked.daytime or not survey.asked.low_light:
        raise BadInput("surveys-asks-nothing")
    for target, inset in insets.items():
        if target not in USUAL or not inset.u_inset_m >= 0:
            raise BadInput("surveys-inset-unusable", target=target)
    whole = {**USUAL, **insets}
    return {
        "name": survey.name.strip(),
        "site": survey.site.strip(),
        "description": survey.description.strip(),
        **asdict(survey.traffic),
        **asdict(checked_place(survey.place)),
        "asked": {lighting: list(dict.fromkeys(found)) for lighting, found in asdict(survey.asked).items()},
        "classes": stored_classes(survey.classes),
        "sampling": stored_sampling(survey.sampling),
        "insets": {target: asdict(inset) for target, inset in whole.items()},
    }


def _with_codes_of(insets: Mapping[str, Inset], before: Mapping[str, Inset]) -> dict[str, Inset]:
    """Each with its code while its note is the program's, whether or not it was sent along."""
    known = [(one.code, one.note) for one in (*USUAL.values(), *before.values()) if one.code]
    own = {note: code for code, note in reversed(known)}

    def code_of(name: str, inset: Inset) -> str | None:
        if inset.code is None:
            return name if (name, inset.note) in known else own.get(inset.note)
        return inset.code if (inset.code, inset.note) in known else None

    return {name: replace(one, code=code_of(name, one)) for name, one in insets.items()}


def _survey(row: Mapping[str, Any]) -> Survey:
    return record_of(
        Survey,
        row,
        traffic=traffic_of_row(row),
        place=Place(**{name: row[name] for name in PLACE}),
        asked=asked_of(row["asked"]),
        classes=classes_of(row["classes"]),
        sampling=sampling_of(row["sampling"]),
        insets=insets_of(row["insets"]),
    )


def traffic_of_row(row: Mapping[Any, Any]) -> TrafficFacts:
    """The traffic of a survey, from its row or one joined with it."""
    return TrafficFacts(**{name: row[name] for name in TRAFFIC})


def asked_of(stored: Mapping[str, list[AskedTarget]]) -> Asked:
    """What a survey asks for, as its column holds it."""
    return Asked(tuple(stored["daytime"]), tuple(stored["low_light"]))


def sampling_of(stored: Mapping[str, Any]) -> Sampling:
    """Which passes a survey takes, as its column holds it."""
    return Sampling(**{**stored, "quotas": tuple(Quota(**one) for one in stored["quotas"])})


def stored_sampling(sampling: Sampling) -> dict[str, Any]:
    """A rule as its column and the chain hold it. Raises BadInput if it takes nothing or a quota twice."""
    if not 1 <= sampling.step <= MOST_STEP or not 1 <= sampling.start <= sampling.step:
        raise BadInput("surveys-sampling-step", most_step=MOST_STEP)
    if not 0.0 < sampling.share_percent <= 100.0:
        raise BadInput("surveys-sampling-share")
    if sampling.free_flowing_s is not None and not 0.0 < sampling.free_flowing_s <= MOST_HEADWAY_S:
        raise BadInput("surveys-sampling-headway", most_headway_s=format(MOST_HEADWAY_S, "g"))
    of = [(one.lighting, one.class_set) for one in sampling.quotas]
    if len(of) != len(set(of)):
        raise BadInput("surveys-sampling-quota-twice")
    return {**asdict(sampling), "quotas": [asdict(one) for one in sampling.quotas]}
