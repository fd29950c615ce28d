"""What was added to surveys, or changed, since packages of them were built: by places in the audit chain.

A package's seal names the last event that its tables tell of; what came into the chain after that one is not
in them, however soon it came. No clock is asked.
"""

import json
from collections.abc import Collection

from sqlalchemy import Integer, String, and_, case, cast, column, func, literal, select, values
from sqlalchemy.orm import Session

from sightline.infra.audit.records import survey_chain
from sightline.infra.audit.tables import audit_events
from sightline.measurements.query import is_first
from sightline.measurements.tables import measurement_series
from sightline.results.overview.records import ChangesSince
from sightline.results.tables import exports

#: Events of what no table of a package holds: what was asked of the program, and choices for work to come.
#: Whatever is not named here counts as a change.
NOT_IN_PACKAGES = (
    "package",
    "export",
    "evidence",
    "job",
    "upload",
    "proposals",
    "survey_member",
    "calibration_image",
    "review_plan",
    "free_plan",
    "click_sigma",
)
_REVIEWS = ("review", "scan_review")
_e = audit_events.c


def changes_since_packages(session: Session, package_ids: Collection[int]) -> dict[int, ChangesSince]:
    """By package, what was added or changed since; two queries however many packages there are."""
    places = [
        (id_, survey_chain(survey_id), as_of) for id_, survey_id, as_of in _places(session, package_ids)
    ]
    if not places:
        return {}
    package = (
        values(column("id", Integer), column("chain", String), column("as_of", Integer), name="package")
        .data(places)
        .cte("package")
    )
    height = and_(_e.entity == "measurement", is_first)
    kind = case((height, "heights"), (_e.entity.in_(_REVIEWS), "reviews"), else_="other")
    thing = _e.entity.concat(literal(" ")).concat(func.coalesce(cast(_e.entity_id, String), ""))
    each = (
        select(package.c.id, kind.label("kind"), thing.label("thing"))
        .select_from(package)
        .join(audit_events, and_(_e.chain == package.c.chain, _e.number > package.c.as_of))
        .outerjoin(
            measurement_series,
            and_(_e.entity == "measurement", measurement_series.c.id == _e.entity_id),
        )
        .where(_e.entity.not_in(NOT_IN_PACKAGES))
        .subquery()
    )
    count = func.count(each.c.thing.distinct()).label("count")
    query = select(each.c.id, each.c.kind, count).group_by(each.c.id, each.c.kind)
    found: dict[int, dict[str, int]] = {id_: {} for id_, *_ in places}
    for id_, of, number in session.execute(query):
        found[id_][of] = number
    return {id_: ChangesSince(**counts) for id_, counts in found.items()}


def _places(session: Session, package_ids: Collection[int]) -> list[tuple[int, int, int]]:
    """(package, survey, the last event that its tables tell of); without a seal, the end of its chain."""
    query = (
        select(exports.c.id, exports.c.survey_id, exports.c.audit_count, _e.after)
        .outerjoin(audit_events, and_(_e.hash == exports.c.audit_head, _e.entity == "package"))
        .where(exports.c.id.in_(package_ids))
    )
    return [
        (row.id, row.survey_id, row.audit_count if row.after is None else int(json.loads(row.after)["as_of"]))
        for row in session.execute(query)
    ]
