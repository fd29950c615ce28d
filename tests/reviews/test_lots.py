"""Review by lots: drawn before anybody judges, decided by the sample, taken back as a whole, and proved."""

import json
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sqlalchemy import text

from sightline.export.verdicts import verdicts_in
from sightline.export.verify.package import verify_package
from sightline.infra.audit.verification import verify_records
from sightline.infra.csv_package.files import FolderFiles, place_of
from sightline.infra.services import Services
from sightline.reviews.lots.draw import drawn_order, seed_of
from sightline.reviews.lots.judged import ItemNow, Judgement, items_of
from sightline.statistics.acceptance import estimate_outgoing
from tests.export.report.pdf_text import words
from tests.support.app import Client, error_of
from tests.support.ground import Ground, add_vehicle, clicks, lay_ground, measure, pixel
from tests.support.packages import edit, rehash, reseal, rewrite, rows, written

COUNT = 24
RISKS = {"producer_quality": 0.01, "producer_risk": 0.1, "consumer_quality": 0.25, "consumer_risk": 0.2}


@pytest.fixture
def ground(services: Services, survey_id: int, recording_id: int) -> Ground:
    return lay_ground(services, survey_id, recording_id)


@pytest.fixture
def made(operator: Client, ground: Ground) -> list[dict[str, Any]]:
    """Roofs of two dozen vehicles, one by one."""
    cars = [add_vehicle(operator, ground.recording_id)["id"] for _ in range(COUNT)]
    return [measure(operator, car) for car in cars]


def draw(client: Client, survey_id: int, *by: str) -> dict[str, Any]:
    (lot,) = client.made(f"/surveys/{survey_id}/lots", {"by": list(by), **RISKS})
    return dict(lot)


def sample_of(client: Client, lot: dict[str, Any]) -> list[dict[str, Any]]:
    of = lot["lot"]
    found = client.seen(f"/surveys/{of['survey_id']}/review-queue?lot={of['id']}")
    return [item["measurement"] for item in found]


def judge(client: Client, one: dict[str, Any], verdict: str = "accepted", **more: Any) -> Any:
    body = {"revision": one["revision"], "verdict": verdict, **more}
    return client.post(f"/measurements/{one['id']}/reviews", body)


def lots(client: Client, ground: Ground) -> list[dict[str, Any]]:
    return list(client.seen(f"/surveys/{ground.survey_id}/lots"))


def verdicts(client: Client, made: list[dict[str, Any]]) -> list[dict[str, Any]]:
    return [client.seen(f"/measurements/{one['id']}")["review"] for one in made]


@pytest.mark.dialect
def test_a_lot_is_drawn_judged_accepted_and_taken_back_as_a_whole(
    reviewer: Client, operator: Client, ground: Ground, made: list[dict[str, Any]], services: Services
) -> None:
    path = f"/surveys/{ground.survey_id}"
    wanted = "&".join(f"{name}={value}" for name, value in RISKS.items())
    (plan,) = reviewer.seen(f"{path}/lots/plan?by=target&{wanted}")
    assert plan["size"] == COUNT and plan["saves"] and plan["common"]["target"] == "roof"
    lot = draw(reviewer, ground.survey_id, "target", "operator", "day", "lighting")
    of, n = lot["lot"], plan["sample_size"]
    assert (of["number"], of["size"], of["sample_size"], lot["state"]) == (1, COUNT, n, "open")
    assert of["common"]["operator"]["name"] == "Operator"
    assert lot["kept"]["consumer_risk"] <= 0.2 and lot["curve"][0]["accepted"] == 1.0
    sample = sample_of(reviewer, lot)
    order = drawn_order(of["seed"], [one["id"] for one in made])
    assert sorted(one["id"] for one in sample) == sorted(order[:n])
    # the rest waits for its sample: neither in the queue nor in another lot
    queue = reviewer.seen(f"{path}/review-queue")
    assert len(queue) == n and {item["judged"]["lot"]["number"] for item in queue} == {1}
    waits = {"to_review": n, "own": 0, "in_lots": COUNT - n}
    assert reviewer.seen(f"{path}/review-work") == {**waits, "accepted": 0, "rejected": 0, "heights": COUNT}
    assert reviewer.seen(f"{path}/lots/plan?{wanted}") == []
    early = reviewer.post(f"/lots/{of['id']}/accept")
    assert early.status_code == 409 and f"{n} heights of the sample still wait" in error_of(early)
    for one in sample:
        assert judge(reviewer, one).status_code == 201
    late = reviewer.post(f"/lots/{of['id']}/dissolve")
    assert late.status_code == 409 and "cannot be dissolved" in error_of(late)
    accepted = reviewer.post(f"/lots/{of['id']}/accept").json()
    assert accepted["state"] == "accepted" and accepted["outgoing"]["count"] == COUNT - n
    assert 0 < accepted["outgoing"]["at_most"] < COUNT - n and accepted["outgoing"]["estimate"] == 0.0
    said = verdicts(reviewer, made)
    assert {one["verdict"] for one in said} == {"accepted"}
    assert [one["lot_id"] for one in said].count(of["id"]) == COUNT - n
    summary = reviewer.seen(f"{path}/lots/summary")
    assert (summary["individual"], summary["by_lot"], summary["waiting"]) == (n, COUNT - n, 0)
    # one of the rest is judged for itself and one is measured again: both stay when the lot is taken back
    rest = [one for one in made if one["id"] in order[n:]]
    assert judge(reviewer, rest[0], "rejected", reason="mirror").status_code == 201
    points = {name: value for name, value in clicks(1.25).items() if name != "target"}
    assert operator.put(f"/measurements/{rest[1]['id']}", {"revision": 1, **points}).status_code == 200
    # neither is one that nobody looked at any more
    summary = reviewer.seen(f"{path}/lots/summary")
    assert summary["by_lot"] == summary["outgoing"]["count"] == COUNT - n - 2
    back = reviewer.post(f"/lots/{of['id']}/take-back").json()
    assert back["state"] == "taken_back" and back["progress"]["rest"] == COUNT - n - 2
    said = [one["verdict"] for one in verdicts(reviewer, rest)]
    assert said == ["rejected", "to_review", *["reopened"] * (COUNT - n - 2)]
    assert {one["verdict"] for one in verdicts(reviewer, sample)} == {"accepted"}
    again = reviewer.post(f"/lots/{of['id']}/take-back")
    assert again.status_code == 409
    with services.reading() as session:
        assert verify_records(session).problem is None


@pytest.mark.dialect
def test_with_too_many_the_rest_goes_to_the_queue_and_into_no_other_lot(
    reviewer: Client, ground: Ground, made: list[dict[str, Any]]
) -> None:
    lot = draw(reviewer, ground.survey_id)
    sample = sample_of(reviewer, lot)
    moved = [pixel(0.2, 0.0, 0.0), pixel(0.6, 0.0, 1.5)]
    fixed = judge(reviewer, sample[0], "fixed", contact=moved[0], target_point=moved[1])
    assert fixed.status_code == 201
    for one in sample[1:]:
        judge(reviewer, one)
    (shown,) = lots(reviewer, ground)
    assert shown["progress"]["nonconforming"] == 1 and not shown["progress"]["may_accept"]
    refused = reviewer.post(f"/lots/{lot['lot']['id']}/accept")
    assert refused.status_code == 409 and "with 0 at most" in error_of(refused)
    done = reviewer.post(f"/lots/{lot['lot']['id']}/inspect").json()
    assert (done["state"], done["progress"]["nonconforming"]) == ("full_inspection", 1)
    queue = reviewer.seen(f"/surveys/{ground.survey_id}/review-queue")
    assert len(queue) == COUNT - len(sample) and all(item["judged"]["lot"] is None for item in queue)
    nothing = reviewer.post(f"/surveys/{ground.survey_id}/lots", {"by": [], **RISKS})
    assert nothing.status_code == 422 and "No lot would save work" in error_of(nothing)


@pytest.mark.dialect
def test_what_is_changed_meanwhile_leaves_with_its_reason_and_the_next_of_the_draw_follows(
    reviewer: Client, operator: Client, ground: Ground, made: list[dict[str, Any]]
) -> None:
    lot = draw(reviewer, ground.survey_id)
    of = lot["lot"]
    order = drawn_order(of["seed"], [one["id"] for one in made])
    by_id = {one["id"]: one for one in made}
    points = {name: value for name, value in clicks(1.25).items() if name != "target"}
    assert operator.put(f"/measurements/{order[0]}", {"revision": 1, **points}).status_code == 200
    assert operator.delete(f"/measurements/{order[1]}?revision=1").status_code == 200
    assert operator.delete(f"/vehicles/{by_id[order[2]]['vehicle_id']}").status_code == 204
    assert judge(reviewer, by_id[order[-1]]).status_code == 201
    (shown,) = lots(reviewer, ground)
    wanted = {"measured_again": 1, "withdrawn": 1, "vehicle_deleted": 1, "verdict_of_its_own": 1}
    assert shown["progress"]["left"] == wanted
    assert {one["id"] for one in sample_of(reviewer, lot)} == set(order[3 : 3 + of["sample_size"]])
    assert shown["progress"]["rest"] == COUNT - 4 - of["sample_size"]
    # judged first, then measured again: what was said of the lot's revision counts
    assert judge(reviewer, by_id[order[3]], "rejected", reason="kerb").status_code == 201
    assert operator.put(f"/measurements/{order[3]}", {"revision": 1, **points}).status_code == 200
    (shown,) = lots(reviewer, ground)
    assert (shown["progress"]["judged"], shown["progress"]["nonconforming"]) == (1, 1)


def test_nobody_accepts_heights_of_their_own_and_a_draw_is_dissolved_before_it_is_judged(
    reviewer: Client, admin: Client, ground: Ground
) -> None:
    for _ in range(COUNT):
        measure(reviewer, add_vehicle(reviewer, ground.recording_id)["id"])
    lot = draw(reviewer, ground.survey_id)
    assert lot["progress"]["own"] == lot["lot"]["sample_size"] and lot["progress"]["next_measurement"] is None
    gone = reviewer.post(f"/lots/{lot['lot']['id']}/dissolve").json()
    assert gone["state"] == "dissolved"
    lot = draw(reviewer, ground.survey_id)
    assert lot["lot"]["number"] == 2
    for one in sample_of(admin, lot):
        judge(admin, one)
    refused = reviewer.post(f"/lots/{lot['lot']['id']}/accept")
    assert refused.status_code == 403 and "your own heights" in error_of(refused)
    assert admin.post(f"/lots/{lot['lot']['id']}/accept").json()["state"] == "accepted"


@pytest.mark.dialect
def test_who_only_restored_heights_may_accept_their_lot(
    reviewer: Client, ground: Ground, made: list[dict[str, Any]]
) -> None:
    for one in made:
        path = f"/measurements/{one['id']}"
        assert reviewer.delete(f"{path}?revision=1").status_code == 200
        assert reviewer.post(f"{path}/restore", {"revision": 2}).status_code == 200
    lot = draw(reviewer, ground.survey_id)
    assert lot["progress"]["own"] == 0
    for one in sample_of(reviewer, lot):
        assert judge(reviewer, one).status_code == 201
    assert reviewer.post(f"/lots/{lot['lot']['id']}/accept").json()["state"] == "accepted"


@pytest.mark.parametrize(
    ("risks", "words"),
    [
        ({"producer_quality": 0.3}, "must be smaller"),
        ({"consumer_risk": 0.0}, "Enter a risk"),
        ({"consumer_quality": 1.5}, "a fraction nonconforming"),
    ],
)
def test_risks_that_are_none_are_refused_in_one_sentence(
    reviewer: Client, ground: Ground, risks: dict[str, float], words: str
) -> None:
    refused = reviewer.post(f"/surveys/{ground.survey_id}/lots", {"by": [], **RISKS, **risks})
    assert refused.status_code == 422 and words in error_of(refused)


def test_a_fix_conforms_up_to_u95_and_a_reopened_item_waits_again() -> None:
    def one(now_m: float | None, *said: Judgement, u95: float = 0.02) -> Any:
        heights = {1: (1.5, u95), 2: (now_m, 0.02)}
        newest = max(each.result_revision for each in said)
        item = ItemNow(7, 1, 1, newest, said=said, heights=heights)
        return items_of([item], 1)[0].conforming

    fixed = Judgement(1, 2, "fixed")
    assert one(1.519, fixed) is True and one(1.521, fixed) is False and one(None, fixed) is False
    assert one(1.519, fixed, Judgement(2, 2, "reopened")) is None
    assert one(1.519, fixed, Judgement(2, 2, "rejected")) is False
    assert one(1.521, fixed, Judgement(2, 2, "accepted")) is False


def test_what_was_rejected_reopened_and_changed_does_not_leave_the_sample() -> None:
    """Else a reviewer and an operator lead a wrong height out of it, and the next of the draw follows."""
    said = Judgement(1, 1, "rejected"), Judgement(1, 1, "reopened")
    next_one = ItemNow(8, 1, 2, 1)
    for newest, gone in ((2, None), (2, "withdrawn"), (1, "vehicle_deleted")):
        first, second = items_of([ItemNow(7, 1, 1, newest, gone, said), next_one], 1)
        assert (first.role, first.conforming, second.role) == ("sample", False, "rest"), (newest, gone)
    waits, _ = items_of([ItemNow(7, 1, 1, 1, None, said), next_one], 1)
    assert (waits.role, waits.conforming) == ("sample", None)


def test_a_lot_that_was_judged_is_not_dissolved_because_the_verdict_was_reopened(
    reviewer: Client,
    operator: Client,
    ground: Ground,
    made: list[dict[str, Any]],
    services: Services,
    tmp_path: Path,
) -> None:
    """Else whoever dislikes a sample could reopen what it showed and draw another."""
    lot = draw(reviewer, ground.survey_id)
    first, *others = sample_of(reviewer, lot)
    assert judge(reviewer, first, "rejected", reason="mirror").status_code == 201
    assert judge(reviewer, first, "reopened", reason="look again").status_code == 201
    late = reviewer.post(f"/lots/{lot['lot']['id']}/dissolve")
    assert late.status_code == 409 and "cannot be dissolved" in error_of(late)
    points = {name: value for name, value in clicks(1.25).items() if name != "target"}
    assert operator.put(f"/measurements/{first['id']}", {"revision": 1, **points}).status_code == 200
    for one in others:
        judge(reviewer, one)
    (shown,) = lots(reviewer, ground)
    assert shown["progress"]["nonconforming"] == 1 and not shown["progress"]["may_accept"]
    assert reviewer.post(f"/lots/{lot['lot']['id']}/inspect").status_code == 200
    place = written(services, ground.survey_id, tmp_path / "export")
    assert (found := verify_package(FolderFiles(place))).ok, found.problem


def test_the_draw_is_the_seeds_and_every_measurement_has_the_same_chance() -> None:
    items = [(number, 1) for number in range(1, 41)]
    seed = seed_of("0" * 64, items)
    assert seed == seed_of("0" * 64, reversed(items)) != seed_of("1" * 64, items)
    assert seed_of("0" * 64, [*items[:-1], (40, 2)]) != seed
    order = drawn_order(seed, range(1, 41))
    assert sorted(order) == list(range(1, 41)) and order == drawn_order(seed, range(40, 0, -1))
    drawn = np.zeros(41)
    for n in range(4000):
        drawn[drawn_order(seed_of(str(n), items), range(1, 41))[:10]] += 1
    assert abs(drawn[1:] / 4000 - 0.25).max() < 5 * (0.25 * 0.75 / 4000) ** 0.5


# -- the package ---------------------------------------------------------------------------------------------


_BUILT: dict[str, Path] = {}


@pytest.fixture
def package(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory, tmp_path: Path) -> Path:
    """A copy of that survey's package; it is built by the first test that asks."""
    if "place" not in _BUILT:
        ground: Ground = request.getfixturevalue("decided")
        place = tmp_path_factory.mktemp("lots") / "export"
        _BUILT["place"] = written(request.getfixturevalue("services"), ground.survey_id, place)
    return shutil.copytree(_BUILT["place"], tmp_path / "export")


@pytest.fixture
def decided(reviewer: Client, operator: Client, ground: Ground, made: list[dict[str, Any]]) -> Ground:
    """One lot accepted, one taken back, one open, and a height of the sample whose vehicle was deleted."""
    lot = draw(reviewer, ground.survey_id)
    sample = sample_of(reviewer, lot)
    for one in sample:
        judge(reviewer, one)
    assert reviewer.post(f"/lots/{lot['lot']['id']}/accept").status_code == 200
    assert reviewer.post(f"/lots/{lot['lot']['id']}/take-back").status_code == 200
    second = draw(reviewer, ground.survey_id)
    for one in sample_of(reviewer, second):
        judge(reviewer, one)
    assert reviewer.post(f"/lots/{second['lot']['id']}/accept").status_code == 200
    operator.delete(f"/vehicles/{sample[0]['vehicle_id']}")
    for _ in range(COUNT):
        measure(operator, add_vehicle(operator, ground.recording_id)["id"])
    draw(reviewer, ground.survey_id)
    return ground


def check(place: Path) -> str | None:
    return verify_package(FolderFiles(place)).problem


def event_of(place: Path, entity: str, change: Callable[[dict[str, Any]], None], which: int = 0) -> None:
    """Rewrite an event and every hash after it, as who holds the key could."""
    events = rows(place, "audit.csv")
    at = [n for n, one in enumerate(events) if one["entity"] == entity and one["action"] != "x"][which]
    after = json.loads(events[at]["after"])
    change(after)
    events[at]["after"] = json.dumps(after, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
    rewrite(place, "audit.csv", rehash(events, max(at, 1)))
    reseal(place)


@pytest.mark.once
def test_what_lots_let_through_is_told_of_the_vehicles_that_count(package: Path) -> None:
    """Of one of them, where the package is of its class alone."""
    one = next(row for row in rows(package, "measurements.csv") if row["verdict_by"] == "lot")
    cars = rows(package, "vehicles.csv")
    rewrite(
        package,
        "vehicles.csv",
        [{**car, "category": "suv" * (car["id"] == one["vehicle_id"])} for car in cars],
    )
    (package / "tables" / "selection.csv").write_text("by,word\r\ncategory,suv\r\n")
    counts = verdicts_in(FolderFiles(package))
    assert counts.outgoing is not None
    assert (counts.by_lot, counts.lots, counts.outgoing.count, counts.outgoing.at_most) == (1, 1, 1, 1)


@pytest.mark.once
def test_a_package_tells_which_verdicts_are_by_lot_and_what_is_forged_is_found(package: Path) -> None:
    assert check(package) is None
    told = rows(package, "lots.csv")
    assert [one["state"] for one in told] == ["taken_back", "accepted", "open"]
    assert int(told[1]["outgoing_at_most"]) > 0 and told[0]["outgoing_at_most"] == ""
    judged = [(one["verdict"], one["verdict_by"], one["lot_id"]) for one in rows(package, "measurements.csv")]
    assert ("accepted", "lot", told[1]["id"]) in judged and ("accepted", "individual", "") in judged
    assert ("to_review", "", "") in judged
    counts = verdicts_in(FolderFiles(package))
    assert (counts.by_lot, counts.individual) == tuple(
        sum(one[:2] == ("accepted", basis) for one in judged) for basis in ("lot", "individual")
    )
    assert counts.outgoing is not None and counts.outgoing.at_most == int(told[1]["outgoing_at_most"])
    report = " ".join(words((package / "report.pdf").read_bytes()).split())
    assert (
        f"{counts.by_lot} by the sample of their lot" in report
        and "not reviewed individually in 1 accepted" in report
    )
    for name, column, value, said in (
        ("lots.csv", "seed", "0" * 64, "lots.csv: seed of row 1 differs from its audit events"),
        (
            "lots.csv",
            "acceptance_number",
            "3",
            "lots.csv: acceptance_number of row 1 differs from its audit events",
        ),
        ("lots.csv", "nonconforming", "2", "lots.csv: nonconforming of row 1 differs from its audit events"),
        ("lot_items.csv", "role", "left", "lot_items.csv: role of row"),
        ("measurements.csv", "verdict_by", "individual", "verdict on"),
        ("reviews.csv", "lot_id", "2", "differs from its audit event"),
    ):
        place = package / place_of(FolderFiles(package), name)
        kept = place.read_bytes()
        edit(
            package,
            name,
            lambda row, column=column, value=value: _another(row, column, value),
            **{column: value},
        )  # type: ignore[misc]
        reseal(package)
        assert said in str(check(package)), (name, column)
        place.write_bytes(kept)


def _another(row: dict[str, str], column: str, value: str) -> bool:
    if column == "verdict_by":
        return row[column] == "lot"
    if column == "lot_id":
        return row[column] == "1"
    return row.get("id", "1") == "1" and row[column] not in ("", value)


@pytest.mark.once
@pytest.mark.parametrize(
    ("entity", "which", "change", "said"),
    [
        ("lot", 1, {"seed": "ab" * 32}, "another lot than it hashed"),
        ("lot_decision", 0, {"nonconforming": 1}, "another lot than it hashed"),
    ],
)
def test_an_event_that_was_changed_with_every_hash_is_found(
    package: Path, entity: str, which: int, change: dict[str, Any], said: str
) -> None:
    event_of(package, entity, lambda after: after.update(change), which)
    assert said in str(check(package))


@pytest.mark.once
@pytest.mark.parametrize("forge", ["seed", "sample", "plan", "verdicts", "counts", "rest", "accepted"])
def test_who_writes_rows_events_and_every_hash_anew_meets_the_rules_of_the_draw(
    package: Path, forge: str
) -> None:
    entity, which, change, cells, said = _FORGERIES[forge]
    if forge == "counts":
        row = next(one for one in rows(package, "lots.csv") if one["id"] == "2")
        lets = estimate_outgoing(int(row["judged"]) + int(row["rest"]), int(row["judged"]), 1)
        cells = {"nonconforming": "1", "outgoing_at_most": str(lets.at_most)}
        cells["outgoing_estimate"] = repr(round(lets.estimate, 6))
    if cells:
        edit(package, "lots.csv", lambda row: row["id"] == "2", **cells)
    event_of(package, entity, change, which)
    assert said in str(check(package)), check(package)


def _rehashed(change: Callable[[dict[str, Any]], None]) -> Callable[[dict[str, Any]], None]:
    from sightline.infra.audit.hashing import content_hash

    def both(after: dict[str, Any]) -> None:
        change(after)
        apart = ("content_sha256", "items")
        after["content_sha256"] = content_hash({k: v for k, v in after.items() if k not in apart})

    return both


def _seed(after: dict[str, Any]) -> None:
    """A seed that was chosen, with the order that follows from it."""
    after["seed"] = "ab" * 32
    revision = dict(after["items"])
    after["items"] = [[one, revision[one]] for one in drawn_order(after["seed"], revision)]


def _sample(after: dict[str, Any]) -> None:
    after["items"] = [after["items"][-1], *after["items"][1:-1], after["items"][0]]


Forgery = tuple[str, int, Callable[[dict[str, Any]], None], dict[str, str], str]
_FORGERIES: dict[str, Forgery] = {
    "seed": ("lot", 1, _rehashed(_seed), {"seed": "ab" * 32}, "does not follow from the audit chain"),
    "sample": ("lot", 1, _rehashed(_sample), {}, "lot 2 was not drawn in the order of its seed"),
    "plan": (
        "lot",
        1,
        _rehashed(lambda after: after.update(sample_size=1)),
        {"sample_size": "1"},
        "the plan of lot 2 does not keep the risks",
    ),
    "verdicts": (
        "lot_decision",
        2,
        _rehashed(lambda after: after["sample"].pop()),
        {},
        "the sample of lot 2 is not the first of its draw",
    ),
    "counts": (
        "lot_decision",
        2,
        _rehashed(lambda after: after.update(nonconforming=1)),
        {},
        "the counts of lot 2 are not those",
    ),
    "rest": (
        "lot_decision",
        2,
        _rehashed(lambda after: after["left_out"].update({str(after["sample"][0]): "withdrawn"})),
        {},
        "the sample of lot 2 is not the first of its draw",
    ),
    "accepted": (
        "lot_decision",
        2,
        _rehashed(lambda after: after.update(choice="full_inspection")),
        {"state": "full_inspection", "outgoing_estimate": "", "outgoing_at_most": ""},
        "the verdicts by lot 2 are not those of its rest",
    ),
}


@pytest.mark.once
def test_items_changed_behind_the_programs_back_are_found(
    reviewer: Client, ground: Ground, made: list[dict[str, Any]], services: Services
) -> None:
    draw(reviewer, ground.survey_id)
    with services.writing() as session:
        session.execute(text("DROP TRIGGER IF EXISTS lot_items_update"))
        for name in session.execute(
            text("SELECT name FROM sqlite_master WHERE type = 'trigger' AND tbl_name = 'lot_items'")
        ).scalars():
            session.execute(text(f"DROP TRIGGER {name}"))
        session.execute(text("UPDATE lot_items SET revision = 2 WHERE place = 1"))
    with services.reading() as session:
        assert "items of lot" in str(verify_records(session).problem)
