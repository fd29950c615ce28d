"""What a stream writes beside its spooled strips, a JSON line each, so that it can be taken up when killed.

First what was recorded and how, then every vehicle that was told, and every second the line before which all
vehicles are told ("settled"), but for those that stand for too long ("stand"). A journal without the line
"closed" is that of a stream that was killed; without its last line, "ended", its strips are yet to be moved.
"""

import json
import re
from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import asdict, dataclass, replace
from datetime import datetime
from pathlib import Path
from typing import Any

from sightline.linescan.parts import Crossings, Entry, Motion
from sightline.linescan.passing import Ahead, keep_ahead
from sightline.messages.said import Said
from sightline.scans.live.records import LiveVehicle

FORMAT = "sightline-live-1"
_LAST_BYTES = 100
_NAME = re.compile(r"(\d{4,})\.jsonl")


@dataclass(frozen=True)
class Before:
    """Which vehicles are told: all whose front came before line `settled`, and those that passed camera 1
    from line to line (`passed`, of those that left it later); `left`: by which all had left both cameras.
    """

    settled: float = -1.0
    passed: tuple[tuple[float, float], ...] = ()
    left: float = -1.0

    @classmethod
    def of(cls, settled: float, passed: Iterable[tuple[float, float]], left: float) -> "Before":
        return cls(settled, tuple(one for one in passed if one[1] >= settled), left)

    def has(self, front: float, within: float) -> bool:
        """Whether a front, known to so many lines, is of one of them; what shows until the rear of one that
        came before all others may be its leaving.
        """
        return front < self.settled or any(
            abs(front - one) <= within or (one < self.settled and front < rear) for one, rear in self.passed
        )

    def leaves_later(self, at: Crossings, within: float) -> bool:
        """Whether one of them was not yet known to have left: the next one's gap runs from that rear."""
        near = (abs(at.front_line_1 - front) <= within for front, _ in self.passed)
        return at.rear_line_1 > self.settled and not any(near)

    def since(self, line: float) -> "Before":
        """The same where lines count from that one on."""
        passed = tuple((front - line, rear - line) for front, rear in self.passed)
        return Before(self.settled - line, passed, self.left - line)


@dataclass(frozen=True)
class Told:
    """What is known of a segment from its journal.

    `began_at`: time of line 0; `begin`: number of line 0 in the followed file; `last_at`: when lines last
    came; `first_id`, `vehicles`: numbers of its first and last vehicle; `before`: who is told, `ahead`: those
    of them that the next gap may run from; `stand`: of those that stood for too long and are not told, where
    they came and were given up; `kept`: in a survey, as `scan_id` once that is stored; `stop`: the line at
    which it ends, another having been begun; `closed`: all is told; `notes`: what was said of it then.
    """

    number: int
    stream: str
    source: str
    rows: int
    rig: dict[str, Any]
    began_at: datetime
    begin: int
    last_at: datetime
    first_id: int
    vehicles: int
    before: Before
    ahead: Ahead
    stand: tuple[Crossings, ...]
    kept: bool
    scan_id: int | None
    stop: int | None
    closed: bool
    notes: tuple[Said, ...]


class Journal:
    """The journal of a segment that is being recorded."""

    def __init__(self, path: Path, head: dict[str, Any]) -> None:
        self._path, self._file = path, path.open("x", encoding="utf-8", buffering=1)
        try:
            self.write({"format": FORMAT, **head})
        except OSError:
            with suppress(OSError):
                self._file.close()
            path.unlink()
            raise

    def write(self, said: dict[str, Any]) -> None:
        """Also once it is closed."""
        if not self._file.closed:
            self._file.write(json.dumps(said) + "\n")
            return
        with self._path.open("a", encoding="utf-8") as file:
            file.write(json.dumps(said) + "\n")

    def close(self) -> None:
        self._file.close()


def journal_path(folder: Path, number: int) -> Path:
    return folder / f"{number:04}.jsonl"


def spool_paths(folder: Path, number: int) -> tuple[Path, Path]:
    """The files of camera 1 and camera 2."""
    return folder / f"{number:04}-camera-1.tif", folder / f"{number:04}-camera-2.tif"


def last_number(folder: Path) -> int:
    """The highest number of a segment, 0 where there is none."""
    numbers = [int(path.name.split("-")[0]) for path in folder.glob("[0-9]*-camera-*.tif")]
    numbers += [int(found[1]) for path in folder.glob("*.jsonl") if (found := _NAME.fullmatch(path.name))]
    return max(numbers, default=0)


def interrupted_segment(folder: Path) -> Told | None:
    """The last segment of a folder where it was not closed: its program was killed. One that was not yet
    begun, as its journal shows, is none.
    """
    for number in reversed(_numbers(folder)):
        told = _read_segment(journal_path(folder, number), number)
        if told is not None:
            return None if told.closed else told
    return None


def unmoved_segments(folder: Path, left: Told | None) -> list[Told]:
    """Segments before the interrupted one (`left`) that were not ended: the program was killed before their
    strips were moved, or before it had closed them, another having been begun.
    """
    found = [_unended(folder, number) for number in _numbers(folder)]
    return [told for told in found if told is not None and (left is None or told.number < left.number)]


def _numbers(folder: Path) -> list[int]:
    return sorted(int(found[1]) for path in folder.glob("*.jsonl") if (found := _NAME.fullmatch(path.name)))


def _unended(folder: Path, number: int) -> Told | None:
    path = journal_path(folder, number)
    with path.open("rb") as file:
        file.seek(max(0, path.stat().st_size - _LAST_BYTES))
        if b'"ended"' in file.read():
            return None
    return _read_segment(path, number)


def append(folder: Path, number: int, said: dict[str, Any]) -> None:
    """Say in a killed stream's journal what was told of it since, or that it has been answered for."""
    with journal_path(folder, number).open("a", encoding="utf-8") as file:
        file.write("\n" + json.dumps(said) + "\n")


def told_line(live_vehicle: LiveVehicle) -> dict[str, Any]:
    """What is said of a vehicle that was told."""
    motion = live_vehicle.vehicle.motion
    lines = {"front_line": float(motion.crossings.front_line_1), "left_line": left_by(motion.crossings)}
    lines |= {"rear_line": float(motion.crossings.rear_line_1)}
    return {"vehicles": live_vehicle.vehicle.number, **lines, "motion": motion_document(motion)}


def motion_document(motion: Motion) -> dict[str, Any]:
    """A motion as far as a gap behind it goes."""
    said = asdict(replace(motion, profile=None, warnings=(), reason=None, axle_lines=None))
    return said | {"reason": motion.reason and motion.reason.document}


def _read_motion(said: dict[str, Any]) -> Motion:
    budget = tuple(Entry(**entry) for entry in said["budget"])
    reason = said["reason"] and Said.read(said["reason"])
    parts = {"budget": budget, "reason": reason, "crossings": Crossings(**said["crossings"])}
    return Motion(**{**said, **parts, "warnings": ()})


def left_by(at: Crossings) -> float:
    """The line at which a vehicle had left both cameras."""
    return float(max(at.rear_line_1, at.rear_line_2))


def _read_segment(path: Path, number: int) -> Told | None:
    lines = _lines(path)
    head = next(lines, None)
    if head is None or head.get("format") != FORMAT:
        return None
    known: dict[str, Any] = {"vehicles": head["first_id"] - 1, "scan_id": None, "last_at": head["began_at"]}
    known |= {"kept": False, "stop": None, "closed": False, "notes": ()}
    motions = map(_read_motion, head.get("ahead", ()))
    ahead: Ahead = tuple((motion.crossings, motion) for motion in motions)
    stand, before = dict[float, Crossings](), Before(*head.get("before", ()))
    settled, left = max(0.0, before.settled), before.left
    passed = [(front, rear) for front, rear in before.passed]
    for entry in lines:
        if "settled" in entry:
            stand.clear()
            # less than before where one that was given up is seen to leave
            settled = max(before.settled, entry["settled"])
        # of several that are complete at once, those that follow stand no longer and are not yet told
        stand |= {one[0]: Crossings(*one) for one in entry.get("stand", ())}
        stand.pop(entry.get("front_line", -1.0), None)
        if "front_line" in entry:
            passed.append((entry["front_line"], entry["rear_line"]))
            left = max(left, entry.get("left_line", entry["rear_line"]))
        if "motion" in entry:
            motion = _read_motion(entry["motion"])
            ahead = keep_ahead(ahead, motion.crossings, motion)
        if "closed" in entry:
            known |= {"closed": True, "notes": tuple(map(Said.read, entry["closed"]))}
        known |= {"kept": True} if "scan_id" in entry else {}
        known |= {name: entry[name] for name in ("vehicles", "scan_id", "stop") if name in entry}
        known["last_at"] = entry.get("at", known["last_at"])
    return Told(
        number=number,
        began_at=datetime.fromisoformat(head["began_at"]),
        last_at=datetime.fromisoformat(known.pop("last_at")),
        **{name: head[name] for name in ("stream", "source", "rows", "rig", "begin", "first_id")},
        before=Before.of(settled, passed, left),
        ahead=ahead,
        stand=tuple(stand.values()),
        **known,
    )


def _lines(path: Path) -> Iterator[dict[str, Any]]:
    for line in path.read_text(encoding="utf-8", errors="replace").splitlines():
        try:
            said = json.loads(line)
        except ValueError:
            continue  # the last one, cut off in the middle
        if isinstance(said, dict):
            yield said
