"""A followed stream that is killed at any write to its folder and taken up, once or twice: who is told."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO, Any

import numpy as np
import pytest

from sightline.linescan.parts import Rig
from sightline.media.lines.source import LineSource, Piece
from sightline.media.strips.sheet import Pixels
from sightline.scans.live.records import Keeper, LiveVehicle
from sightline.scans.live.run import Clock, LiveRun
from tests.linescan.scenes import SLOW_RIG
from tests.simulation.scan_strips import strips
from tests.simulation.scan_traffic import ScanSite, traffic

pytestmark = pytest.mark.once

SITE = ScanSite(rows=64, misalignment_px=0.3, line_rate_hz=SLOW_RIG.line_rate_hz)
RIG = Rig(SITE.baseline_m, SITE.line_rate_hz)
AT_ONCE = 1 << 20
# The road is learnt anew from another stretch of lines: of the standard uncertainty by which noise moves a
# result, the part that the background has.
OF_U = 0.3
Files = dict[str, bytes]


@dataclass(frozen=True)
class Left:
    """A folder as a kill leaves it, and who had been told by then."""

    last: str
    files: Files
    told: tuple[LiveVehicle, ...]


class Writing:
    """A file of the folder, opened to be written; a text goes there in two halves."""

    def __init__(self, file: IO[Any], name: str, disk: Disk) -> None:
        self._file, self._name, self._disk = file, name, disk
        disk.step(f"open {name}")

    def write(self, data: Any) -> int:
        halves = [data[: len(data) // 2], data[len(data) // 2 :]] if isinstance(data, str) else [data]
        for half in halves:
            self._file.write(half)
            self._file.flush()
            self._disk.step(f"write {self._name} {data[:40]!r}")
        return len(data)

    def truncate(self, size: int) -> None:
        self._file.truncate(size)
        self._disk.step(f"truncate {self._name}")

    def seek(self, at: int) -> int:
        return self._file.seek(at)

    def close(self) -> None:
        self._file.close()

    @property
    def closed(self) -> bool:
        return self._file.closed

    def __enter__(self) -> Writing:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


@dataclass
class Disk:
    """Keeps what a kill would leave after each write to a folder, and between telling and keeping: the files
    of every `nth` such state, for all of them would fill the memory.
    """

    folder: Path
    told: list[LiveVehicle]
    nth: int
    left: list[Left] = field(default_factory=list)
    files: Files = field(default_factory=dict)

    def step(self, last: str) -> None:
        files = {path.name: path.read_bytes() for path in self.folder.iterdir()}
        if not self.left or files != self.files or len(self.told) != len(self.left[-1].told):
            kept = files if len(self.left) % self.nth == 0 else {}
            self.left.append(Left(last, kept, tuple(self.told)))
            self.files = files

    def watch(self, patch: pytest.MonkeyPatch) -> None:
        open_file, unlink = Path.open, Path.unlink

        def opened(path: Path, mode: str = "r", *args: Any, **more: Any) -> Any:
            file = open_file(path, mode, *args, **more)
            writes = path.parent == self.folder and mode not in ("r", "rb")
            return Writing(file, path.name, self) if writes else file

        def unlinked(path: Path, *args: Any, **more: Any) -> None:
            unlink(path, *args, **more)
            self.step(f"unlink {path.name}")

        patch.setattr(Path, "open", opened)
        patch.setattr(Path, "unlink", unlinked)


class Growing:
    """A file of line pairs; `lines`: how many come at once."""

    name, notes, broken = "growing", list[str](), False

    def __init__(self, pair: tuple[Pixels, Pixels], begin: int, lines: int) -> None:
        self._pair, self._begin, self._lines = pair, begin, lines
        self.waiting_bytes, self.last_at = 0, 1e9

    def pieces(self) -> Iterator[Piece | None]:
        count = len(self._pair[0])
        for start in range(self._begin, count, self._lines):
            yield None
            stop = min(start + self._lines, count)
            self.waiting_bytes = 2 * SITE.rows * (count - stop)
            first, second = (np.array(one[start:stop], np.uint8) for one in self._pair)
            yield Piece(first, second)


@dataclass(frozen=True)
class Case:
    """`lines`: how many come at once before the kill, and after it."""

    lines: tuple[int, int]
    lead_s: float
    segment_s: float = 3600.0


def clock() -> Clock:
    """A second goes by whenever somebody looks."""
    ticks = itertools.count()
    now = [0.0]

    def steady() -> float:
        now[0] = float(next(ticks))
        return now[0]

    return Clock(wall=lambda: 1e9 + now[0], steady=steady)


def run(
    pair: tuple[Pixels, Pixels], folder: Path | None, lines: int, segment_s: float, disk: Disk | None = None
) -> list[LiveVehicle]:
    told = list[LiveVehicle]() if disk is None else disk.told

    def source(begin: int) -> LineSource:
        return Growing(pair, begin, lines)

    live = LiveRun(
        source,
        SITE.rows,
        RIG,
        "direct",
        folder=folder,
        keeper=Keeper(),
        say=lambda _: None,
        name="growing",
        can_go_back=True,
        segment_s=segment_s,
        clock=clock(),
    )
    for one in live.vehicles():
        told.append(one)
        if disk is not None:
            disk.step(f"told {one.vehicle.number}")
        live.told(one)
    return told


def resumed(pair: tuple[Pixels, Pixels], left: Left, folder: Path, case: Case, *, nth: int = 0) -> Disk:
    """What is told in all, and what further kills would leave, every `nth` state of that (0: none)."""
    folder.mkdir()
    for name, data in left.files.items():
        (folder / name).write_bytes(data)
    disk = Disk(folder, list(left.told), nth)
    with pytest.MonkeyPatch.context() as patch:
        if nth:
            disk.watch(patch)
        told = run(pair, folder, case.lines[1], case.segment_s, disk if nth else None)
    if not nth:
        disk.told += told
    for path in folder.iterdir():
        path.unlink()
    folder.rmdir()
    return disk


def kind_of(one: LiveVehicle) -> tuple[object, ...]:
    motion, gap = one.vehicle.motion, one.vehicle.gap
    numbers = (gap.time_gap_s, gap.distance_gap_m, gap.headway_s, motion.speed_mps, one.vehicle.rear_s)
    known = tuple(number is not None for number in numbers)
    return one.vehicle.number, motion.status, motion.reason, motion.crossings.direction, gap.reason, known


def in_u(one: LiveVehicle, same: LiveVehicle) -> list[float]:
    """By how many standard uncertainties the numbers differ."""
    (now, then), (gap, was) = (one.vehicle.motion, same.vehicle.motion), (one.vehicle.gap, same.vehicle.gap)
    pairs = [
        (now.speed_mps, then.speed_mps, then.u_speed_mps),
        (now.acceleration_mps2, then.acceleration_mps2, then.u_acceleration_mps2),
        (now.length_m, then.length_m, then.u_length_m),
        (gap.time_gap_s, was.time_gap_s, was.u_time_gap_s),
        (gap.distance_gap_m, was.distance_gap_m, was.u_distance_gap_m),
        (gap.headway_s, was.headway_s, was.u_time_gap_s),
    ]
    return [abs(a - b) / u for a, b, u in pairs if a is not None and b is not None and u]


def check(told: list[LiveVehicle], clean: list[LiveVehicle], where: object) -> None:
    """Everybody once, but for one who was told and not yet kept in the journal: with the same number."""
    numbers = [one.vehicle.number for one in told]
    assert [number for number, _ in itertools.groupby(numbers)] == list(range(1, len(clean) + 1)), where
    for one in told:
        same = clean[one.vehicle.number - 1]
        assert kind_of(one) == kind_of(same), where
        assert max(in_u(one, same)) < OF_U, (where, in_u(one, same))
        u_s = same.vehicle.gap.u_time_gap_s or 0.5 / RIG.line_rate_hz
        assert abs((one.at - same.at).total_seconds()) < u_s, where


@pytest.fixture(scope="module")
def pair() -> tuple[Pixels, Pixels]:
    return strips(SITE, traffic(5, 4, speeds_mps=(11.0, 18.0), gaps_s=(0.5, 0.8), start_s=0.8))


@pytest.mark.parametrize(
    ("case", "nth"),
    [
        (Case((500, 500), 0.5, 2.0), 13),
        # 40 is within the picture of a front that was not told yet
        (Case((500, AT_ONCE), 0.5), 20),
        *(
            pytest.param(Case((before, after), lead_s, segment_s), 1, marks=pytest.mark.proof)
            for before, after in [(500, 500), (500, AT_ONCE), (170, 2500), (2500, 130)]
            for lead_s, segment_s in [(0.5, 2.0), (10.0, 3600.0)]
        ),
    ],
)
def test_a_stream_killed_at_any_write_tells_everybody_once_with_the_same_numbers(
    pair: tuple[Pixels, Pixels], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, case: Case, nth: int
) -> None:
    """Numbers, motions, gaps and times are those of a stream that nobody killed; also after a second kill."""
    monkeypatch.setattr("sightline.scans.live.run.LEAD_S", case.lead_s)
    monkeypatch.setattr("sightline.scans.live.segment.LEAD_S", case.lead_s)
    clean = run(pair, None, case.lines[0], 3600.0)
    assert len(clean) == 4
    disk = Disk(tmp_path / "first", [], nth)
    disk.folder.mkdir()
    with pytest.MonkeyPatch.context() as patch:
        disk.watch(patch)
        run(pair, disk.folder, case.lines[0], case.segment_s, disk)
    check(disk.told, clean, "not killed")
    for number, left in under_way(disk):
        again = number % max(4 * nth, 16) == 0
        second = resumed(pair, left, tmp_path / f"{number}", case, nth=max(6 * nth, 12) if again else 0)
        check(second.told, clean, (number, left.last))
        for further, twice in under_way(second) if again else ():
            third = resumed(pair, twice, tmp_path / f"{number}-{further}", case)
            check(third.told, clean, (number, left.last, further, twice.last))


def under_way(disk: Disk) -> list[tuple[int, Left]]:
    """The kept states until the last segment is closed: the stream has ended, and the next is another."""
    closed = max(number for number, left in enumerate(disk.left) if '{"closed"' in left.last)
    return list(enumerate(disk.left[:closed]))[:: disk.nth]
