"""Statistics of stored measurements against a recount in plain Python; what is said where there are few."""

import statistics as plain
from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from random import Random
from typing import Any

import pytest

from sightline.infra.audit import trail
from sightline.infra.csv_package.files import Staging
from sightline.infra.services import Services
from sightline.measurements import store
from sightline.results.csv import STANDARDS, standards_in
from sightline.results.standards_store import get_standards
from sightline.results.usual_standards import STANDARDS as USUAL
from sightline.results.usual_standards import in_language, stored_standards
from sightline.reviews.store import add_review
from sightline.surveys.store import create_survey
from sightline.vehicles.store import create_vehicle, update_vehicle
from tests.support import samples
from tests.support.app import Client, error_of
from tests.support.samples import KEY, Sample

pytestmark = pytest.mark.dialect

VEHICLES = 26
NOON = datetime(2025, 5, 1, 12, tzinfo=UTC)
TARGETS = ("roof", "driver_eye", "taillight")
CATEGORIES = ("hatchback", "suv", None)
VERDICTS = ("accepted", "fixed", "rejected", None)


@dataclass(frozen=True)
class Told:
    """What the test itself knows of a measurement that stands."""

    vehicle_id: int
    target: str
    height_m: float
    paper_m: float
    reference_m: float | None
    lighting: str | None
    category: str | None
    operator_id: int
    day: datetime
    verdict: str | None


@dataclass(frozen=True)
class Ground:
    one: Sample
    told: list[Told]


@pytest.fixture
def ground(services: Services, monkeypatch: pytest.MonkeyPatch) -> Ground:
    """Vehicles measured by two people on four days, and what must never count."""
    random, told = Random(5), []
    with services.writing() as session:
        one = samples.sample(session)
        for n in range(VEHICLES):
            day = NOON + timedelta(days=n % 4)
            monkeypatch.setattr(store, "now", lambda day=day: day)
            reference = None if n % 5 == 4 else round(1.4 + 0.013 * n, 3)
            lighting: Any = ("daytime", "low_light")[n % 3 == 2]
            category: Any = CATEGORIES[n % 3]
            fields: Any = {
                "first_frame": 10,
                "last_frame": 40,
                "lighting": lighting,
                "category": category,
                "manufacturer_height_m": reference,
                "u_manufacturer_height_m": None if reference is None else 0.015,
            }
            car = create_vehicle(session, one.recording.id, fields, actor=one.olga.id)
            for k, target in enumerate(TARGETS):
                true = {"roof": reference or 1.5, "driver_eye": 1.15, "taillight": 0.8}[target]
                height, paper = true + random.gauss(0, 0.01), true + random.gauss(0.03, 0.012)
                operator = (one.olga, one.rene)[n % 2]
                other = (one.rene, one.olga)[n % 2]
                content: Any = samples.values(one, target=target, height_m=9.9, uncorrected_height_m=9.9)
                made = store.add_measurement(
                    session, car.id, client_key=KEY.format(n * 3 + k), values=content, actor=operator.id
                )
                content = replace(content, height_m=height, uncorrected_height_m=paper)
                made = store.revise_measurement(session, made, content, actor=operator.id)
                verdict: Any = VERDICTS[(n + k) % 4] if n >= 6 else "accepted"
                if verdict == "fixed":
                    x, y = content.target_point
                    content = replace(content, height_m=height + 0.004, target_point=(x, y - 0.5))
                    height += 0.004
                if verdict:
                    verdict = judge(session, made, verdict, content, other.id)
                if n % 4 == 0:
                    repeated = samples.values(one, target=target, height_m=7.7, uncorrected_height_m=7.7)
                    store.add_measurement(
                        session,
                        car.id,
                        client_key=KEY.format(1000 + n * 3 + k),
                        values=repeated,
                        repeat_of=made.id,
                        actor=other.id,
                    )
                if n % 7 == 6:
                    current = store.get_measurement(session, made.id)
                    store.withdraw_measurement(
                        session, made.id, seen_revision=current.revision, actor=operator.id
                    )
                    continue
                who = other.id if verdict == "fixed" else operator.id
                told.append(
                    Told(
                        car.id,
                        target,
                        *(float(f"{one:.6f}") for one in (height, paper)),  # as a package writes them
                        reference,
                        lighting,
                        category,
                        who,
                        day,
                        verdict,
                    )
                )
    return Ground(one, told)


def judge(session: Any, made: Any, verdict: Any, content: Any, actor: int) -> str:
    """A reviewer's verdict; "fixed" stores the better content."""
    reason = "Blurred." if verdict == "rejected" else None
    fixed = content if verdict == "fixed" else None
    add_review(session, made.id, seen_revision=2, verdict=verdict, reason=reason, fixed=fixed, actor=actor)
    return str(verdict)


ACCEPTED = ("accepted", "fixed")
Keep = Callable[[Told, Ground], bool]
FILTERS: dict[str, tuple[str, Keep]] = {
    "nothing": ("", lambda t, g: t.verdict in ACCEPTED),
    "daytime": ("lighting=daytime", lambda t, g: t.verdict in ACCEPTED and t.lighting == "daytime"),
    "low light": ("lighting=low_light", lambda t, g: t.verdict in ACCEPTED and t.lighting == "low_light"),
    "category": ("category=suv", lambda t, g: t.verdict in ACCEPTED and t.category == "suv"),
    "operator": (
        "operator={rene}",
        lambda t, g: t.verdict in ACCEPTED and t.operator_id == g.one.rene.id,
    ),
    "one day": (
        "first_day=2025-05-02&last_day=2025-05-02",
        lambda t, g: t.verdict in ACCEPTED and t.day.day == 2,
    ),
    "from a day": ("first_day=2025-05-03", lambda t, g: t.verdict in ACCEPTED and t.day.day >= 3),
    "to a day": ("last_day=2025-05-01", lambda t, g: t.verdict in ACCEPTED and t.day.day == 1),
    "to review": ("state=to_review", lambda t, g: t.verdict is None),
    "rejected": ("state=rejected", lambda t, g: t.verdict == "rejected"),
    "all": ("state=all", lambda t, g: True),
    "target": ("target=taillight", lambda t, g: t.verdict in ACCEPTED and t.target == "taillight"),
    "several": (
        "survey={survey}&lighting=daytime&category=hatchback&state=all",
        lambda t, g: t.lighting == "daytime" and t.category == "hatchback",
    ),
}


def filters_are_a_recount(viewer: Client, ground: Ground) -> None:
    for name, (query, keep) in FILTERS.items():
        left = [one for one in ground.told if keep(one, ground)]
        query = query.format(rene=ground.one.rene.id, survey=ground.one.survey.id)
        found = viewer.seen(f"/statistics?rounding=none&{query}")
        assert len(left) > 2, name
        assert found["counted"]["measurements"] == len(left), name
        assert found["of_chosen"] == ("category=" in query), name
        assert found["counted"]["vehicles"] == len({one.vehicle_id for one in left}), name
        same_but_state = found["counted"]["measurements"] + sum(found["counted"]["left_out"].values())
        assert same_but_state >= len(left)
        # a target limits what is counted and shown; errors are those of the roofs anyway
        roofs = [
            t for t in ground.told if keep(replace(t, target="taillight"), ground) and t.target == "roof"
        ]
        errors = [t.height_m - t.reference_m for t in roofs if t.reference_m is not None]
        overall = found["errors"]["groups"][2]
        assert overall["n"] == found["counted"]["with_reference"] == len(errors), name
        if len(errors) > 1:
            figures = {key: one["value"] for key, one in overall["figures"].items()}
            assert figures["bias_m"] == pytest.approx(plain.fmean(errors), abs=1e-12), name
            assert figures["mae_m"] == pytest.approx(plain.fmean(map(abs, errors)), abs=1e-12), name
            assert figures["sd_m"] == pytest.approx(plain.stdev(errors), abs=1e-12), name
        assert len(found["targets"]) == (1 if name == "target" else 4)
        for target in found["targets"]:
            heights = [one.height_m for one in left if one.target == target["target"]]
            paper = [one.paper_m for one in left if one.target == target["target"]]
            assert (target["corrected"]["n"], target["raw"]["n"]) == (len(heights), len(paper)), name
            if heights:
                assert target["corrected"]["mean_m"] == pytest.approx(plain.fmean(heights), abs=1e-12), name
                assert target["raw"]["mean_m"] == pytest.approx(plain.fmean(paper), abs=1e-12), name


def groups_and_shares_are_a_recount(viewer: Client, ground: Ground) -> None:
    found = viewer.seen("/statistics?state=all&eye_limit_m=1.15")
    eye = found["targets"][0]
    left = [one for one in ground.told if one.target == "driver_eye"]
    words = {"category": "category", "lighting": "lighting"}
    for grouping, field in words.items():
        counted = {g["word"]: (g["n"], g["mean_m"]) for g in eye["groups"][grouping]["groups"]}
        wanted = {getattr(one, field) for one in left} - {None}
        assert set(counted) == wanted
        for word, (n, mean) in counted.items():
            heights = [one.height_m for one in left if getattr(one, field) == word]
            assert n == len(heights) and mean == pytest.approx(plain.fmean(heights), abs=1e-12)
    assert [g["word"] for g in eye["groups"]["site"]["groups"]] == ["lane 1"]
    assert {g["word"] for g in eye["groups"]["operator"]["groups"]} == {"Olga", "René"}
    assert {one["name"] for one in found["operators"]} == {"Olga", "René"}
    own = next(one for one in eye["corrected"]["shares"] if one["standard"]["name"] == "own value")
    below = sum(one.height_m < 1.15 for one in left)
    assert (own["below"], own["n"]) == (below, len(left)) and own["low"] < own["share"] < own["high"]
    ecdf = eye["corrected"]["ecdf"]
    middle = sorted(one.height_m for one in left)[len(left) // 2 - 1]
    at = max(i for i, value in enumerate(ecdf["value"]) if value <= middle + 1e-6)
    assert ecdf["share"][at] == pytest.approx((len(left) // 2) / len(left), abs=1e-5)


def corrections_do_what_they_say(viewer: Client, ground: Ground) -> None:
    left = [one for one in ground.told if one.verdict in ACCEPTED]
    roofs = [(t.paper_m, t.reference_m) for t in left if t.target == "roof" and t.reference_m is not None]
    shift = plain.fmean(measured - reference for measured, reference in roofs)
    eyes = plain.fmean(t.paper_m for t in left if t.target == "driver_eye")
    found = {
        kind: viewer.seen(f"/statistics?correction={kind}")["targets"][0]["corrected"]
        for kind in ("none", "shift", "regression", "deconvolution")
    }
    assert found["none"]["mean_m"] == pytest.approx(eyes, abs=1e-12)
    assert found["shift"]["mean_m"] == pytest.approx(eyes - shift, abs=1e-12)
    assert f"{len(roofs)} vehicles" in found["shift"]["words"]["message"]
    assert "extrapolates" in found["regression"]["warning"]["message"]
    narrower = found["deconvolution"]["sd_m"] or 0.0
    assert found["deconvolution"]["reason"] or narrower < found["shift"]["sd_m"]


def test_statistics_are_a_recount(viewer: Client, services: Services, ground: Ground) -> None:
    filters_are_a_recount(viewer, ground)
    groups_and_shares_are_a_recount(viewer, ground)
    corrections_do_what_they_say(viewer, ground)
    # a write makes the kept answer old
    before = viewer.seen("/statistics?state=all")["counted"]["measurements"]
    assert viewer.seen("/statistics?state=all")["counted"]["measurements"] == before
    with services.writing() as session:
        samples.measure(session, ground.one, key=5000)
    assert viewer.seen("/statistics?state=all")["counted"]["measurements"] == before + 1


def test_empty_one_and_few_have_reasons(viewer: Client, services: Services) -> None:
    empty = viewer.seen("/statistics")
    assert empty["counted"]["measurements"] == 0 and len(empty["standards"]) == len(USUAL)
    assert "no counted height" in empty["errors"]["groups"][0]["reason"]["message"]
    assert "at least 4" in empty["errors"]["trend"]["reason"]["message"]
    assert "reason" in empty["targets"][0]["corrected"]["ecdf"]
    assert empty["targets"][0]["corrected"]["percentiles"] == []
    assert viewer.seen("/statistics?correction=shift")["targets"][0]["corrected"]["reason"]
    with services.writing() as session:
        one = samples.sample(session)
        update_vehicle(session, one.vehicle.id, {"manufacturer_height_m": 1.6}, version=1, actor=None)
        samples.measure(session, one)
        second = create_survey(session, name="Other", open_to_all=True, actor=None)
    waiting = viewer.seen("/statistics")
    assert waiting["counted"] == {
        "measurements": 0,
        "vehicles": 0,
        "with_reference": 0,
        "by_size": 0,
        "without_class": 0,
        "without_time": 0,
        "left_out": {"to_review": 1},
    }
    found = viewer.seen(f"/statistics?state=all&survey={one.survey.id}&survey={second.id}")
    overall = found["errors"]["groups"][2]
    assert overall["n"] == 1 and "too few" in overall["reason"]["message"]
    assert overall["figures"]["bias_m"]["value"] == pytest.approx(0.018034, abs=1e-12)
    # 1.618 against 1.600: 2 cm when both are rounded
    paper = viewer.seen(f"/statistics?state=all&survey={one.survey.id}&rounding=cm")["errors"]["groups"][2]
    assert paper["figures"]["bias_m"]["value"] == pytest.approx(0.02, abs=1e-12)
    none = {"value": None, "ci95": None, "reason": None, "holds": []}
    assert overall["figures"]["sd_m"] == none
    roof = found["targets"][3]["raw"]
    assert [one["low"] for one in roof["percentiles"]] == [None] * 11
    assert roof["percentiles"][0]["reason"]["message"] == "P2 needs 183; there is 1"
    assert [one["value"] for one in roof["percentiles"]] == [None] * 11
    assert "at least 10" in found["targets"][3]["density"]["reason"]["message"]


REST = {
    "edition": "",
    "year": None,
    "percent": None,
    "vehicle_class": "",
    "cited_by": "",
    "drawn": True,
    "code": None,
}


@pytest.mark.once
def test_a_standard_of_the_program_keeps_its_code_until_its_words_change(
    operator: Client, ground: Ground
) -> None:
    path = f"/surveys/{ground.one.survey.id}/standards"
    first, second, third, *_ = operator.seen(path)["standards"]
    assert [one["code"] for one in (first, second)] == ["usa_eye_car", "usa_object_stopping"]
    kept, written = {**first, "height_m": 1.1, "drawn": False}, {**second, "vehicle_class": "my class"}
    made_up = {**third, "code": "usa_eye_car"}
    told = operator.put(path, json={"version": 0, "standards": [kept, written, made_up]}).json()
    assert told["standards"] == [kept, {**written, "code": None}, {**made_up, "code": None}]


def test_standards_of_before_codes_get_them_by_their_words() -> None:
    stored = [{name: value for name, value in asdict(one).items() if name != "code"} for one in USUAL]
    stored[0]["name"] = "AASHTO"
    read = stored_standards(stored)
    assert [one.code for one in read] == [None, *(one.code for one in USUAL[1:])]
    assert stored_standards([asdict(replace(USUAL[1], code=None))])[0].code is None


def test_the_words_of_the_program_s_standards_are_said_in_each_language() -> None:
    french = {one.code: in_language(one, "fr") for one in USUAL}
    english = {one.code: in_language(one, "en") for one in USUAL}
    assert all(english[one.code].name == one.name for one in USUAL) and None not in french
    assert english["germany_eye_car"].cited_by == "an unrecorded source"  # better than it is stored
    assert french["uk_object_low"].name == "Royaume-Uni, bas"
    assert french["germany_eye_car"].source == "RAL (auparavant RAS-L)"
    written = replace(USUAL[9], code=None)
    assert written.name == "United Kingdom" and in_language(written, "fr") is written


def test_a_survey_has_its_own_standards(
    viewer: Client, operator: Client, services: Services, ground: Ground
) -> None:
    one = ground.one.survey.id
    usual = viewer.seen(f"/surveys/{one}/standards")
    assert usual["version"] == 0 and usual["standards"] == viewer.seen("/statistics")["standards"]
    table = [{**REST, "name": "House rule", "what": "eye_car", "height_m": 1.15, "source": "By-law 7"}]
    told = operator.put(f"/surveys/{one}/standards", json={"version": 0, "standards": table}).json()
    assert told["standards"] == table and told["version"] > 0
    assert viewer.seen(f"/surveys/{one}/standards") == told
    with services.writing() as session:
        other = create_survey(session, name="Other", open_to_all=True, actor=None).id
    found = viewer.seen(f"/statistics?survey={one}&state=all")
    assert found["standards"] == table
    eyes = [t.height_m for t in ground.told if t.target == "driver_eye"]
    share = found["targets"][0]["corrected"]["shares"][0]
    assert share["standard"] == table[0] and share["below"] == sum(eye < 1.15 for eye in eyes)
    assert viewer.seen(f"/statistics?survey={other}")["standards"] == usual["standards"]
    assert viewer.seen("/statistics")["standards"] == [*usual["standards"], *table]
    with services.reading() as session:
        event = trail.listing(session, survey_id=one, entity="standards")[0]
    assert event.after == {"standards": table} and event.before == {"standards": usual["standards"]}


@pytest.mark.once
def test_a_surveys_standards_go_into_its_package(
    operator: Client, services: Services, ground: Ground, tmp_path: Path
) -> None:
    one = ground.one.survey.id
    given = {"name": "=House, rule", "what": "eye_truck", "height_m": 1.15, "source": '"By-law" 7'}
    table = [{**REST, **given, "year": 2020, "percent": 2.5, "drawn": False}, {**REST, **given, "name": "B"}]
    assert operator.put(f"/surveys/{one}/standards", json={"version": 0, "standards": table}).is_success
    staging = Staging(tmp_path)
    with services.reading() as session:
        staging.fill(STANDARDS, get_standards(session, one).standards)
    assert [asdict(standard) for standard in standards_in(staging.files())] == table


@pytest.mark.once
def test_a_table_of_standards_that_cannot_be_is_refused(operator: Client, ground: Ground) -> None:
    path = f"/surveys/{ground.one.survey.id}/standards"
    row = {"name": "A", "what": "object_stopping", "height_m": 0.6, "source": ""}
    bad: list[tuple[list[dict[str, Any]], str]] = [
        ([row, row], "twice"),
        ([{**row, "name": "  "}], "needs a name"),
        ([{**row, "height_m": 0}], "between 0 and 10 m"),
        ([{**row, "percent": 100}], "percentile"),
        ([{**row, "name": f"A{n}"} for n in range(41)], "40 are the maximum"),
    ]
    for table, word in bad:
        answer = operator.put(path, json={"version": 0, "standards": table})
        assert answer.status_code == 422 and word in error_of(answer)
    assert operator.put(path, json={"version": 0, "standards": [row]}).status_code == 200
    late = operator.put(path, json={"version": 0, "standards": []})
    assert late.status_code == 409 and "meanwhile" in error_of(late)
    missing = operator.put("/surveys/77/standards", json={"version": 0, "standards": []})
    assert missing.status_code == 404


@pytest.mark.once
def test_the_paper_stands_beside(viewer: Client) -> None:
    paper = viewer.seen("/statistics")["errors"]["paper"]
    assert [(one["n"], one["mae_m"], one["rmse_m"]) for one in paper] == [
        (400, 0.023, 0.028),
        (250, 0.0147, 0.019),
        (650, 0.0203, 0.026),
    ]
    day, low, both = paper
    pooled = (400 * day["mae_m"] + 250 * low["mae_m"]) / 650
    assert f"{pooled:.4f} m" in both["note"]["message"] and abs(pooled - both["mae_m"]) > 0.0004


@pytest.mark.once
def test_bad_input_is_a_sentence(viewer: Client) -> None:
    bad = (
        "first_day=2025-05-02&last_day=2025-05-01",
        "u_reference_m=-1",
        "eye_limit_m=12",
        "lighting=dusk",
        "survey=0",
        "first_day=yesterday",
    )
    for query in bad:
        answer = viewer.get(f"/statistics?{query}")
        assert answer.status_code == 422, query
        error_of(answer)
    missing = viewer.get("/statistics?survey=77")
    assert missing.status_code == 404 and "no survey 77" in error_of(missing)


@pytest.mark.once
def test_sample_size(viewer: Client) -> None:
    found = viewer.seen("/statistics/sample-size?percent=50&width_m=0.02&sd_m=0.08")
    # 2 z sqrt(0.25 / n) sd sqrt(2 pi) = width
    assert found["vehicles"] == pytest.approx((2 * 1.959964 * 0.5 * 0.08 * 2.506628 / 0.02) ** 2, rel=0.01)
    for query in ("percent=0&width_m=0.02&sd_m=0.08", "percent=10&width_m=0&sd_m=0.08"):
        answer = viewer.get(f"/statistics/sample-size?{query}")
        assert answer.status_code == 422
        error_of(answer)


@pytest.mark.once
def test_targets_are_read_against_the_standards_of_their_kind(viewer: Client, ground: Ground) -> None:
    """Trucks' eyes, headlights of sags, superseded values and upper ends of ranges are no one's to fall
    below.
    """
    found = viewer.seen(f"/statistics?state=all&survey={ground.one.survey.id}")
    against = {
        one["target"]: {(s["standard"]["what"], s["standard"]["name"]) for s in one["corrected"]["shares"]}
        for one in found["targets"]
    }
    assert {what for what, _ in against["driver_eye"]} == {"eye_car"}
    assert {what for what, _ in against["taillight"]} == {"object_stopping"}
    assert against["roof"] == set()
    named = {name for _, name in against["driver_eye"] | against["taillight"]}
    assert not {"AASHTO (USA), 1965", "United Kingdom, high"} & named


@pytest.mark.once
def test_no_standard_claims_more_than_its_source() -> None:
    """A value that nobody was seen to cite states no percentile, and each kind and name stands there once."""
    assert len({(one.what, one.name) for one in USUAL}) == len(USUAL)
    for one in USUAL:
        assert one.source and (one.cited_by or "Austroads" in one.source), one.name
        assert not ("nobody" in one.cited_by and one.percent is not None), one.name
