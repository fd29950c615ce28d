"""Who is seen in several recordings counts once, and where nobody can tell, it is said."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import replace
from datetime import datetime, timedelta
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sightline.commands.scanned import Start, about_rig, cell_of, row_of
from sightline.linescan.parts import CUT, STOOD, STOPPED, Lane, Rig
from sightline.linescan.passing import measure_passages
from sightline.scans.statistics.traffic import seen_in_each, traffic_of_seen
from sightline.traffic.archive import add_recorded
from sightline.traffic.query import ArchiveTables
from sightline.traffic.records import Asked, Stood
from sightline.traffic.results import results_in
from sightline.traffic.sources import read_recorded
from tests.linescan.scenes import SLOW_RIG, found, two_standing
from tests.support.proofs import PROOFS
from tests.traffic.flow_files import (
    LINE_0,
    RATE_HZ,
    ROWS,
    Row,
    as_json,
    flow,
    table,
    vehicle,
    written,
)

pytestmark = pytest.mark.once


def test_who_stands_through_segments_of_a_stream_counts_once(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """In view where the second segment began, it was told of the first."""
    names = ("reason", "lane", "speed_mps", "u_speed_mps", "length_m", "u_length_m")
    first = {
        **dict.fromkeys(names),
        **{"id": 1, "segment": 1, "status": "not_measurable", "direction": "camera_1_first"},
        **{"front_s": 50.0, "rear_s": None, "front_line_1": 250_000.0, "rear_line_1": None},
        **{"reason": str(STOOD), "front_at": "2026-05-04T06:00:50+00:00"},
    }
    again = {**first, "id": 2, "segment": 2, "front_s": 60.0, "rear_s": 90.0, "front_line_1": 0.0}
    again |= {"rear_line_1": 150_000.0, "reason": str(STOPPED), "front_at": "2026-05-04T06:01:00+00:00"}
    path = tmp_path / "stream.jsonl"
    path.write_text("\n".join(map(json.dumps, (first, again))))
    told = flow(capsys, path, "--interval", "60", "--vehicles", tmp_path / "cars.csv")
    (hour,) = table(told)
    assert (hour["vehicles"], hour["headway_mean_s"], hour["occupancy_percent"]) == ("1", "", "")
    assert len(table((tmp_path / "cars.csv").read_text())) == 1  # as many as count


def test_who_leaves_behind_one_that_stands_is_counted_once(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Three vehicles, of whom two stood: 37 were counted, in both directions."""
    passages, _ = found(two_standing(30.0)[0], SLOW_RIG)
    start = Start(LINE_0, None)
    rows = [
        {name: cell_of(value) for name, value in (row_of(one) | start.times_of(one, SLOW_RIG)).items()}
        for one in measure_passages(passages, SLOW_RIG, "direct")
    ]
    (hour,) = table(flow(capsys, written(tmp_path / "vehicles.csv", rows), "--interval", "60"))
    assert (hour["vehicles"], hour["refused"]) == ("3", "2")
    assert float(hour["headway_mean_s"]) == pytest.approx((41.87 - 1.48) / 2, abs=0.01)


def test_recordings_of_the_same_time_are_said_to_count_a_vehicle_in_each(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Two files of one road and time held its vehicles twice, and nothing said so."""

    def shifted(name: str, by_s: float, **changed: str) -> Path:
        path = as_json(tmp_path / name, 680.0, u_start_s=0.1)
        told = json.loads(path.read_text())
        told["start"] = (LINE_0 + timedelta(seconds=by_s)).isoformat()
        told["vehicles"] = [one | changed for one in told["vehicles"]]
        path.write_text(json.dumps(told))
        return path

    def notes(*places: Path) -> list[str]:
        found: list[str] = json.loads(flow(capsys, *places, "--json"))["notes"]
        return [note for note in found if "overlap" in note]

    first, next_one = shifted("a.json", 0.0), shifted("b.json", 679.0)
    assert notes(first, next_one) == []  # 1 s, which a start told by a person leaves open
    half = shifted("half.json", 340.0)
    said = "a.json and half.json overlap for 340 s: a vehicle that both contain counts in each."
    assert notes(half, first) == [said]
    assert said in flow(capsys, first, half, "-o", tmp_path / "out.csv")
    assert notes(first, shifted("back.json", 340.0, direction="camera_2_first")) == []
    near, far = (shifted(f"{lane}.json", 340.0, lane=lane) for lane in ("near", "far"))
    assert notes(near, far) == [] and len(notes(first, near)) == 1
    bare = written(tmp_path / "vehicles.csv", ROWS)  # from its first front, 8 s after line 0, to its last
    assert notes(first, bare) == [
        "a.json and vehicles.csv overlap for 662 s: a vehicle that both contain counts in each."
    ]


RIG = Rig(0.5, RATE_HZ, 0.0005)


def held(
    path: Path, by_s: float, cars: Sequence[dict[str, Any]], rig: Rig = RIG, duration_s: float = 600.0
) -> Path:
    """A recording as the JSON of `linescan`, which begins so long after line 0."""
    usual = {"direction": "camera_1_first", "lane": None, "speed_mps": None, "length_m": None}
    told = [{**usual, "id": number, "status": "not_measurable", **car} for number, car in enumerate(cars, 1)]
    start = (LINE_0 + timedelta(seconds=by_s)).isoformat()
    path.write_text(
        json.dumps(
            {**about_rig(rig), "duration_s": duration_s, "start": start, "u_start_s": 0.1, "vehicles": told}
        )
    )
    return path


def passing(front_s: float) -> dict[str, Any]:
    lines = {"front_line_1": RATE_HZ * front_s, "rear_line_1": RATE_HZ * (front_s + 0.2)}
    moved = {"status": "ok", "reason": None, "speed_mps": 20.0, "length_m": 4.0}
    return {**lines, **moved, "front_s": front_s, "rear_s": front_s + 0.2}


STANDS = {"front_line_1": 2.5e6, "rear_line_1": None, "front_s": 500.0, "rear_s": None, "reason": str(STOOD)}
IN_VIEW = {"front_line_1": 0.0, "rear_line_1": 4e4, "front_s": 0.0, "rear_s": 8.0, "reason": str(STOPPED)}


def listed_and_counted(
    capsys: pytest.CaptureFixture[str], *places: Path, minutes: int = 60
) -> tuple[list[str], int]:
    """The recordings that a vehicle is listed of, vehicle by vehicle, and how many the intervals count."""
    told = json.loads(flow(capsys, *places, "--interval", str(minutes), "--json"))
    return [one["recording"] for one in told["vehicles"]], sum(one["vehicles"] for one in told["intervals"])


def kept_as(kept: str, place: Path, paths: Sequence[Path]) -> Path:
    """The folder of the recordings, or an archive of them."""
    if kept == "folder":
        return paths[0].parent
    for path in paths:
        begun = datetime.fromisoformat(json.loads(path.read_text())["start"])
        add_recorded(place / "archive", read_recorded(path, None), Stood("Hill", "", "UTC", begun, 0.1))
    return place / "archive"


def counted_in(capsys: pytest.CaptureFixture[str], kept: str, place: Path) -> tuple[list[str], int]:
    """`listed_and_counted`; `traffic flows` and `traffic sites` count as many of an archive."""
    listed, counted = listed_and_counted(capsys, place)
    if kept == "archive":
        with ArchiveTables(place) as tables:
            assert sum(row["vehicles"] for row in tables.intervals(Asked())) == counted
            assert sum(site.vehicles for site in tables.sites()) == counted
    return [name.removeprefix("Hill: ") for name in listed], counted


def counted_in_survey(paths: Sequence[Path]) -> int:
    """How many the intervals of a survey, or of a package of it, count of the recordings."""
    results = [one for path in paths for one in results_in(path)[0]]
    watched = [replace(one.seen.watched, scan_id=at) for at, one in enumerate(results)]
    cars = [replace(car, scan_id=at) for at, one in enumerate(results) for car in one.vehicles]
    found = traffic_of_seen(seen_in_each(watched, cars), 60, accepted_only=False)
    return sum(one.vehicles for scan in found for one in scan.intervals)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    place = tmp_path / "recordings"
    place.mkdir()
    return place


@pytest.mark.parametrize("kept", ["folder", "archive"])
def test_who_stands_where_one_recording_goes_on_from_another_is_listed_once(
    kept: str, folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The intervals counted it once; the list had it twice."""
    paths = [held(folder / "a.json", 0.0, [passing(10.0), STANDS])]
    paths.append(held(folder / "b.json", 600.0, [IN_VIEW, passing(30.0)]))
    place = kept_as(kept, tmp_path, paths)
    assert counted_in(capsys, kept, place) == (["a.json", "a.json", "b.json"], 3)


LANED = Rig(0.5, RATE_HZ, 0.0005, lanes=(Lane("near", 5.0), Lane("far", 9.0)))


@pytest.mark.parametrize("kept", ["folder", "archive"])
def test_who_is_cut_beside_one_that_stands_counts_once(
    kept: str, folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Two vehicles: of those in view as the next recording began, only who was of the lane of one that stood
    was told before, and the other one counted in both.
    """
    lines = {"front_line_1": 2.999e6, "rear_line_1": 3e6, "reason": str(CUT)}
    at_end = {**lines, "front_s": 599.8, "rear_s": 600.0}
    at_begin = {**at_end, "front_line_1": 0.0, "rear_line_1": 1e3, "front_s": 0.0, "rear_s": 0.2}
    beside = [(STANDS, at_end), (IN_VIEW, at_begin)]
    paths = [
        held(folder / f"{name}.json", by_s, [near | {"lane": "near"}, far | {"lane": "far"}], LANED)
        for name, by_s, (near, far) in zip("ab", (0.0, 600.0), beside, strict=True)
    ]
    place = kept_as(kept, tmp_path, paths)
    assert counted_in(capsys, kept, place) == (["a.json", "a.json"], 2)


BACK = {"direction": "camera_2_first"}


@pytest.mark.parametrize("kept", ["folder", "archive"])
@pytest.mark.parametrize(
    ("rigs", "cars", "counted"),
    [
        # one of unknown lane stands, and another one drives through
        ((LANED, LANED, LANED), ([STANDS], [passing(30.0)], [IN_VIEW]), 3),
        # lanes were told to the rig meanwhile
        ((RIG, LANED), ([STANDS], [IN_VIEW | {"lane": "near"}]), 1),
        # of a two-way road without lanes, the other way was driven
        ((RIG, RIG, RIG), ([STANDS], [passing(30.0) | BACK], [IN_VIEW]), 2),
    ],
)
def test_a_folder_a_survey_and_an_archive_count_by_one_rule(
    rigs: Sequence[Rig],
    cars: Sequence[Sequence[dict[str, Any]]],
    counted: int,
    kept: str,
    folder: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Of an archive 2, 2 and 3 were counted, by a rule of its own."""
    paths = [
        held(folder / f"{at}.json", 600.0 * at, own, rig)
        for at, (rig, own) in enumerate(zip(rigs, cars, strict=True))
    ]
    assert counted_in(capsys, kept, kept_as(kept, tmp_path, paths))[1] == counted_in_survey(paths) == counted


_CAR = st.one_of(
    st.floats(1.0, 590.0).map(passing),
    st.just(STANDS | {"rear_line_1": 2.9e6, "rear_s": 580.0, "reason": str(STOPPED)}),
)
_STREAM = st.tuples(st.sampled_from(["near", "far", None]), st.booleans())


@st.composite
def _recordings(draw: st.DrawFn) -> list[tuple[float, Rig, list[dict[str, Any]]]]:
    """When each begins, by what rig, and who passed: at most one of a stream is in view, one stands."""
    found, begins_s = [], 0.0
    for _ in range(draw(st.integers(1, 4))):
        rig, cars = draw(st.sampled_from([RIG, LANED])), list[dict[str, Any]]()
        for lane, back in draw(st.lists(_STREAM, max_size=4, unique=True)):
            shown = [
                *draw(st.lists(_CAR, max_size=2)),
                *draw(st.sampled_from([[], [IN_VIEW], [STANDS], [IN_VIEW, STANDS], [_STAYS]])),
            ]
            way = {"lane": lane if rig.lanes else None, **(BACK if back else {})}
            cars += [one | way for one in shown]
        found.append((begins_s, rig, cars))
        begins_s += 600.0 + draw(st.sampled_from([0.0, 0.05, 30.0, 100.0]))
    return found


_STAYS = IN_VIEW | {"rear_line_1": 3e6, "rear_s": 600.0}


@settings(max_examples=200 if PROOFS else 8)
@given(_recordings())
def test_a_folder_and_an_archive_agree_on_who_is_counted(
    recordings: list[tuple[float, Rig, list[dict[str, Any]]]],
) -> None:
    with TemporaryDirectory() as name:
        place = Path(name)
        (place / "folder").mkdir()
        paths = [
            held(place / "folder" / f"{at}.json", begins_s, cars, rig)
            for at, (begins_s, rig, cars) in enumerate(recordings)
        ]
        kept_as("archive", place, paths)
        with ArchiveTables(place / "archive") as tables:
            by_hour = sum(row["vehicles"] for row in tables.intervals(Asked()))
            by_site = sum(site.vehicles for site in tables.sites())
        counted = counted_in_survey(paths)
        by_flow = [
            sum(not car.told_before for one in results_in(kept)[0] for car in one.vehicles)
            for kept in (place / "folder", place / "archive")
        ]
    assert [by_hour, by_site, *by_flow] == 4 * [counted]


@pytest.mark.parametrize("kept", ["folder", "archive"])
@pytest.mark.parametrize(("gap_s", "listed"), [(0.0, "ab"), (30.0, "abc")])
def test_a_gap_before_a_recording_in_between_leaves_open_who_is_in_view(
    gap_s: float,
    listed: str,
    kept: str,
    folder: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Nobody watched before the second, of whose other lane one passed: who is in view as the third begins at
    once after it was told before, and lost.
    """
    shown = [STANDS | {"lane": "near"}, passing(30.0) | {"lane": "far"}, IN_VIEW | {"lane": "near"}]
    starts = (0.0, 600.0 + gap_s, 1200.0 + gap_s)
    paths = [
        held(folder / f"{name}.json", by_s, [car], LANED)
        for name, by_s, car in zip("abc", starts, shown, strict=True)
    ]
    place = kept_as(kept, tmp_path, paths)
    assert counted_in(capsys, kept, place) == ([f"{name}.json" for name in listed], len(listed))


@pytest.mark.parametrize("kept", ["folder", "archive"])
def test_a_recording_that_nobody_passed_is_read_with_its_folder(
    kept: str, folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """It was skipped: who stood through it counted twice, and what it watched was lost."""
    cars = [[passing(10.0), STANDS], [], [IN_VIEW, passing(30.0)]]
    paths = [held(folder / f"{name}.json", 600.0 * at, cars[at]) for at, name in enumerate("abc")]
    for name, told in (("no_time", {"vehicles": []}), ("no_list", {"duration_s": 600.0})):
        (folder / f"{name}.json").write_text(json.dumps(told))
    place = kept_as(kept, tmp_path, paths)
    assert counted_in(capsys, kept, place) == (["a.json", "a.json", "c.json"], 3)
    if kept == "folder":
        told = json.loads(flow(capsys, place, "--interval", "60", "--json"))
        seconds = [one["interval_s"] for one in told["intervals"] if one["recording"] == "b.json"]
        assert sum(seconds) == pytest.approx(600.0)
        skipped = [name for name in ("b", "no_time", "no_list") if f"{name}.json" in str(told["notes"])]
        assert skipped == ["no_time", "no_list"]


@pytest.mark.parametrize(("later_s", "counted"), [(0.05, 3), (0.2, 4), (30.0, 4)])
def test_an_archive_counts_by_one_rule_whoever_asks(
    later_s: float, counted: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """`traffic flows` and `flow` told of an archive in two ways who counts in the recording before."""
    for number, (by_s, cars) in enumerate(
        [(0.0, [passing(10.0), STANDS]), (600.0 + later_s, [IN_VIEW, passing(30.0)])]
    ):
        path = held(tmp_path / f"{number}.json", by_s, cars)
        begun = LINE_0 + timedelta(seconds=by_s)
        add_recorded(tmp_path / "a", read_recorded(path, None), Stood("Hill", "", "UTC", begun, 0.1))
    with ArchiveTables(tmp_path / "a") as tables:
        by_sql = sum(row["vehicles"] for row in tables.intervals(Asked()))
    listed, by_flow = listed_and_counted(capsys, tmp_path / "a")
    assert len(listed) == by_flow == by_sql == counted


@pytest.mark.parametrize("by_s", [0.0, 599.0, 600.0])
def test_no_vehicle_of_another_rig_is_left_out(
    by_s: float, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Two rigs of one survey: what is in view of the second is not what stood before the first."""
    held(tmp_path / "a.json", 0.0, [passing(10.0), STANDS])
    held(tmp_path / "b.json", by_s, [IN_VIEW, passing(30.0)], Rig(0.6, RATE_HZ, 0.0005))
    assert listed_and_counted(capsys, tmp_path) == (["a.json"] * 2 + ["b.json"] * 2, 4)
    assert not [one for one in json.loads(flow(capsys, tmp_path, "--json"))["notes"] if "overlap" in one]


def test_no_vehicle_of_a_file_named_by_itself_is_left_out(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Each PLACE is computed alone: these may be of different roads."""
    first = held(tmp_path / "a.json", 0.0, [passing(10.0), STANDS])
    second = held(tmp_path / "b.json", 600.0, [IN_VIEW, passing(30.0)])
    assert listed_and_counted(capsys, first, second) == (["a.json"] * 2 + ["b.json"] * 2, 4)


@pytest.mark.parametrize("by_s", [300.0, 597.0])
def test_the_later_of_two_that_overlap_keeps_its_vehicles(
    by_s: float, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """By more than starts that people tell leave open: it watched that time too, and counts who came."""
    held(tmp_path / "a.json", 0.0, [passing(10.0), STANDS])
    held(tmp_path / "b.json", by_s, [IN_VIEW, passing(30.0)])
    assert listed_and_counted(capsys, tmp_path) == (["a.json"] * 2 + ["b.json"] * 2, 4)


def test_tables_count_alike_in_intervals_of_every_length(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """They do not say where they end: the second went on from the first at the end of its last hour alone."""
    stood = {**vehicle(1, 900.0, 0.2, None, None, None), "rear_line_1": "", "reason": str(STOOD)}
    written(tmp_path / "a.csv", [vehicle(2, 10.0, 0.2, 20.0, 4.0, 2), stood])
    at_seven = {"front_at": "2026-05-04T07:00:00.000+02:00", "front_line_1": "0", "rear_line_1": "40000"}
    in_view = {**vehicle(1, 3310.0, 8.0, None, None, None), **at_seven, "reason": str(STOPPED)}
    written(tmp_path / "b.csv", [in_view, vehicle(2, 3340.0, 0.2, 20.0, 4.0, 2)])
    counts = [listed_and_counted(capsys, tmp_path, minutes=minutes) for minutes in (1, 5, 15, 60)]
    assert counts == 4 * [(["a.csv"] * 2 + ["b.csv"] * 2, 4)]


@pytest.mark.parametrize("minutes", [1, 60])
def test_who_stood_where_a_table_ends_is_the_road_of_the_next_in_intervals_of_every_length(
    minutes: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Of 60 minutes the next one told an occupancy, for the last interval of the table went on after it."""
    stood = {**vehicle(2, 900.0, 0.2, None, None, None), "rear_line_1": "", "reason": str(STOOD)}
    written(tmp_path / "a.csv", [vehicle(1, 10.0, 0.2, 20.0, 4.0, 2), stood])
    held(tmp_path / "b.json", 920.0, [passing(30.0)])
    rows = table(flow(capsys, tmp_path, "--interval", str(minutes)))
    assert {one["occupancy_percent"] for one in rows if one["recording"] == "b.json"} == {""}


_RESTS = {**vehicle(2, 100.0, 30.0, None, None, None), "reason": str(STOPPED)}
_STOOD = {**vehicle(2, 100.0, 0.2, None, None, None), "rear_line_1": "", "reason": str(STOOD)}


@pytest.mark.parametrize(
    ("last", "begins_s", "overlaps_s", "may_twice"),
    [
        (_RESTS, 99.0, 31, True),
        (_RESTS, 130.05, None, True),
        (_STOOD, 99.0, None, True),
        (_STOOD, 600.0, None, True),
        (ROWS[-1], 671.0, None, False),
    ],
)
def test_no_recording_goes_on_from_a_table_for_it_does_not_say_where_it_ends(
    last: Row,
    begins_s: float,
    overlaps_s: int | None,
    may_twice: bool,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """One that stops last stood at the end of what is known, whenever it left; a note says that it may count
    twice. What is known goes on to the last rear.
    """
    written(tmp_path / "a.csv", [vehicle(1, 10.0, 0.2, 20.0, 4.0, 2), last])
    in_view = {**vehicle(1, begins_s, 8.0, None, None, None), "front_line_1": "0", "rear_line_1": "40000"}
    in_view["reason"] = str(STOPPED)
    written(tmp_path / "b.csv", [in_view, vehicle(2, begins_s + 300.0, 0.2, 20.0, 4.0, 2)])
    assert listed_and_counted(capsys, tmp_path) == (["a.csv"] * 2 + ["b.csv"] * 2, 4)
    notes = json.loads(flow(capsys, tmp_path, "--json"))["notes"]
    assert [one for one in notes if "overlap" in one] == (
        [f"a.csv and b.csv overlap for {overlaps_s} s: a vehicle that both contain counts in each."]
        if overlaps_s
        else []
    )
    said = "A vehicle that still stood at its end may count again in the next recording"
    assert [one[:5] for one in notes if said in one] == (["a.csv"] if may_twice else [])


def test_files_of_one_name_that_overlap_are_told_with_their_places(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    paths = [tmp_path / name / "cars.json" for name in ("one", "two")]
    for path in paths:
        path.parent.mkdir()
        held(path, 0.0, [passing(10.0)])
    (note,) = json.loads(flow(capsys, *paths, "--json"))["notes"]
    first, second = (f"{path}: cars.json" for path in paths)
    assert note.startswith(f"{first} and {second} overlap for 600 s")
