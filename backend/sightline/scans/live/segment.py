"""One stretch of a live stream: lines in, vehicles out, both cameras' lines kept in a pair of files."""

from collections.abc import Iterator, Sequence
from contextlib import ExitStack
from dataclasses import asdict, astuple, replace
from datetime import datetime, timedelta
from math import inf
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from sightline.enums import ScanMethod
from sightline.linescan.background import Road, first_road
from sightline.linescan.finding import BEGIN_S, Behind, Finder
from sightline.linescan.parts import STOOD, Crossings, Passage, Rig
from sightline.linescan.passing import Ahead, Follower
from sightline.media.lines.source import Lines, Lost, Piece
from sightline.media.strips.notes import Dropped, columns_of
from sightline.media.strips.spool import Spool, SpooledLines
from sightline.messages.said import Said
from sightline.scans.live.journal import (
    Before,
    Journal,
    Told,
    journal_path,
    left_by,
    motion_document,
    spool_paths,
    told_line,
)
from sightline.scans.live.records import LiveVehicle, SegmentFacts
from sightline.scans.losses import without_losses

LEAD_S = 10.0  # lines before the first one asked for, from which the road is learnt


class Camera:
    """What was lost of one camera's lines, and the file that they are kept in."""

    def __init__(self, spool: Spool | None) -> None:
        self.spool, self.lost, self.dropped = spool, 0, list[Dropped]()
        self._lines = self._pending = 0

    def take(self, lines: Lines, lost: Sequence[tuple[int, int]]) -> None:
        """The next lines, those of `lost` (first, count) being copies; only what came is kept."""
        kept = np.ones(len(lines), bool)
        for start, count in lost:
            kept[start : start + count] = False
        there = lines[kept] if lost else lines
        gaps: list[Dropped] = []
        # what was lost at the very end stands before the next line that comes
        if self._pending and len(there):
            gaps.append(Dropped(0, self._pending))
            self._pending = 0
        for start, count in lost:
            at = int(kept[:start].sum())
            self.lost += count
            if at < len(there):
                gaps.append(Dropped(at, count))
            else:
                self._pending += count
        self.dropped += [Dropped(self._lines + gap.line, gap.count) for gap in gaps]
        self._lines += len(there)
        if self.spool is not None:
            self.spool.write(there, gaps)


class Segment:
    """Lines that are counted from 0, one finder, a pair of files (`folder` None: not kept).

    `begin`: number of line 0 in a followed file; `before`: vehicles that are already told; `first_id`: number
    of the first vehicle; `behind`: roads behind who stands and was told; `ahead`: who was told before, in
    this segment's lines; `lead`: so many lines come before line 0, from which the road is learnt: they are of
    the segment before, and are not kept again.
    """

    def __init__(
        self,
        facts: SegmentFacts,
        rows: int,
        rig: Rig,
        method: ScanMethod,
        folder: Path | None,
        *,
        begin: int = 0,
        before: Before = Before(),
        first_id: int = 1,
        behind: Behind = ((), ()),
        ahead: Ahead = (),
        lead: int = 0,
    ) -> None:
        self.facts, self.rig, self.lines, self._lead = facts, rig, -lead, lead
        self.full: Said | None = None
        self.finder = Finder(rows, rig, behind=behind)
        self.vehicles = first_id - 1
        self.found = 0
        self._more = False  # of those that were complete at once, some are yet to be told
        self._before, self.begin = before, begin
        self.paths = spool_paths(folder, facts.number) if folder else None
        self._follower = Follower(rig, method, self._columns, first_id, ahead)
        head = {"stream": facts.stream, "source": facts.source, "rows": rows, "rig": asdict(rig)}
        head |= {"began_at": facts.began_at.isoformat(), "begin": begin, "first_id": first_id}
        head |= {"before": astuple(before), "ahead": [motion_document(motion) for _, motion in ahead]}
        with ExitStack() as made:
            spools: list[Spool | None] = [None, None]
            for at, path in enumerate(self.paths or ()):
                spools[at] = spool = Spool(path, rows, rig.line_rate_hz)
                made.callback(spool.discard)
            self.journal = Journal(journal_path(folder, facts.number), head) if folder else None
            made.pop_all()
        self.cameras = (Camera(spools[0]), Camera(spools[1]))

    def take(self, piece: Piece) -> Iterator[LiveVehicle]:
        """The vehicles that are complete with these lines. A full disk ends the keeping only."""
        kept = piece.since(min(max(-self.lines, 0), len(piece.first)))
        for number, (camera, lines) in enumerate(
            zip(self.cameras, (kept.first, kept.second), strict=True), 1
        ):
            lost = _within(kept.lost, number)
            try:
                camera.take(lines, lost)
            except OSError as error:
                self._stop_keeping(error)
        self.lines += len(piece.first)
        yield from self._tell_passages(self.finder.push(piece.first, piece.second))

    def finish(self) -> Iterator[LiveVehicle]:
        """What is complete at the end of the lines."""
        if self.lines > 0:
            yield from self._tell_passages(self.finder.finish())
            yield from self._tell_passages(self.finder.stood_throughout(), always=True)

    def give_up(self) -> Iterator[LiveVehicle]:
        """What still stands, where another segment goes on; what has stood all the time is told of this one
        too.
        """
        yield from self._tell_passages(self.finder.give_up())
        yield from self._tell_passages(self.finder.stood_throughout(), always=True)

    def note(self, at: datetime) -> None:
        """Say in the journal how far everything is told."""
        settled, stand = self._returned_line, self._stand()
        self._write({"settled": settled, "stand": stand, "lines": self.lines, "at": at.isoformat()})

    def told(self, live_vehicle: LiveVehicle) -> None:
        """Say in the journal that a vehicle has been told."""
        settled = {} if self._more else {"settled": self._returned_line}
        self._write({**told_line(live_vehicle), **settled, "stand": self._stand()})

    def stop_at(self, line: int) -> None:
        """Say in the journal that another segment goes on from there."""
        self._write({"stop": line})

    def belongs_to(self, scan_id: int | None) -> None:
        self._write({"scan_id": scan_id})

    def close(self, notes: Sequence[Said], stop: int | None = None) -> list[Said]:
        """Close the files, both with the same lines (`stop`: only so many); what is to be said of them.
        `notes`: of the segment, for whoever moves its strips after a kill.
        """
        sayings = []
        for camera in self.cameras:
            if camera.spool is not None:
                camera.spool.close()
        if self.paths:
            kept = trim_to_common_lines(self.paths, stop)
            for path in self.paths:
                if kept:
                    sayings.append(Said("stream-lines-stored", kept=kept, path=path))
                else:
                    path.unlink(missing_ok=True)
            self.paths = self.paths if kept else None
        if self.journal is not None:
            self._write({"closed": [one.document for one in notes]})
            self.journal.close()
        return sayings + ([self.full] if self.full else [])

    @property
    def settled_line(self) -> int:
        """All whose rears came before this line are told."""
        return max(0, self.finder.settled_line - self._lead)

    @property
    def crowded(self) -> bool:
        """Whether the list of lost lines needs another file."""
        return any(camera.spool is not None and camera.spool.full for camera in self.cameras)

    @property
    def quiet(self) -> bool:
        """Whether no vehicle is in view of what was looked at: a good moment to begin another segment."""
        return 0 < self.finder.watchers[0].lines == self.finder.settled_line

    def time_of(self, line: float) -> datetime:
        return self.facts.began_at + timedelta(seconds=line / self.rig.line_rate_hz)

    def _tell_passages(self, passages: Sequence[Passage], *, always: bool = False) -> Iterator[LiveVehicle]:
        for left, found in zip(range(len(passages) - 1, -1, -1), passages, strict=True):
            self._more = left > 0
            passage = _move_passage(found, -self._lead, 0.0 if always else -inf)
            guard = self.finder.spans.guard
            counted = always or not self._before.has(passage.crossings.front_line_1, guard)
            if not counted and not self._before.leaves_later(passage.crossings, guard):
                continue
            dropped = (self.cameras[0].dropped, self.cameras[1].dropped)
            vehicle = self._follower.next(without_losses(passage, dropped), counted=counted)
            if counted and vehicle is not None:
                self.vehicles = vehicle.number
                self.found += vehicle.motion.status == "ok"
                at = self.time_of(passage.crossings.front_line_1)
                yield LiveVehicle(self.facts.number, self.begin, vehicle, at)

    @property
    def _returned_line(self) -> int:
        """For the journal."""
        return max(0, self.finder.returned_line - self._lead)

    @property
    def ahead(self) -> Ahead:
        """Who was told and the next gap may run from."""
        return self._follower.ahead

    def _stand(self) -> list[list[float]]:
        """Lines of those that nobody waits for, and that are told when they have left."""
        return [[float(line - self._lead) for line in asdict(one).values()] for one in self.finder.given_up]

    def _columns(self, crossings: Crossings) -> Crossings:
        return columns_of(crossings, *(camera.dropped for camera in self.cameras))

    def _stop_keeping(self, error: OSError) -> None:
        self.full = Said("stream-lines-not-stored", strerror=error.strerror)
        for camera in self.cameras:
            if camera.spool is not None:
                camera.spool.close()
                camera.spool = None

    def _write(self, said: dict[str, Any]) -> None:
        if self.journal is not None:
            try:
                self.journal.write(said)
            except OSError as error:
                self.full = self.full or Said("stream-journal-not-written", strerror=error.strerror)


class Remainder:
    """What a killed stream had taken and not told: who stood, and its spooled lines, looked through again."""

    def __init__(
        self, paths: tuple[Path, Path], facts: SegmentFacts, rig: Rig, method: ScanMethod, left: Told
    ) -> None:
        self.lines = trim_to_common_lines(paths)
        self._spooled = [SpooledLines(path) for path in paths]
        self._start = max(0, int(left.before.settled - LEAD_S * rig.line_rate_hz))
        self._before, self._facts, self._rig, self._begin = left.before, facts, rig, left.begin
        self._told = list[Crossings]()
        dropped = (self._spooled[0].dropped, self._spooled[1].dropped)
        first_id = left.vehicles + 1
        self._follower = Follower(
            rig, method, lambda crossings: columns_of(crossings, *dropped), first_id, left.ahead
        )
        behind = (
            self._roads(0, [at.front_line_1 for at in left.stand]),
            self._roads(1, [at.front_line_2 for at in left.stand]),
        )
        self.finder = Finder(self._spooled[0].rows, rig, behind=behind)
        self._stand = left.stand

    def stood(self) -> Iterator[LiveVehicle]:
        """Those whom nobody saw leave: all that is known of them are their lines, far before the others'."""
        rows, stand = self._spooled[0].rows, self._stand
        nothing, road = np.empty((0, rows), np.uint8), np.zeros(rows, np.float32)
        for at in stand:
            passage = Passage(
                crossings=at,
                first=nothing,
                second=nothing,
                start_1=0,
                start_2=0,
                background_1=road,
                background_2=road,
                noise_dn=0.0,
                reason=STOOD,
            )
            yield from self._tell_vehicle(passage, counted=True)

    def complete(self) -> Iterator[LiveVehicle]:
        """The vehicles that were not told before and are complete."""
        for one, two in zip(*(each.chunks(self._start) for each in self._spooled), strict=True):
            yield from self._vehicles(self.finder.push(one, two))

    def give_up(self) -> Iterator[LiveVehicle]:
        """Who still stands and is given up, where the lines go on in another finder."""
        yield from self._vehicles(self.finder.give_up())

    def finish(self) -> Iterator[LiveVehicle]:
        """Who is in view where the lines end."""
        yield from self._vehicles(self.finder.finish())

    @property
    def before(self) -> Before:
        """Who is told by now."""
        settled = max(self._before.settled, self._start + float(self.finder.returned_line))
        passed = [(at.front_line_1, at.rear_line_1) for at in self._told]
        left = max([self._before.left, *map(left_by, self._told)])
        return Before.of(settled, [*self._before.passed, *passed], left)

    @property
    def ahead(self) -> Ahead:
        """Who was told and the next gap may run from."""
        return self._follower.ahead

    def begins(self, start: int, piece: Piece) -> bool:
        """Whether a piece shows the lines that were taken from `start` on, as far as it goes."""
        for spooled, lines in zip(self._spooled, (piece.first, piece.second), strict=True):
            kept, came = next(spooled.chunks(max(0, start)), lines[:0]), lines[max(0, -start) :]
            count = min(len(kept), len(came))
            if not np.array_equal(kept[:count], came[:count]):
                return False
        return True

    def _vehicles(self, passages: Sequence[Passage]) -> Iterator[LiveVehicle]:
        dropped = (self._spooled[0].dropped, self._spooled[1].dropped)
        for passage in passages:
            moved = _move_passage(passage, self._start)
            guard = self.finder.spans.guard
            counted = not self._before.has(moved.crossings.front_line_1, guard)
            if counted or self._before.leaves_later(moved.crossings, guard):
                yield from self._tell_vehicle(without_losses(moved, dropped), counted=counted)

    def _roads(self, camera: int, fronts: Sequence[float]) -> list[Road]:
        """What the lines before these fronts show."""
        finder, roads = Finder(self._spooled[0].rows, self._rig), list[Road]()
        for front in fronts:
            stop = int(front) - finder.spans.guard
            start = max(0, stop - round(BEGIN_S * self._rig.line_rate_hz))
            pieces, lines = list[NDArray[np.uint8]](), 0
            for piece in self._spooled[camera].chunks(start):
                pieces.append(piece[: max(0, stop - start - lines)])
                lines += len(piece)
                if lines >= stop - start:
                    break
            block = np.concatenate([np.empty((0, finder.rows), np.uint8), *pieces])
            if len(block) >= finder.spans.road:
                roads.append(first_road(block, finder.grid, finder.spans.road))
        return roads

    def _tell_vehicle(self, passage: Passage, *, counted: bool) -> Iterator[LiveVehicle]:
        vehicle = self._follower.next(passage, counted=counted)
        if counted and vehicle is not None:
            self._told.append(passage.crossings)
            at = self._facts.began_at + timedelta(seconds=vehicle.front_s)
            yield LiveVehicle(self._facts.number, self._begin, vehicle, at)


def trim_to_common_lines(paths: tuple[Path, Path], stop: int | None = None) -> int:
    """The lines that both files have (`stop`: at most so many), each shortened to them."""
    both = [SpooledLines(path) for path in paths]
    common = min(one.total_lines for one in both)
    common = common if stop is None else min(common, stop)
    for one in both:
        if one.total_lines > common or any(gap.line >= one.lines for gap in one.dropped):
            one.shorten(common)
    return common


def _move_passage(passage: Passage, by: int, least: float = -inf) -> Passage:
    crossings = Crossings(*(max(line + by, least) for line in asdict(passage.crossings).values()))
    start_1, start_2 = passage.start_1 + by, passage.start_2 + by
    return replace(passage, crossings=crossings, start_1=start_1, start_2=start_2)


def _within(lost: Sequence[Lost], camera: int) -> list[tuple[int, int]]:
    return [(one.line, one.count) for one in lost if one.camera == camera]
