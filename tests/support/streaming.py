"""What tests of live streams into a survey stand on: cameras, and the survey in its two places."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from sightline.enums import Scope
from sightline.infra.services import Services
from sightline.linescan.parts import Rig
from sightline.people.store import create_person, list_people
from sightline.people.token_store import create_api_token
from sightline.scans.live.keeping import Sink, SurveyKeeper
from sightline.scans.live.records import LiveHealth
from sightline.surveys.members.store import put_member
from tests.simulation.scan_traffic import ScanSite

SITE = ScanSite(rows=64, misalignment_px=0.3)
RIG = ("--baseline", str(SITE.baseline_m), "--line-rate", str(SITE.line_rate_hz), "--u-baseline", "0.0005")
HEALTH = LiveHealth(
    lines=0,
    lost_lines=(0, 0),
    light_dn=(None, 90.0),
    saturated=(0.0, 0.0),
    clock_offset_s=0.0,
    memory_mib=1.0,
    waiting_mib=0.0,
    words=(),
)
CAMERAS = Rig(SITE.baseline_m, SITE.line_rate_hz)
STREAM = ("stream", "--rows", str(SITE.rows), *RIG)


@dataclass
class Place:
    """A survey, in the database itself or behind a running Sightline: how a stream is told of it."""

    where: tuple[str, ...]
    folder: Path
    sink: Callable[[], Sink]


def token_of(services: Services, *scopes: Scope) -> str:
    with services.writing() as session:
        email = f"{len(list_people(session))}@example.org"
        person = create_person(session, name="Olga", email=email, role="operator", actor=None)
        put_member(session, 1, person.id, "operator", actor=None)
        return create_api_token(session, person.id, name="gate", scopes=scopes, days=1)[1]


def stored(keeper: SurveyKeeper) -> None:
    """Returns when what waited is stored, or was tried to be."""
    assert keeper.storing is not None
    keeper.storing.result()
