"""A live stream from its source to what is told: segments, what a killed run left, health."""

import os
import secrets
import time
from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from datetime import UTC, datetime, timedelta
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from sightline.enums import ScanMethod
from sightline.errors import BadInput
from sightline.linescan import faults
from sightline.linescan.finding import Behind, Finder
from sightline.linescan.parts import Rig
from sightline.linescan.passing import Ahead, move_ahead
from sightline.linescan.rig import rig_from
from sightline.media.lines.source import LineSource, Piece, describe_replaced
from sightline.messages.said import Said
from sightline.scans.live.journal import (
    Before,
    Told,
    append,
    interrupted_segment,
    journal_path,
    last_number,
    spool_paths,
    told_line,
    unmoved_segments,
)
from sightline.scans.live.records import Keeper, LiveHealth, LiveVehicle, SegmentFacts
from sightline.scans.live.segment import LEAD_S, Remainder, Segment, trim_to_common_lines

TICK_S = 1.0
JUMP_S = 0.5
_ENDED = {"ended": "whole"}
Say = Callable[[Said | str], None]


@dataclass(frozen=True)
class Clock:
    """The computer's two clocks: the one that is set, and the one that only counts."""

    wall: Callable[[], float] = time.time
    steady: Callable[[], float] = time.monotonic

    def now(self) -> datetime:
        return datetime.fromtimestamp(self.wall(), UTC)


class LiveRun:
    """The vehicles of a source while they pass.

    `source`: opens it, from a line on where it can go back (`can_go_back`); `folder`: where lines and journal
    are kept (None: nowhere); `segment_s`: how much traffic one pair of files holds; `say`: takes sentences.
    `broken`: what went wrong with the source ended it.
    Raises BadInput where what a killed run left was recorded with another rig.
    """

    def __init__(
        self,
        source: Callable[[int], LineSource],
        rows: int,
        rig: Rig,
        method: ScanMethod,
        *,
        folder: Path | None,
        keeper: Keeper,
        say: Say,
        name: str,
        can_go_back: bool = False,
        segment_s: float = 3600.0,
        clock: Clock = Clock(),
    ) -> None:
        self.rows, self.rig, self.method, self.folder = rows, rig, method, folder
        self.found, self.lines, self.broken = 0, 0, False
        self._keeper, self._say, self._clock, self._name = keeper, say, clock, name
        self._segment_s, self._go_back, self._open = segment_s, can_go_back, source
        self._said: set[tuple[str, object]] = set()
        self._segment: Segment | None = None
        self._stream = secrets.token_hex(8)
        self._begin, self._lead, self._before, self._first_id = 0, 0, Before(), 1
        self._stop = 0  # of the segment that a killed run left
        self._resumed_at: datetime | None = None
        self._left: Told | None = None
        self._rest: Remainder | None = None
        self._behind: Behind = ((), ())
        self._ahead: Ahead = ()  # in the next segment's lines
        self._ticked = self._clock.steady()
        self._apart = self._clock.wall() - self._ticked
        self._began, self._number = 0.0, 0
        self._recent: deque[Piece] = deque()
        self.source: LineSource | None = None

    def vehicles(self) -> Iterator[LiveVehicle]:
        """Every vehicle as soon as it is measured; first those that a killed run had not told."""
        left = interrupted_segment(self.folder) if self.folder else None
        for before in unmoved_segments(self.folder, left) if self.folder else ():
            if not before.closed:
                self._close_left(before, before.stop)
            self._hand_on(replace(before, closed=True))
        if left is not None:
            yield from self._taken_up(left)
        self.source = self._open(self._begin - self._lead)
        for piece in self._compared(self.source.pieces()):
            if piece is not None and len(piece.first):
                yield from self._take(piece)
            self._tick()
            if self._segment is not None and self._is_over(self._segment):
                yield from self._next_segment(self._segment)
        yield from self._end()
        self.broken |= self.source.broken
        if self._left is not None and self.broken:
            # its file was cut or replaced, so its lines never go on; who stood is told by now
            yield from self._end_whole(self._left, self._rest)
        for sentence in self.source.notes:
            self._say(sentence)

    def told(self, live_vehicle: LiveVehicle) -> None:
        """After a vehicle was told: it is kept, and no later run tells it again."""
        if self._segment is not None:
            self._segment.told(live_vehicle)
        elif self.folder is not None:
            self._append(live_vehicle.segment, told_line(live_vehicle))
        self._keeper.add(live_vehicle)
        self.found += live_vehicle.vehicle.motion.status == "ok"

    def _take(self, piece: Piece) -> Iterator[LiveVehicle]:
        segment = self._segment or self._first_segment(piece)
        piece = replace(piece, lost=tuple(replace(one, line=one.line - self.lines) for one in piece.lost))
        self.lines += len(piece.first)
        self._recent.append(piece)
        held = sum(len(one.first) for one in self._recent)
        while held - len(self._recent[0].first) > 2 * segment.finder.block:
            held -= len(self._recent.popleft().first)
        yield from segment.take(piece)

    def _compared(self, pieces: Iterator[Piece | None]) -> Iterator[Piece | None]:
        """The pieces, held back until they reach a line that a killed run kept of the file that it followed;
        none where its lines are others, though it is as long.
        """
        rest, held = self._rest, list[Piece]()
        start = 0 if self._left is None else self._begin - self._lead - self._left.begin
        for piece in pieces:
            if rest is None or piece is None or not len(piece.first):
                yield piece
                continue
            if not rest.begins(start, piece):
                self.broken = True
                self._say(describe_replaced(self._name))
                return
            held.append(piece)
            start += len(piece.first)
            if start > 0 or not rest.lines:
                yield from held
                rest, held = None, []

    def _first_segment(self, piece: Piece) -> Segment:
        """Its line 0 is older than the last line by as much as the lines since make, or what a killed run
        wrote of it.
        """
        assert self.source is not None
        left, self._left = self._left, None
        if left is not None:
            self._append(left.number, {"stop": self._stop})
        came = len(piece.first) + self.source.waiting_bytes // (2 * self.rows)
        now, last_at = self._clock.now(), self.source.last_at
        # another machine's clock may be ahead, but no line comes after now
        last = now if last_at is None else min(now, datetime.fromtimestamp(last_at, UTC))
        began_at = self._resumed_at or last - timedelta(seconds=came / self.rig.line_rate_hz)
        end_left = partial(self._end_left, left) if left is not None else lambda: None
        return self._new_segment(began_at, self._begin, (now - began_at).total_seconds(), end_left)

    def _next_segment(self, before: Segment) -> Iterator[LiveVehicle]:
        """Where the road is empty: another pair of files, from just before the lines not yet looked at."""
        yield from before.give_up()
        stop = before.settled_line
        start = max(0, stop - 2 * before.finder.margin)
        self._behind, self._ahead = before.finder.behind, move_ahead(before.ahead, -start)
        self._first_id = before.vehicles + 1
        before.stop_at(stop)
        again = before.lines - start
        since_s = again / self.rig.line_rate_hz
        end_before = partial(self._close, before, stop)
        segment = self._new_segment(before.time_of(start), before.begin + start, since_s, end_before)
        held = sum(len(one.first) for one in self._recent)
        for piece in self._recent:
            skipped = min(max(0, held - again), len(piece.first))
            held -= len(piece.first)
            if skipped < len(piece.first):
                yield from segment.take(piece.since(skipped))

    def _new_segment(
        self, began_at: datetime, begin: int, since_s: float, end_before: Callable[[], None]
    ) -> Segment:
        """The one before ends once this one is in the folder: a program that is killed between the two leaves
        one that the next goes on from.
        """
        number = 1 + max(self._number, last_number(self.folder) if self.folder else 0)
        facts = SegmentFacts(number, self._stream, self._name, began_at)
        make = partial(
            Segment,
            facts,
            self.rows,
            self.rig,
            self.method,
            begin=begin,
            before=self._before,
            first_id=self._first_id,
            behind=self._behind,
            ahead=self._ahead,
            lead=self._lead,
        )
        try:
            segment = make(self.folder)
        except OSError as error:
            if not self._number:
                raise BadInput("commands-not-writable", path=self.folder, strerror=error.strerror) from None
            # The disk is full by now: that ends the keeping, not the stream.
            self._say(Said("stream-lines-not-stored", strerror=error.strerror))
            segment = make(None)
        end_before()
        self._number = number
        self._segment, self._began = segment, self._clock.steady() - since_s
        self._before, self._lead, self._ahead = Before(), 0, ()
        self._keeper.begin(facts, segment.belongs_to)
        return segment

    def _is_over(self, segment: Segment) -> bool:
        if segment.crowded:
            return True
        return segment.lines >= self._segment_s * self.rig.line_rate_hz and segment.quiet

    def _end(self) -> Iterator[LiveVehicle]:
        segment = self._segment
        if segment is None:
            return
        yield from segment.finish()
        self._close(segment, None)

    def _close(self, segment: Segment, stop: int | None) -> None:
        self._keeper.hear(self._health(segment))
        self._segment = None
        notes = self._losses(segment) + faults.notes_of(segment.finder)
        for sentence in [*segment.close(notes, stop), *notes]:
            self._say(sentence)
        self._keeper.end(segment.paths, notes, partial(self._append, segment.facts.number, _ENDED))

    def _tick(self) -> None:
        """Once a second: how the stream is, and whether the clock was set."""
        now = self._clock.steady()
        segment = self._segment
        if now - self._ticked < TICK_S or segment is None:
            return
        self._ticked = now
        self._watch_clock(now, segment)
        segment.note(self._clock.now())
        health = self._health(segment)
        for words in health.words:
            # once each of a kind and a camera, whatever the figures in it
            kind = words.code, words.values.get("camera")
            if kind not in self._said and segment.finder.found >= 3:
                self._said.add(kind)
                self._say(words)
        self._keeper.hear(health)

    def _watch_clock(self, now: float, segment: Segment) -> None:
        apart = self._clock.wall() - now
        jump = apart - self._apart
        if abs(jump) > JUMP_S:
            self._say(Said("stream-clock-set", jump_s=round(jump, 1), lines=segment.lines))
        self._apart = apart

    def _health(self, segment: Segment) -> LiveHealth:
        rate, watchers = self.rig.line_rate_hz, segment.finder.watchers
        light = [None if one.road is None else float(np.mean(one.road.pooled)) for one in watchers]
        saturated = [one.saturated_lines / max(one.lines, 1) for one in watchers]
        waiting = 0 if self.source is None else self.source.waiting_bytes
        words = [*self._losses(segment), *faults.notes_of(segment.finder)]
        return LiveHealth(
            lines=max(segment.lines, 0),
            lost_lines=(segment.cameras[0].lost, segment.cameras[1].lost),
            light_dn=(light[0], light[1]),
            saturated=(saturated[0], saturated[1]),
            clock_offset_s=self._clock.steady() - self._began - segment.lines / rate,
            memory_mib=_memory_mib(),
            waiting_mib=waiting / 2**20,
            words=tuple(words if segment.finder.found else words[: len(self._losses(segment))]),
        )

    @staticmethod
    def _losses(segment: Segment) -> list[Said]:
        return [
            Said("stream-lines-lost", count=camera.lost, camera=number)
            for number, camera in enumerate(segment.cameras, 1)
            if camera.lost
        ]

    def _taken_up(self, left: Told) -> Iterator[LiveVehicle]:
        assert self.folder is not None
        if left.rows != self.rows or rig_from(left.rig) != self.rig:
            raise BadInput("commands-stream-other-rig", path=self.folder, number=f"{left.number:04}")
        self._first_id, self._stream = left.vehicles + 1, left.stream
        paths, facts = spool_paths(self.folder, left.number), _facts_of(left)
        self._keeper.take_up(facts if left.kept else None, left.scan_id, _count(left))
        again, kept = self._go_back and left.source == self._name, all(path.is_file() for path in paths)
        rest = None
        if kept or not again:
            rest = Remainder(paths, facts, self.rig, self.method, left)
            yield from self._numbered(rest.stood())
            yield from self._numbered(rest.complete())
            self._behind = rest.finder.behind
        if not again:
            yield from self._end_whole(left, rest)
            return
        lead, margin = round(LEAD_S * self.rig.line_rate_hz), Finder(self.rows, self.rig).margin
        # the road is learnt from before those who were in view when the program was killed
        learnt_from = max(0, left.begin + int(left.before.settled) - 2 * margin - lead)
        if rest is not None:
            yield from self._numbered(rest.give_up())
            self._behind, left = rest.finder.behind, replace(left, before=rest.before)
        # another begins in the empty road before what is not yet told
        settled, gone = int(left.before.settled), int(left.before.left)
        left_by = gone + 2 * margin if gone > 0 else 0
        cut = min(settled, max(left_by, settled - lead))
        cut = cut if cut > 2 * margin else settled
        start, self._stop = max(0, cut - 2 * margin), max(cut, left_by)
        self._begin, self._before = left.begin + start, left.before.since(start)
        self._ahead = move_ahead(left.ahead if rest is None else rest.ahead, -start)
        self._lead = self._begin - learnt_from
        self._resumed_at = left.began_at + timedelta(seconds=start / self.rig.line_rate_hz)
        self._left, self._rest = left, rest

    def _numbered(self, vehicles: Iterator[LiveVehicle]) -> Iterator[LiveVehicle]:
        for one in vehicles:
            self._first_id = one.vehicle.number + 1
            yield one

    def _end_whole(self, left: Told, rest: Remainder | None) -> Iterator[LiveVehicle]:
        """None of its lines come again: who was in view is told, and the strips are handed on as they are."""
        if rest is not None:
            yield from self._numbered(rest.finish())
        self._say(self._missing(left, 0 if rest is None else rest.lines))
        self._append(left.number, {"closed": []})
        self._hand_on(left)

    def _end_left(self, left: Told) -> None:
        """Lines come again: the killed segment ends in the empty road before who is not yet told, or after
        the last rear of those who are told.
        """
        self._say(Said("stream-resumed", begin=self._begin, name=self._name))
        self._close_left(left, self._stop)
        self._hand_on(left)

    def _close_left(self, left: Told, stop: int | None) -> None:
        """The files of a segment that a killed run left end there."""
        assert self.folder is not None
        paths = spool_paths(self.folder, left.number)
        if all(path.is_file() for path in paths) and not trim_to_common_lines(paths, stop):
            for path in paths:
                path.unlink()
        self._append(left.number, {"closed": []})

    def _hand_on(self, left: Told) -> None:
        """Give the strips of a segment that a killed run left to who keeps them."""
        assert self.folder is not None
        if left.kept and not self._keeper.keeps:
            return
        if left.closed:
            self._keeper.take_up(_facts_of(left) if left.kept else None, left.scan_id, _count(left))
        paths = spool_paths(self.folder, left.number)
        kept = paths if all(path.is_file() for path in paths) else None
        self._keeper.end(kept, list(left.notes), partial(self._append, left.number, _ENDED))

    def _append(self, number: int, said: dict[str, Any]) -> None:
        """Say it in a journal that is closed, where there is one; a full disk ends no stream."""
        try:
            if self.folder is not None and journal_path(self.folder, number).is_file():
                append(self.folder, number, said)
        except OSError as error:
            self._say(Said("stream-journal-not-written", strerror=error.strerror))

    def _missing(self, left: Told, lines: int) -> Said:
        end = left.began_at.timestamp() + lines / self.rig.line_rate_hz
        gap_s = max(0.0, self._clock.wall() - max(end, left.last_at.timestamp()))
        return Said(
            "stream-stopped",
            lines=lines,
            number=f"{left.number:04}",
            last_at=f"{left.last_at:%Y-%m-%d %H:%M:%S}",
            gap_s=round(gap_s, 1),
            gap_lines=round(gap_s * self.rig.line_rate_hz),
        )


def _facts_of(left: Told) -> SegmentFacts:
    return SegmentFacts(left.number, left.stream, left.source, left.began_at)


def _count(left: Told) -> int:
    return left.vehicles + 1 - left.first_id


def _memory_mib() -> float:
    """What this process holds now."""
    try:
        pages = int(Path("/proc/self/statm").read_text().split()[1])
    except (OSError, IndexError, ValueError):
        return 0.0
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20
