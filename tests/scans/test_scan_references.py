"""Reference values of scanned vehicles: said on the bench or in a CSV, compared; runs of one car."""

from dataclasses import replace
from datetime import datetime, timedelta
from typing import Any

import httpx2
import pytest

from sightline.coverage import COVERAGE_95
from sightline.errors import BadInput
from sightline.infra.audit.verification import verify_records
from sightline.infra.local_time import instant_of
from sightline.infra.services import Services
from sightline.linescan.parts import CUT
from sightline.recordings.filming import Filming
from sightline.scans.records import StripSource
from sightline.scans.references.passing_times import Matching, PassedAt
from sightline.scans.store import create_scan, note_scan_read
from sightline.scans.vehicles.measurement_store import append_scan_measurement
from sightline.scans.vehicles.review_store import add_scan_review
from sightline.scans.vehicles.store import create_scan_vehicle
from tests.support import scans_samples
from tests.support.app import Client, error_of
from tests.support.events import events_of

pytestmark = pytest.mark.dialect
SOURCE = (StripSource("a.tif", "aa/a.tif", "aa" * 32), StripSource("b.tif", "bb/b.tif", "bb" * 32))
LENGTHS_M = (4.740, 4.745, 4.751, 4.738)


def words_of(row: dict[str, Any]) -> str:
    return " ".join(one["message"] for one in row["words"])


@pytest.fixture
def scan_id(services: Services, survey_id: int) -> int:
    """Four measured vehicles at 19.31415 +- 0.011 m/s, and a fifth without a motion; none is reviewed."""
    nothing: dict[str, Any] = dict.fromkeys(("speed_mps", "u_speed_mps", "length_m", "u_length_m"))
    with services.writing() as session:
        rig = scans_samples.RIG
        made = create_scan(
            session, survey_id, name="Gate", source=SOURCE, time_axis="width", rig=rig, actor=None
        )
        note_scan_read(session, made.id, replace(scans_samples.facts(), lines=20_000), actor=None)
        told = [scans_samples.values(front_line_1=100.0 * n, length_m=m) for n, m in enumerate(LENGTHS_M, 1)]
        told.append(scans_samples.values(front_line_1=900.0, status="not_measurable", reason=CUT, **nothing))
        for values in told:
            one = create_scan_vehicle(session, made.id, origin="found", actor=None)
            append_scan_measurement(session, one.id, values, actor=None)
    return made.id


def vehicles(client: Client, scan_id: int) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = client.seen(f"/scans/{scan_id}/vehicles")
    return found


def radar(value: float = 19.4, u: float = 0.1, revision: int = 0, **more: Any) -> dict[str, Any]:
    return {"value": value, "u": u, "revision": revision, **more}


def test_a_reference_stands_beside_our_own_value(operator: Client, viewer: Client, scan_id: int) -> None:
    first, *_, dark = vehicles(viewer, scan_id)
    assert first["references"] == []
    address = f"/scan-vehicles/{first['id']}/references"
    assert viewer.put(f"{address}/speed/radar", radar()).status_code == 403
    told = operator.put(f"{address}/speed/radar", radar(device=" Gun 2 ")).json()
    (one,) = told["references"]
    assert (one["value"], one["u"], one["unit"], one["device"]) == (19.4, 0.1, "m/s", "Gun 2")
    apart = one["agreement"]
    assert apart["difference"] == pytest.approx(19.31415 - 19.4)
    assert apart["u_difference"] == pytest.approx((0.011**2 + 0.1**2) ** 0.5)
    assert apart["U95_difference"] == pytest.approx(COVERAGE_95 * apart["u_difference"])
    assert apart["E_n"] == pytest.approx(apart["difference"] / apart["U95_difference"]) and apart["within"]
    assert operator.put(f"{address}/speed/radar", radar(device="Gun 2")).json() == told  # a repeat adds none
    operator.put(f"{address}/length/tape", radar(4.70, 0.005))
    speed, length = vehicles(viewer, scan_id)[0]["references"]
    assert (speed["source"], length["source"], length["unit"]) == ("radar", "tape", "m")
    assert length["agreement"]["difference"] == pytest.approx(0.04) and not length["agreement"]["within"]
    (unmeasured,) = operator.put(f"/scan-vehicles/{dark['id']}/references/speed/gps", radar()).json()[
        "references"
    ]
    assert unmeasured["agreement"] is None


def test_a_reference_is_replaced_by_who_saw_it_and_taken_back(operator: Client, scan_id: int) -> None:
    number = vehicles(operator, scan_id)[0]["id"]
    address = f"/scan-vehicles/{number}/references/speed/radar"
    operator.put(address, radar())
    stale = operator.put(address, radar(19.5))
    assert stale.status_code == 409 and "changed this reference value meanwhile" in error_of(stale)
    (one,) = operator.put(address, radar(19.5, revision=1)).json()["references"]
    assert (one["value"], one["revision"]) == (19.5, 2)
    assert operator.delete(f"{address}?revision=2").json()["references"] == []
    again = operator.delete(f"{address}?revision=3")
    assert again.status_code == 409 and "already removed" in error_of(again)
    never = operator.delete(address.replace("radar", "gps") + "?revision=0")
    assert never.status_code == 404
    (one,) = operator.put(address, radar(19.5, revision=3)).json()["references"]
    assert one["revision"] == 4


@pytest.mark.once
@pytest.mark.parametrize(
    ("body", "said"),
    [
        (radar(400.0), "up to 150 m/s"),
        (radar(19.4, 20.0), "not above the value itself"),
        (radar(-1.0), "greater than 0"),
        (radar(19.4, 0.0), "greater than 0"),
    ],
)
def test_a_value_that_cannot_be_is_refused(
    operator: Client, scan_id: int, body: dict[str, Any], said: str
) -> None:
    address = f"/scan-vehicles/{vehicles(operator, scan_id)[0]['id']}/references/speed/radar"
    refused = operator.put(address, body)
    assert refused.status_code == 422 and said in error_of(refused)


CSV = """number;source;device;speed_kmh;u_speed_kmh;Length (m);u_length_m;run_of
1;radar;Gun 2;70.0;0.5;;;
2;GPS;;69.5;0.2;4.75;0.01;The Golf
9;radar;;70;0.5;;;
3;radar;;70;;;;
3;sonar;;70;1;;;
x;radar;;70;1;;;
1;radar;;71;1;;;
4;counter;;fast;1;;;
4;counter;;900;1;;;
3;;;;;;;The Golf
"""


def sent(client: Client, scan_id: int, what: str, text: str = CSV) -> httpx2.Response:
    files = {"file": ("refs.csv", text.encode(), "text/csv")}
    return client.http.post(f"/api/scans/{scan_id}/references/{what}", files=files)


def test_a_csv_is_previewed_and_imported_line_by_line(operator: Client, scan_id: int) -> None:
    plan = sent(operator, scan_id, "preview").json()
    assert plan["counts"] == {"new": 3, "replaces": 0, "same": 0, "ambiguous": 0, "refused": 7}
    assert all(one["references"] == [] for one in vehicles(operator, scan_id))
    refused = {row["line"]: words_of(row) for row in plan["rows"] if row["change"] == "refused"}
    for line, said in {
        4: "has no vehicle 9",
        5: "no uncertainty; give u_speed",
        6: "source is “sonar”; use one of counter, radar",
        7: "number is “x”",
        8: "Line 2 gives the speed of this vehicle by radar already",
        9: "refs.csv, line 9: speed_kmh is “fast”, which is not a number",
        10: "speed of 900 km/h is out of range; give a value above 0 and up to 540 km/h",
    }.items():
        assert said in refused[line], line
    done = sent(operator, scan_id, "import").json()
    assert (done["values"], done["cars"], done["plan"]["counts"]["refused"]) == (3, 2, 7)
    first, second, third, *_ = vehicles(operator, scan_id)
    (one,) = first["references"]
    assert (one["value"], one["u"]) == (pytest.approx(70 / 3.6), pytest.approx(0.5 / 3.6))
    assert {each["quantity"]: each["source"] for each in second["references"]} == {
        "speed": "gps",
        "length": "gps",
    }
    assert (first["run_of"], second["run_of"], third["run_of"]) == (None, "The Golf", "The Golf")
    again = sent(operator, scan_id, "import").json()
    assert (again["values"], again["cars"], again["plan"]["counts"]["same"]) == (0, 0, 3)
    other = CSV.replace("70.0;0.5", "71;0.4").replace("The Golf", "The Polo")
    plan = sent(operator, scan_id, "preview", other).json()
    assert plan["counts"]["replaces"] == 3
    words = " ".join(words_of(row) for row in plan["rows"] if row["change"] == "replaces")
    assert "Replaces the speed 19.4444 m/s" in words and "Was a run of The Golf." in words


@pytest.mark.once
@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            "number,source,speed\n1,radar,70\n",
            "does not state its unit; name it one of speed_mps",
        ),
        ("source,speed_kmh\nradar,70\n", "needs a column “number”"),
        ("number,source\n1,radar\n", "needs a column “number”"),
        ('number,run_of\n1,"a\n', "line 2: a quote is not closed on its line"),
        (
            "number,run_of\n99,Golf\n",
            "can be used; line 2: This recording has no vehicle 99",
        ),
    ],
)
def test_a_csv_that_is_no_such_table_is_refused_in_words(
    operator: Client, scan_id: int, text: str, said: str
) -> None:
    refused = sent(operator, scan_id, "import", text)
    assert refused.status_code == 422 and said in error_of(refused)


SPEEDS = "number,source,speed_kmh,u_speed_kmh\n"
SIZES = "number,source,length_m,u_length_m\n"

# Tables of known values that were spoiled, made up before their reader was read: what becomes of each line
# (its change and words of its reason), or words of the refusal of the whole
SPOILED: dict[str, tuple[bytes | str, dict[int, tuple[str, ...]] | tuple[str, ...]]] = {
    "a speed below nothing": (SPEEDS + "1,radar,-70,0.5\n", {2: ("refused", "speed", "a value above 0")}),
    "a speed of nothing": (SPEEDS + "1,radar,0,0.5\n", {2: ("refused", "speed")}),
    "an uncertainty of nothing": (SPEEDS + "1,radar,70,0\n", {2: ("refused", "uncertainty above 0")}),
    "an uncertainty below nothing": (SPEEDS + "1,radar,70,-0.5\n", {2: ("refused", "uncertainty above 0")}),
    "an uncertainty above the value": (SPEEDS + "1,radar,70,90\n", {2: ("refused", "90 km/h", "70 km/h")}),
    "an uncertainty alone": (SPEEDS + "1,radar,,0.5\n", {2: ("refused", "but no speed")}),
    "a value without end": (SPEEDS + "1,radar,inf,0.5\n", {2: ("refused", "speed_kmh", "not a number")}),
    "digits of another script": (SPEEDS + "1,radar,７０,0.5\n", {2: ("refused", "speed_kmh")}),
    "a decimal comma": (
        SPEEDS.replace(",", ";") + "1;radar;70,5;0.5\n", {2: ("refused", "decimals with a point")}),
    "decimal commas between commas": (
        SPEEDS + "1,radar,70,5,0,5\n2,radar,70,0.5\n", {2: ("refused", "cells"), 3: ("new",)}),
    "an exponent beyond any car": (
        SPEEDS + "1,radar,1e3,0.5\n", {2: ("refused", "1000 km/h is out of range")}),
    "a length in millimetres": (SIZES + "1,tape,4750,10\n", {2: ("refused", "length", "4750")}),
    "metres as millimetres": (
        SIZES.replace("_m", "_mm") + "1,tape,4.75,0.01\n",
        {2: ("refused", "length", "4.75 mm", "above 300 and up to 100000 mm")}),
    "half a vehicle": (SPEEDS + "1.5,radar,70,0.5\n", {2: ("refused", "number", "1.5")}),
    "a vehicle below nothing": (SPEEDS + "-1,radar,70,0.5\n", {2: ("refused", "-1")}),
    "a vehicle without end": (SPEEDS + "9" * 30 + ",radar,70,0.5\n", {2: ("refused", "no vehicle 999")}),
    "no vehicle": (SPEEDS + ",radar,70,0.5\n", {2: ("refused", "number")}),
    "no source": (SPEEDS + "1,,70,0.5\n", {2: ("refused", "source")}),
    "nothing but a number": (SPEEDS + "1,,,\n1,radar,70,0.5\n", {2: ("refused",), 3: ("new",)}),
    "the same vehicle twice": (
        SPEEDS + "1,radar,70,0.5\n1,radar,71,0.5\n", {2: ("new",), 3: ("refused", "Line 2")}),
    "a source in capitals and blanks": (SPEEDS + "1, Radar ,70,0.5\n", {2: ("new",)}),
    "the header again": (
        SPEEDS + "1,radar,70,0.5\n" + SPEEDS, {2: ("new",), 3: ("refused", "names the columns again")}),
    "a name of five thousand signs": (
        "number,run_of\n1," + "x" * 5000 + "\n", {2: ("refused", "longer than 100")}),
    "a quote astray": (
        SPEEDS + '1,"radar,70,0.5\n2,radar,70,0.5\n', {2: ("refused", "quote"), 3: ("new",)}),
    "a column twice": ("number,source,speed_kmh,speed_kmh\n1,radar,70,0.5\n", ("speed_kmh", "twice")),
    "a value in two units": (
        "number,source,speed_kmh,speed_mps,u_speed_kmh\n1,radar,70,19,1\n", ("speed_kmh", "speed_mps")),
    "a vehicle by two columns": (
        "number,vehicle,source,speed_kmh,u_speed_kmh\n1,2,radar,70,1\n", ("vehicle", "leave one out")),
    "an expanded uncertainty, which was read as a standard one": (
        "number,source,speed_kmh,U_speed_kmh\n1,radar,70,2\n", ("U_speed_kmh", "k = 1")),
    "an interval's half-width": (
        "number,source,speed_kmh,u95_speed_kmh\n1,radar,70,2\n", ("u95_speed_kmh", "k = 1")),
    "a speed in knots": ("number,source,speed_kn,u_speed_kn\n1,radar,70,1\n", ("speed_kn",)),
    "UTF-16": ((SPEEDS + "1,radar,70,0.5\n").encode("utf-16"), ("UTF-8",)),
    "Windows' letters": ((SPEEDS + "1,Gerät,70,0.5\n").encode("cp1252"), ("UTF-8",)),
    "a spreadsheet's own file": (b"PK\x03\x04\x14\x00" + bytes(range(256)), ("UTF-8",)),
    "nothing": (b"", ("needs a column", "number")),
    "a header alone": (SPEEDS, ("no line of reference values below it",)),
    "a page in HTML": (b"<!DOCTYPE html><html><body>Sign in</body></html>", ("number",)),
    "blank lines, a BOM and a lone CR": (
        "\ufeff" + (SPEEDS + "\n1,radar,70,0.5\n\n").replace("\n", "\r"), {3: ("new",)}),
    "the separator named first": ("sep=,\n" + SPEEDS + "1,radar,70,0.5\n", {3: ("new",)}),
}  # fmt: skip


@pytest.mark.once
def test_a_spoiled_table_is_refused_where_it_is_wrong(operator: Client, scan_id: int) -> None:
    wrong = {}
    for name, (content, right) in SPOILED.items():
        files = {
            "file": ("refs.csv", content if isinstance(content, bytes) else content.encode(), "text/csv")
        }
        answer = operator.http.post(f"/api/scans/{scan_id}/references/preview", files=files)
        if isinstance(right, tuple):
            said: Any = error_of(answer) if answer.status_code == 422 else answer.text
            fits = answer.status_code == 422 and all(word in said for word in ("refs.csv", *right))
        else:
            said = {one["line"]: (one["change"], words_of(one)) for one in answer.json().get("rows", [])}
            fits = said.keys() == right.keys() and all(
                said[at][0] == change and all(word in said[at][1] for word in words)
                for at, (change, *words) in right.items()
            )
        if not fits:
            wrong[name] = said
    assert not wrong, "\n".join(f"{name}: {said}" for name, said in wrong.items())


def test_the_survey_tells_errors_by_source_and_compares_runs(
    operator: Client, services: Services, survey_id: int, scan_id: int
) -> None:
    found = vehicles(operator, scan_id)[:4]
    with services.writing() as session:
        for one in found[:3]:
            reviewer = 2
            add_scan_review(session, one["measurement"]["id"], verdict="accepted", actor=reviewer)
    for one, mps in zip(found, (19.3, 19.9, 19.2, 12.0), strict=True):
        operator.put(f"/scan-vehicles/{one['id']}/references/speed/radar", radar(mps))
        body = {"version": one["version"], "run_of": " Test Golf "}
        assert operator.put(f"/scan-vehicles/{one['id']}/facts", body).json()["run_of"] == "Test Golf"

    def by_source() -> tuple[dict[str, Any], dict[tuple[str, str | None], Any]]:
        told = operator.seen(f"/surveys/{survey_id}/scan-statistics")
        return told, {(one["quantity"], one["source"]): one["errors"] for one in told["references"]}

    # all together would say the one source's row once more
    assert set(by_source()[1]) == {("speed", "radar")}
    operator.put(f"/scan-vehicles/{found[0]['id']}/references/speed/counter", radar(19.44, 0.5))
    operator.put(f"/scan-vehicles/{found[0]['id']}/references/length/tape", radar(4.75, 0.01))
    told, groups = by_source()
    assert set(groups) - {("length", "tape")} == {("speed", "radar"), ("speed", "counter"), ("speed", None)}
    by_radar = groups["speed", "radar"]
    assert (by_radar["n"], by_radar["within"]) == (3, 2)  # the fourth waits for its review
    assert by_radar["mean"] == pytest.approx(19.31415 - (19.3 + 19.9 + 19.2) / 3)
    assert groups["speed", None]["n"] == 4
    rows = {row["number"]: row["references"] for row in told["table"]}
    assert [one["source"] for one in rows[1]] == ["radar", "counter", "tape"] and len(rows[2]) == 1
    (car,) = told["cars"]
    assert (car["car"], [run["number"] for run in car["runs"]]) == ("Test Golf", [1, 2, 3])
    length = car["sizes"]["length"]
    assert (length["n"], length["degrees"], length["verdict"]) == (3, 2, "agree")
    assert length["mean"] == pytest.approx(sum(LENGTHS_M[:3]) / 3, abs=1e-6)
    assert 0.005 < length["u_stated"] < 0.0081 and length["p"] > 0.3 and "wheelbase" not in car["sizes"]


# The fixture's fronts cross at lines 100, 200, 300 and 400, then 900, of 4,882.8 a second: 0.02 s apart.
START = {"local": "2026-05-03T08:10:00", "time_zone": "Europe/Paris", "u_s": 0.005}
SECONDS = [line / 4882.8 for line in (100, 200, 300, 400, 900)]


def start_is(client: Client, scan_id: int, **changed: Any) -> None:
    version = client.seen(f"/scans/{scan_id}")["version"]
    answer = client.http.patch(
        f"/api/scans/{scan_id}", json={"version": version, "start": {**START, **changed}}
    )
    assert answer.status_code == 200, answer.text


def timed(
    client: Client, scan_id: int, what: str, lines: list[str], tolerance_s: float = 0.005
) -> dict[str, Any]:
    """What is answered for lines of `time,number,source,speed_kmh,u_speed_kmh,run_of`."""
    text = "\n".join(["time,number,source,speed_kmh,u_speed_kmh,run_of", *lines])
    answer = sent(client, scan_id, f"{what}?tolerance_s={tolerance_s}", text)
    assert answer.status_code == 200, answer.text
    found: dict[str, Any] = answer.json()
    return found


def clock(seconds: float) -> str:
    return f"08:10:{seconds:06.3f}"


def by_line(plan: dict[str, Any]) -> dict[int, dict[str, Any]]:
    return {row["line"]: row for row in plan["rows"]}


def test_lines_find_their_vehicles_by_time_of_day(operator: Client, services: Services, scan_id: int) -> None:
    start_is(operator, scan_id)
    lines = [
        f"{clock(SECONDS[0] + 0.003)},,radar,70,0.5,",
        f"2026-05-03T{clock(SECONDS[1] + 0.002)},,radar,71,0.5,",
        f"2026-05-03T06:10:{SECONDS[2] + 0.004:06.3f}Z,,radar,72,0.5,",
        f"{clock(SECONDS[3])},4,radar,73,0.5,",
    ]
    plan = timed(operator, scan_id, "preview", lines)
    assert plan["counts"] == {"new": 4, "replaces": 0, "same": 0, "ambiguous": 0, "refused": 0}
    assert plan["tolerance_s"] == 0.005
    rows = by_line(plan)
    assert [(rows[n]["number"], rows[n]["by_time"]) for n in (2, 3, 4, 5)] == [
        ("1", True),
        ("2", True),
        ("3", True),
        ("4", False),
    ]
    assert rows[2]["apart_s"] == pytest.approx(0.003, abs=0.0011)  # both are written to the millisecond
    assert "0.00 s later (median)" in plan["notes"][0]["message"]
    assert (
        "is 0.0098 s, more than the tolerance" in plan["notes"][1]["message"]
    )  # beyond the tolerance of 0.005 s
    assert timed(operator, scan_id, "import", lines)["values"] == 4
    told = [one["references"][0]["value"] * 3.6 for one in vehicles(operator, scan_id)[:4]]
    assert told == [pytest.approx(value) for value in (70, 71, 72, 73)]
    with services.reading() as session:
        events = [one for one in events_of(session) if one.entity == "scan_reference"]
    kept = [(one.after or {}).get("matched") for one in events]
    assert kept[3] is None and kept[0]["tolerance_s"] == 0.005 and kept[0]["time"] == lines[0].split(",")[0]
    with services.reading() as session:
        assert verify_records(session).ok


def test_what_fits_several_is_named_and_nothing_of_it_is_stored(operator: Client, scan_id: int) -> None:
    start_is(operator, scan_id)
    lines = [
        f"{clock(SECONDS[0] + 0.001)},,radar,70,0.5,",  # fits the same vehicle as the next
        f"{clock(SECONDS[0] - 0.001)},,radar,71,0.5,",
        f"{clock(SECONDS[0])},,gps,70,0.5,",  # another source is no rival
        f"{clock(SECONDS[1])},,radar,70,0.5,",  # the vehicle that line 6 names
        ",2,radar,72,0.5,",
        f"{clock(SECONDS[4] + 0.1)},,radar,72,0.5,",
        f"{clock(SECONDS[2])},4,radar,72,0.5,",
        "08:10,,radar,72,0.5,",
        f"{clock(SECONDS[2])},,,,,Golf",
        f"{clock(SECONDS[2])},,,,,Polo",
    ]
    rows = by_line(timed(operator, scan_id, "preview", lines))
    assert {n: row["change"] for n, row in rows.items()} == {
        **{2: "ambiguous", 3: "ambiguous", 4: "new", 5: "ambiguous", 6: "new"},
        **{7: "refused", 8: "refused", 9: "refused", 10: "ambiguous", 11: "ambiguous"},
    }
    for line, said in {
        2: "this is vehicle 1, but line 3 gives its speed by radar too",
        3: "but line 2",
        5: "this is vehicle 2, but line 6",
        7: "the nearest is vehicle 5, 0.1 s away",
        8: "Vehicle 4 passed 0.0 s from this time, more than 0.005 s",
        9: "“08:10” is not a time with seconds",
        10: "line 11 names another car",
    }.items():
        assert said in words_of(rows[line]), rows[line]
    wide = by_line(timed(operator, scan_id, "preview", lines[:1], tolerance_s=0.05))
    assert wide[2]["change"] == "ambiguous" and wide[2]["number"] == ""
    assert "Vehicles 1, 2, 3 passed within 0.05 s" in words_of(wide[2])
    assert timed(operator, scan_id, "import", lines)["values"] == 2
    first, second, *rest = vehicles(operator, scan_id)
    assert [one["source"] for one in first["references"]] == ["gps"]
    assert [one["value"] * 3.6 for one in second["references"]] == [pytest.approx(72)]
    assert all(one["references"] == [] and one["run_of"] is None for one in rest)


@pytest.mark.once
def test_times_need_a_confirmed_start(operator: Client, scan_id: int) -> None:
    text = f"time,source,speed_kmh,u_speed_kmh\n{clock(SECONDS[0])},radar,70,0.5\n"
    refused = sent(operator, scan_id, "preview", text)
    assert refused.status_code == 422 and "is not confirmed" in error_of(refused)
    wide = sent(operator, scan_id, "preview?tolerance_s=61", text)
    assert wide.status_code == 422 and "60" in error_of(wide)


def at(text: str, zone: str = "Europe/Paris") -> datetime:
    return instant_of(text, zone)


def matching(start: str, duration_s: float, *passed_s: float) -> Matching:
    """A recording in Paris, with vehicles 1, 2, ... so many seconds after its start."""
    began = at(start)
    told = tuple(PassedAt(n, began + timedelta(seconds=one)) for n, one in enumerate(passed_s, 1))
    return Matching(Filming(began, "Europe/Paris"), duration_s, 0.01, told, 1.0)


@pytest.mark.once
def test_a_time_of_day_is_of_the_day_of_the_recording() -> None:
    night = matching("2026-05-03T23:59:00", 600.0, 30.0, 120.0)
    assert night.instant("23:59:30") == at("2026-05-03T23:59:30")
    assert night.instant("0:01:00,5") == at("2026-05-04T00:01:00.5")
    assert night.vehicle_at(night.instant("00:01:00.5"), "") == (2, 0.5)
    # just before line 0, where no line was recorded yet
    assert matching("2026-05-03T00:00:00.2", 10.0).instant("23:59:59.9") == at("2026-05-02T23:59:59.9")
    long = matching("2026-05-03T08:00:00", 90_000.0)
    assert long.instant("12:00:00") == at("2026-05-03T12:00:00")
    with pytest.raises(BadInput, match="give the date too"):
        long.instant("08:30:00")
    assert long.instant("2026-05-04T08:30:00") == at("2026-05-04T08:30:00")


@pytest.mark.once
def test_an_hour_that_clocks_show_twice_wants_its_offset() -> None:
    autumn = matching("2026-10-25T01:30:00", 7200.0, 3600.0, 7100.0)
    with pytest.raises(BadInput, match="occurs twice"):
        autumn.instant("02:30:00")
    assert autumn.vehicle_at(autumn.instant("2026-10-25T02:30:00+02:00"), "")[0] == 1
    with pytest.raises(BadInput, match="nearest is vehicle 2"):
        autumn.vehicle_at(autumn.instant("2026-10-25T02:30:00+01:00"), "")
    # the day before has the time too; it was taken, without a word
    for hours, words in ((26, "give the date too"), (24, "give the date too"), (23, None)):
        long = matching("2026-10-24T02:00:00", 3600.0 * hours)
        if words is None:
            assert long.instant("02:30:00") == at("2026-10-24T02:30:00")
        else:
            with pytest.raises(BadInput, match=words):
                long.instant("02:30:00" if hours == 26 else "02:00:00")
    # the first of the two hours alone was recorded
    assert matching("2026-10-25T01:30:00", 4000.0).instant("02:30:00") == at("2026-10-25T02:30:00+02:00")


@pytest.mark.parametrize(
    "column, value, times",
    [("speed_kmh", "19.3", "0.28"), ("speed_mps", "69.5", "3.6"), ("speed_mph", "69.5", "1.61")],
)
def test_speeds_in_another_unit_than_their_column_says_are_told(
    operator: Client, scan_id: int, column: str, value: str, times: str
) -> None:
    """Every line is in range, so that all were stored without a word."""
    text = "\n".join([f"number,source,{column},u_{column}", *(f"{n},radar,{value},0.1" for n in range(1, 6))])
    (note,) = sent(operator, scan_id, "preview", text).json()["notes"]
    assert note["message"].startswith(f"The speed of 4 lines is about {times} times ours: check")


@pytest.mark.parametrize("speeds", [[19.3, 69.5, 69.5, 69.5], [69.5 * 1.3] * 4, [19.3, 19.3]])
def test_references_like_ours_are_not_doubted_nor_few_lines_nor_what_no_unit_explains(
    operator: Client, scan_id: int, speeds: list[float]
) -> None:
    """One wrong line is not the file's, and a baseline that is off makes all of ours wrong alike."""
    text = "number,source,speed_kmh,u_speed_kmh,length_m,u_length_m\n" + "\n".join(
        f"{n},radar,{speed},0.5,4.7,0.1" for n, speed in enumerate(speeds, 1)
    )
    assert sent(operator, scan_id, "preview", text).json()["notes"] == []
