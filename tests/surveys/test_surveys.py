"""Surveys, the audit trail of what was done, and the list of jobs."""

from collections.abc import Callable
from typing import get_args

from sqlalchemy import text

from sightline.enums import InsetName
from sightline.geometry.insets import USUAL_INSETS
from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from sightline.surveys.bodies import InsetChanges, Insets
from sightline.surveys.records import insets_of
from tests.support.app import Client, error_of
from tests.support.ground import add_vehicle, lay_ground, measure


def test_a_survey_tells_what_comes_next(operator: Client, survey_id: int) -> None:
    survey = operator.seen(f"/surveys/{survey_id}")
    assert [step["key"] for step in survey["steps"]] == [
        "camera",
        "recordings",
        "pose",
        "vehicles",
        "review",
        "results",
    ]
    assert survey["steps"][0]["state"] == "next"
    assert set(survey["insets"]) == set(get_args(InsetName))
    assert set(survey["counts"].values()) == {0}


def states(client: Client, survey_id: int) -> dict[str, str]:
    """The state of each step."""
    return {step["key"]: step["state"] for step in client.seen(f"/surveys/{survey_id}")["steps"]}


def test_recordings_are_not_done_before_their_facts_are_confirmed(
    operator: Client, survey_id: int, recording_id: int
) -> None:
    assert states(operator, survey_id)["recordings"] == "begun"
    (said,) = [
        step["summary"]
        for step in operator.seen(f"/surveys/{survey_id}")["steps"]
        if step["key"] == "recordings"
    ]
    assert [one["message"] for one in said] == [
        "1 of 1 recording ready.",
        "Confirm lighting and start of 1 recording.",
    ]
    operator.put(f"/recordings/{recording_id}", {"lighting": "daytime"})
    assert states(operator, survey_id)["recordings"] == "begun"
    start = {"local": "2026-05-03T08:10:00", "time_zone": "Europe/Paris"}
    operator.put(f"/recordings/{recording_id}", {"start": start})
    assert states(operator, survey_id)["recordings"] == "done"


def test_a_review_that_waits_is_told_of_while_an_earlier_step_is_next(
    services: Services, operator: Client, survey_id: int, recording_id: int
) -> None:
    assert states(operator, survey_id)["review"] == "waiting"
    ground = lay_ground(services, survey_id, recording_id)
    measure(operator, add_vehicle(operator, ground.recording_id)["id"])
    found = states(operator, survey_id)
    assert "next" in [found[key] for key in ("camera", "recordings", "pose", "vehicles")]
    assert found["review"] == "begun"


def test_two_people_change_one_survey(operator: Client, reviewer: Client, survey_id: int) -> None:
    path = f"/surveys/{survey_id}"
    first = operator.put(path, {"name": "Rouen", "site": "Lane 1", "version": 1})
    assert first.json()["version"] == 2
    second = reviewer.put(path, {"name": "Paris", "version": 1})
    assert second.status_code == 409
    assert "Operator" in error_of(second)
    assert operator.seen(path)["name"] == "Rouen"


def test_text_with_nul_is_refused_on_every_database(operator: Client, viewer: Client) -> None:
    refused = operator.post("/surveys", {"name": "a\x00b", "site": "", "description": ""})
    assert refused.status_code == 422
    assert "NUL" in error_of(refused)
    # In an address SQLite looks for it and PostgreSQL refuses it; neither breaks.
    assert viewer.get("/catalogue?q=%00").status_code in (200, 422)


def test_insets_left_out_stay(operator: Client, survey_id: int) -> None:
    path = f"/surveys/{survey_id}"
    before = operator.seen(path)["insets"]
    body = {
        "name": "Rouen",
        "version": 1,
        "insets": {"roof": {"inset_m": 0.2, "u_inset_m": 0.05, "note": "tape"}},
    }
    after = operator.put(path, body).json()["insets"]
    assert after["roof"] == {"inset_m": 0.2, "u_inset_m": 0.05, "note": "tape", "code": None}
    assert {k: v for k, v in after.items() if k != "roof"} == {k: v for k, v in before.items() if k != "roof"}
    for bad in ({"bonnet": {"inset_m": 0, "u_inset_m": 0}}, {"roof": {"inset_m": 0.1, "u_inset_m": -0.1}}):
        assert operator.put(path, {"name": "Rouen", "version": 2, "insets": bad}).status_code == 422


def test_an_inset_keeps_its_code_until_its_note_changes(operator: Client, survey_id: int) -> None:
    path = f"/surveys/{survey_id}"
    before = operator.seen(path)["insets"]
    assert {name: one["code"] for name, one in before.items()} == {name: name for name in before}
    moved, written = {**before["roof"], "inset_m": 0.2}, {**before["headlight"], "note": "tape"}
    body = {"name": "Rouen", "version": 1, "insets": {"roof": moved, "headlight": written}}
    after = operator.put(path, body).json()["insets"]
    assert (after["roof"], after["headlight"]) == (moved, {**written, "code": None})


# Insets that were spoiled, made up before their reader was read: each is refused in words, and none is stored
SPOILED: dict[str, str] = {
    "millimetres": '{"roof": {"inset_m": 200, "u_inset_m": 0.05}}',
    "an uncertainty in millimetres": '{"roof": {"inset_m": 0.2, "u_inset_m": 50}}',
    "an uncertainty below nothing": '{"roof": {"inset_m": 0.2, "u_inset_m": -0.05}}',
    "no uncertainty": '{"roof": {"inset_m": 0.2}}',
    "an uncertainty of null": '{"roof": {"inset_m": 0.2, "u_inset_m": null}}',
    "a word": '{"roof": {"inset_m": "usual", "u_inset_m": 0.05}}',
    "a decimal comma": '{"roof": {"inset_m": "0,2", "u_inset_m": 0.05}}',
    "no number": '{"roof": {"inset_m": NaN, "u_inset_m": 0.05}}',
    "a number without end": '{"roof": {"inset_m": 1e999, "u_inset_m": 0.05}}',
    "a list": '{"roof": [0.2, 0.05]}',
    "a list of all": '[{"roof": {"inset_m": 0.2, "u_inset_m": 0.05}}]',
    "a target that is none": '{"bonnet": {"inset_m": 0.2, "u_inset_m": 0.05}}',
    "a name in capitals": '{"ROOF": {"inset_m": 0.2, "u_inset_m": 0.05}}',
    "one more column": '{"roof": {"inset_m": 0.2, "u_inset_m": 0.05, "unit": "mm"}}',
    "a sound one beside a spoiled one": (
        '{"roof": {"inset_m": 0.2, "u_inset_m": 0.05}, "taillight": {"inset_m": 0.1, "u_inset_m": -1}}'
    ),
}  # fmt: skip


def test_spoiled_insets_are_refused_and_none_is_stored(operator: Client, survey_id: int) -> None:
    path = f"/surveys/{survey_id}"
    before = operator.seen(path)
    taken: dict[str, tuple[int, str]] = {}
    headers = {"Content-Type": "application/json"}
    for name, insets in SPOILED.items():
        body = f'{{"name": "Rouen", "version": 1, "insets": {insets}}}'
        answer = operator.http.put(f"/api{path}", content=body, headers=headers)
        if answer.status_code not in (400, 422) or not error_of(answer):
            taken[name] = (answer.status_code, answer.text[:300])
    assert not taken and operator.seen(path) == before


def test_the_audit_trail(operator: Client, viewer: Client, admin: Client, survey_id: int) -> None:
    operator.put(f"/surveys/{survey_id}", {"name": "Rouen", "version": 1})
    events = viewer.seen(f"/audit?survey_id={survey_id}")
    assert [one["action"] for one in events] == ["update", "create", "create"]  # survey, member
    assert events[0]["before"]["name"] == "Test road" and events[0]["after"]["name"] == "Rouen"
    assert events[0]["actor"]["name"] == "Operator"
    assert events[0]["previous_hash"] == viewer.seen(f"/audit?before_id={events[0]['id']}&limit=1")[0]["hash"]
    assert viewer.seen(f"/audit?before_id={events[0]['id']}&survey_id={survey_id}") == events[1:]
    assert viewer.seen("/audit?entity=person") == []  # accounts are for administrators
    assert {one["entity"] for one in admin.seen("/audit?entity=person")} == {"person"}
    assert viewer.get("/audit?limit=0").status_code == 422


def test_a_tampered_row_is_found(admin: Client, survey_id: int, services: Services) -> None:
    good = admin.made("/audit/verify")
    assert good["ok"] is True and good["checked"] > 0 and good["problem"] is None
    with services.engine.begin() as connection:
        if connection.dialect.name == "sqlite":
            connection.exec_driver_sql("DROP TRIGGER IF EXISTS audit_events_refuse_update")
            names = connection.exec_driver_sql(
                "SELECT name FROM sqlite_master WHERE type = 'trigger' AND tbl_name = 'audit_events'"
            )
            for (name,) in names.fetchall():
                connection.exec_driver_sql(f'DROP TRIGGER "{name}"')
        else:
            connection.execute(text("SET LOCAL session_replication_role = replica"))
        connection.execute(text("UPDATE audit_events SET action = 'nothing' WHERE id = 2"))
    bad = admin.made("/audit/verify")
    assert bad["ok"] is False and bad["problem"]


def test_jobs(
    operator: Client, viewer: Client, survey_id: int, recording_id: int, work: Callable[[], list[Job]]
) -> None:
    (job,) = viewer.seen(f"/jobs?survey_id={survey_id}")
    assert job["kind"] == "ingest" and job["state"] == "done" and job["progress"] == 1.0
    assert viewer.seen(f"/jobs/{job['id']}") == job
    assert viewer.seen("/jobs?state=queued") == []
    assert viewer.get("/jobs?survey_id=999").status_code == 404
    assert viewer.get("/jobs?state=odd").status_code == 422
    mine = viewer.made(f"/surveys/{survey_id}/exports")
    assert viewer.made(f"/jobs/{mine['id']}/cancel")["state"] == "cancelled"
    theirs = operator.made(f"/recordings/{recording_id}/ingest")
    refused = viewer.post(f"/jobs/{theirs['id']}/cancel")
    assert refused.status_code == 403
    error_of(refused)


def test_insets_follow_the_list_of_their_names_and_old_surveys_are_filled_up() -> None:
    """A new target needs no line in the bodies; a survey stored before it has its usual inset."""
    names = set(get_args(InsetName))
    assert set(Insets.model_fields) == set(InsetChanges.model_fields) == names
    found = insets_of({"roof": {"inset_m": 0.2, "u_inset_m": 0.05}})
    assert set(found) == names
    assert found["roof_van"] == found["roof"] and found["roof"].inset_m == 0.2
    assert found["headlight"].inset_m == USUAL_INSETS["headlight"][0]
