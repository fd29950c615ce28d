"""A stream's vehicles on their way into a survey: a recording that grows, its strips once it has ended."""

import time
from collections.abc import Callable, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import AbstractContextManager, suppress
from dataclasses import dataclass, field
from enum import Enum, auto
from pathlib import Path
from weakref import WeakValueDictionary

from sightline.enums import ScanMethod
from sightline.errors import Away, NoRoom, NotFound, SightlineError
from sightline.infra.database import Session
from sightline.infra.services import Services
from sightline.infra.stored_bytes import let_go
from sightline.linescan.parts import Rig
from sightline.media.store.local import key_of, sha256_of
from sightline.messages.said import Said
from sightline.scans.live.records import Keeper, LiveHealth, LiveVehicle, SegmentFacts
from sightline.scans.live.store import (
    add_live_scan,
    end_live_scan,
    hear_live_scan,
    live_scan_deleted,
    live_scans_of,
    passings_stored,
)
from sightline.scans.records import LiveSource, StripSource
from sightline.scans.service import queue_reading
from sightline.scans.store import create_scan, get_scan, note_reading_failed, note_scan_recorded
from sightline.scans.vehicles.find_job import run_values
from sightline.scans.vehicles.measurement_store import append_scan_measurements
from sightline.scans.vehicles.motion import motion_of, values_of
from sightline.scans.vehicles.run_store import add_scan_run
from sightline.scans.vehicles.store import create_scan_vehicles, list_scan_vehicles

NOT_KEPT = Said("scans-lines-not-stored")
_SUFFIX = ".spool.tif"
AGAIN_S = 1.0


class _Row(Enum):
    """Whether a recording's row is its own; where it is gone, or a person deleted it, no more is stored."""

    UNASKED = auto()
    OWN = auto()
    GONE = auto()
    DELETED = auto()


@dataclass
class _Recording:
    """What is to be stored of one segment; `scan_id`: its row, once it is there; `strips`: as the media store
    names them.
    """

    segment: SegmentFacts
    belongs_to: Callable[[int | None], None] | None = None
    scan_id: int | None = None
    waiting: list[LiveVehicle] = field(default_factory=list)
    row: _Row = _Row.UNASKED
    strips: list[StripSource] = field(default_factory=list)

    @property
    def name(self) -> str:
        return f"Live {self.segment.began_at:%Y-%m-%d %H:%M:%S} UTC"

    @property
    def gone(self) -> bool:
        return self.row in (_Row.GONE, _Row.DELETED)

    def strips_of(self, paths: Sequence[Path]) -> list[StripSource]:
        """Its strips, hashed once."""
        if not self.strips:
            hashes = [(path.name, sha256_of(path)) for path in paths]
            self.strips = [StripSource(name, key_of(sha256, _SUFFIX), sha256) for name, sha256 in hashes]
        return self.strips


class SurveyKeeper(Keeper):
    """Stores vehicles as they come, with the store functions of the search and their audit events.

    A database that cannot be written delays the storing, never the stream: what waits is stored with the next
    second. A commit whose answer is lost may have been one: what is there already is not stored again.
    Strips are moved to the media store beside the stream, in a thread of their own, which tries again until
    what is away or full takes them.
    """

    keeps = True

    def __init__(
        self, services: Services, survey_id: int, rig: Rig, method: ScanMethod, say: Callable[[Said], None]
    ) -> None:
        self._services, self._survey_id, self._rig, self._method = services, survey_id, rig, method
        self._say = say
        self._recording: _Recording | None = None
        self._recording_of: WeakValueDictionary[int, _Recording] = WeakValueDictionary()
        self._troubled = False
        self._mover = ThreadPoolExecutor(1)
        self._moves: list[Future[None]] = []

    def begin(self, segment: SegmentFacts, belongs_to: Callable[[int | None], None]) -> None:
        belongs_to(None)
        recording = self._recording = _Recording(segment, belongs_to)
        self._try(recording, lambda: self._store(recording))

    def take_up(self, segment: SegmentFacts | None, scan_id: int | None) -> None:
        recording = self._recording = None if segment is None else _Recording(segment, scan_id=scan_id)
        if recording is not None and scan_id is not None:
            self._recording_of[scan_id] = recording

    def add(self, vehicle: LiveVehicle) -> None:
        if (recording := self._recording) is not None and not recording.gone:
            recording.waiting.append(vehicle)
            self._try(recording, lambda: self._store(recording))

    def hear(self, health: LiveHealth) -> None:
        if (recording := self._recording) is None or recording.gone:
            return

        def heard() -> None:
            scan_id = self._store(recording)
            with self._writing() as session:
                hear_live_scan(session, scan_id, health)

        self._try(recording, heard)

    def end(self, paths: tuple[Path, Path] | None, notes: list[Said], moved: Callable[[], None]) -> None:
        recording, self._recording = self._recording, None
        if recording is None:
            moved()
            return
        recording.belongs_to = None  # its journal is closed
        self._moves = [one for one in self._moves if not one.done() or one.exception()]
        self._moves.append(self._mover.submit(self._end, recording, paths, notes, moved))

    def close(self) -> None:
        """After all strips are where they belong."""
        self._mover.shutdown(wait=True)
        for move in self._moves:
            move.result()

    def _end(
        self,
        recording: _Recording,
        paths: tuple[Path, Path] | None,
        notes: list[Said],
        moved: Callable[[], None],
    ) -> None:
        warned = False
        while True:
            try:
                if not recording.gone:
                    self._store_end(recording, paths, notes)
                elif recording.row is _Row.DELETED:
                    # strips that were put into the media store before
                    keys = [strip.media_key for strip in recording.strips_of(paths or ())]
                    with self._writing() as session:
                        let_go(session, self._survey_id, keys, None)
                break
            except (Away, NoRoom) as error:
                if not warned:
                    self._say(
                        Said("stream-vehicles-wait", message=error.said, waiting=len(recording.waiting))
                    )
                warned = True
                time.sleep(AGAIN_S)
            except NotFound:
                self._forget(recording)
        if paths and recording.row is _Row.GONE:
            self._say(Said("stream-strips-kept", recording=recording.name, first=paths[0], second=paths[1]))
            return
        for path in paths or ():
            path.unlink()  # the media store has it, or a person deleted it
        moved()

    def _store_end(self, recording: _Recording, paths: tuple[Path, Path] | None, notes: list[Said]) -> None:
        scan_id = self._store(recording)
        with self._services.reading() as session:
            if get_scan(session, scan_id).state != "live":
                return  # stored by one that was killed before it had said so
        for path, one in zip(paths or (), recording.strips_of(paths or ()), strict=True):
            self._services.media.put_file(one.media_key, path, link=True)
        with self._writing() as session:
            if get_scan(session, scan_id).state != "live":
                return  # by the try before this one
            # those too that were stored before a kill
            stored = list_scan_vehicles(session, scan_id, deleted=True)
            motions = [
                motion_of(one.measurement.values)
                for one in stored
                if one.origin == "found" and one.measurement is not None
            ]
            run = run_values(self._method, self._rig, motions, len(motions), notes)
            add_scan_run(session, scan_id, run, actor=None)
            end_live_scan(session, scan_id)
            if paths is None:
                note_reading_failed(session, scan_id, NOT_KEPT, actor=None)
            else:
                note_scan_recorded(session, scan_id, (recording.strips[0], recording.strips[1]), actor=None)
                queue_reading(session, get_scan(session, scan_id), None, None)

    def _store(self, recording: _Recording) -> int:
        """The recording and those of its vehicles that wait; its number."""
        if recording.scan_id is None:
            self._store_begin(recording)
        assert recording.scan_id is not None
        if recording.row is _Row.UNASKED:
            # a journal may tell the number of another database's recording, or of an older state's
            with self._services.reading() as session:
                if live_scan_deleted(session, self._survey_id, recording.scan_id, recording.segment) is None:
                    raise NotFound("stream-recording-not-there", recording=recording.name)
            recording.row = _Row.OWN
        if recording.waiting:
            with self._writing() as session:
                self._store_in(session, recording.scan_id, recording.waiting)
            recording.waiting = []
        return recording.scan_id

    def _store_begin(self, recording: _Recording) -> None:
        with self._writing() as session:
            same = live_scans_of(session, self._survey_id, recording.segment)
            # there already, by a commit that nobody heard of; not another segment's
            own = (one for one in same if self._recording_of.get(one, recording) is recording)
            if (scan_id := next(own, None)) is None:
                scan_id = create_scan(
                    session,
                    self._survey_id,
                    name=recording.name,
                    source=LiveSource(),
                    time_axis="height",
                    rig=self._rig,
                    actor=None,
                ).id
                add_live_scan(session, self._survey_id, scan_id, recording.segment, self._rig.line_rate_hz)
            self._recording_of[scan_id] = recording
        recording.scan_id = scan_id
        if recording.belongs_to is not None:
            recording.belongs_to(scan_id)

    def _store_in(self, session: Session, scan_id: int, vehicles: list[LiveVehicle]) -> None:
        told = [values_of(one.vehicle.motion, self._rig, "found") for one in vehicles]
        stored = passings_stored(session, scan_id, [one.front_line_1 for one in told])
        values = [one for one in told if (one.front_line_1, one.rear_line_1) not in stored]
        if not values:
            return
        made = create_scan_vehicles(session, scan_id, len(values), origin="found", actor=None)
        append_scan_measurements(session, scan_id, list(zip(made, values, strict=True)), actor=None)

    def _writing(self) -> AbstractContextManager[Session]:
        return self._services.writing(self._survey_id)

    def _forget(self, recording: _Recording) -> None:
        """Its row is deleted or not there: nothing more of it is stored. In doubt nobody deleted it."""
        recording.row, recording.waiting = _Row.GONE, []
        if (scan_id := recording.scan_id) is not None:
            with suppress(SightlineError), self._services.reading() as session:
                if live_scan_deleted(session, self._survey_id, scan_id, recording.segment):
                    recording.row = _Row.DELETED
        if recording.row is _Row.DELETED:
            self._say(Said("stream-recording-deleted", recording=recording.name))
        else:
            self._say(Said("stream-recording-not-there", recording=recording.name))

    def _try(self, recording: _Recording, work: Callable[[], object]) -> None:
        """Whatever the database does, the stream goes on: said once, tried again with the next second."""
        try:
            work()
            self._troubled = False
        except NotFound:
            self._forget(recording)
        except SightlineError as error:
            if not self._troubled:
                waiting = len(recording.waiting)
                self._say(Said("stream-vehicles-wait", message=error.said, waiting=waiting))
            self._troubled = True
