"""What a stream writes beside its spooled strips, a JSON line each, so that it can be taken up when killed.

First what was recorded and how, then every vehicle that was told, and every second the line before which all
vehicles are told ("settled"), but for those that stand for too long ("stand"). A journal without its last
line, "ended", is that of a stream that was killed.
"""

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Any

from sightline.linescan.parts import Crossings
from sightline.scans.live.records import LiveVehicle

FORMAT = "sightline-live-1"
_NAME = re.compile(r"(\d{4,})\.jsonl")


@dataclass(frozen=True)
class Told:
    """What is known of a segment from its journal.

    `began_at`: time of line 0; `begin`: number of line 0 in the followed file; `last_at`: when lines last
    came; `settled`: all vehicles before this line are told; `rear_line`: last rear at camera 1 of those
    told; `stand`: of those that stood for too long and are not told, where they came and were given up.
    """

    number: int
    stream: str
    source: str
    rows: int
    rig: dict[str, Any]
    began_at: datetime
    begin: int
    last_at: datetime
    vehicles: int
    settled: int
    rear_line: float
    stand: tuple[Crossings, ...]
    scan_id: int | None
    ended: bool


class Journal:
    """The journal of a segment that is being recorded."""

    def __init__(self, path: Path, head: dict[str, Any]) -> None:
        self._file = path.open("x", encoding="utf-8", buffering=1)
        self.write({"format": FORMAT, **head})

    def write(self, said: dict[str, Any]) -> None:
        self._file.write(json.dumps(said) + "\n")

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


def interrupted(folder: Path) -> Told | None:
    """The last segment of a folder where it was not ended: its program was killed."""
    number = last_number(folder)
    path = journal_path(folder, number)
    told = _read(path, number) if path.is_file() else None
    return told if told is not None and not told.ended else None


def append(folder: Path, number: int, said: dict[str, Any]) -> None:
    """Say in a killed stream's journal what was told of it since, or that it has been answered for."""
    with journal_path(folder, number).open("a", encoding="utf-8") as file:
        file.write("\n" + json.dumps(said) + "\n")


def told_line(one: LiveVehicle) -> dict[str, Any]:
    """What is said of a vehicle that was told."""
    at = one.vehicle.motion.crossings
    lines = {"front_line": float(at.front_line_1), "rear_line": float(at.rear_line_1)}
    return {"vehicles": one.vehicle.number, **lines}


def _read(path: Path, number: int) -> Told | None:
    lines = _lines(path)
    head = next(lines, None)
    if head is None or head.get("format") != FORMAT:
        return None
    known: dict[str, Any] = {"vehicles": head["first_id"] - 1, "settled": 0, "rear_line": -1.0}
    known |= {"scan_id": None, "last_at": head["began_at"], "ended": False}
    stand = dict[float, Crossings]()
    for said in lines:
        if "settled" in said:
            stand.clear()
        # of several that are complete at once, those that follow stand no longer and are not yet told
        stand |= {one[0]: Crossings(*one) for one in said.get("stand", ())}
        stand.pop(said.get("front_line", -1.0), None)
        known |= {"ended": "ended" in said or known["ended"]}
        known |= {name: said[name] for name in ("vehicles", "settled", "scan_id") if name in said}
        known["rear_line"] = max(known["rear_line"], said.get("rear_line", -1.0))
        known["last_at"] = said.get("at", known["last_at"])
    return Told(
        number=number,
        began_at=datetime.fromisoformat(head["began_at"]),
        last_at=datetime.fromisoformat(known.pop("last_at")),
        **{name: head[name] for name in ("stream", "source", "rows", "rig", "begin")},
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
