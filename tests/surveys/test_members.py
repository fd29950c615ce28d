"""Who belongs to a survey sees it; for everybody else it does not exist."""

import pytest
from fastapi import FastAPI
from sqlalchemy import select

from sightline.infra.audit.tables import audit_events
from sightline.infra.database.types import metadata
from sightline.infra.services import BELIEVED_S, Services
from sightline.infra.slices import load_tables
from sightline.infra.web.access import THINGS, Access
from sightline.surveys.members import store as members
from tests.support import samples
from tests.support.app import Client, error_of

pytestmark = pytest.mark.dialect


@pytest.fixture
def mine(operator: Client) -> int:
    """A survey that the operator made."""
    return int(operator.made("/surveys", {"name": "Mine"})["id"])


def id_of(client: Client) -> int:
    return int(client.seen("/session")["person"]["id"])


def test_who_makes_a_survey_manages_it_and_others_do_not_see_it(
    operator: Client, reviewer: Client, admin: Client, mine: int
) -> None:
    assert operator.seen(f"/surveys/{mine}")["my_role"] == "manager"
    assert operator.seen(f"/surveys/{mine}")["open_to_all"] is False
    assert admin.seen(f"/surveys/{mine}")["my_role"] == "admin"
    unseen, nothing = reviewer.get(f"/surveys/{mine}"), reviewer.get("/surveys/4711")
    assert unseen.status_code == nothing.status_code == 404
    assert error_of(unseen).replace(str(mine), "N") == error_of(nothing).replace("4711", "N")
    assert reviewer.seen("/surveys") == [] and len(operator.seen("/surveys")) == 1
    assert reviewer.put(f"/surveys/{mine}/members/{id_of(reviewer)}", {"role": "manager"}).status_code == 404


def test_a_role_in_a_survey_is_the_role_that_counts(operator: Client, viewer: Client, mine: int) -> None:
    def put(role: str) -> None:
        answer = operator.put(f"/surveys/{mine}/members/{id_of(viewer)}", {"role": role})
        assert answer.status_code == 200, answer.text

    put("viewer")
    assert viewer.post(f"/surveys/{mine}/cameras", {"name": "Left"}).status_code == 403
    put("operator")
    camera = viewer.made(f"/surveys/{mine}/cameras", {"name": "Left"})["id"]
    assert viewer.seen(f"/cameras/{camera}")["name"] == "Left"
    assert viewer.get(f"/surveys/{mine}/members/others").status_code == 403
    gone = operator.delete(f"/surveys/{mine}/members/{id_of(viewer)}")
    assert [one["name"] for one in gone.json()["members"]] == ["Operator"]
    assert viewer.get(f"/cameras/{camera}").status_code == 404
    assert viewer.post("/surveys", {"name": "no"}).status_code == 403


def test_open_to_all_means_by_the_role_of_the_account(operator: Client, viewer: Client, mine: int) -> None:
    assert operator.put(f"/surveys/{mine}/open-to-all", {"open_to_all": True}).status_code == 200
    assert viewer.seen(f"/surveys/{mine}")["my_role"] == "viewer"
    assert [one["id"] for one in viewer.seen("/surveys")] == [mine]
    assert operator.put(f"/surveys/{mine}/open-to-all", {"open_to_all": False}).status_code == 200
    assert viewer.get(f"/surveys/{mine}").status_code == 404


def test_a_survey_keeps_a_manager(operator: Client, viewer: Client, admin: Client, mine: int) -> None:
    me, other = f"/surveys/{mine}/members/{id_of(operator)}", f"/surveys/{mine}/members/{id_of(viewer)}"
    for refused in (operator.delete(me), admin.delete(me), operator.put(me, {"role": "viewer"})):
        assert refused.status_code == 409
        assert "manager" in error_of(refused)
    assert admin.put(other, {"role": "manager"}).status_code == 200
    assert operator.delete(me).status_code == 200
    assert operator.get(f"/surveys/{mine}").status_code == 404


def test_lists_hold_only_what_is_seen(operator: Client, reviewer: Client, admin: Client, mine: int) -> None:
    camera = operator.made(f"/surveys/{mine}/cameras", {"name": "Left"})["id"]
    shared = int(admin.made("/surveys", {"name": "Shared", "open_to_all": True})["id"])
    for path in ("/statistics", "/sightdistance"):
        assert reviewer.get(f"{path}?survey={mine}").status_code == 404
        assert reviewer.get(f"{path}?survey={shared}&survey={mine}").status_code == 404
        assert reviewer.get(path).status_code == operator.get(path).status_code == 200
    assert [one["name"] for one in reviewer.seen("/statistics")["surveys"]] == ["Shared"]
    for path in ("/audit", "/audit/events", "/jobs"):
        assert reviewer.get(f"{path}?survey_id={mine}").status_code == 404
    events = reviewer.seen("/audit")
    assert {one["survey_id"] for one in events} <= {shared, None}
    assert not any(one["entity"] in ("person", "sign_in_link") for one in events)
    assert {one["survey_id"] for one in operator.seen("/audit")} >= {mine, shared}
    assert any(one["entity"] == "person" for one in admin.seen("/audit"))
    theirs = int(reviewer.made("/surveys", {"name": "Theirs"})["id"])
    taken = reviewer.post(f"/surveys/{theirs}/cameras/from/{camera}", {})
    assert taken.status_code == 404
    assert reviewer.get(f"/surveys/{theirs}/plan?calibration_id=1").status_code == 404


def test_a_study_is_made_of_surveys_that_one_sees(
    operator: Client, reviewer: Client, admin: Client, mine: int
) -> None:
    shared = int(admin.made("/surveys", {"name": "Shared", "open_to_all": True})["id"])
    of = [{"survey_id": id_, "year": 2026} for id_ in (mine, shared)]
    made = operator.made("/studies", {"name": "Both", "surveys": of})["id"]
    assert operator.seen(f"/studies/{made}")["study"]["name"] == "Both"
    assert reviewer.get(f"/studies/{made}").status_code == 404 and reviewer.seen("/studies") == []
    assert reviewer.post("/studies", {"name": "Both", "surveys": of}).status_code == 404
    reviewer.made("/studies", {"name": "One", "surveys": of[1:]})
    assert [one["name"] for one in operator.seen("/studies")] == ["Both"]


def test_the_chain_of_the_survey_tells_who_belonged(
    operator: Client, viewer: Client, services: Services, mine: int
) -> None:
    who = id_of(viewer)
    operator.put(f"/surveys/{mine}/members/{who}", {"role": "viewer"})
    operator.put(f"/surveys/{mine}/members/{who}", {"role": "reviewer"})
    operator.delete(f"/surveys/{mine}/members/{who}")
    with services.reading() as session:
        e = audit_events.c
        query = select(e.action).where(e.survey_id == mine, e.entity == "survey_member").order_by(e.id)
        assert list(session.execute(query).scalars()) == ["create", "create", "update", "delete"]


def test_people_who_may_be_added(operator: Client, viewer: Client, admin: Client, mine: int) -> None:
    admin.put(f"/people/{id_of(viewer)}", {"name": "Viewer", "role": "viewer", "active": False})
    found = operator.seen(f"/surveys/{mine}/members/others")
    assert [one["name"] for one in found] == ["Admin", "Reviewer"]
    assert [one["account_role"] for one in found] == ["admin", "reviewer"]
    roles = [one["account_role"] for one in operator.seen(f"/surveys/{mine}/members")["members"]]
    assert roles == ["operator"]


def test_everything_that_a_route_names_leads_to_its_survey(services: Services) -> None:
    load_tables()
    with services.writing() as session:
        one = samples.sample(session, open_to_all=False)
        rows = {
            "surveys": one.survey.id,
            "survey_photographs": samples.photograph(session, one).id,
            "cameras": one.camera.id,
            "calibrations": one.calibration.id,
            "recordings": one.recording.id,
            "road_poses": one.pose.id,
            "vehicles": one.vehicle.id,
            "measurement_series": samples.measure(session, one).id,
        }
        members.put_member(session, one.survey.id, one.olga.id, "manager", actor=None)
    with services.reading() as session:
        for table, id_ in rows.items():
            assert members.roles_by_thing(session, one.olga, table, [id_, 999]) == {id_: "manager"}, table
            assert members.roles_by_thing(session, one.rene, table, [id_]) == {}, table
        for table in set(THINGS.values()) - {"studies"}:
            assert members.roles_by_thing(session, one.rene, table, [999]) == {}, table
            columns = metadata.tables[table].c
            assert table == "surveys" or "survey_id" in columns or "camera_id" in columns, table
        assert members.seen_surveys(session, one.olga) == frozenset({one.survey.id})
        assert members.seen_surveys(session, one.rene) == frozenset()


def test_a_change_counts_at_once_here_and_within_two_seconds_in_another_process(
    app: FastAPI, services: Services, operator: Client, viewer: Client, mine: int
) -> None:
    """Another process is another app on the same database; it believes what it read for `BELIEVED_S`."""
    clock = [0.0]
    app.state.access = Access(services, members, lambda: clock[0])
    operator.put(f"/surveys/{mine}/members/{id_of(viewer)}", {"role": "viewer"})
    assert viewer.get(f"/surveys/{mine}").status_code == 200
    with services.writing() as session:  # as another process does
        members.remove_member(session, mine, id_of(viewer), actor=None)
    clock[0] += BELIEVED_S - 0.01
    assert viewer.get(f"/surveys/{mine}").status_code == 200
    clock[0] += 0.02
    assert viewer.get(f"/surveys/{mine}").status_code == 404
