"""A live stream beyond the command: lines that are lost, a clock that is set, segments, swapped cameras."""

from __future__ import annotations

import gc
import os
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

from sightline.linescan import finding
from sightline.linescan.finding import Finder
from sightline.linescan.parts import STOOD, STOPPED, Rig
from sightline.linescan.passing import measure_passages
from sightline.media.lines.followed import FollowedLines
from sightline.media.lines.piped import PipedLines
from sightline.media.lines.source import Ending, LineSource, Lost, Piece
from sightline.media.strips import spool
from sightline.media.strips.reader import open_strip
from sightline.media.strips.sheet import Pixels
from sightline.messages.said import Said
from sightline.scans.live.journal import Journal, interrupted_segment, unmoved_segments
from sightline.scans.live.records import Keeper, LiveHealth, LiveVehicle, SegmentFacts
from sightline.scans.live.run import Clock, LiveRun
from sightline.traffic.archive import SHARED_S
from tests.linescan.scenes import SLOW_RIG, at, cars, standing
from tests.simulation.scan_strips import strips
from tests.simulation.scan_traffic import ScanSite, traffic
from tests.support.proofs import every

pytestmark = pytest.mark.once

SITE = ScanSite(rows=64, misalignment_px=0.3)
RIG = Rig(SITE.baseline_m, SITE.line_rate_hz)


class Played:
    """A source of strips in pieces of 500 lines; `lost`: lines that did not arrive."""

    name, broken, waiting_bytes, last_at = "played", False, 0, None

    def __init__(self, pair: tuple[Pixels, Pixels], lost: tuple[Lost, ...] = ()) -> None:
        self.notes: list[str] = []
        self._pair = [np.array(one, np.uint8) for one in pair]
        self._lost = lost
        for gap in lost:
            self._pair[gap.camera - 1][gap.line : gap.line + gap.count] = self._pair[gap.camera - 1][
                gap.line - 1
            ]

    def pieces(self) -> Iterator[Piece | None]:
        first, second = self._pair
        for start in range(0, len(first), 500):
            yield None
            stop = min(start + 500, len(first))
            inside = tuple(part for gap in self._lost if (part := _part(gap, start, stop)))
            yield Piece(first[start:stop], second[start:stop], inside)


def _part(gap: Lost, start: int, stop: int) -> Lost | None:
    begin, end = max(gap.line, start), min(gap.line + gap.count, stop)
    return Lost(gap.camera, begin, end - begin) if begin < end else None


def live_run(source: Callable[[int], LineSource], folder: Path | None = None, **more: object) -> LiveRun:
    options = {"folder": folder, "keeper": Keeper(), "say": print, "name": "played", **more}
    rig = options.pop("rig", RIG)
    return LiveRun(source, SITE.rows, rig, "direct", **options)  # type: ignore[arg-type]


def run_of(source: Played, folder: Path | None = None, **more: object) -> tuple[list[LiveVehicle], list[str]]:
    said: list[object] = []
    run = live_run(lambda _: source, folder, say=said.append, **more)
    told = []
    for one in run.vehicles():
        run.told(one)
        told.append(one)
    return told, [str(one) for one in said]


@pytest.fixture(scope="module")
def pair() -> tuple[Pixels, Pixels]:
    return strips(SITE, traffic(5, 4, speeds_mps=(14.0, 24.0), gaps_s=(0.5, 0.8), start_s=0.8))


@pytest.fixture(scope="module")
def clean(pair: tuple[Pixels, Pixels]) -> list[LiveVehicle]:
    """The vehicles of a stream in which nothing happens."""
    return run_of(Played(pair))[0]


@pytest.fixture(scope="module")
def two(pair: tuple[Pixels, Pixels], clean: list[LiveVehicle]) -> tuple[Pixels, Pixels]:
    """The first two vehicles: up to the middle of the road between the second and the third."""
    second, third = (one.vehicle.motion.crossings for one in clean[1:3])
    cut = int(second.rear_line_2 + third.front_line_1) // 2
    return pair[0][:cut], pair[1][:cut]


@pytest.fixture(scope="module")
def twice(two: tuple[Pixels, Pixels]) -> tuple[Pixels, Pixels]:
    """The first two vehicles, and again."""
    return np.concatenate([two[0], two[0]]), np.concatenate([two[1], two[1]])


def test_lost_lines_are_listed_in_the_files_and_spoil_only_whom_they_hit(
    pair: tuple[Pixels, Pixels], clean: list[LiveVehicle], tmp_path: Path
) -> None:
    second = clean[1].vehicle.motion.crossings
    hit = int(second.front_line_2 + second.rear_line_2) // 2
    lost = (Lost(1, 300, 40), Lost(2, 480, 40), Lost(2, hit, 30), Lost(1, len(pair[0]) - 20, 20))
    live, said = run_of(Played(pair, lost), tmp_path)
    assert [one.vehicle.motion.status for one in live] == ["ok", "not_measurable", "ok", "ok"]
    assert live[1].vehicle.motion.reason.sentence() == (
        "The recorder lost 30 lines of camera 2 while the vehicle passed. This passage cannot be measured; "
        "find out why the recorder loses lines before you record again."
    )
    assert live[2].vehicle.motion.speed_mps == pytest.approx(clean[2].vehicle.motion.speed_mps, rel=1e-6)
    assert any(one.startswith("60 lines of camera 1 were lost") for one in said)

    files = [open_strip(tmp_path / f"0001-camera-{k}.tif", "height") for k in (1, 2)]
    assert [[(gap.line, gap.count) for gap in one.notes.dropped] for one in files] == [
        [(300, 40)],
        [(480, 40), (hit - 40, 30)],
    ]
    # the lost end of camera 1 has no partner, so both end there
    assert files[0].lines == files[1].lines == len(pair[0]) - 20
    finder = Finder(SITE.rows, RIG)
    for one, two in zip(files[0].chunks(), files[1].chunks(), strict=True):
        assert len(one) == len(two)
    passages = finder.push(*(np.concatenate(list(one.chunks())) for one in files)) + finder.finish()
    again = list(measure_passages(passages, RIG, "direct"))
    for k in (0, 2, 3):
        assert again[k].motion.speed_mps == live[k].vehicle.motion.speed_mps
        assert again[k].motion.length_m == live[k].vehicle.motion.length_m


def test_a_clock_that_is_set_changes_no_number_and_is_said(
    pair: tuple[Pixels, Pixels], clean: list[LiveVehicle]
) -> None:
    ticks = iter(range(10_000))
    steady = [0.0]

    def count() -> float:
        steady[0] = next(ticks) * 0.7
        return steady[0]

    jumped = Clock(wall=lambda: 1e9 + steady[0] + (3600.0 if steady[0] > 20 else 0.0), steady=count)
    live, said = run_of(Played(pair), clock=jumped)
    assert any("clock was set by 3600.0 s" in one and "are not affected" in one for one in said)
    first, last = (one.vehicle.motion for one in (live[0], live[-1]))
    assert [one.vehicle.motion.speed_mps for one in live] == [one.vehicle.motion.speed_mps for one in clean]
    lines = last.crossings.front_line_1 - first.crossings.front_line_1
    assert (live[-1].at - live[0].at).total_seconds() == pytest.approx(lines / RIG.line_rate_hz, abs=1e-5)


def stopped_at(wall: float) -> Clock:
    return Clock(wall=lambda: wall, steady=iter(range(10_000)).__next__)


def kill(run: LiveRun) -> None:
    """Leave its files as they are."""
    left = run._segment
    assert left is not None and left.journal is not None
    for open_file in (left.journal, *(camera.spool for camera in left.cameras)):
        assert open_file is not None
        open_file.close()


def test_what_a_killed_stream_left_has_its_places_in_the_files(
    pair: tuple[Pixels, Pixels], clean: list[LiveVehicle], tmp_path: Path
) -> None:
    """Lines that were lost are not in the files, and take their time all the same."""
    killed = live_run(lambda _: Played(pair, (Lost(1, 300, 40), Lost(2, 480, 30))), tmp_path)
    found = killed.vehicles()
    killed.told(next(found))
    next(found)
    kill(killed)
    nothing = Played((pair[0][:0], pair[1][:0]))
    second = next(live_run(lambda _: nothing, tmp_path).vehicles()).vehicle
    seen, in_files = second.motion.crossings, second.columns
    assert seen.front_line_1 == pytest.approx(clean[1].vehicle.motion.crossings.front_line_1, abs=1)
    lost = [
        a - b
        for a, b in (
            (seen.front_line_1, in_files.front_line_1),
            (seen.rear_line_1, in_files.rear_line_1),
            (seen.front_line_2, in_files.front_line_2),
            (seen.rear_line_2, in_files.rear_line_2),
        )
    ]
    assert lost == [40, 40, 30, 30]


def test_line_0_came_before_the_piece_that_brought_it(
    pair: tuple[Pixels, Pixels], clean: list[LiveVehicle]
) -> None:
    source = Played(pair)
    source.waiting_bytes = 2 * SITE.rows * 700
    first = next(live_run(lambda _: source, clock=stopped_at(1e9)).vehicles())
    lines = clean[0].vehicle.motion.crossings.front_line_1 - 500 - 700
    assert first.at.timestamp() == pytest.approx(1e9 + lines / RIG.line_rate_hz, abs=1e-5)


@pytest.mark.parametrize("piped", [False, True])
@pytest.mark.parametrize("ahead_s", [-7200.0, 30.0])
def test_a_file_at_rest_tells_when_it_was_written(
    two: tuple[Pixels, Pixels], clean: list[LiveVehicle], tmp_path: Path, ahead_s: float, piped: bool
) -> None:
    """Its last line came when it was last modified, two hours ago; never later than now. Followed, or given
    as standard input.
    """
    path, ending = tmp_path / "lines.raw", Ending()
    path.write_bytes(np.stack([np.array(one, np.uint8) for one in two], axis=1).tobytes())
    os.utime(path, (1e9 + ahead_s, 1e9 + ahead_s))
    with path.open("rb") as given:

        def source(_: int) -> LineSource:
            if piped:
                return PipedLines(given.fileno(), SITE.rows, ending)
            return FollowedLines(path, SITE.rows, ending, idle_s=0.1)

        told = list(live_run(source, clock=stopped_at(1e9)).vehicles())
    ending.close()
    for one, same in zip(told, clean[:2], strict=True):
        lines = same.vehicle.motion.crossings.front_line_1 - len(two[0])
        assert one.at.timestamp() == pytest.approx(1e9 + min(ahead_s, 0) + lines / RIG.line_rate_hz, abs=1e-3)


def test_a_followed_file_taken_up_an_hour_later_tells_when_its_lines_were_taken(
    pair: tuple[Pixels, Pixels],
    clean: list[LiveVehicle],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    heard: list[float] = []

    class Heard(Keeper):
        def hear(self, health: LiveHealth) -> None:
            heard.append(health.clock_offset_s + health.lines / RIG.line_rate_hz)

    begun: list[int] = []

    def played(begin: int) -> Played:
        begun.append(begin)
        return Played((pair[0][begin:], pair[1][begin:]))

    monkeypatch.setattr("sightline.scans.live.run.LEAD_S", 0.3)
    killed = live_run(played, tmp_path, can_go_back=True, clock=stopped_at(1e9))
    killed.told(next(killed.vehicles()))
    kill(killed)

    later = stopped_at(1e9 + 3600)
    resumed = live_run(played, tmp_path, can_go_back=True, clock=later, keeper=Heard())
    rest = list(resumed.vehicles())
    assert [one.vehicle.number for one in rest] == [2, 3, 4]
    for one, same in zip(rest, clean[1:], strict=True):
        lines = same.vehicle.motion.crossings.front_line_1 - 500
        assert one.at.timestamp() == pytest.approx(1e9 + lines / RIG.line_rate_hz, abs=1e-3)
    begun_at = rest[0].begin
    # no line is kept twice, but for what a segment shares with the one before
    one, two = (open_strip(path, "height").lines for path in sorted(tmp_path.glob("*-camera-1.tif")))
    margin = 2 * Finder(SITE.rows, RIG).margin
    assert (one - margin, two) == (begun_at, len(pair[0]) - begun_at)
    assert all(one.vehicle.front_s > 0 for one in rest)
    # an hour has passed since line 500; the counting clock goes on by 1 s each time it is read
    assert 0 < begun[1] < begun_at
    assert heard[0] == pytest.approx(3600 + (500 - begun_at) / RIG.line_rate_hz + 1, abs=2)


def test_swapped_cameras_are_said_while_the_stream_goes_on(two: tuple[Pixels, Pixels]) -> None:
    live, said = run_of(Played((two[1], two[0])))
    assert len(live) == 2
    assert {one.vehicle.motion.crossings.direction for one in live} == {"camera_2_first"}
    assert any("the strips are swapped" in one for one in said)


def test_segments_begin_where_the_road_is_empty_and_lose_nothing(
    twice: tuple[Pixels, Pixels], tmp_path: Path
) -> None:
    whole, _ = run_of(Played(twice))
    assert len(whole) == 4
    live, _ = run_of(Played(twice), tmp_path, segment_s=1.5)
    assert [one.vehicle.number for one in live] == list(range(1, len(whole) + 1))
    assert max(one.segment for one in live) >= 2
    kept = [open_strip(path, "height").lines for path in sorted(tmp_path.glob("*-camera-1.tif"))]
    # each begins a moment before the one before it ends
    overlap = 2 * Finder(SITE.rows, RIG).margin
    assert sum(kept) == len(twice[0]) + overlap * (len(kept) - 1)
    for one, same in zip(live, whole, strict=True):
        assert one.vehicle.motion.speed_mps == pytest.approx(same.vehicle.motion.speed_mps, rel=2e-3)


@pytest.mark.parametrize("file", every(2, ["0002-camera-1.tif", "0002-camera-2.tif", "0002.jsonl"]))
def test_a_disk_that_is_full_where_a_segment_begins_ends_the_keeping_only(
    twice: tuple[Pixels, Pixels],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    recwarn: pytest.WarningsRecorder,
    file: str,
) -> None:
    """The files of that segment that could be made are closed, and none of them is left."""
    whole, _ = run_of(Played(twice), segment_s=1.5)
    put_words, write = spool.Spool._put_words, Journal.write

    def full(path: Path) -> None:
        if path.name == file:
            raise OSError(28, "No space left on device")

    monkeypatch.setattr(spool.Spool, "_put_words", lambda made: [full(made.path), put_words(made)])
    monkeypatch.setattr(Journal, "write", lambda made, said: [full(Path(made._file.name)), write(made, said)])
    told, said = run_of(Played(twice), tmp_path, segment_s=1.5)
    in_turn = [(one.segment, one.vehicle.number, one.vehicle.motion.speed_mps) for one in told]
    assert in_turn == [(one.segment, one.vehicle.number, one.vehicle.motion.speed_mps) for one in whole]
    assert told[-1].segment >= 2
    assert len([one for one in said if "No space left" in one]) == 1
    gc.collect()
    assert [one for one in recwarn if one.category is ResourceWarning] == []
    assert list(tmp_path.glob("0002*")) == []


@pytest.mark.parametrize(
    ("killed_again", "can_go_back"),
    [
        (False, False),
        (True, True),
        pytest.param(False, True, marks=pytest.mark.proof),
        pytest.param(True, False, marks=pytest.mark.proof),
    ],
)
def test_who_stands_when_a_stream_is_killed_is_told_by_the_next_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, killed_again: bool, can_go_back: bool
) -> None:
    """It was given up, and waited for its leaving in memory alone; also where the next one is killed too."""
    monkeypatch.setattr(finding, "STANDS_S", 4.0)
    monkeypatch.setattr("sightline.scans.live.run.LEAD_S", 2.0)
    pair, (_, next_s) = standing(1.6, wait_s=12.0)
    killed_at = 16_000

    def played(begin: int) -> Played:
        begin = begin if can_go_back else killed_at
        return Played((pair[0][begin:], pair[1][begin:]))

    def stream(source: Callable[[int], Played]) -> LiveRun:
        ticks = stopped_at(1e9)
        return live_run(source, tmp_path, rig=SLOW_RIG, can_go_back=can_go_back, clock=ticks)

    killed = stream(lambda _: Played((pair[0][:killed_at], pair[1][:killed_at])))
    monkeypatch.setattr(killed, "_end", lambda: iter(()))
    found = list(killed.vehicles())
    for one in found:
        killed.told(one)
    assert [one.vehicle.motion.status for one in found] == ["ok"]
    kill(killed)
    second = stream(played)
    told = second.vehicles()
    stood = next(told)
    second.told(stood)
    assert (stood.segment, stood.vehicle.number) == (1, 2)
    assert stood.vehicle.motion.reason == STOOD and stood.vehicle.rear_s is None
    assert stood.vehicle.front_s == pytest.approx(1905.5 / SLOW_RIG.line_rate_hz)
    assert stood.at.timestamp() == pytest.approx(1e9 + stood.vehicle.front_s - 500 / SLOW_RIG.line_rate_hz)
    if killed_again:
        told = stream(played).vehicles()
        assert all(one.segment > 1 for one in told)
        return
    # neither is its leaving told
    (after,) = told
    front = after.begin / SLOW_RIG.line_rate_hz + after.vehicle.front_s
    front += 0.0 if can_go_back else killed_at / SLOW_RIG.line_rate_hz
    assert (front, after.vehicle.motion.status) == (pytest.approx(next_s, abs=0.01), "ok")
    assert after.vehicle.number == 3


@pytest.mark.parametrize("can_go_back", [False, True])
def test_of_two_that_were_complete_at_once_the_second_is_told_after_a_kill(
    tmp_path: Path, can_go_back: bool
) -> None:
    """One stood while the other passed beside it; as it left, the program died between the two."""
    pair, _ = standing(1.6)

    def played(begin: int) -> Played:
        begin = begin if can_go_back else len(pair[0])
        return Played((pair[0][begin:], pair[1][begin:]))

    killed = live_run(lambda _: Played(pair), tmp_path, rig=SLOW_RIG, clock=stopped_at(1e9))
    found = killed.vehicles()
    stood = next(found)
    killed.told(stood)
    kill(killed)
    resumed = live_run(played, tmp_path, rig=SLOW_RIG, can_go_back=can_go_back)
    beside, *rest = resumed.vehicles()
    assert (beside.segment, beside.vehicle.number) == (1, 2)
    assert beside.vehicle.front_s < (stood.vehicle.rear_s or 0.0)
    assert beside.vehicle.motion.speed_mps == pytest.approx(14.0, abs=0.1)
    if can_go_back:
        assert [one.vehicle.number for one in rest] == [3]
        kept = [open_strip(path, "height").lines for path in sorted(tmp_path.glob("*-camera-1.tif"))]
        # an archive takes both
        assert 0 <= sum(kept) - len(pair[0]) <= SHARED_S * SLOW_RIG.line_rate_hz


def test_a_stream_killed_before_anything_was_looked_at_leaves_no_pair(
    pair: tuple[Pixels, Pixels], tmp_path: Path
) -> None:
    """All its lines are in the next; some lines of road were kept as a recording."""
    few = Played((pair[0][:500], pair[1][:500]))
    killed = live_run(lambda _: few, tmp_path, can_go_back=True)
    killed._end = lambda: iter(())  # type: ignore[method-assign]
    assert list(killed.vehicles()) == []
    kill(killed)
    assert len(list(tmp_path.glob("0001-camera-*.tif"))) == 2
    list(
        live_run(
            lambda begin: Played((pair[0][begin:], pair[1][begin:])), tmp_path, can_go_back=True
        ).vehicles()
    )
    assert list(tmp_path.glob("0001-camera-*.tif")) == []
    assert open_strip(tmp_path / "0002-camera-1.tif", "height").lines == len(pair[0])


def test_a_search_of_a_resumed_recording_sees_the_road_before_its_first_vehicle(
    pair: tuple[Pixels, Pixels], clean: list[LiveVehicle], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first, second = (one.vehicle.motion.crossings for one in clean[:2])
    in_view = int(second.front_line_2) + 200

    def played(begin: int) -> Played:
        return Played((pair[0][begin:], pair[1][begin:]))

    cut = Played((pair[0][:in_view], pair[1][:in_view]))
    killed = live_run(lambda _: cut, tmp_path, can_go_back=True, clock=stopped_at(1e9))
    monkeypatch.setattr(killed, "_end", lambda: iter(()))
    for one in killed.vehicles():
        killed.told(one)
    assert killed.found == 1
    kill(killed)
    resumed = list(live_run(played, tmp_path, can_go_back=True).vehicles())
    # all of it since the vehicle before
    front = resumed[0].vehicle.motion.crossings.front_line_1
    assert front >= second.front_line_1 - first.rear_line_2
    files = [open_strip(tmp_path / f"0002-camera-{k}.tif", "height") for k in (1, 2)]
    finder = Finder(SITE.rows, RIG)
    passages = finder.push(*(np.concatenate(list(one.chunks())) for one in files)) + finder.finish()
    again = [one.motion.speed_mps for one in measure_passages(passages, RIG, "direct")]
    assert again == pytest.approx([one.vehicle.motion.speed_mps for one in clean[1:]], rel=1e-3)


def test_a_disk_that_is_full_where_a_killed_stream_is_taken_up_ends_no_stream(
    pair: tuple[Pixels, Pixels], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    killed = live_run(lambda _: Played(pair), tmp_path)
    found = killed.vehicles()
    next(found)
    next(found)
    kill(killed)

    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("sightline.scans.live.run.append", full)
    told, said = run_of(Played((pair[0][:0], pair[1][:0])), tmp_path)
    assert [one.vehicle.number for one in told[:2]] == [1, 2]
    assert any("No space left" in one for one in said)


@pytest.mark.parametrize("then", ["rests", "cut", "replaced"])
def test_a_killed_segment_whose_file_was_cut_or_replaced_is_handed_on_whole_once(
    pair: tuple[Pixels, Pixels],
    clean: list[LiveVehicle],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    then: str,
) -> None:
    """A file that merely does not grow ends no segment: its lines may come later."""
    ended, said = list[str | None](), list[object]()

    class Survey(Keeper):
        keeps = True

        def begin(self, segment: SegmentFacts, belongs_to: Callable[[int | None], None]) -> None:
            belongs_to(7)

        def end(self, paths: tuple[Path, Path] | None, notes: list[Said], moved: Callable[[], None]) -> None:
            ended.append(paths and paths[0].name)
            moved()

    folder, path, ending = tmp_path / "spool", tmp_path / "lines.raw", Ending()
    folder.mkdir()
    monkeypatch.setattr("sightline.scans.live.run.LEAD_S", 0.3)

    def source(begin: int) -> LineSource:
        return FollowedLines(path, SITE.rows, ending, begin=0 if then == "rests" else begin, idle_s=0.1)

    def again() -> list[LiveVehicle]:
        run = live_run(source, folder, can_go_back=True, keeper=Survey(), say=said.append)
        told = list[LiveVehicle]()
        for one in run.vehicles():
            run.told(one)
            told.append(one)
        assert run.broken == (then != "rests")
        return told

    killed = live_run(lambda _: Played(pair), folder, can_go_back=True, keeper=Survey())
    found = killed.vehicles()
    for _ in range(2):
        killed.told(next(found))
    next(found)  # the third is complete, and not told
    kill(killed)
    other = np.stack([np.array(one[::-1], np.uint8) for one in pair], axis=1).tobytes()
    path.write_bytes(other if then == "replaced" else b"")
    told = again()
    assert not any("nothing is missing" in str(one) for one in said)
    if then != "rests":
        third = clean[2].vehicle.motion.crossings.front_line_1
        assert told[0].vehicle.motion.crossings.front_line_1 == pytest.approx(third, abs=1)
        assert ended == ["0001-camera-1.tif"]
        # answered for: the next run takes up nothing
        assert interrupted_segment(folder) is None and unmoved_segments(folder, None) == []
    else:
        assert ended == []
    ending.close()


@pytest.mark.parametrize("replaced", [False, True])
def test_a_file_is_compared_with_the_kept_lines_though_older_ones_come_first(
    pair: tuple[Pixels, Pixels], tmp_path: Path, replaced: bool
) -> None:
    """The second pair had just begun: the first piece was all of the road before it, and taken as equal."""
    killed = live_run(lambda _: Played(pair), tmp_path, can_go_back=True, segment_s=0.1)
    for one in killed.vehicles():
        killed.told(one)
        if one.segment == 2:
            break
    kill(killed)
    left = interrupted_segment(tmp_path)
    assert left is not None and left.number == 2 and left.begin > 500
    first, second = (one[::-1] if replaced else one for one in pair)
    said = list[object]()
    resumed = live_run(
        lambda begin: Played((first[begin:], second[begin:])), tmp_path, can_go_back=True, say=said.append
    )
    told = [(one.segment, one.vehicle.number) for one in resumed.vehicles()]
    assert resumed.broken == replaced
    assert any("was replaced by another file" in str(one) for one in said) == replaced
    assert any(segment > 2 for segment, _ in told) != replaced


@pytest.mark.parametrize("against", [True, False])
def test_vehicles_nearer_together_than_the_baseline_are_each_told_once_after_a_kill(
    tmp_path: Path, against: bool
) -> None:
    """The second was before the one camera while the first, which was told, was still before the other."""
    first = at(cars()[1], 0.8, 6.0, against=against)
    second = at(cars()[0], first.time_s(first.length_m + 0.3), 6.0, against=against)
    pair = strips(SITE, (first, second))
    clean, _ = run_of(Played(pair))
    killed = live_run(lambda _: Played(pair), tmp_path, clock=stopped_at(1e9))
    killed.told(next(killed.vehicles()))
    kill(killed)
    resumed = live_run(lambda begin: Played(tuple(one[begin:] for one in pair)), tmp_path, can_go_back=True)
    (told,) = resumed.vehicles()
    assert (told.segment, told.vehicle.number) == (2, 2)
    front = told.begin + told.vehicle.motion.crossings.front_line_1
    assert front == pytest.approx(clean[1].vehicle.motion.crossings.front_line_1, abs=0.5)
    assert told.vehicle.motion.speed_mps == pytest.approx(6.0, abs=0.05)
    assert told.vehicle.gap.time_gap_s == pytest.approx(clean[1].vehicle.gap.time_gap_s, abs=1e-3)


@pytest.mark.parametrize("written", ["over its beginning", "anew and longer", "anew and as long"])
def test_a_followed_file_that_is_written_over_ends_the_stream_and_is_said(
    pair: tuple[Pixels, Pixels], tmp_path: Path, written: str
) -> None:
    """The same file: what was read of it is others' lines now, and what follows does not go on from it."""
    lines = np.stack([np.asarray(one, np.uint8) for one in pair], axis=1)
    path, ending = tmp_path / "lines.raw", Ending()
    path.write_bytes(lines[:2000].tobytes())
    source = FollowedLines(path, SITE.rows, ending, idle_s=0.1)
    pieces = source.pieces()
    first = next(pieces)
    assert first is not None and len(first.first) == 2000
    others = lines[::-1].tobytes()
    if written == "over its beginning":
        with path.open("r+b") as file:
            file.write(others[: 500 * lines[0].size])
    else:
        path.write_bytes(others[: (3000 if written == "anew and longer" else 2000) * lines[0].size])
    assert [one for one in pieces if one is not None] == []
    assert source.broken and "written over" in source.notes[0]
    ending.close()


def test_strips_that_were_not_moved_when_a_stream_was_killed_are_moved_by_the_next(
    two: tuple[Pixels, Pixels], tmp_path: Path
) -> None:
    class Survey(Keeper):
        keeps = True

        def __init__(self, *, killed: bool) -> None:
            self.killed, self.seen = killed, list[object]()

        def begin(self, segment: SegmentFacts, belongs_to: Callable[[int | None], None]) -> None:
            belongs_to(7)

        def take_up(self, segment: SegmentFacts | None, scan_id: int | None, told: int) -> None:
            self.seen.append((segment and segment.number, scan_id, told))

        def end(self, paths: tuple[Path, Path] | None, notes: list[Said], moved: Callable[[], None]) -> None:
            self.seen.append(paths and paths[0].name)
            if not self.killed:
                moved()

    told = run_of(Played(two), tmp_path, keeper=Survey(killed=True))[0]
    assert len(told) == 2
    nothing = Played((two[0][:0], two[1][:0]))
    run_of(nothing, tmp_path)  # of no survey: they are another's
    next_one, last = Survey(killed=False), Survey(killed=False)
    for keeper in (next_one, last):
        assert run_of(nothing, tmp_path, keeper=keeper)[0] == []
    assert (next_one.seen, last.seen) == ([(1, 7, 2), "0001-camera-1.tif"], [])


def test_who_left_before_a_stream_was_killed_is_not_told_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The journal's last second says that it stands; since then it was told."""
    monkeypatch.setattr(finding, "STANDS_S", 4.0)
    pair, _ = standing(1.6, wait_s=12.0)
    run = live_run(lambda _: Played(pair), tmp_path, rig=SLOW_RIG, clock=stopped_at(1e9))
    for one in run.vehicles():
        run.told(one)
        if one.vehicle.number == 2:
            break
    assert one.vehicle.rear_s == pytest.approx(20375.5 / SLOW_RIG.line_rate_hz)
    kill(run)
    nothing = Played((pair[0][:0], pair[1][:0]))
    rest = list(live_run(lambda _: nothing, tmp_path, rig=SLOW_RIG).vehicles())
    assert [one.vehicle.motion.reason for one in rest if one.vehicle.front_s < 18] == []


def test_a_gap_runs_from_one_that_stood_since_the_segment_before(monkeypatch: pytest.MonkeyPatch) -> None:
    """Another passed beside it meanwhile: 6.2 s were told from that one's rear."""
    monkeypatch.setattr(finding, "STANDS_S", 4.0)
    pair, (rear_s, next_s) = standing(1.6)
    run = live_run(lambda _: Played(pair), rig=SLOW_RIG, segment_s=6.5)
    told = []
    for one in run.vehicles():
        told.append(one)
        run._segment_s = 3600.0
    assert [(one.segment, one.vehicle.number) for one in told] == [(1, 1), (2, 2), (2, 3), (2, 4)]
    _, beside, stood, last = (one.vehicle for one in told)
    # in view where its lines begin: nobody saw its front there
    assert (stood.front_s, beside.gap.time_gap_s) == (0.0, None)
    begin_s = told[2].begin / SLOW_RIG.line_rate_hz
    assert begin_s + (stood.rear_s or 0.0) == pytest.approx(rear_s, abs=0.02)
    assert last.gap.time_gap_s == pytest.approx(next_s - rear_s, abs=0.02)
    # from the front of the one beside it, as `flow` counts
    assert last.gap.headway_s == pytest.approx(last.front_s - beside.front_s)
    assert last.gap.distance_gap_m is None


def test_what_still_stands_where_a_segment_ends_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    """Another segment begins before it; nobody waits for it any longer."""
    monkeypatch.setattr(finding, "STANDS_S", 4.0)
    pair, _ = standing(1.6, wait_s=12.0)
    played, rig = Played(pair), SLOW_RIG
    run = LiveRun(
        lambda _: played,
        64,
        rig,
        "direct",
        folder=None,
        keeper=Keeper(),
        say=print,
        name="played",
        segment_s=6.5,
    )
    told = list(run.vehicles())
    # not again as it leaves, but of the segment through all of which it stood: that told 0 % occupancy
    assert [(one.segment, one.vehicle.number) for one in told] == [(1, 1), (2, 2), (2, 3), (3, 4)]
    throughout = told[2].vehicle
    assert (throughout.front_s, throughout.motion.reason) == (0.0, STOPPED)
    begun = [one.begin / rig.line_rate_hz for one in told]
    assert begun[2] + (throughout.rear_s or 0.0) == pytest.approx(begun[3], abs=0.1)
    assert told[0].vehicle.motion.reason == STOOD and told[0].vehicle.rear_s is None
    assert told[1].vehicle.motion.speed_mps == pytest.approx(14.0, abs=0.1)
