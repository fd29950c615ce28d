"""Every route as each role, as somebody who does not belong to the survey, signed out, and with a token of
each scope, against a matrix written by hand. The whole table stands in the guide:
`python -m tests.people.test_roles` prints it there.
"""

import re
from collections.abc import Collection, Iterator
from pathlib import Path
from typing import Any, get_args

import pytest
from fastapi import FastAPI
from fastapi.routing import APIRoute
from fastapi.testclient import TestClient

from sightline.app import ROUTERS
from sightline.enums import ActingRole, Scope
from sightline.infra.database import Session
from sightline.infra.services import Services
from sightline.infra.web.access import APART, RANK, THINGS, Access
from sightline.infra.web.deps import allow_anybody, require
from sightline.infra.web.person import Person, Seen
from sightline.people.store import create_person, create_sign_in_link, list_people
from sightline.surveys.members import store as members
from sightline.surveys.store import create_survey
from tests.support.app import TUS, Client, error_of

pytestmark = pytest.mark.once
# The lowest role that may do it; "" needs no sign-in.
MATRIX = {
    "GET /health": "",
    "GET /ready": "",
    "POST /session": "",
    "POST /session/link": "",
    "DELETE /session": "",
    "GET /session": "viewer",
    "GET /session/tokens": "viewer",
    "POST /session/tokens": "viewer",
    "DELETE /session/tokens/{token_id}": "viewer",
    "PUT /session/name": "viewer",
    "PUT /session/password": "viewer",
    "GET /people": "admin",
    "GET /system": "admin",
    "GET /system/licences": "admin",
    "POST /people": "admin",
    "PUT /people/{person_id}": "admin",
    "POST /people/{person_id}/link": "admin",
    "GET /surveys": "viewer",
    "POST /surveys": "operator",
    "GET /surveys/{survey_id}": "viewer",
    "PUT /surveys/{survey_id}": "operator",
    "GET /surveys/{survey_id}/members": "viewer",
    "GET /surveys/{survey_id}/members/others": "manager",
    "PUT /surveys/{survey_id}/members/{person_id}": "manager",
    "DELETE /surveys/{survey_id}/members/{person_id}": "manager",
    "PUT /surveys/{survey_id}/open-to-all": "manager",
    "GET /surveys/{survey_id}/photographs": "viewer",
    "POST /surveys/{survey_id}/photographs": "operator",
    "PUT /surveys/{survey_id}/photographs/order": "operator",
    "PUT /photographs/{photograph_id}": "operator",
    "DELETE /photographs/{photograph_id}": "operator",
    "POST /photographs/{photograph_id}/restore": "operator",
    "GET /photographs/{photograph_id}.jpg": "viewer",
    "GET /surveys/{survey_id}/cameras": "viewer",
    "POST /surveys/{survey_id}/cameras": "operator",
    "POST /surveys/{survey_id}/cameras/from/{camera_id}": "operator",
    "PUT /cameras/{camera_id}": "operator",
    "GET /cameras/{camera_id}": "viewer",
    "POST /cameras/{camera_id}/images": "operator",
    "POST /cameras/{camera_id}/images/detect": "operator",
    "GET /calibration-images/{image_id}.jpg": "viewer",
    "DELETE /calibration-images/{image_id}": "operator",
    "PUT /cameras/{camera_id}/current-calibration": "operator",
    "POST /cameras/{camera_id}/calibrations": "operator",
    "POST /cameras/{camera_id}/calibrations/import": "operator",
    "GET /calibrations/{calibration_id}": "viewer",
    "GET /calibrations/{calibration_id}/camera.json": "viewer",
    "OPTIONS /uploads": "",
    "GET /surveys/{survey_id}/uploads": "viewer",
    "POST /surveys/{survey_id}/uploads": "operator",
    "HEAD /uploads/{upload_id}": "operator",
    "PATCH /uploads/{upload_id}": "operator",
    "DELETE /uploads/{upload_id}": "operator",
    "GET /surveys/{survey_id}/recordings": "viewer",
    "GET /recordings/{recording_id}": "viewer",
    "GET /recordings/{recording_id}/video": "viewer",
    "PUT /recordings/{recording_id}": "operator",
    "DELETE /recordings/{recording_id}": "operator",
    "POST /recordings/{recording_id}/ingest": "operator",
    "POST /recordings/{recording_id}/pictures/{number}": "operator",
    "PUT /recordings/{recording_id}/filming-rate": "operator",
    "GET /recordings/{recording_id}/frames": "viewer",
    "GET /recordings/{recording_id}/frames/ready": "viewer",
    "GET /recordings/{recording_id}/frames/{n}.jpg": "viewer",
    "GET /recordings/{recording_id}/frames/{n}/crop.png": "viewer",
    "GET /recordings/{recording_id}/thumbs/{frame}.jpg": "viewer",
    "POST /recordings/{recording_id}/board": "operator",
    "POST /recordings/{recording_id}/board/span": "operator",
    "POST /recordings/{recording_id}/poses": "operator",
    "GET /surveys/{survey_id}/poses": "viewer",
    "GET /poses/{pose_id}": "viewer",
    "GET /poses/{pose_id}/pose.json": "viewer",
    "GET /surveys/{survey_id}/checks/insets": "viewer",
    "GET /surveys/{survey_id}/plan": "viewer",
    "GET /surveys/{survey_id}/plan.pdf": "viewer",
    "GET /line-rate-plan": "viewer",
    "GET /boards.pdf": "viewer",
    "GET /samples": "viewer",
    "GET /samples/pictures.zip": "viewer",
    "GET /samples/catalogue.csv": "viewer",
    "GET /surveys/{survey_id}/checks/traffic": "viewer",
    "GET /poses/{pose_id}/turn": "viewer",
    "GET /surveys/{survey_id}/checks/adjustment": "viewer",
    "POST /poses/{pose_id}/adjustment": "operator",
    "POST /poses/{pose_id}/adjustment/undo": "operator",
    "POST /poses/{pose_id}/turn": "operator",
    "POST /vehicles/{vehicle_id}/wheel-pair": "operator",
    "GET /vehicles/{vehicle_id}/which-model": "viewer",
    "DELETE /vehicles/{vehicle_id}/wheel-pair": "operator",
    "GET /recordings/{recording_id}/drift": "viewer",
    "POST /recordings/{recording_id}/drift": "operator",
    "PUT /recordings/{recording_id}/drift/decision": "operator",
    "DELETE /recordings/{recording_id}/drift/decision": "operator",
    "POST /recordings/{recording_id}/frames/{n}/contact": "viewer",
    "POST /vehicles/{vehicle_id}/frames/{n}/snap": "viewer",
    "POST /vehicles/{vehicle_id}/follow": "viewer",
    "GET /surveys/{survey_id}/anchoring": "viewer",
    "GET /surveys/{survey_id}/free-plan": "viewer",
    "PUT /surveys/{survey_id}/free-plan": "manager",
    "POST /recordings/{recording_id}/geometry/axes": "viewer",
    "POST /recordings/{recording_id}/geometry/height": "viewer",
    "POST /recordings/{recording_id}/geometry/second-frame": "viewer",
    "GET /surveys/{survey_id}/vehicles": "viewer",
    "POST /recordings/{recording_id}/vehicles": "operator",
    "GET /vehicles/{vehicle_id}": "viewer",
    "PUT /vehicles/{vehicle_id}": "operator",
    "DELETE /vehicles/{vehicle_id}": "operator",
    "POST /vehicles/{vehicle_id}/restore": "operator",
    "POST /recordings/{recording_id}/find-passes": "operator",
    "GET /surveys/{survey_id}/pass-counts": "viewer",
    "POST /recordings/{recording_id}/propose": "operator",
    "GET /recordings/{recording_id}/proposals": "viewer",
    "POST /vehicles/{vehicle_id}/split": "operator",
    "POST /vehicles/{vehicle_id}/join": "operator",
    "GET /catalogue": "viewer",
    "POST /catalogue": "operator",
    "GET /catalogue/page": "viewer",
    "GET /catalogue/export": "viewer",
    "PUT /catalogue/{entry_id}": "operator",
    "POST /catalogue/{entry_id}/retire": "operator",
    "POST /catalogue/import/preview": "operator",
    "POST /catalogue/import": "operator",
    "POST /vehicles/{vehicle_id}/measurements": "operator",
    "GET /measurements/{measurement_id}": "viewer",
    "PUT /measurements/{measurement_id}": "operator",
    "DELETE /measurements/{measurement_id}": "operator",
    "POST /measurements/{measurement_id}/restore": "operator",
    "GET /measurements/{measurement_id}/history": "viewer",
    "GET /surveys/{survey_id}/computings": "viewer",
    "POST /surveys/{survey_id}/computings": "operator",
    "GET /computings/{computing_id}": "viewer",
    "POST /computings/{computing_id}/undo": "operator",
    "GET /surveys/{survey_id}/review-queue": "viewer",
    "GET /surveys/{survey_id}/review-work": "viewer",
    "GET /surveys/{survey_id}/lots": "viewer",
    "GET /surveys/{survey_id}/lots/summary": "viewer",
    "GET /surveys/{survey_id}/lots/plan": "viewer",
    "POST /surveys/{survey_id}/lots": "reviewer",
    "POST /lots/{lot_id}/accept": "reviewer",
    "POST /lots/{lot_id}/inspect": "reviewer",
    "POST /lots/{lot_id}/dissolve": "reviewer",
    "POST /lots/{lot_id}/take-back": "reviewer",
    "GET /surveys/{survey_id}/review-plan": "viewer",
    "PUT /surveys/{survey_id}/review-plan": "manager",
    "POST /measurements/{measurement_id}/reviews": "reviewer",
    "GET /surveys/{survey_id}/repeats": "viewer",
    "GET /surveys/{survey_id}/repeats/sample": "operator",
    "GET /measurements/{measurement_id}/repeats": "viewer",
    "PUT /surveys/{survey_id}/people/{person_id}/click-sigma": "reviewer",
    "GET /surveys/{survey_id}/scans": "viewer",
    "GET /surveys/{survey_id}/live": "viewer",
    "GET /surveys/{survey_id}/live/segments": "operator",
    "POST /surveys/{survey_id}/live": "operator",
    "POST /scans/{scan_id}/live": "operator",
    "POST /scans/{scan_id}/live/end": "operator",
    "GET /surveys/{survey_id}/strip-uploads": "viewer",
    "POST /surveys/{survey_id}/scans": "operator",
    "POST /surveys/{survey_id}/scans/from-video": "operator",
    "GET /scans/{scan_id}": "viewer",
    "GET /scans/{scan_id}/rig-of-traffic": "viewer",
    "PATCH /scans/{scan_id}": "operator",
    "DELETE /scans/{scan_id}": "operator",
    "POST /scans/{scan_id}/read": "operator",
    "POST /scans/{scan_id}/find": "operator",
    "POST /scans/{scan_id}/swap": "operator",
    "GET /scans/{scan_id}/tiles/{camera}/{level}/{index}": "viewer",
    "GET /scans/{scan_id}/vehicles": "viewer",
    "POST /scans/{scan_id}/vehicles": "operator",
    "GET /scan-vehicles/{vehicle_id}": "viewer",
    "PUT /scan-vehicles/{vehicle_id}/boundaries": "operator",
    "PUT /scan-vehicles/{vehicle_id}/wheels": "operator",
    "PUT /scan-vehicles/{vehicle_id}/axles": "operator",
    "PUT /scan-vehicles/{vehicle_id}/lane": "operator",
    "PUT /scan-vehicles/{vehicle_id}/facts": "operator",
    "DELETE /scan-vehicles/{vehicle_id}": "operator",
    "POST /scan-vehicles/{vehicle_id}/restore": "operator",
    "GET /scan-vehicles/{vehicle_id}/match/{picture}": "viewer",
    "PUT /scan-vehicles/{vehicle_id}/references/{quantity}/{source}": "operator",
    "DELETE /scan-vehicles/{vehicle_id}/references/{quantity}/{source}": "operator",
    "POST /scans/{scan_id}/references/preview": "operator",
    "POST /scans/{scan_id}/references/import": "operator",
    "POST /scan-measurements/{measurement_id}/review": "reviewer",
    "GET /scans/{scan_id}/rig-calibrations": "viewer",
    "POST /scans/{scan_id}/rig-calibrations/preview": "operator",
    "POST /scans/{scan_id}/rig-calibrations": "operator",
    "GET /scans/{scan_id}/line-pose": "viewer",
    "POST /scans/{scan_id}/line-pose/preview": "viewer",
    "PUT /scans/{scan_id}/line-pose": "operator",
    "POST /scans/{scan_id}/line-height": "viewer",
    "GET /scans/{scan_id}/heights": "viewer",
    "GET /scan-vehicles/{vehicle_id}/heights": "viewer",
    "POST /scan-vehicles/{vehicle_id}/heights": "operator",
    "DELETE /scan-vehicles/{vehicle_id}/heights": "operator",
    "GET /surveys/{survey_id}/scan-statistics": "viewer",
    "GET /surveys/{survey_id}/scan-traffic": "viewer",
    "GET /statistics": "viewer",
    "GET /statistics/sample-size": "viewer",
    "GET /sightdistance": "viewer",
    "GET /surveys/{survey_id}/standards": "viewer",
    "GET /surveys/{survey_id}/sample": "viewer",
    "PUT /surveys/{survey_id}/standards": "operator",
    "GET /surveys/{survey_id}/conclusion": "viewer",
    "POST /surveys/{survey_id}/exports": "viewer",
    "GET /surveys/{survey_id}/exports": "viewer",
    "GET /exports/{export_id}.zip": "viewer",
    "POST /scan-vehicles/{vehicle_id}/evidence": "viewer",
    "GET /studies": "viewer",
    "POST /studies": "operator",
    "GET /studies/{study_id}": "viewer",
    "PUT /studies/{study_id}": "operator",
    "DELETE /studies/{study_id}": "operator",
    "POST /studies/{study_id}/computings": "operator",
    "GET /studies/{study_id}/members": "viewer",
    "PUT /studies/{study_id}/members/{person_id}": "operator",
    "DELETE /studies/{study_id}/members/{person_id}": "operator",
    "PUT /studies/{study_id}/open-to-all": "operator",
    "GET /studies/{study_id}/beside/studies/{other_id}": "viewer",
    "GET /studies/{study_id}/results/{result_id}.zip": "viewer",
    "GET /studies/{study_id}/results/{result_id}.pdf": "viewer",
    "GET /audit/events": "viewer",
    "GET /audit/people": "viewer",
    "GET /audit": "viewer",
    "POST /audit/verify": "admin",
    "GET /audit/checkpoints": "admin",
    "POST /audit/checkpoints": "admin",
    "GET /audit/checkpoints/{checkpoint_id}/checkpoint.json": "admin",
    "GET /jobs": "viewer",
    "GET /jobs/{job_id}": "viewer",
    "POST /jobs/{job_id}/again": "operator",
    "POST /jobs/{job_id}/cancel": "viewer",
}


#: What a token needs beside the role of its person, where it is not the usual one; None: no token will do.
USUAL_SCOPES: dict[str, Scope | None] = {
    "viewer": "read",
    "operator": "measure",
    "reviewer": "review",
    "manager": None,
    "admin": None,
}
SCOPES: dict[str, Scope | None] = {
    "GET /session/tokens": None,
    "POST /session/tokens": None,
    "DELETE /session/tokens/{token_id}": None,
    "PUT /session/name": None,
    "PUT /session/password": None,
    "POST /surveys/{survey_id}/uploads": "upload",
    "HEAD /uploads/{upload_id}": "upload",
    "PATCH /uploads/{upload_id}": "upload",
    "DELETE /uploads/{upload_id}": "upload",
    "POST /recordings/{recording_id}/ingest": "upload",
    "POST /recordings/{recording_id}/find-passes": "upload",
    "POST /surveys/{survey_id}/exports": "export",
    "GET /exports/{export_id}.zip": "export",
    "GET /recordings/{recording_id}/video": "export",
    "POST /scan-vehicles/{vehicle_id}/evidence": "export",
    "GET /studies/{study_id}/results/{result_id}.zip": "export",
    "GET /studies/{study_id}/results/{result_id}.pdf": "export",
    "PUT /studies/{study_id}/members/{person_id}": None,
    "DELETE /studies/{study_id}/members/{person_id}": None,
    "PUT /studies/{study_id}/open-to-all": None,
    "POST /jobs/{job_id}/cancel": "measure",
}


def scope_of(name: str) -> Scope | None:
    """What a token needs for a route that is not open."""
    return SCOPES.get(name, USUAL_SCOPES[MATRIX[name]])


def routes() -> Iterator[tuple[str, APIRoute]]:
    """Every route of every module, as "METHOD /path"."""
    for _, router in ROUTERS:
        for route in router.routes:
            assert isinstance(route, APIRoute), route
            for method in sorted(route.methods):
                yield f"{method} {route.path}", route


def calls(dependant: Any) -> Iterator[Any]:
    for inner in dependant.dependencies:
        yield inner.call
        yield from calls(inner)


def declared(route: APIRoute) -> list[tuple[str, Scope | None]]:
    """The roles that a route's dependencies ask for, each with its scope."""
    asked = list(calls(route.dependant))
    return [(one.role, one.scope) for one in asked if isinstance(one, require)] + [
        ("", None) for one in asked if one is allow_anybody
    ]


def test_every_route_declares_exactly_the_role_of_the_matrix() -> None:
    expected = {name: [(role, scope_of(name) if role else None)] for name, role in MATRIX.items()}
    assert {name: declared(route) for name, route in routes()} == expected


def test_no_route_is_served_that_the_matrix_does_not_know(app: FastAPI) -> None:
    served = {
        f"{method.upper()} {path.removeprefix('/api')}"
        for path, methods in app.openapi()["paths"].items()
        for method in methods
    }
    assert served == set(MATRIX)


def of_a_survey(name: str) -> bool:
    """Whether what a route names in its path belongs to a survey."""
    return any(f"/{kind}/{{" in name for kind in THINGS if kind != "studies")


def test_no_path_names_a_kind_that_is_not_known() -> None:
    """What is named in no list would be shown to everybody."""
    for name in MATRIX:
        for kind in re.findall(r"/([a-z-]+)/\{\w+_id\}", name):
            assert kind in THINGS or kind in APART, name
        assert of_a_survey(name) or "survey_id" not in name, name


def ask(client: Client, name: str) -> Any:
    """Ask for things that are not there: what is answered depends on who asks only through the role."""
    method, path = name.split(" ")
    path = re.sub(r"\{\w+_id\}", "999999", path)
    path = path.replace("{n}", "0").replace("{frame}", "0").replace("{picture}", "first")
    path = path.replace("{camera}/{level}/{index}", "1/0/0")
    query = {"x": 0, "y": 0, "w": 8, "h": 8, "revision": 1} if method in ("GET", "DELETE") else {}
    return client.http.request(method, f"/api{path}", headers=TUS, params=query)


class InOneSurvey:
    """Everything that is asked for belongs to one survey, whatever its number."""

    def __init__(self, survey_id: int) -> None:
        self._survey_id = survey_id

    def seen_surveys(self, session: Session, person: Person) -> Seen:
        return members.seen_surveys(session, person)

    def seen_studies(self, session: Session, person: Person) -> Seen:
        return members.seen_studies(session, person)

    def roles_by_thing(
        self, session: Session, person: Person, table: str, ids: Collection[int]
    ) -> dict[int, ActingRole]:
        if table == "studies":  # there the role of the account counts
            return dict.fromkeys(ids, person.role)
        roles = members.roles_by_thing(session, person, "surveys", [self._survey_id])
        return dict.fromkeys(ids, roles[self._survey_id]) if roles else {}


@pytest.fixture
def closed(app: FastAPI, services: Services, clients: dict[str, Client]) -> int:
    """A survey to which each account belongs in its own role, but for the admin and an outsider."""
    with services.writing() as session:
        survey_id = create_survey(session, name="Closed", actor=None).id
        for person in list_people(session):
            if person.role != "admin":
                members.put_member(session, survey_id, person.id, person.role, actor=None)
        tokens = {}
        for name, role in (("manager", "viewer"), ("outsider", "reviewer")):
            made = create_person(session, name=name, email=f"{name}@x.org", role=role, actor=None)  # type: ignore[arg-type]
            tokens[name] = create_sign_in_link(session, made.id, actor=None)
            if name == "manager":
                members.put_member(session, survey_id, made.id, "manager", actor=None)
    for name, token in tokens.items():
        clients[name] = Client(TestClient(app, headers={"X-Sightline": "1"}, raise_server_exceptions=False))
        clients[name].made("/session/link", {"token": token})
    app.state.access = Access(services, InOneSurvey(survey_id))
    return survey_id


#: Who asks: the role of the account, and the role in the survey (None: does not belong to it).
ASKING: dict[str, tuple[str, ActingRole | None]] = {
    "outsider": ("reviewer", None),
    "viewer": ("viewer", "viewer"),
    "operator": ("operator", "operator"),
    "reviewer": ("reviewer", "reviewer"),
    "manager": ("viewer", "manager"),
    "admin": ("admin", "admin"),
}


def refused(who: str, name: str) -> int | None:
    """With which status a route refuses somebody; None where it lets them in."""
    least, (account, inside) = MATRIX[name], ASKING[who]
    if not least:
        return None
    role = inside if of_a_survey(name) else account
    if role is None:
        return 404
    return 403 if RANK[role] < RANK[least] else None  # type: ignore[index]


@pytest.mark.parametrize("who", ASKING)
def test_roles_are_enforced(clients: dict[str, Client], closed: int, who: str) -> None:
    client = clients[who]
    for name in MATRIX:
        if name == "DELETE /session":
            continue
        answer, expected = ask(client, name), refused(who, name)
        if expected is None:
            assert answer.status_code not in (403, 405, 500), (name, who, answer.text)
            assert answer.status_code != 401 or "session" in name, (name, who, answer.text)
            continue
        assert answer.status_code == expected, (name, who, answer.text)
        if answer.text and expected == 403:
            assert MATRIX[name] in error_of(answer)


def test_signed_out_nothing_is_given(nobody: Client) -> None:
    for name, least in MATRIX.items():
        answer = ask(nobody, name)
        if least:
            assert answer.status_code == 401, (name, answer.text)
            assert not answer.text or error_of(answer) == "You are not signed in; sign in and try again."
        else:
            assert answer.status_code in (200, 204, 422), (name, answer.text)


@pytest.fixture
def tokens(app: FastAPI, clients: dict[str, Client]) -> dict[Scope, Client]:
    """Programs of the admin, who may do everything: each with a token of one scope."""
    made = {}
    for scope in get_args(Scope):
        text = clients["admin"].made("/session/tokens", {"name": scope, "scopes": [scope]})["text"]
        http = TestClient(app, headers={"Authorization": f"Bearer {text}"}, raise_server_exceptions=False)
        made[scope] = Client(http)
    return made


@pytest.mark.parametrize("others", [1, pytest.param(len(get_args(Scope)), marks=pytest.mark.proof)])
def test_a_token_may_do_what_its_scopes_say(tokens: dict[Scope, Client], closed: int, others: int) -> None:
    """Each route is asked with its own scope and, one that writes, with all others, else with as many. No
    request carries the header against cross-site writes: a token needs none.
    """
    for n, name in enumerate(name for name, least in MATRIX.items() if least):
        own = scope_of(name)
        wrong = [scope for scope in tokens if scope != own]
        first = n % len(wrong)
        tried = (wrong[first:] + wrong[:first])[:others] if name.startswith(("GET ", "HEAD ")) else wrong
        for scope in filter(None, (own, *tried)):
            answer = ask(tokens[scope], name)
            if scope == own:
                assert answer.status_code not in (401, 403, 405, 500), (name, scope, answer.text)
            else:
                assert answer.status_code == 403, (name, scope, answer.text)
                assert not answer.text or "token" in error_of(answer).lower(), (name, answer.text)


GUIDE = Path(__file__).parents[2] / "docs" / "guide"
MARK = "<!-- printed by: python -m tests.people.test_roles -->\n"
ASKED = ("signed out", "does not belong", "viewer", "operator", "reviewer", "manager", "administrator")
WORDS: dict[str, dict[str, str]] = {
    "en": {},
    "fr": {
        "signed out": "non connecté",
        "does not belong": "non membre",
        "viewer": "lecteur",
        "operator": "opérateur",
        "reviewer": "vérificateur",
        "manager": "gestionnaire",
        "administrator": "administrateur",
        "token": "jeton",
        "yes": "oui",
        "never": "jamais",
        "read": "lire",
        "upload": "envoyer",
        "measure": "mesurer",
        "review": "vérifier",
        "export": "exporter",
    },
}


def table(language: str) -> str:
    """The table of the guide in a language: what each route answers to whom."""
    lines = [row(language, "route", [*ASKED, "token"]), "| --- " * 9 + "|"]
    for name, least in MATRIX.items():
        if of_a_survey(name):
            cells = [refused(who, name) or "yes" for who in ASKING]
        else:
            inside = {"viewer", "operator", "reviewer", "admin"}
            open_to = [who for who in inside if not least or RANK[who] >= RANK[least]]  # type: ignore[index]
            cells = [
                "-",
                *(
                    "-" if who == "manager" else "yes" if who in open_to else 403
                    for who in ("viewer", "operator", "reviewer", "manager", "admin")
                ),
            ]
        token = (scope_of(name) or "never") if least else "yes"
        lines.append(row(language, f"`{name}`", [401 if least else "yes", *cells, token]))
    return "\n".join(lines) + "\n"


def row(language: str, first: str, cells: Collection[str | int]) -> str:
    words = WORDS[language]
    return f"| {' | '.join([first, *(words.get(str(cell), str(cell)) for cell in cells)])} |"


@pytest.mark.parametrize("language", WORDS)
def test_the_guide_prints_the_table(language: str) -> None:
    written = (GUIDE / language / "access.md").read_text(encoding="utf-8")
    assert written.partition(MARK)[2] == table(language)


def test_every_guide_has_the_table() -> None:
    assert {page.parent.name for page in GUIDE.glob("*/access.md")} == set(WORDS)


if __name__ == "__main__":
    for guide in (GUIDE / language / "access.md" for language in WORDS):
        text = guide.read_text(encoding="utf-8").partition(MARK)[0]
        guide.write_text(text + MARK + table(guide.parent.name), encoding="utf-8")
