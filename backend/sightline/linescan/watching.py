"""Watches one strip: from blocks of lines to events, the spans in which something hid the road."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from sightline.linescan.background import (
    Grid,
    Road,
    blend_roads,
    first_road,
    road_from,
    same_but_for_light,
    same_but_moved,
)
from sightline.linescan.middle import median
from sightline.linescan.parts import Pixels

LEAST_PART = 0.04
LIGHT = 0.1
# so many that were given up are looked for behind what is seen
MOST_GIVEN_UP = 4
# a step shows what stands still where so many of its cells are as they are on the mean
STILL_PART = 0.9


@dataclass(frozen=True)
class Spans:
    """Lengths in lines: a hole that is bridged, the shortest vehicle, standing still; `stands`: after which
    nobody waits for what stands; `road`: those that show the empty road.
    """

    close: int
    least: int
    guard: int
    still: int
    stuck: int
    stands: int
    longest: int
    road: int


@dataclass(frozen=True, eq=False)
class Event:
    """Lines `front` to `rear` (of whole steps) in which something stood before the road; `leaving`: while
    what had stood there left, and may be a part of that.
    """

    front: float
    rear: float
    road: Road
    still: bool = False
    cut: bool = False
    leaving: bool = False


@dataclass(eq=False)
class _Open:
    front: int
    last: int
    road: Road
    still: bool = False
    given_up: int = 0
    told: bool = False
    elsewhere: bool = False

    def event(self, rear: int, cut: bool) -> Event:
        """Between the lines of road and of vehicle; none comes before line 0."""
        return Event(max(self.front - 0.5, 0.0), rear - 0.5, self.road, self.still, cut)


def find_occupied_steps(cells: NDArray[np.float32], road: Road, upper_part: float) -> NDArray[np.bool_]:
    """(steps,) whether enough cells, `cells` (steps, bands), of the upper part differ from the road under the
    light of the moment.

    Own method (Douxchamps et al., section IV, compare lines with a background): the light is the middle
    cell's, within LIGHT, for clouds and lamps change it from line to line.
    """
    upper = max(1, int(cells.shape[1] * upper_part))
    line = np.maximum(road.pooled[:upper], 1.0)
    # every other cell will do for the middle one
    light = median(cells[:, :upper:2] / line[::2]).astype(np.float32)
    expected = np.clip(light, 1 - LIGHT, 1 + LIGHT) * line
    differs = np.abs(cells[:, :upper] - expected) > road.threshold_dn[:upper]
    return np.asarray(differs.sum(1) >= max(2, LEAST_PART * upper))


@dataclass(eq=False)
class Watcher:
    """One camera's state between blocks; `see` takes blocks in order and returns the events that ended, in
    the order of their fronts.

    What stands in view becomes the background, before which others pass; its event goes on until the road is
    seen again, and theirs wait for it. What stands for too long, or until another stands before it, is given
    up: theirs wait no longer, and its own comes after them, when it has left. `rests_again`: how often that
    was, for the other may be the same that moved on a little.
    """

    grid: Grid
    spans: Spans
    road: Road | None = None
    blips: int = 0
    jumps: int = 0
    moves: int = 0
    rests_again: int = 0
    lines: int = 0
    saturated_lines: float = 0.0
    bits: int = 8
    _open: _Open | None = None
    _standing: _Open | None = None
    _waiting: list[Event] = field(default_factory=list)
    _still: int = 0
    _mean: NDArray[np.float32] | None = None
    _before: NDArray[np.float32] | None = None
    _given_up: list[_Open] = field(default_factory=list)
    _passed: bool = False

    @property
    def busy_since(self) -> float:
        """No event that is still to be returned begins before this line, but for what was given up."""
        return self._standing.front if self._standing else self.needed_since

    @property
    def needed_since(self) -> float:
        """First line that is still needed for an event under way; of what stands, none is."""
        under_way = [one.front for one in self._waiting] + ([self._open.front] if self._open else [])
        return min(under_way, default=self.lines)

    def begin(self, block: Pixels) -> None:
        """Finds the road in the recording's first part, `block` (lines, rows)."""
        self.road = first_road(block, self.grid, self.spans.road)

    def see(self, block: Pixels) -> list[Event]:
        """Takes the next block (lines, rows)."""
        if self.road is None:
            self.begin(block)
        assert self.road is not None
        cells = self.grid.pooled(block)
        events = self._look_behind(cells)
        there = find_occupied_steps(cells, self.road, self.grid.upper_part)
        events += self._follow(there)
        events += self._watch_stillness(cells, there, block)
        self._before = cells
        if self._open and self.lines + len(block) - self._open.front > self.spans.longest:
            if not self._open.told:
                events.append(self._open.event(self._open.last, cut=True))
            # its rest is no vehicle of its own
            end = self.lines + len(block)
            self._open = _Open(end, end, self._open.road, told=True)
        self._refresh(block, there)
        self.saturated_lines += len(block) * float(np.mean(block[::32] >= (1 << self.bits) - 1))
        self.lines += len(block)
        return self._in_order(events)

    def finish(self) -> list[Event]:
        """Ends what is still open when the recording ends."""
        if self._standing is not None:
            self._stands_no_longer()
            assert self._open is not None
            self._open.last = self.lines
        self._waiting += self._end(self._open.last, cut=True) if self._open else []
        left = self.given_up
        self.tell([one.front for one in left])
        return self._released(len(self._waiting)) + left

    @property
    def given_up(self) -> list[Event]:
        """What was given up and nobody saw leave, as it was then."""
        return [one.event(one.given_up, cut=True) for one in self._given_up if not one.told]

    def tell(self, fronts: Sequence[float]) -> None:
        """Those with these fronts were told, and are not told any more when they leave."""
        for one in self._given_up:
            one.told |= one.event(one.given_up, cut=True).front in fronts

    @property
    def behind(self) -> list[Road]:
        """The roads behind those that were told and have not left."""
        return [one.road for one in self._given_up if one.told]

    def leave_untold(self, behind: Sequence[Road]) -> None:
        """What stands before these roads when the lines begin was told before. It is told again only as one
        that was in view then, where others pass before it leaves: gaps behind theirs run from its rear.
        """
        self._given_up = [_Open(0, 0, road, still=True, told=True, elsewhere=True) for road in behind]

    @property
    def stood_throughout(self) -> list[Event]:
        """What was told before the lines began and has not left: in view from the first to the last."""
        return [one.event(self.lines, cut=True) for one in self._given_up if one.elsewhere and self.lines]

    def one_stands_before(self, line: float) -> bool:
        """Whether one has stood since before a line that was given up and is still to be told."""
        return any(not one.told and one.front < line for one in self._given_up)

    def given_up_beside(self, event: Event) -> Event | None:
        """What was given up while the other camera saw this `event`, and did not leave as that did."""
        for candidate in self._given_up:
            if not candidate.told and candidate.front < event.rear and event.front < candidate.given_up:
                candidate.told = True
                return candidate.event(candidate.given_up, cut=True)
        return None

    def _in_order(self, events: list[Event]) -> list[Event]:
        """What is returned now. What stands is given up after a time, or where the lines of those that wait
        for it can no longer be kept.
        """
        self._waiting += events
        for_others = bool(self._waiting) and self.lines - self._waiting[0].front > self.spans.longest
        if self._standing is not None:
            if not for_others and self.lines - self._standing.front <= self.spans.stands:
                return []
            self._give_up()
        late: list[Event] = []
        if len(self._given_up) > MOST_GIVEN_UP:
            was = self._given_up.pop(0)
            late = [] if was.told else [was.event(was.given_up, cut=True)]
        return late + self._released(
            len(self._waiting) if for_others or not self._given_up else self._stood_still_after()
        )

    def _give_up(self) -> None:
        """Nobody waits any longer for what stands, if anything does."""
        if self._standing is not None:
            self._standing.given_up = self.lines
            self._given_up.append(self._standing)
            self._standing = None

    def _released(self, count: int) -> list[Event]:
        """The first of those that wait."""
        out, self._waiting = self._waiting[:count], self._waiting[count:]
        return sorted(out, key=lambda one: one.front)

    def _stood_still_after(self) -> int:
        """How many of those that wait cannot be the leaving of what was given up: it stood still after."""
        since: float = self._open.front if self._open else self.lines
        for at, event in reversed(list(enumerate(self._waiting))):
            if since - event.rear >= self.spans.still:
                return at + 1
            since = event.front
        return 0

    def _look_behind(self, cells: NDArray[np.float32]) -> list[Event]:
        """Whether the road is seen again behind what stands or was given up; what was taken for something
        before it was its leaving. Returns those that came to stand before it later, and have left with it.
        """
        for stood in (*([self._standing] if self._standing else []), *reversed(self._given_up)):
            step = self.grid.step
            absent = ~find_occupied_steps(cells, stood.road, self.grid.upper_part)
            edges = np.flatnonzero(np.diff(np.concatenate([[0], absent.astype(np.int8), [0]]))).reshape(-1, 2)
            if not (edges @ [-step, step] > self.spans.close).any():
                continue
            last = cells[:0] if self._before is None else self._before
            before = np.flatnonzero(find_occupied_steps(last, stood.road, self.grid.upper_part))
            seen = len(last) - (int(before[-1]) + 1 if len(before) else 0)
            gone = self._has_left(stood)
            stood.last = self.lines - step * seen
            # it has left since it last stood still
            self._leaves_until(stood.last)
            return [one.event(stood.last, cut=False) for one in gone if not one.told]
        return []

    def _leaves_until(self, line: float) -> None:
        """Who waits and was seen from when something last stood still to this line may be a part of it."""
        for at, event in reversed(list(enumerate(self._waiting))):
            if line - event.rear >= self.spans.still:
                break
            line = event.front
            self._waiting[at] = replace(event, leaving=True)

    @property
    def _several_stand(self) -> bool:
        return len(self._given_up) + (self._standing is not None) > 1

    def _stands_no_longer(self) -> None:
        """What stood is the event under way again, before its own road."""
        assert self._standing is not None
        self._has_left(self._standing)

    def _has_left(self, stood: _Open) -> list[_Open]:
        """The same of one that stands or was given up; those that came to stand before it later, which have
        left too.
        """
        gone: list[_Open] = []
        if stood is not self._standing:
            at = next(at for at, one in enumerate(self._given_up) if one is stood)
            gone = [*self._given_up[at + 1 :], *([self._standing] if self._standing else [])]
            self._given_up = self._given_up[:at]
        self.road, self._open, self._standing = stood.road, stood, None
        self._still, self._mean = 0, None
        return gone

    def _follow(self, there: NDArray[np.bool_]) -> list[Event]:
        """Runs of presence become events; holes shorter than `close` are bridged."""
        events: list[Event] = []
        step, base = self.grid.step, self.lines
        edges = np.flatnonzero(np.diff(np.concatenate([[0], there.astype(np.int8), [0]])))
        for start, stop in edges.reshape(-1, 2):
            front, rear = base + int(start) * step, base + int(stop) * step
            if self._open and front - self._open.last > self.spans.close:
                events += self._end(self._open.last)
            if self._open is None:
                assert self.road is not None
                self._open = _Open(front, rear, self.road)
            self._open.last = rear
        if self._open and base + len(there) * step - self._open.last > self.spans.close:
            events += self._end(self._open.last)
        return events

    def _end(self, rear: int, cut: bool = False) -> list[Event]:
        was, self._open = self._open, None
        assert was is not None
        if was.told and not (was.elsewhere and self._passed):
            return []
        if rear - was.front < self.spans.least:
            self.blips += 1
            return []
        self._passed = True
        return [was.event(rear, cut)]

    def _watch_stillness(
        self, cells: NDArray[np.float32], there: NDArray[np.bool_], block: Pixels
    ) -> list[Event]:
        """An event whose picture does not change: a vehicle that stopped, or a road under another light."""
        assert self.road is not None
        if not there.any():
            self._still, self._mean = 0, None
            return []
        mean = np.asarray(cells.mean(0), np.float32)
        loose = 2.0 * self.road.cell_dn + 0.02 * mean
        calm = float(np.mean(cells.std(0) < loose)) > 0.97
        alike = self._mean is None or float(np.mean(np.abs(mean - self._mean) < loose)) > 0.97
        self._still = self._still + len(block) if calm and alike else 0
        self._mean = mean if calm else None
        if not self._still:
            return []
        if self._open is None or not there.all():
            self._rest(block)
            return []
        if self._standing is not None and same_but_for_light(mean, self._standing.road, self.grid):
            self._stands_no_longer()
            return self._road_again(cells, mean, block, lit=True)
        for stood in reversed(self._given_up):
            if same_but_for_light(mean, stood.road, self.grid):
                gone = self._has_left(stood)
                rest, events = self._come_to_rest(cells, mean, block)
                return [*(one.event(rest, cut=False) for one in gone if not one.told), *events]
        lit = same_but_for_light(mean, self.road, self.grid)
        if lit or same_but_moved(block.mean(0, dtype=np.float32), self.road, self.grid):
            return self._road_again(cells, mean, block, lit)
        self._open.still |= self._still >= self.spans.still
        if self._still < self.spans.stuck:
            return []
        self.rests_again += self._standing is not None or bool(self._given_up)
        self._give_up()
        self._standing = self._open
        self._take(block)
        return []

    def _rest(self, block: Pixels) -> None:
        """The picture has rested, and yet parts of it are taken for something before the road, by their
        noise: what is behind who stands, seen since that left.
        """
        since = self.lines + len(block) - self._still
        if self._still >= self.spans.still and (self._open is None or self._open.front >= since):
            self._waiting = [event for event in self._waiting if event.front < since]
            if self._several_stand:
                self._leaves_until(since)
            self._take(block)

    def _road_again(
        self, cells: NDArray[np.float32], mean: NDArray[np.float32], block: Pixels, lit: bool
    ) -> list[Event]:
        """The road is seen under another light, or from a camera that moved: what passed before, if anything
        did, ended where the picture came to rest.
        """
        self.jumps += lit
        self.moves += not lit
        rest, events = self._come_to_rest(cells, mean, block)
        if not self._several_stand:
            return events
        # one of them may have left
        self._leaves_until(events[0].front if events else rest)
        return [replace(event, leaving=True) for event in events]

    def _come_to_rest(
        self, cells: NDArray[np.float32], mean: NDArray[np.float32], block: Pixels
    ) -> tuple[int, list[Event]]:
        """The line since which the picture rests, and the event under way, which ends there."""
        assert self._open is not None and self.road is not None
        near = np.concatenate([part for part in (self._before, cells) if part is not None])
        loose = 4 * self.road.cell_dn + 0.03 * mean
        moving = np.flatnonzero((np.abs(near - mean) < loose).mean(1) < STILL_PART)
        steps = len(near) - (int(moving[-1]) + 1 if len(moving) else 0)
        rest = max(self.lines + len(cells) * self.grid.step - steps * self.grid.step, self._open.front)
        # a jump of the light is no vehicle, nor is what it ends
        events = self._end(rest) if rest - self._open.front >= self.spans.least else []
        self._take(block)
        return rest, events

    def _take(self, block: Pixels) -> None:
        """What is seen now is the background from here on."""
        self.road = road_from(block, self.grid)
        self._open, self._still, self._mean = None, 0, None

    def _refresh(self, block: Pixels, there: NDArray[np.bool_]) -> None:
        """Moves the road towards what the longest empty run of this block shows, shadows left out."""
        assert self.road is not None
        step, guard = self.grid.step, self.spans.guard
        edges = np.flatnonzero(np.diff(np.concatenate([[0], (~there).astype(np.int8), [0]])))
        best = (0, 0)
        for start, stop in edges.reshape(-1, 2):
            first = int(start) * step + (guard if start > 0 else 0)
            last = int(stop) * step - (guard if stop < len(there) else 0)
            best = max(best, (first, last), key=lambda run: run[1] - run[0])
        count = best[1] - best[0]
        enough = self.spans.road
        if count >= enough // 4:
            seen = road_from(block[best[1] - min(count, 2 * enough) : best[1]], self.grid)
            self.road = blend_roads(self.road, seen, min(1.0, count / enough))
