"""Finds vehicles in a pair of strips that come in pieces: watches both, pairs what is alike, cuts it out.

Memory is bounded: lines are kept only as long as an event under way or waiting for its partner needs them.
"""

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import cast

import numpy as np

from sightline.errors import BadInput
from sightline.linescan.background import MOST_UNREST, Grid, Road, enough_lines
from sightline.linescan.boundaries import refine_crossings
from sightline.linescan.depth import brightest_of, depth_of, in_8_bits
from sightline.linescan.lanes import lane_of
from sightline.linescan.parts import (
    CUT,
    STANDS_S,
    STOOD,
    STOPPED,
    TOO_LONG,
    Crossings,
    Passage,
    Pixels,
    Rig,
)
from sightline.linescan.rig import at_lane, baseline_of
from sightline.linescan.watching import Event, Spans, Watcher, find_occupied_steps
from sightline.messages.said import Said

BANDS = 64
STEPS_HZ = 1220.0
BLOCK_S = 0.2
BEGIN_S = 1.0
TILE = 1024
KEPT_BYTES = 48 << 20
# what a vehicle may be: from a motorcycle to a road train, from walking pace to 300 km/h
LENGTHS_M = (1.0, 32.0)
SPEEDS_MPS = (1.0, 85.0)

Behind = tuple[Sequence[Road], Sequence[Road]]

NO_ROAD = Said("scan-motion-no-road")
TWO_AT_ONCE = Said("scan-motion-two-at-once")


@dataclass(eq=False)
class LineBuffer:
    """The last lines of one strip."""

    blocks: deque[tuple[int, Pixels]]
    stop: int = 0

    def add(self, block: Pixels) -> None:
        """Keep the next lines, `block` (n, rows)."""
        self.blocks.append((self.stop, block))
        self.stop += len(block)

    def forget(self, before: int) -> None:
        while self.blocks and self.blocks[0][0] + len(self.blocks[0][1]) <= before:
            self.blocks.popleft()

    def cut(self, start: int, stop: int) -> tuple[Pixels, int]:
        """Lines start to stop, as far as they are kept, (n, rows), and the first line's number."""
        parts = [
            (begin + max(start - begin, 0), block[max(start - begin, 0) : max(stop - begin, 0)])
            for begin, block in self.blocks
            if begin < stop and begin + len(block) > start
        ]
        if not parts:
            return self.blocks[-1][1][-1:], self.stop - 1
        return cast(Pixels, np.concatenate([part for _, part in parts])), parts[0][0]


def _add(waiting: deque[Event], events: list[Event]) -> None:
    """Events that wait for their partners, in the order of their fronts: what was given up comes late."""
    in_order = sorted((*waiting, *events), key=lambda one: one.front)
    waiting.clear()
    waiting.extend(in_order)


class Finder:
    """Vehicles of a pair of strips, pushed in pieces of any size; `notes` tells what else was seen.

    rows: height of both strips; rig: baseline and line rate tell how far apart the crossings may be; bits: of
    the cameras, as the whole strips tell, or else the brightest pixel so far; behind: the roads behind what
    stands and was told before, of both cameras. `baseline_m`: at the vehicles, in the middle of the rig's
    lanes.
    """

    def __init__(self, rows: int, rig: Rig, bits: int = 8, behind: Behind = ((), ())) -> None:
        if rows < 8:
            raise BadInput("linescan-strips-too-low", rows=rows)
        rate = rig.line_rate_hz
        step = max(1, round(rate / STEPS_HZ))
        self.rig, self.rows = rig, rows
        self.baseline_m, _ = baseline_of(at_lane(rig, None))
        self.grid = Grid(rows, step, max(1, rows // BANDS), 1.0 - rig.shadow_share)
        lines = max(16 * step, round(BLOCK_S * rate))
        # whole tiles of the stored form where that comes near
        self.block = (
            round(lines / TILE) * TILE if lines > 0.9 * TILE and TILE % step == 0 else lines // step * step
        )
        self.spans = Spans(
            close=max(step, round(0.004 * rate)),
            least=max(2 * step, round(0.012 * rate)),
            guard=round(0.05 * rate),
            still=round(1.0 * rate),
            stuck=round(3.0 * rate),
            stands=round(STANDS_S * rate),
            longest=KEPT_BYTES // rows,
            road=enough_lines(rate),
        )
        self.margin = max(2 * step, round(0.02 * rate))
        self.watchers = (Watcher(self.grid, self.spans), Watcher(self.grid, self.spans))
        for watcher, roads in zip(self.watchers, behind, strict=True):
            watcher.leave_untold(roads)
        self.bits = bits
        self.found = 0
        self.reversed = 0
        self.alone = 0
        self._buffers = (LineBuffer(deque()), LineBuffer(deque()))
        self._waiting: tuple[deque[Event], deque[Event]] = (deque(), deque())
        self._held: tuple[list[Pixels], list[Pixels]] = ([], [])

    def push(self, first: Pixels, second: Pixels) -> list[Passage]:
        """Takes the next lines of both strips, `first` and `second` (n, rows); returns the vehicles that are
        now complete. Raises BadInput for strips that differ in shape.
        """
        if first.shape != second.shape or first.ndim != 2 or first.shape[1] != self.rows:
            raise BadInput(
                "linescan-strips-differ",
                shape=first.shape,
                shape_2=second.shape,
                rows=self.rows,
            )
        for held, piece in zip(self._held, (first, second), strict=True):
            held.append(piece)
            self.bits = max(self.bits, depth_of(brightest_of(piece)))
        for watcher in self.watchers:
            watcher.bits = self.bits
        return self._work(False)

    @property
    def settled_line(self) -> int:
        """Every vehicle whose rear came before this line has been returned, or counted as left out."""
        fronts = [event.front for waiting in self._waiting for event in waiting]
        open_since = [watcher.busy_since for watcher in self.watchers]
        return max(0, int(min([*fronts, *open_since])))

    @property
    def returned_line(self) -> int:
        """No front of a vehicle that is yet to be returned lies before it: that is looked for in its picture,
        which begins a margin before the first line that shows it.
        """
        return self.settled_line - self.margin

    def give_up(self) -> list[Passage]:
        """What was given up and still stands, where the lines go on in another finder."""
        pairs, alone = self._pairs_given_up()
        self.alone += alone
        for watcher, told in zip(self.watchers, zip(*pairs, strict=True), strict=False):
            watcher.tell([event.front for event in told])
        return [self._passage(*pair) for pair in pairs]

    def stood_throughout(self) -> list[Passage]:
        """What was told before these lines began and still stands, as in view from the first to the last."""
        ones, twos = (watcher.stood_throughout for watcher in self.watchers)
        return [self._passage(*pair) for pair in zip(ones, twos, strict=False)]

    @property
    def behind(self) -> Behind:
        """Of both cameras, the roads behind those that were told and have not left: another finder's."""
        return self.watchers[0].behind, self.watchers[1].behind

    @property
    def given_up(self) -> list[Crossings]:
        """Of those that `give_up` would return now: the fronts, and where nobody waited any longer."""
        return [Crossings(one.front, one.rear, two.front, two.rear) for one, two in self._pairs_given_up()[0]]

    def _pairs_given_up(self) -> tuple[list[tuple[Event, Event]], int]:
        """What both cameras gave up, and how many one camera alone did."""
        ones, twos = (watcher.given_up for watcher in self.watchers)
        pairs = []
        for event in ones:
            partner = next((two for two in twos if self._direction(event, two) is not None), None)
            if partner is not None:
                twos.remove(partner)
                pairs.append((event, partner))
        return pairs, len(ones) - len(pairs) + len(twos)

    def finish(self) -> list[Passage]:
        """The recording ends here: returns what is left."""
        out = self._work(True)
        for watcher, waiting in zip(self.watchers, self._waiting, strict=True):
            _add(waiting, watcher.finish())
        out += self._paired(True)
        self.alone += sum(len(waiting) for waiting in self._waiting)
        return out

    def _work(self, last: bool) -> list[Passage]:
        held = sum(len(piece) for piece in self._held[0])
        begun = self.watchers[0].road is not None
        if not last and held < (self.block if begun else self._begin_lines):
            return []
        if not held:
            return []
        pieces = [cast(Pixels, held[0] if len(held) == 1 else np.concatenate(held)) for held in self._held]
        if not begun:
            # of 16 bits, half as many lines are kept
            self.spans = replace(self.spans, longest=KEPT_BYTES // (self.rows * pieces[0].itemsize))
            for watcher, piece in zip(self.watchers, pieces, strict=True):
                watcher.spans = self.spans
                watcher.begin(piece[: self._begin_lines])
        out: list[Passage] = []
        whole = held if last else held // self.block * self.block
        for start in range(0, whole, self.block):
            for k in (0, 1):
                block = pieces[k][start : min(start + self.block, whole)]
                if len(block) < len(pieces[k]) or pieces[k].base is not None:
                    # a slice would keep the whole piece alive
                    block = block.copy()
                self._buffers[k].add(block)
                _add(self._waiting[k], self.watchers[k].see(block))
            out += self._paired(False)
            self._forget()
        for k in (0, 1):
            self._held[k][:] = [pieces[k][whole:].copy()] if whole < held else []
        return out

    @property
    def _begin_lines(self) -> int:
        return self.block * max(1, round(BEGIN_S / BLOCK_S))

    def _forget(self) -> None:
        for reel, watcher, waiting in zip(self._buffers, self.watchers, self._waiting, strict=True):
            needed = min([watcher.needed_since, *(event.front for event in waiting)])
            reel.forget(max(int(needed) - 2 * self.margin, reel.stop - self.spans.longest * 5 // 4))

    def _paired(self, last: bool) -> list[Passage]:
        """Takes pairs off both queues; an event that its partner's camera can no longer see stays alone."""
        out: list[Passage] = []
        queue_1, queue_2 = self._waiting
        while queue_1 and queue_2:
            way = self._direction(queue_1[0], queue_2[0])
            if way is None:
                if self._part_first_events(last, out):
                    continue
                break
            if not last and min(reel.stop for reel in self._buffers) < self._needed_to(
                queue_1[0], queue_2[0]
            ):
                break
            out.append(self._passage(queue_1.popleft(), queue_2.popleft()))
            self.reversed += way < 0 and out[-1].reason is None
        self._drop_late(out)
        return out

    def _part_first_events(self, last: bool, out: list[Passage]) -> bool:
        """Of first events that are not of one vehicle, the one that ends first stays alone. Where one passed
        while another stood before one camera alone, camera 1's first event goes on with its own partner, so
        that vehicles stay in the order of their fronts there; False until that has come.
        """
        queue_1, queue_2 = self._waiting
        stood, passed = (
            (queue_1[0], queue_2[0]) if queue_1[0].front < queue_2[0].front else (queue_2[0], queue_1[0])
        )
        if not (stood.still or stood.cut) or stood.rear <= passed.rear:
            self._leave_alone(0 if queue_1[0].rear < queue_2[0].rear else 1, out)
            return True
        partner = next((event for event in queue_2 if self._direction(queue_1[0], event) is not None), None)
        if partner is not None:
            queue_2.remove(partner)
            queue_2.appendleft(partner)
            return True
        kept = self._buffers[0].stop - passed.front <= self.spans.longest
        if not last and kept and self._may_come(1, queue_1[0]):
            return False
        self._leave_alone(0, out)
        return True

    def _drop_late(self, out: list[Passage]) -> None:
        for k in (0, 1):
            while self._waiting[k] and not self._waiting[1 - k]:
                if self._may_come(1 - k, self._waiting[k][0]):
                    break
                self._leave_alone(k, out)

    def _may_come(self, camera: int, partner: Event) -> bool:
        """Whether camera 1 (0) or 2 (1) can still see what the other saw."""
        slowest = self.baseline_m / SPEEDS_MPS[0] * self.rig.line_rate_hz
        return self.watchers[camera].busy_since < partner.rear + slowest + self.margin

    def _leave_alone(self, camera: int, out: list[Passage]) -> None:
        """What the other camera gave up and did not see leave, if that is its partner, leaves with it."""
        event = self._waiting[camera].popleft()
        partner = self.watchers[1 - camera].given_up_beside(event) if event.still else None
        if partner is not None:
            out.append(self._passage(*((partner, event) if camera else (event, partner))))
        else:
            self.alone += not event.leaving

    def _needed_to(self, one: Event, two: Event) -> float:
        return max(one.rear, two.rear) + 2 * self.margin

    def _direction(self, event_1: Event, event_2: Event) -> int | None:
        """1: camera 1 came first; -1: camera 2 did; None: not the same vehicle."""
        delay = event_2.front - event_1.front
        if event_1.still or event_2.still or event_1.cut or event_2.cut:
            overlap = min(event_1.rear, event_2.rear) - max(event_1.front, event_2.front)
            return 1 if overlap > -self.spans.guard and not self._overtaken(event_1, event_2) else None
        shift = self._shift(event_1, event_2)
        lines = self.baseline_m * self.rig.line_rate_hz
        # a step of uncertainty in the delay matters where it is only a few steps long
        most_mps = lines / max(shift - 2 * self.grid.step, 0.5)
        least_mps = lines / (shift + 2 * self.grid.step)
        duration = (event_1.rear - event_1.front + event_2.rear - event_2.front) / 2 / self.rig.line_rate_hz
        if most_mps < SPEEDS_MPS[0] or least_mps > SPEEDS_MPS[1] or most_mps * duration < LENGTHS_M[0]:
            return None
        apart = min(event_1.rear, event_2.rear) <= max(event_1.front, event_2.front)
        leaving = event_1.leaving or event_2.leaving
        if not self._have_equal_duration(event_1, event_2) and (
            apart or leaving or least_mps * duration > LENGTHS_M[1]
        ):
            return None
        if apart and least_mps * duration > LENGTHS_M[1]:
            return None
        return 1 if delay + event_2.rear - event_1.rear > 0 else -1

    def _overtaken(self, event_1: Event, event_2: Event) -> bool:
        """Whether one camera's event lies within the other's, so that front and rear tell opposite ways: what
        stood before one camera, and another that passed. An event that was cut ends no earlier than that.
        """
        fronts, rears = event_2.front - event_1.front, event_2.rear - event_1.rear
        rears = min(rears, 0.0) if event_1.cut else rears
        rears = max(rears, 0.0) if event_2.cut else rears
        return fronts * rears < 0 and min(abs(fronts), abs(rears)) > self.spans.guard

    def _shift(self, one: Event, two: Event) -> float:
        """Lines from camera to camera, the mean of front and rear, whichever way."""
        return abs(two.front - one.front + two.rear - one.rear) / 2

    def _have_equal_duration(self, one: Event, two: Event) -> bool:
        """Whether both cameras saw something for the same length of time."""
        first, second = one.rear - one.front, two.rear - two.front
        return abs(first - second) - 6 * self.grid.step <= 0.12 * max(first, second)

    def _long(self, event_1: Event, event_2: Event) -> Said | None:
        """That it is longer than any vehicle, whatever its ends' rough lines may be off by. Where front and
        rear tell opposite ways, they tell no length: too few lines lie between the cameras for its direction.
        """
        lines = (event_1.rear - event_1.front + event_2.rear - event_2.front) / 2
        shift = self._shift(event_1, event_2)
        if lines * self.baseline_m / (shift + 2 * self.grid.step) <= LENGTHS_M[1]:
            return None
        if (event_2.front - event_1.front) * (event_2.rear - event_1.rear) < 0:
            return too_few_lines(shift)
        length_m = lines * self.baseline_m / shift
        return Said("scan-motion-too-long", length_m=round(length_m), most_m=LENGTHS_M[1])

    def _reason(self, event_1: Event, event_2: Event) -> Said | None:
        if max(event_1.road.unrest, event_2.road.unrest) > MOST_UNREST:
            return NO_ROAD
        stop = min(reel.stop for reel in self._buffers)
        given_up = any(event.cut and stop - event.rear >= 2 * self.margin for event in (event_1, event_2))
        if event_1.still or event_2.still:
            return STOOD if given_up else STOPPED
        if event_1.cut or event_2.cut:
            return TOO_LONG if given_up else CUT
        shift = self._shift(event_1, event_2)
        if shift <= 2 * self.grid.step:
            return too_few_lines(shift)
        if min(event_1.front, event_2.front) < self.margin:
            return CUT
        return self._long(event_1, event_2) if self._have_equal_duration(event_1, event_2) else TWO_AT_ONCE

    def _passage(self, event_1: Event, event_2: Event) -> Passage:
        reason = self._reason(event_1, event_2)
        self.found += 1
        cuts = []
        for event, reel in zip((event_1, event_2), self._buffers, strict=True):
            stop = int(event.rear) + self.margin + 1
            if reason in (STOPPED, STOOD, TOO_LONG):
                stop = min(stop, int(event.front) + self.spans.longest // 4)
            cuts.append(reel.cut(int(event.front) - self.margin, stop))
        (first, start_1), (second, start_2) = cuts
        # where one camera alone saw it leave, it was before the other until then
        rear_1 = max(event_1.rear, event_2.rear) if event_1.cut else event_1.rear
        rear_2 = max(event_1.rear, event_2.rear) if event_2.cut else event_2.rear
        passage = Passage(
            crossings=Crossings(event_1.front, rear_1, event_2.front, rear_2),
            first=first,
            second=second,
            start_1=start_1,
            start_2=start_2,
            background_1=event_1.road.line,
            background_2=event_2.road.line,
            noise_dn=max(event_1.road.noise_dn, event_2.road.noise_dn),
            reason=reason,
            beside=self.watchers[0].one_stands_before(event_1.front),
            leaving=event_1.leaving and event_2.leaving,
        )
        if reason:
            return passage
        passage = in_8_bits(passage, self.bits)
        if not self.rig.lanes:
            return _bounded(passage, self.rig)
        lane = lane_of(passage, self.rig).lane
        name = None if lane is None else lane.name
        rig = at_lane(self.rig, name, passage.crossings.direction)
        if rig.shadow_share > self.rig.shadow_share:
            ends = [
                self._ends_above_shadow(*one, 1 - rig.shadow_share)
                for one in zip((event_1, event_2), cuts, strict=True)
            ]
            passage = replace(passage, crossings=Crossings(*ends[0], *ends[1]))
        return _bounded(passage, rig)

    def _ends_above_shadow(
        self, event: Event, cut: tuple[Pixels, int], upper_part: float
    ) -> tuple[float, float]:
        """Front and rear, roughly, by the rows above a lane's own shadow zone alone."""
        picture, start = cut
        step = self.grid.step
        there = np.flatnonzero(find_occupied_steps(self.grid.pooled(picture), event.road, upper_part))
        lines = start + there * step
        lines = lines[(lines > event.front - step) & (lines < event.rear)]
        if not len(lines):
            return event.front, event.rear
        return max(float(lines[0]) - 0.5, event.front), min(float(lines[-1]) + step - 0.5, event.rear)


def too_few_lines(lines: float) -> Said:
    """Why a vehicle with so many lines from camera to camera is not measured."""
    return Said("scan-motion-few-lines", lines=round(lines))


def _bounded(passage: Passage, rig: Rig) -> Passage:
    """The passage with its boundaries to a fraction of a line."""
    crossings, u_ends_m = refine_crossings(passage, rig)
    return replace(passage, crossings=crossings, u_ends_m=u_ends_m)
