"""The evidence file of a line-scanned vehicle: who may make it, what it says, and that no change passes."""

import json
import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import islice
from math import hypot
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest

from sightline.cli import main
from sightline.enums import JsonObject
from sightline.errors import Damaged
from sightline.export.evidence import page, service, verify
from sightline.export.evidence.decision import decision_of
from sightline.export.evidence.document import derived_parts
from sightline.export.evidence.pictures import StripPicture
from sightline.export.evidence.translated import translations_of
from sightline.export.evidence.verify import EvidenceCheck, verify_evidence
from sightline.infra.audit.checkpoints import hand_on
from sightline.infra.audit.hashing import canonical_json, chain_hash, content_hash
from sightline.infra.audit.signing import SigningKey, put_in_force, replacing_key, signing_key
from sightline.infra.audit.verification import verify_records
from sightline.infra.jobs.records import Job
from sightline.infra.services import Services
from sightline.linescan.parts import Lane, Rig
from sightline.media.images import read_image
from sightline.scans.records import LiveSource
from sightline.scans.store import create_scan, rig_columns
from sightline.settings import Settings
from tests.support import scans_samples
from tests.support.app import Client, error_of
from tests.support.scanning_ground import pictures

Work = Callable[[], list[Job]]
SPEED = {"quantity": "speed", "limit": 10.0, "risk": 0.05, "source": "Sign at the gate"}
PROGRAM = "<!doctype html><title>Sightline</title>\n<!--evidence-->\n<script>0</script>\n"


@pytest.fixture(autouse=True)
def program(monkeypatch: pytest.MonkeyPatch) -> None:
    """A page's program: these tests look at what stands in it (the browser tests at the page)."""
    monkeypatch.setattr(page, "template", lambda: PROGRAM)


@pytest.fixture
def scan(operator: Client, gate_scan_id: int) -> dict[str, Any]:
    """A recording with three measured vehicles."""
    found: dict[str, Any] = operator.seen(f"/scans/{gate_scan_id}")
    return found


def vehicles(client: Client, scan: dict[str, Any]) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = client.seen(f"/scans/{scan['id']}/vehicles")
    return found


def judge(reviewer: Client, vehicle: dict[str, Any], verdict: str = "accepted") -> None:
    body = {"verdict": verdict, "reason": "Another car." if verdict == "rejected" else None}
    reviewer.made(f"/scan-measurements/{vehicle['measurement']['id']}/review", body)


def made(client: Client, vehicle: dict[str, Any], rule: JsonObject | None = None) -> dict[str, Any]:
    found: dict[str, Any] = client.made(f"/scan-vehicles/{vehicle['id']}/evidence", {"rule": rule})
    return found


def document_of(file: dict[str, Any]) -> JsonObject:
    return page.read_page(file["html"].encode()).document


def checked(content: str, key: str | None = None) -> EvidenceCheck:
    return verify_evidence(content.encode(), key)


def test_a_file_says_all_of_it_verifies_and_is_an_event(
    viewer: Client, reviewer: Client, scan: dict[str, Any], services: Services
) -> None:
    one, two, _ = vehicles(viewer, scan)
    judge(reviewer, two)
    file = made(viewer, two, SPEED)
    assert file["filename"].startswith("evidence-gate-vehicle-2-") and file["answer"] == "not_conforming"
    found = checked(file["html"], file["signing_key"])
    assert found.ok, found.problems
    told = document_of(file)
    motion = two["measurement"]
    assert told["measurement"]["speed_mps"] == motion["speed_mps"]
    assert found.lines is not None and abs(found.lines.length_m - motion["length_m"]) < 0.02
    assert told["before"]["id"] == one["measurement"]["id"]
    assert told["gap"]["time_gap_s"] == pytest.approx(two["gap"]["time_gap_s"])
    assert told["review"]["reviewer"]["name"] == "Reviewer" and told["made_by"]["name"] == "Viewer"
    assert "69." in file["decision"] and "at most 36 km/h" in file["decision"]
    (event,) = [
        one
        for one in viewer.seen(f"/audit?survey_id={scan['survey_id']}")
        if (one["entity"], one["action"]) == ("evidence", "create")
    ]
    assert event["after"]["sha256"] == file["sha256"] == content_hash(told)
    assert (event["entity_id"], event["actor"]["name"]) == (two["id"], "Viewer")
    with services.reading() as session:
        assert verify_records(session).ok


def test_the_vehicle_before_is_the_one_whose_rear_left_last(operator: Client, scan: dict[str, Any]) -> None:
    """The first one's rear is placed behind the second's: the third follows the first."""
    one, two, three = vehicles(operator, scan)
    later = {name: two["measurement"][name] + 50 for name in LINES if name.startswith("rear")}
    lines = {**{name: one["measurement"][name] for name in LINES}, **later, "version": one["version"]}
    assert operator.put(f"/scan-vehicles/{one['id']}/boundaries", lines).status_code == 200
    gap = vehicles(operator, scan)[2]["gap"]
    told = document_of(made(operator, three))
    assert told["before"]["vehicle_id"] == one["id"]
    assert told["gap"]["time_gap_s"] == pytest.approx(gap["time_gap_s"])
    rate_hz = told["rig_now"]["line_rate_hz"]
    lines_between = three["measurement"]["front_line_1"] - later["rear_line_1"]
    assert gap["time_gap_s"] == pytest.approx(lines_between / rate_hz)


def test_the_verdict_on_a_motion_that_was_put_back_is_told_by_its_event(
    operator: Client, reviewer: Client, scan: dict[str, Any]
) -> None:
    _, two, three = vehicles(operator, scan)

    def placed(by: float) -> dict[str, Any]:
        version = vehicles(operator, scan)[1]["version"]
        lines = {name: two["measurement"][name] + by for name in LINES}
        answer = operator.put(f"/scan-vehicles/{two['id']}/boundaries", {**lines, "version": version})
        found: dict[str, Any] = answer.json()
        return found

    judge(reviewer, placed(1.0))
    assert placed(2.0)["measurement"]["review"]["verdict"] == "to_review"
    back = placed(1.0)
    assert back["measurement"]["review"]["verdict"] == "accepted"
    for vehicle in (back, three):  # its own file, and the one of the vehicle behind it
        found = checked(made(operator, vehicle, SPEED)["html"])
        assert found.ok, found.problems


def test_every_vehicle_by_either_method_and_with_a_confirmed_start(
    viewer: Client, operator: Client, scan: dict[str, Any], work: Work
) -> None:
    address = f"/scans/{scan['id']}"
    told = made(operator, vehicles(viewer, scan)[0])
    assert document_of(told)["time"]["filmed_at"] is None and document_of(told)["clock"] is None
    start = {"local": "2026-05-04T08:00:00.000", "time_zone": "Europe/Paris", "u_s": 0.02}
    body = {"start": start, "version": operator.seen(address)["version"]}
    assert operator.http.patch(f"/api{address}", json=body).status_code == 200
    for method in ("direct", "paper"):
        asked = operator.post(f"{address}/find", {"method": method, "search": False})
        assert asked.status_code == 202, asked.text
        assert {job.state for job in work()} == {"done"}
        for vehicle in vehicles(viewer, scan):
            file = made(viewer, vehicle, SPEED)
            found = checked(file["html"])
            assert found.ok, found.problems
            document = document_of(file)
            assert document["measurement"]["method"] == method
            assert document["time"]["filmed_at"] == vehicle["filmed_at"]
            assert document["time"]["u_filmed_at_s"] == pytest.approx(vehicle["u_filmed_at_s"])


@pytest.mark.parametrize("most", [100, 8192])
def test_pictures_keep_every_so_many_lines_of_a_long_vehicle(
    viewer: Client, scan: dict[str, Any], monkeypatch: pytest.MonkeyPatch, most: int
) -> None:
    monkeypatch.setattr("sightline.export.evidence.pictures.MOST_COLUMNS", most)
    monkeypatch.setattr("sightline.export.evidence.pictures._AT_ONCE", 7)
    two = vehicles(viewer, scan)[1]
    file = page.read_page(made(viewer, two)["html"].encode())
    strips = pictures()[:2]
    for facts, strip in zip(file.document["pictures"], strips, strict=True):
        shown = read_image(file.pictures[facts["name"]])
        start, step = facts["first_line"], facts["step_lines"]
        assert facts["columns"] <= most and (step > 1) == (most == 100)
        kept = strip[start : start + facts["columns"] * step : step]
        assert np.array_equal(shown, kept.T)


def test_the_command_writes_a_file_that_verify_takes(
    viewer: Client,
    scan: dict[str, Any],
    settings: Settings,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setenv("SIGHTLINE_DATA_DIR", str(settings.data_dir))
    monkeypatch.setenv("SIGHTLINE_DATABASE_URL", settings.database_url)
    place = tmp_path / "two.html"
    asked = ["evidence", "--survey", "Test road", "--scan", "Gate", "--vehicle", "2", "-o", str(place)]
    assert main([*asked, "--most-kmh", "50", "--limit-source", "Sign"]) == 0, capsys.readouterr().err
    said = capsys.readouterr().out
    assert "no reviewer has accepted" in said
    key = said.rsplit("key ", 1)[1].strip(".\n")
    assert main(["verify", str(place), "--key", key]) == 0
    assert "decision are valid" in capsys.readouterr().out
    kept = tmp_path / "kept.json"
    assert main(["checkpoint", "-o", str(kept)]) == 0
    capsys.readouterr()
    for name, value in (("head", "0" * 64), ("checkpoint", str(kept))):
        assert main(["verify", str(place), f"--{name}", value]) == 2
        assert f"--{name} has no effect here" in capsys.readouterr().err
    place.write_text(place.read_text().replace('"number":2', '"number":3', 1))
    assert main(["verify", str(place)]) == 1
    assert "signature is not valid" in capsys.readouterr().err
    for wrong, why in (
        ([*asked[:5], "--scan", "Gate", "--vehicle", "9", "-o", str(place)], "no vehicle 9"),
        ([*asked, "--most-kmh", "50", "--least-time-gap-s", "1"], "Give one limit"),
        ([*asked, "--most-kmh", "50", "--risk", "0.9"], "is out of range"),
        ([*asked[:3], "--scan", "Bridge", *asked[5:]], "no line-scan recording Bridge"),
    ):
        assert main(wrong) == 2
        assert why in capsys.readouterr().err


def test_a_name_that_several_recordings_have_is_refused_and_their_numbers_are_said(
    operator: Client,
    scan: dict[str, Any],
    services: Services,
    settings: Settings,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Else the file is of the vehicle of that number in another recording."""
    monkeypatch.setenv("SIGHTLINE_DATA_DIR", str(settings.data_dir))
    monkeypatch.setenv("SIGHTLINE_DATABASE_URL", settings.database_url)
    rig = Rig(baseline_m=2.0, u_baseline_m=0.001, line_rate_hz=5000.0)
    with services.writing() as session:
        other = create_scan(
            session,
            operator.seen("/surveys")[0]["id"],
            name="Gate",
            source=LiveSource(),
            time_axis="width",
            rig=rig,
            actor=None,
        )
    asked = ["evidence", "--survey", "Test road", "--vehicle", "2", "-o", str(tmp_path / "two.html")]
    assert main([*asked, "--scan", "Gate"]) == 2
    assert f"give the number of one: {scan['id']}, {other.id}." in capsys.readouterr().err
    assert main([*asked, "--scan", str(scan["id"])]) == 0, capsys.readouterr().err


def test_what_it_says_is_signed_in_every_language_and_answered_in_that_of_the_request(
    viewer: Client, reviewer: Client, scan: dict[str, Any]
) -> None:
    two = vehicles(viewer, scan)[1]
    judge(reviewer, two)
    address, french = f"/scan-vehicles/{two['id']}/evidence", {"Accept-Language": "fr"}
    file = viewer.post(address, {"rule": SPEED}, headers=french).json()
    document = document_of(file)
    assert checked(file["html"]).ok and document["language"] == "fr"
    words = document["decision"]["words"]
    assert words.startswith("Not conforming") and file["decision"] == document["said"]["fr"][words]
    assert file["decision"].startswith("Non conforme") and "." not in file["decision"].split(" km/h")[0]
    sources = {one["source"] for one in document["measurement"]["budget"]}
    assert {*sources, words} <= document["said"]["fr"].keys()


def test_without_a_rule_or_an_accepted_measurement_nothing_is_decided(
    viewer: Client, operator: Client, reviewer: Client, scan: dict[str, Any]
) -> None:
    one, two, three = vehicles(viewer, scan)
    gap = {"quantity": "time_gap", "limit": 0.9, "risk": 0.05, "source": ""}

    def says(vehicle: dict[str, Any], rule: JsonObject | None) -> str:
        file = made(viewer, vehicle, rule)
        assert checked(file["html"]).ok
        assert file["answer"] is None
        words: str = file["decision"]
        return words

    assert "No limit was stated" in says(two, None)
    assert "no reviewer has accepted the measurement" in says(two, SPEED)
    judge(reviewer, two, "rejected")
    assert "a reviewer rejected the measurement" in says(two, SPEED)
    judge(reviewer, two, "reopened")
    assert "a reviewer reopened the measurement" in says(two, SPEED)
    judge(reviewer, two)
    assert "no reviewer has accepted the measurement of vehicle 1" in says(two, gap)
    judge(reviewer, one)
    assert made(viewer, two, gap)["answer"] in ("conforming", "not_conforming")
    assert "no vehicle was measured in front" in says(one, gap)
    rig = {"baseline_m": 0.6, "version": operator.seen(f"/scans/{scan['id']}")["version"]}
    assert operator.http.patch(f"/api/scans/{scan['id']}", json=rig).status_code == 200
    assert "values of the rig were changed" in says(two, SPEED)
    moved = {name: three["measurement"][name] for name in LINES} | {"version": three["version"]}
    moved |= {"front_line_2": moved["front_line_1"] - 200, "rear_line_2": moved["rear_line_1"] - 200}
    placed = operator.put(f"/scan-vehicles/{three['id']}/boundaries", moved).json()
    assert placed["measurement"]["status"] != "ok"
    assert "has no measured motion" in says(placed, SPEED)


LINES = ("front_line_1", "rear_line_1", "front_line_2", "rear_line_2")


def test_who_may_not_export_or_asks_for_what_cannot_be(
    viewer: Client, nobody: Client, scan: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    two = vehicles(viewer, scan)[1]
    address = f"/scan-vehicles/{two['id']}/evidence"
    assert nobody.post(address, {"rule": None}).status_code == 401
    reading = viewer.made("/session/tokens", {"name": "reads", "scopes": ["read"], "days": 1})["text"]
    headers = {"Authorization": f"Bearer {reading}"}
    assert nobody.post(address, {"rule": None}, headers=headers).status_code == 403
    for wrong in ({**SPEED, "risk": 0.5}, {**SPEED, "limit": 0}, {**SPEED, "quantity": "length"}):
        assert viewer.post(address, {"rule": wrong}).status_code == 422
    assert viewer.post("/scan-vehicles/999999/evidence", {"rule": None}).status_code == 404
    monkeypatch.setattr(page, "template", lambda: None)
    assert "not built" in error_of(viewer.post(address, {"rule": None}))


def signed_again(file: dict[str, Any], document: JsonObject, key: SigningKey | None) -> str:
    """The file with another document, signed by who holds a key, or with the old signature."""
    old = page.read_page(file["html"].encode())
    signature = old.signature if key is None else key.sign(document)
    same = [StripPicture(name=name, content=data, facts={}) for name, data in old.pictures.items()]
    return page.written_page(document, signature, same).decode()


def leaves(value: Any, path: tuple[str | int, ...] = ()) -> Iterator[tuple[str | int, ...]]:
    """The place of every plain value of a document."""
    inner: Any = value.items() if isinstance(value, dict) else enumerate(value)
    for name, one in inner:
        if isinstance(one, dict | list):
            yield from leaves(one, (*path, name))
        else:
            yield (*path, name)


def changed(document: JsonObject, path: tuple[str | int, ...]) -> JsonObject:
    """A copy with one value another one of its kind."""
    copy: JsonObject = json.loads(json.dumps(document))
    at: Any = copy
    for name in path[:-1]:
        at = at[name]
    old = at[path[-1]]
    if isinstance(old, bool) or old is None:
        at[path[-1]] = not old
    else:
        at[path[-1]] = old * 1.02 + 1 if isinstance(old, int | float) else f"{old}x"
    return copy


@pytest.mark.parametrize("every", [5, pytest.param(1, marks=pytest.mark.proof)])
def test_each_value_that_is_changed_is_found(
    viewer: Client, reviewer: Client, scan: dict[str, Any], services: Services, every: int
) -> None:
    one, two, _ = vehicles(viewer, scan)
    judge(reviewer, one)
    judge(reviewer, two)
    file = made(viewer, two, {"quantity": "distance_gap", "limit": 9.0, "risk": 0.05, "source": "Order 7"})
    document = document_of(file)
    places = list(leaves(document))
    assert len(places) > 200 and ("measurement", "budget", 0, "u_length_m") in places
    with pytest.raises(Damaged, match="not an evidence file"):
        checked(signed_again(file, changed(document, ("format",)), None))
    for place in places[::every]:
        if place == ("format",):
            continue
        found = checked(signed_again(file, changed(document, place), None))
        assert not found.ok, place

    # signed anew by who holds the key: what follows from the rest, or stands in an event, is found even so
    key = signing_key(services.settings)
    assert checked(signed_again(file, document, key)).ok
    parts = ("pictures", "decision", "gap", "time", "at_vehicle", "audit", "said")
    bound = {
        *((part, *rest) for part, *rest in places if part in parts),
        *(("measurement", name) for name in (*LINES, "speed_mps", "acceleration_mps2", "length_m")),
        *(("before", name) for name in (*LINES, "speed_mps", "length_m")),
        *(("measurement", "rig", name) for name in ("baseline_m", "line_rate_hz", "u_baseline_m")),
        *(place for place in places if place[:2] == ("measurement", "budget") and place[-1] != "source"),
        ("review", "verdict"),
        ("before", "review", "verdict"),
    }
    # what the key's holder alone vouches for: who set the limit, where the chain stood, what a picture shows
    free = {("decision", "rule", "source"), ("audit", "count"), ("audit", "hash")} | {
        ("pictures", n, name)
        for n in (0, 1)
        for name in ("first_line", "step_lines", "grey_black", "grey_white")
    }
    for place in sorted(bound - free, key=str)[::every]:
        found = checked(signed_again(file, changed(document, place), key))
        assert not found.ok, place


def test_who_writes_the_event_anew_too_is_told_by_the_numbers(
    viewer: Client, scan: dict[str, Any], services: Services
) -> None:
    file = made(viewer, vehicles(viewer, scan)[1], None)
    document = document_of(file)
    for name, named in (("speed_mps", "speed_mps"), ("u_speed_mps", "u_speed_mps"), ("length_m", "length_m")):
        forged = changed(document, ("measurement", name))
        for event in forged["audit"]["events"]:
            if (event["entity"], event["entity_id"]) == ("scan_measurement", forged["measurement"]["id"]):
                after = {**json.loads(event["after"]), name: forged["measurement"][name]}
                event["after"] = canonical_json(after)
                event["hash"] = chain_hash(event)
        found = checked(signed_again(file, forged, signing_key(services.settings)))
        assert any(
            "does not follow from lines, rig and budget" in one and named in one for one in found.problems
        )


def test_words_of_another_version_are_no_fault_and_its_answer_is_held_to_the_numbers(
    viewer: Client, scan: dict[str, Any], services: Services, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Only the version that made a file knows how it worded it. It is decided once."""
    file = made(viewer, vehicles(viewer, scan)[1], SPEED)
    key = signing_key(services.settings)
    document = document_of(file)
    document["decision"]["words"] = "As it was said then."
    assert "decision: words" in (checked(signed_again(file, document, key)).problem or "")
    document["program"] = "0.0.9"
    decisions: list[JsonObject] = []

    def decide(*given: Any) -> JsonObject:
        decisions.append(decision_of(*given))
        return decisions[-1]

    with monkeypatch.context() as counted:
        counted.setattr(verify, "decision_of", decide)
        found = checked(signed_again(file, document, key))
    assert found.ok and len(decisions) == 1, found.problem
    words = document_of(file)["decision"]["words"]
    assert any("Another version worded" in one and words in one for one in found.notes)
    document["decision"]["limit" if "limit" in document["decision"] else "value"] = 1.0
    assert "decision: " in (checked(signed_again(file, document, key)).problem or "")


@pytest.mark.parametrize("by_hand", [False, True])
def test_a_budget_of_before_that_tells_both_ends_together_is_held_to_as_it_was(
    viewer: Client, scan: dict[str, Any], services: Services, by_hand: bool
) -> None:
    """No such file could be read any more, those made since of such motions neither."""
    document = document_of(file := made(viewer, vehicles(viewer, scan)[1]))
    for part in ("measurement", "before"):
        told = document[part]
        front, rear = told["budget"][-2:]
        both = {name: hypot(front[name], rear[name]) for name in front if name != "source"}
        told["budget"][-2:] = [{"source": "boundaries", **both}]
        told["u_boundaries_m"] = 0.0 if by_hand else told["u_boundaries_m"]
        for event in document["audit"]["events"]:
            if (event["entity"], event["entity_id"]) == ("scan_measurement", told["id"]):
                after = {**json.loads(event["after"]), "budget": told["budget"]}
                event["after"] = canonical_json({**after, "u_boundaries_m": told["u_boundaries_m"]})
                event["hash"] = chain_hash(event)
                document["audit"]["hash"] = (
                    event["hash"]
                    if event["number"] == document["audit"]["count"]
                    else (document["audit"]["hash"])
                )
    document["gap"] = derived_parts(document)["gap"]
    assert document["gap"]["u_time_gap_s"] > 0.3 * document_of(file)["gap"]["u_time_gap_s"]
    document["said"] = translations_of(document)
    document["program"], key = "0.0.9", signing_key(services.settings)
    # its gap as it was computed then, to the last digit
    document["gap"]["u_time_gap_s"] *= 1 + 1e-15
    found = checked(signed_again(file, document, key))
    assert found.ok, found.problems
    document["gap"]["u_time_gap_s"] *= 0.999
    assert "gap" in (checked(signed_again(file, document, key)).problem or "")


STRANGE = (None, [], {}, "x", -1, 1e308, True, [None])


def nodes(value: Any, path: tuple[str | int, ...] = ()) -> Iterator[tuple[str | int, ...]]:
    """The place of everything in a document, whole parts too."""
    inner: Any = (
        value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    )
    for name, one in inner:
        yield (*path, name)
        yield from nodes(one, (*path, name))


@pytest.mark.parametrize("every", [5, pytest.param(1, marks=pytest.mark.proof)])
def test_what_is_of_another_kind_is_found_and_nothing_breaks(
    viewer: Client, scan: dict[str, Any], every: int
) -> None:
    file = made(viewer, vehicles(viewer, scan)[1], SPEED)
    document = document_of(file)
    for number, place in islice(enumerate(nodes(document)), None, None, every):
        # every part by every strange value, every plain value by one of them in turn
        strange = STRANGE if len(place) == 1 else STRANGE[number % len(STRANGE) :][:1]
        for value in strange:
            spoiled: JsonObject = json.loads(json.dumps(document))
            at: Any = spoiled
            for name in place[:-1]:
                at = at[name]
            at[place[-1]] = value
            if spoiled == document or place == ("format",):
                continue
            assert not checked(signed_again(file, spoiled, None), "0" * 16).ok, (place, value)
    text = re.search(r'id="evidence">([^<]*)<', file["html"])
    assert text
    for other in ("[]", "1", "null", "{}", '{"format":1e999}', "[" * 100_000):
        with pytest.raises(Damaged, match="not an evidence file"):
            checked(file["html"].replace(text[1], other, 1))


def test_a_part_of_another_kind_is_named_in_words(viewer: Client, scan: dict[str, Any]) -> None:
    file = made(viewer, vehicles(viewer, scan)[1], SPEED)
    document = document_of(file)

    def named(part: str, value: object) -> set[str]:
        found = checked(signed_again(file, {**document, part: value}, None))
        return {name for one in found.problems for name in re.findall("^The part “(.+)” cannot be read", one)}

    assert named("pictures", 1) == {"images"}
    assert named("audit", 1) == {"audit events"}
    assert named("keys", 1) == {"signature and keys"}
    assert named("decision", 1) == {"decision", "sentences in other languages"}
    assert {"derived values", "measured values"} <= named("measurement", 1)


def test_pictures_page_and_form_are_bound(viewer: Client, scan: dict[str, Any]) -> None:
    file = made(viewer, vehicles(viewer, scan)[1], None)
    html: str = file["html"]
    assert "program is not the one" in (checked(html.replace("<script>0<", "<script>1<")).problem or "")
    old = page.read_page(html.encode())
    name, data = next(iter(old.pictures.items()))
    other = [StripPicture(name=one, content=old.pictures[one], facts={}) for one in old.pictures]
    other[0] = replace(other[0], content=data[:-1] + b"\0")
    spoiled = page.written_page(old.document, old.signature, other).decode()
    assert f"image {name} is not the one" in (checked(spoiled).problem or "")
    spaced = html.replace('"format":"', '"format": "', 1)
    assert "canonical JSON" in (checked(spaced).problem or "")
    assert html.count("<") == PROGRAM.count("<") + 2 * 4, "no text of the document can end its element"


def test_an_old_file_verifies_with_the_old_key_after_a_rotation(
    viewer: Client, scan: dict[str, Any], services: Services
) -> None:
    two = vehicles(viewer, scan)[1]
    before = made(viewer, two)
    old_key = before["signing_key"]
    after_key, waiting = replacing_key(services.settings.data_dir)
    with services.writing() as session:
        hand_on(session, signing_key(services.settings), after_key, actor=None)
    put_in_force(services.settings.data_dir, waiting)
    after = made(viewer, two)
    assert after["signing_key"] == after_key.public != old_key
    for file, key in ((before, old_key), (after, after_key.public), (after, old_key)):
        found = checked(file["html"], key)
        assert found.ok and found.key == file["signing_key"], found.problems
    wrong = checked(before["html"], after_key.public)
    assert "not linked to the given key" in (wrong.problem or "")
    stranger = SigningKey(b"\1" * 32)
    forged = {**document_of(before), "key": stranger.public}
    found = checked(signed_again(before, forged, stranger))
    assert "how its key follows" in (found.problem or "")


def test_no_vehicle_is_before_one_whose_lane_came_unknown_between(monkeypatch: pytest.MonkeyPatch) -> None:
    """A in lane a leaves last, then one of no known lane, then C beside A: whose gap D has is not known."""

    rig = rig_columns(replace(scans_samples.RIG, lanes=(Lane("a", 4.0), Lane("b", 8.0))))

    def seen(id_: int, lane: str | None, front: float, rear: float) -> Any:
        values = scans_samples.values(lane=lane, front_line_1=front, rear_line_1=rear, rig=rig)
        return SimpleNamespace(id=id_, scan_id=1, measurement=SimpleNamespace(values=values))

    every = [seen(1, "a", 0, 1000), seen(2, None, 100, 300), seen(3, "a", 400, 500), seen(4, "a", 1100, 1300)]
    monkeypatch.setattr(service, "list_scan_vehicles", lambda *_: every)
    before = service._find_leader
    assert before(cast(Any, None), every[3]) is None
    every[2] = seen(3, "a", 400, 1050)
    assert before(cast(Any, None), every[3]) is every[2]
