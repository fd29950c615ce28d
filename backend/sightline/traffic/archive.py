"""The archive's files: a folder that DuckDB, Spark and Trino read as it is.

    ARCHIVE/vehicles/site=NAME/day=2026-05-04/HASH.parquet   one row a vehicle
    ARCHIVE/watched/site=NAME/day=2026-05-04/HASH.parquet    one row a stretch of time that was recorded

HASH names the recording (the beginning of its file's SHA-256), days are the site's own. What was watched is
kept beside the vehicles: without it an hour of no traffic and an hour of no camera would look alike.

A recording comes and goes whole: files are written aside, then the journal names every file that is to come
or go, then they are moved, then the journal goes. A journal that was left behind is brought to its end by
whoever opens the archive next.
"""

from __future__ import annotations

import json
import os
import shutil
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import fields, replace
from datetime import UTC, date, datetime, timedelta
from pathlib import Path
from typing import TYPE_CHECKING, Any
from uuid import uuid4

from sightline.errors import BadInput, Busy
from sightline.infra.file_lock import take_lock
from sightline.infra.local_time import day_start, local_date
from sightline.media.atomic import atomic_file
from sightline.traffic.records import Passing, Recorded, Stood

if TYPE_CHECKING:
    import pyarrow as pa

VEHICLES, WATCHED = "vehicles", "watched"
_JOURNAL, _LOCK, _ASIDE = ".journal.json", ".lock", ".aside-"
_HASH_SIGNS = 16
_WAIT_S = 10.0
_UNSAFE = frozenset('/\\:*?"<>|=%+&#')
_MOST_NAME_SIGNS = 80
#: Segments of one stream overlap by twice the margin around a vehicle's lines, 0.04 s.
SHARED_S = 0.1
#: By so much the front of one that was cut off by the end of a segment may differ from that in the next one.
ROUGH_S = 0.01


def add_recorded(folder: Path, recorded: Recorded, stood: Stood) -> int:
    """Put a recording into the archive, which is made where there is none; how many days it touches.

    Raises BadInput: the recording is there already, its lane was watched then by another, the site keeps
    another time zone, a name that is no folder's, or a lane for vehicles that have lanes of their own.
    """
    _check_name("site", stood.site)
    if recorded.lanes and stood.lane:
        raise BadInput("traffic-own-lanes", name=recorded.name, lanes=", ".join(recorded.lanes))
    day_start(stood.start.date(), stood.zone)  # a zone that is on the list
    folder.mkdir(parents=True, exist_ok=True)
    with _hold_archive(folder):
        _check_fits(folder, recorded, stood)
        aside = folder / f"{_ASIDE}{uuid4().hex}"
        try:
            written = _write_aside(aside, recorded, stood)
            come = {str(path.relative_to(folder)): str(path.relative_to(aside)) for path in written}
            _carry_out(folder, come=come, go=[])
        except OSError as error:
            raise BadInput("traffic-cannot-write", path=folder, strerror=error.strerror) from None
        finally:
            shutil.rmtree(aside, ignore_errors=True)
    return len({path.parent.name for path in written})


def remove_recorded(folder: Path, name: str) -> int:
    """Take a recording out, by its file's name or the beginning of its hash; how many days it touched.

    Raises BadInput where none is called so, or several are.
    """
    require_archive(folder)
    with _hold_archive(folder):
        hashes = {
            one["recording_sha256"]
            for one in watched_rows(folder, None)
            if one["recording"] == name or one["recording_sha256"].startswith(name.lower())
        }
        if len(hashes) != 1:
            if hashes:
                raise BadInput("traffic-several-recordings", path=folder, name=name)
            raise BadInput("traffic-no-such-recording", path=folder, name=name)
        files = [
            str(path.relative_to(folder)) for path in folder.glob(f"*/site=*/day=*/{_file_of(hashes.pop())}")
        ]
        _carry_out(folder, come={}, go=files)
    return len({Path(one).parent.name for one in files})


def require_archive(folder: Path) -> None:
    """Raise BadInput where the folder is no archive; bring to its end what a killed process left halfway."""
    if not (folder / WATCHED).is_dir() and not (folder / _JOURNAL).is_file():
        raise BadInput("traffic-no-archive", path=folder)
    until = time.monotonic() + _WAIT_S
    while (folder / _JOURNAL).is_file():
        held = _lock_of(folder)
        if held is not None:
            with held:
                _recover(folder)
        elif time.monotonic() > until:
            raise Busy("traffic-being-changed", path=folder)
        else:
            time.sleep(0.05)


def sites_of(folder: Path) -> list[str]:
    """Names of the archive's sites, in order."""
    return sorted(path.name.removeprefix("site=") for path in (folder / WATCHED).glob("site=*"))


def files_of(folder: Path, table: str, site: str, first: date | None, last: date | None) -> list[str]:
    """A table's files of one site on its days from `first` to `last`, both included."""
    days = [
        (date.fromisoformat(path.name.removeprefix("day=")), path)
        for path in (folder / table / f"site={site}").glob("day=*")
    ]
    chosen = sorted(
        path for day, path in days if (first is None or first <= day) and (last is None or day <= last)
    )
    return [str(file) for path in chosen for file in sorted(path.glob("*.parquet"))]


def watched_rows(
    folder: Path, site: str | None, first: date | None = None, last: date | None = None
) -> Iterator[dict[str, Any]]:
    """Stretches that were watched, as dictionaries by column, with `day`."""
    import pyarrow.parquet as pq

    for site_name in sites_of(folder) if site is None else [site]:
        for file in files_of(folder, WATCHED, site_name, first, last):
            day = date.fromisoformat(Path(file).parent.name.removeprefix("day="))
            yield from (
                {**row, "day": day, "site": site_name} for row in pq.ParquetFile(file).read().to_pylist()
            )


def _check_name(what: str, name: str) -> None:
    if (
        not name.strip()
        or name != name.strip()
        or name.startswith(".")
        or len(name) > _MOST_NAME_SIGNS
        or not name.isprintable()
        or _UNSAFE & set(name)
    ):
        raise BadInput("traffic-no-name", what=what, name=name, most=_MOST_NAME_SIGNS)


def _check_fits(folder: Path, recorded: Recorded, stood: Stood) -> None:
    for path in (folder / WATCHED).glob(f"site=*/day=*/{_file_of(recorded.sha256)}"):
        raise BadInput(
            "traffic-recording-there",
            name=recorded.name,
            site=path.parent.parent.name.removeprefix("site="),
            day=path.parent.name.removeprefix("day="),
        )
    zones = {row["zone"] for row in _some_rows(folder, stood.site)}
    if zones and zones != {stood.zone}:
        raise BadInput("traffic-other-zone", site=stood.site, zone=stood.zone, there=zones.pop())
    end = stood.start + timedelta(seconds=recorded.duration_s)
    days = (local_date(stood.start, stood.zone), local_date(end, stood.zone))
    for row in watched_rows(folder, stood.site, *days):
        begins = row["midnight_at"] + timedelta(seconds=row["from_s"])
        ends = row["midnight_at"] + timedelta(seconds=row["to_s"])
        shared_s = (min(ends, end) - max(begins, stood.start)).total_seconds()
        inside = (begins <= stood.start and end <= ends) or (stood.start <= begins and ends <= end)
        if row["lane"] in recorded.lanes_at(stood) and shared_s > (0.0 if inside else SHARED_S):
            raise BadInput(
                "traffic-overlap",
                name=recorded.name,
                other=row["recording"],
                site=stood.site,
                start=_utc_text(max(begins, stood.start)),
                end=_utc_text(min(ends, end)),
            )


def _some_rows(folder: Path, site: str) -> list[dict[str, Any]]:
    """Rows of one day of a site: its zone is the same on all."""
    for path in (folder / WATCHED / f"site={site}").glob("day=*"):
        day = date.fromisoformat(path.name.removeprefix("day="))
        return list(watched_rows(folder, site, day, day))
    return []


def _utc_text(instant: datetime) -> str:
    return f"{instant.astimezone(UTC):%Y-%m-%d %H:%M:%S} UTC"


def _file_of(sha256: str) -> str:
    return f"{sha256[:_HASH_SIGNS]}.parquet"


def _write_aside(aside: Path, recorded: Recorded, stood: Stood) -> list[Path]:
    """The recording's files below `aside`, as they will stand in the archive."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    starts = _days_of(stood, recorded.duration_s)
    vehicles: dict[date, list[dict[str, Any]]] = {}
    for passing in recorded.passings:
        passed = stood.start + timedelta(seconds=passing.front_s)
        # who comes at the very end, at midnight, is of the day that was watched
        day = min(local_date(passed, stood.zone), max(starts))
        since = (stood.start - starts[day]).total_seconds() + passing.front_s
        own = {field.name: getattr(passing, field.name) for field in fields(Passing)}
        row = {
            **own,
            "lane": recorded.lane_of(passing, stood),
            "recording": recorded.name,
            "recording_sha256": recorded.sha256,
        }
        row |= {"passed_at": passed, "since_midnight_s": since, "occupied_s": passing.occupied_s}
        vehicles.setdefault(day, []).append(row)
    watched = {
        day: [_watched(recorded, replace(stood, lane=lane), day, start) for lane in recorded.lanes_at(stood)]
        for day, start in starts.items()
    }
    written = []
    for table, schema, rows in (
        (VEHICLES, _vehicle_schema(), vehicles),
        (WATCHED, _watched_schema(), watched),
    ):
        for day, of_day in sorted(rows.items()):
            path = aside / table / f"site={stood.site}" / f"day={day}" / _file_of(recorded.sha256)
            with atomic_file(path) as part:
                pq.write_table(pa.Table.from_pylist(of_day, schema), part, compression="zstd")
            written.append(path)
    return written


def _days_of(stood: Stood, duration_s: float) -> dict[date, datetime]:
    """The site's days that the recording touches, and when each begins (UTC). One that ends at midnight does
    not touch the day that begins then.
    """
    last_at = stood.start + timedelta(seconds=duration_s) - timedelta.resolution
    day, last = (local_date(at, stood.zone) for at in (stood.start, max(stood.start, last_at)))
    found = {}
    while day <= last:
        found[day] = day_start(day, stood.zone)
        day += timedelta(days=1)
    return found


def _watched(recorded: Recorded, stood: Stood, day: date, midnight: datetime) -> dict[str, Any]:
    day_s = (day_start(day + timedelta(days=1), stood.zone) - midnight).total_seconds()
    begins = (stood.start - midnight).total_seconds()
    return {
        "lane": stood.lane,
        "zone": stood.zone,
        "recording": recorded.name,
        "recording_sha256": recorded.sha256,
        "start_at": stood.start,
        "u_start_s": stood.u_start_s,
        "u_line_rate_ratio": recorded.u_line_rate_ratio,
        "midnight_at": midnight,
        "day_s": day_s,
        "from_s": max(0.0, begins),
        "to_s": min(day_s, begins + recorded.duration_s),
    }


def _vehicle_schema() -> pa.Schema:
    import pyarrow as pa

    words, counts = ("status", "reason", "direction"), ("number", "axles")
    kinds = {**dict.fromkeys(words, pa.string()), **dict.fromkeys(counts, pa.int32())}
    kinds["told_before"] = pa.bool_()
    own = [(one.name, kinds.get(one.name, pa.float64())) for one in fields(Passing) if one.name != "lane"]
    return pa.schema(
        [
            ("passed_at", pa.timestamp("us", "UTC")),
            ("since_midnight_s", pa.float64()),
            ("lane", pa.string()),
            ("occupied_s", pa.float64()),
            *own,
            ("recording", pa.string()),
            ("recording_sha256", pa.string()),
        ]
    )


def _watched_schema() -> pa.Schema:
    import pyarrow as pa

    instants = "start_at", "midnight_at"
    numbers = "u_start_s", "u_line_rate_ratio", "day_s", "from_s", "to_s"
    return pa.schema(
        [(name, pa.string()) for name in ("lane", "zone", "recording", "recording_sha256")]
        + [(name, pa.timestamp("us", "UTC")) for name in instants]
        + [(name, pa.float64()) for name in numbers]
    )


@contextmanager
def _hold_archive(folder: Path) -> Iterator[None]:
    """The archive for one who changes it, after what a killed one left was brought to its end."""
    held = _lock_of(folder)
    if held is None:
        raise Busy("traffic-being-changed", path=folder)
    with held:
        _recover(folder)
        for left in folder.glob(f"{_ASIDE}*"):
            shutil.rmtree(left, ignore_errors=True)
        yield


def _lock_of(folder: Path) -> Any:
    try:
        return take_lock(folder / _LOCK)
    except OSError as error:
        raise BadInput("traffic-cannot-write", path=folder, strerror=error.strerror) from None


def _carry_out(folder: Path, *, come: dict[str, str], go: list[str]) -> None:
    """Move files to their places and remove others, all or, where this is cut off, all of it later."""
    with atomic_file(folder / _JOURNAL) as part:
        part.write_text(json.dumps({"come": come, "go": go}), encoding="utf-8")
    _recover(folder)


def _recover(folder: Path) -> None:
    """Do what the journal says is still to be done, if there is one."""
    journal = folder / _JOURNAL
    if not journal.is_file():
        return
    document = json.loads(journal.read_text(encoding="utf-8"))
    for here, there in document["come"].items():
        if (folder / here).is_file():
            (folder / there).parent.mkdir(parents=True, exist_ok=True)
            os.replace(folder / here, folder / there)
    for name in document["go"]:
        (folder / name).unlink(missing_ok=True)
        for empty in ((folder / name).parent, (folder / name).parent.parent):
            if empty.is_dir() and not any(empty.iterdir()):
                empty.rmdir()
    journal.unlink()
