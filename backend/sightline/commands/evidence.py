"""`sightline evidence`: one line-scanned vehicle as one file that opens and checks itself."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from sightline.commands.files import write_whole
from sightline.commands.options import (
    data_dir_option,
    number_option,
    opened_services,
    output_option,
    survey_option,
)
from sightline.errors import BadInput

if TYPE_CHECKING:
    from sightline.export.evidence.records import Rule
    from sightline.infra.database import Session


@click.command()
@survey_option
@click.option("--scan", required=True, help="Name (or number) of the line-scan recording.")
@click.option("--vehicle", required=True, type=int, help="Number of the vehicle in the recording.")
@output_option("HTML file to write.")
@number_option("--most-kmh", help="Limit: speed of at most this, km/h.")
@number_option("--least-time-gap-s", "time_gap", help="Limit: time gap of at least this, seconds.")
@number_option("--least-distance-gap-m", "distance_gap", help="Limit: distance gap of at least this, metres.")
@number_option("--risk", default=0.05, help="Risk of a false decision.")
@click.option("--limit-source", default="", help="Source of the limit: the sign, order or rule.")
@data_dir_option
def evidence(
    survey: str,
    scan: str,
    vehicle: int,
    output: Path,
    most_kmh: float | None,
    risk: float,
    limit_source: str,
    data_dir: Path | None,
    **gaps: float | None,
) -> None:
    """Write the evidence file of one vehicle: images, times, rig, motion, budget, decision, signature.

    Without a limit, no decision is made. The file opens without a server; `sightline verify FILE` checks it.
    """
    from sightline.export.evidence.service import make_evidence
    from sightline.export.export_job import find_survey

    rule = _rule(most_kmh, gaps, risk, limit_source)
    with opened_services(data_dir) as services:
        with services.reading() as session:
            vehicle_id = _vehicle(session, find_survey(session, survey).id, scan, vehicle)
        made = make_evidence(services, vehicle_id, rule, actor=None)
    write_whole(output, made.content.decode("utf-8"))
    click.echo(made.document["decision"]["words"])
    click.echo(f"{output}: signed with key {made.document['key']}.")


def _rule(most_kmh: float | None, gaps: dict[str, float | None], risk: float, source: str) -> Rule | None:
    from sightline.export.evidence.decision import KMH_PER_MPS
    from sightline.export.evidence.records import Rule

    speed = None if most_kmh is None else most_kmh / KMH_PER_MPS
    given = {name: limit for name, limit in {**gaps, "speed": speed}.items() if limit is not None}
    if not given:
        return None
    if len(given) > 1 or not 0 < min(given.values()) <= max(given.values()) < 1e4:
        raise BadInput("evidence-one-limit")
    ((name, limit),) = given.items()
    return Rule(name, limit, risk, source)  # type: ignore[arg-type]


def _vehicle(session: Session, survey_id: int, scan: str, number: int) -> int:
    from sightline.scans.store import list_scans
    from sightline.scans.vehicles.store import list_scan_vehicles

    scans = list_scans(session, survey_id)
    matching = [one for one in scans if one.name == scan] or [one for one in scans if str(one.id) == scan]
    if not matching:
        raise BadInput("evidence-no-scan", scan=scan, names=", ".join(one.name for one in scans))
    if len(matching) > 1:
        raise BadInput(
            "evidence-scans-several", scan=scan, numbers=", ".join(str(one.id) for one in matching)
        )
    for one in list_scan_vehicles(session, matching[0].id):
        if one.number == number:
            return one.id
    raise BadInput("evidence-no-vehicle", number=number, scan=matching[0].name)
