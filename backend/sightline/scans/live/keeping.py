"""A stream's vehicles on their way into a survey: a recording that grows, its strips once it has ended."""

import time
from collections.abc import Callable, Collection, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass, field
from enum import Enum, auto
from pathlib import Path
from threading import Lock
from typing import Protocol

from sightline.enums import ScanMethod
from sightline.errors import Away, Busy, NoRoom, NotAllowed, NotFound, NotSignedIn, SightlineError, TooMany
from sightline.infra.services import Services
from sightline.infra.stored_bytes import let_go
from sightline.linescan.parts import Motion, Rig
from sightline.media.store.local import key_of, sha256_of
from sightline.messages.said import Said
from sightline.scans.live.recording import add_to_recording, begin_recording, end_recording
from sightline.scans.live.records import Keeper, LiveHealth, LiveSegment, LiveVehicle, SegmentFacts
from sightline.scans.live.store import is_live, live_segments
from sightline.scans.records import StripSource
from sightline.scans.vehicles.motion import values_of

_SUFFIX = ".spool.tif"
AGAIN_S = 1.0
#: So long after the end of the stream strips wait for what is away; then for the next stream.
PATIENCE_S = 120.0
#: Two of the longest profiles are no larger than a request may be.
_AT_ONCE = 2
_LATER = (Away, Busy, NoRoom, TooMany)
_REFUSED = (NotAllowed, NotSignedIn)


@dataclass(frozen=True)
class SpooledStrip:
    """A strip of an ended segment, hashed."""

    path: Path
    sha256: str


class Sink(Protocol):
    """Where a survey is written to: each call may be repeated, and stores nothing twice (`recording`)."""

    def segments(self, segment: SegmentFacts) -> Sequence[LiveSegment]:
        """The recordings of its stream and moment."""

    def begin(self, segment: SegmentFacts, others: Collection[int]) -> int:
        """The number of its recording; `others`: those of other segments."""

    def add(self, scan_id: int, motions: Sequence[Motion], health: LiveHealth | None) -> None:
        """Vehicles, and how the stream is."""

    def end(self, scan_id: int, strips: Sequence[SpooledStrip], notes: Sequence[Said], told: int) -> None:
        """The stream adds no more; both strips, or none."""

    def let_go(self, strips: Sequence[SpooledStrip]) -> None:
        """Strips that may have been stored are those of a deleted recording."""


class DatabaseSink:
    """The database and the media store of this machine."""

    def __init__(self, services: Services, survey_id: int, rig: Rig, method: ScanMethod) -> None:
        self._services, self._survey_id, self._rig, self._method = services, survey_id, rig, method

    def segments(self, segment: SegmentFacts) -> Sequence[LiveSegment]:
        with self._services.reading() as session:
            return live_segments(session, self._survey_id, segment.stream, segment.began_at)

    def begin(self, segment: SegmentFacts, others: Collection[int]) -> int:
        with self._services.writing(self._survey_id) as session:
            return begin_recording(session, self._survey_id, segment, self._rig, others, actor=None)

    def add(self, scan_id: int, motions: Sequence[Motion], health: LiveHealth | None) -> None:
        vehicles = [values_of(one, self._rig, "found") for one in motions]
        with self._services.writing(self._survey_id) as session:
            add_to_recording(session, scan_id, vehicles, health, actor=None)

    def end(self, scan_id: int, strips: Sequence[SpooledStrip], notes: Sequence[Said], told: int) -> None:
        with self._services.reading() as session:
            if not is_live(session, scan_id):
                return  # stored by one that was killed before it had said so
        sources = [StripSource(one.path.name, self._key(one), one.sha256) for one in strips]
        for strip, source in zip(strips, sources, strict=True):
            self._services.media.put_file(source.media_key, strip.path, link=True)
        pair = (sources[0], sources[1]) if sources else None
        with self._services.writing(self._survey_id) as session:
            end_recording(session, scan_id, pair, self._rig, self._method, notes, told, actor=None)

    def let_go(self, strips: Sequence[SpooledStrip]) -> None:
        with self._services.writing(self._survey_id) as session:
            let_go(session, self._survey_id, map(self._key, strips), None)

    @staticmethod
    def _key(strip: SpooledStrip) -> str:
        return key_of(strip.sha256, _SUFFIX)


class _Row(Enum):
    """Whether a recording's row is its own; where it is gone, or a person deleted it, no more is stored."""

    UNASKED = auto()
    OWN = auto()
    GONE = auto()
    DELETED = auto()


@dataclass(eq=False)
class _Recording:
    """What is stored of one segment; `scan_id`: its row, once it is there; `told`: its vehicles so far."""

    segment: SegmentFacts
    belongs_to: Callable[[int | None], None] | None = None
    scan_id: int | None = None
    told: int = 0
    waiting: list[LiveVehicle] = field(default_factory=list)
    health: LiveHealth | None = None
    row: _Row = _Row.UNASKED
    strips: list[SpooledStrip] = field(default_factory=list)

    @property
    def gone(self) -> bool:
        return self.row in (_Row.GONE, _Row.DELETED)

    def note_number(self) -> None:
        """Have its journal say to which row it belongs, once that is known."""
        if self.scan_id is not None and self.belongs_to is not None:
            self.belongs_to(self.scan_id)
            self.belongs_to = None

    def strips_of(self, paths: Sequence[Path]) -> list[SpooledStrip]:
        """Its strips, hashed once."""
        self.strips = self.strips or [SpooledStrip(path, sha256_of(path)) for path in paths]
        return self.strips


class SurveyKeeper(Keeper):
    """Stores vehicles as they come, beside the stream.

    A survey that cannot be written delays the storing, never the stream: what waits is stored with the next
    second. Strips are stored in a thread of their own, which tries again until what is away or full takes
    them; PATIENCE_S after the end of the stream they are left to the next one. Where who writes is refused,
    nothing is asked again.
    """

    keeps = True

    def __init__(self, sink: Sink, say: Callable[[Said], None]) -> None:
        self._sink, self._say = sink, say
        self._recording: _Recording | None = None
        self._recording_of = dict[int, _Recording]()
        self._troubled = self._refused = self._left = False
        self._until: float | None = None
        self._one_at_a_time = Lock()
        self._storer, self._mover = ThreadPoolExecutor(1), ThreadPoolExecutor(1)
        self.storing: Future[None] | None = None
        self._moves: list[Future[None]] = []

    def begin(self, segment: SegmentFacts, belongs_to: Callable[[int | None], None]) -> None:
        belongs_to(None)
        self._recording = _Recording(segment, belongs_to)
        self._store_beside(self._recording)

    def take_up(self, segment: SegmentFacts | None, scan_id: int | None, told: int) -> None:
        self._recording = None if segment is None else _Recording(segment, scan_id=scan_id, told=told)
        if self._recording is not None and scan_id is not None:
            self._recording_of[scan_id] = self._recording

    def add(self, vehicle: LiveVehicle) -> None:
        if (recording := self._recording) is not None:
            recording.told += 1
            if not (recording.gone or self._refused):
                recording.waiting.append(vehicle)
                self._store_beside(recording)

    def hear(self, health: LiveHealth) -> None:
        if (recording := self._recording) is not None and not recording.gone:
            recording.health = health
            self._store_beside(recording)

    def end(self, paths: tuple[Path, Path] | None, notes: list[Said], moved: Callable[[], None]) -> None:
        recording, self._recording = self._recording, None
        if recording is None:
            moved()
            return
        recording.note_number()
        self._moves = [one for one in self._moves if not one.done() or one.exception()]
        self._moves.append(self._mover.submit(self._end, recording, paths or (), notes, moved))

    def close(self) -> None:
        """After all strips are where they belong, or are left to the next stream."""
        self._until = time.monotonic() + PATIENCE_S
        self._mover.shutdown(wait=True)
        self._storer.shutdown(wait=True)
        for move in self._moves:
            move.result()

    def _end(
        self, recording: _Recording, paths: Sequence[Path], notes: list[Said], moved: Callable[[], None]
    ) -> None:
        stored = self._try_end(recording, paths, notes)
        if not stored or (paths and recording.row is _Row.GONE):
            if paths:
                name, (first, second) = recording.segment.name, paths
                self._say(Said("stream-strips-kept", recording=name, first=first, second=second))
            return
        for path in paths:
            path.unlink()  # the media store has it, or a person deleted it
        moved()

    def _try_end(self, recording: _Recording, paths: Sequence[Path], notes: list[Said]) -> bool:
        """Whether its end is stored, or there is nothing to store it in."""
        warned = False
        while not (self._refused or self._left):
            try:
                self._store(recording)
                recording.note_number()
                if recording.row is _Row.OWN:
                    assert recording.scan_id is not None
                    strips = recording.strips_of(paths)
                    self._sink.end(recording.scan_id, strips, notes, recording.told)
                elif recording.row is _Row.DELETED:
                    self._sink.let_go(recording.strips_of(paths))
                return True
            except NotFound:
                self._forget(recording)
            except _REFUSED as error:
                self._refuse(error)
            except _LATER as error:
                if not warned:
                    self._say_waiting(recording, error)
                warned = True
                if self._until is not None and time.monotonic() >= self._until:
                    self._left = True
                    return False
                time.sleep(AGAIN_S)
            except SightlineError as error:
                self._say_waiting(recording, error)
                return False
        return False

    def _store_beside(self, recording: _Recording) -> None:
        """Store what waits, unless that is being done: then it goes with the next second."""
        recording.note_number()
        if self._refused or not (self.storing is None or self.storing.done()):
            return
        if self.storing is not None:
            self.storing.result()
        self.storing = self._storer.submit(self._try_store, recording)

    def _try_store(self, recording: _Recording) -> None:
        """Whatever the survey does, the stream goes on: said once, tried again with the next second."""
        try:
            self._store(recording)
            self._troubled = False
        except NotFound:
            self._forget(recording)
        except _REFUSED as error:
            self._refuse(error)
        except SightlineError as error:
            if not self._troubled:
                self._say_waiting(recording, error)
            self._troubled = True

    def _store(self, recording: _Recording) -> None:
        """The recording, unless it is gone, and what waits of it."""
        with self._one_at_a_time:
            if recording.gone:
                return
            if recording.scan_id is None:
                segment, known = recording.segment, list(self._recording_of.items())
                others = [one for one, its in known if its.segment.began_at == segment.began_at]
                recording.scan_id = self._sink.begin(segment, others)
                self._recording_of[recording.scan_id] = recording
            if recording.row is _Row.UNASKED:
                # a journal may tell the number of another database's recording, or of an older state's
                if self._deleted(recording) is None:
                    raise NotFound("stream-recording-not-there", recording=recording.segment.name)
                recording.row = _Row.OWN
            while recording.waiting or recording.health:
                some, health = recording.waiting[:_AT_ONCE], recording.health
                self._sink.add(recording.scan_id, [one.vehicle.motion for one in some], health)
                del recording.waiting[: len(some)]
                recording.health = None if recording.health is health else recording.health

    def _deleted(self, recording: _Recording) -> bool | None:
        """Whether its row was deleted; None: there is no such row, or it is not its own."""
        there = {one.scan_id: one.deleted for one in self._sink.segments(recording.segment)}
        return there.get(recording.scan_id or 0)

    def _forget(self, recording: _Recording) -> None:
        """Its row is deleted or not there: nothing more of it is stored. In doubt nobody deleted it."""
        with self._one_at_a_time:
            if recording.gone:
                return
            deleted = None
            with suppress(SightlineError):
                deleted = self._deleted(recording)
            recording.row, recording.waiting = _Row.DELETED if deleted else _Row.GONE, []
        name = recording.segment.name
        if deleted:
            self._say(Said("stream-recording-deleted", recording=name))
        else:
            self._say(Said("stream-recording-not-there", recording=name))

    def _refuse(self, error: SightlineError) -> None:
        if not self._refused:
            self._say(Said("stream-refused", message=error.said))
        self._refused = True

    def _say_waiting(self, recording: _Recording, error: SightlineError) -> None:
        self._say(Said("stream-vehicles-wait", message=error.said, waiting=len(recording.waiting)))
