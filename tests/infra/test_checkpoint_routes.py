"""Administrators sign where the audit chains end, see what was signed, and take it away as a file."""

import json

from sightline.infra.audit.checkpoints import are_handed_on, is_signed
from tests.support.app import Client, error_of


def test_what_is_signed_is_listed_and_given_as_a_file(admin: Client, survey_id: int) -> None:
    assert admin.seen("/audit/checkpoints") == {"key": None, "keys_before": 0, "newest": []}
    before = admin.seen("/audit?entity=checkpoint")
    signed = admin.made("/audit/checkpoints")
    assert before == []
    listed = admin.seen("/audit/checkpoints")
    assert listed == signed
    (one,) = listed["newest"]
    (event,) = admin.seen("/audit?entity=checkpoint")
    assert one["id"] == event["id"] and one["by"] == event["actor"]
    assert one["key"] == listed["key"] and listed["keys_before"] == 0
    answer = admin.http.get(f"/api/audit/checkpoints/{one['id']}/checkpoint.json")
    assert f'filename="checkpoint-{one["id"]}.json"' in answer.headers["content-disposition"]
    document = json.loads(answer.content)
    assert is_signed(document) and are_handed_on(document["keys"], one["key"])
    assert not is_signed({**document, "root": "0" * 64})
    ends = {name: (count, hash_) for name, count, hash_ in document["ends"]}
    last = admin.seen(f"/audit?survey_id={survey_id}")[0]
    assert ends[f"survey/{survey_id}"] == (last["number"], last["hash"])
    assert (one["chains"], one["events"]) == (len(ends), sum(count for count, _ in ends.values()))
    assert admin.made("/audit/verify")["ok"]


def test_the_newest_stands_first_and_another_event_is_no_checkpoint(admin: Client, survey_id: int) -> None:
    first = admin.made("/audit/checkpoints")["newest"][0]
    admin.made(f"/surveys/{survey_id}/cameras", {"name": "Later"})
    newest = admin.made("/audit/checkpoints")["newest"]
    assert [one["id"] for one in newest][1] == first["id"] and newest[0]["events"] > first["events"]
    other = admin.seen(f"/audit?survey_id={survey_id}")[0]["id"]
    refused = admin.http.get(f"/api/audit/checkpoints/{other}/checkpoint.json")
    assert refused.status_code == 404 and "does not exist" in error_of(refused)


def test_only_administrators_sign_and_see(reviewer: Client) -> None:
    assert reviewer.http.get("/api/audit/checkpoints").status_code == 403
    assert reviewer.http.post("/api/audit/checkpoints").status_code == 403
