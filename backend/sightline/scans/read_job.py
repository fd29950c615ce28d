"""Reading a line-scan recording, as a job: both strips become their stored form, all of it or nothing."""

import tempfile
from collections.abc import Mapping
from contextlib import ExitStack
from pathlib import Path
from typing import Any

from sightline.errors import Away, NotFound
from sightline.infra.database import Session
from sightline.infra.jobs import registry
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.registry import Finish, JobContext
from sightline.infra.services import Services
from sightline.infra.stored_bytes import let_go
from sightline.media.store.local import key_of
from sightline.media.strips.reader import Strip, check_pair, open_strip
from sightline.media.strips.stored_writer import SUFFIX, StoredStrip, store_strip
from sightline.media.strips.video import cut_strips
from sightline.messages.said import Said
from sightline.recordings.frames.stills import stills_of
from sightline.scans.records import Scan, StripFacts
from sightline.scans.service import FIND, READ
from sightline.scans.store import get_scan, note_reading_failed, note_scan_read

STOPPED = Said("scans-import-cancelled")
MOST_SATURATED = 0.02
_READING = Said("job-strips-reading")


def mark_failed(session: Session, job: Job, error: Said) -> None:
    """With the job's end: the scan is not ready, and why."""
    if job.scan_id is None:
        return
    try:
        reason = STOPPED if error == registry.STOPPED else error
        note_reading_failed(session, job.scan_id, reason, actor=job.created_by)
    except NotFound:
        return  # deleted meanwhile


@registry.handler(READ, failed=mark_failed)
def read_scan(context: JobContext) -> Finish:
    """Write the stored form of both strips. May be killed at any moment: nothing counts before the end."""
    services = context.services
    scan_id = context.job.scan_id
    assert scan_id is not None
    with services.reading() as session:
        scan = get_scan(session, scan_id)
    with tempfile.TemporaryDirectory(prefix="scan-", dir=services.scratch) as folder:
        facts = _store_strips(context, services, scan, Path(folder))

    def finish(session: Session) -> Mapping[str, Any]:
        # Nobody deletes a file while the lock is held, and everybody waits for it.
        keys = (facts.first_key, facts.second_key)
        if not all(services.media.exists(key) for key in keys):
            raise Away("scans-strips-taken-along")
        note_scan_read(session, scan_id, facts, actor=context.actor)
        # the stored form has every pixel of what it was read from
        let_go(session, scan.survey_id, (scan.first_source_key, scan.second_source_key), context.actor)
        method = context.payload.get("find")
        if method:
            payload = {"method": method, "search": True}
            registry.enqueue(
                session, FIND, payload, survey_id=scan.survey_id, scan_id=scan_id, actor=context.actor
            )
        return {"scan_id": scan_id, "lines": facts.lines, "rows_px": facts.rows_px}

    return finish


def _store_strips(context: JobContext, services: Services, scan: Scan, folder: Path) -> StripFacts:
    context.progress(0.0, _READING)
    with ExitStack() as opened:
        cutting = 0.5 if scan.source == "video" else 0.0
        pair = _open_strips(context, services, scan, folder, cutting)
        for strip in pair:
            opened.callback(strip.close)
        check_pair(*pair)
        share = (1.0 - cutting) / 2
        first, second = (
            _store(context, strip, folder / f"{camera}{SUFFIX}", cutting + camera * share, share)
            for camera, strip in enumerate(pair)
        )
        notes = [*_notes(scan, pair), *_saturation((first, second))]
    keys = []
    for one in (first, second):
        keys.append(key_of(one.sha256, SUFFIX))
        services.media.put_file(keys[-1], one.path, link=True)
    return StripFacts(
        first_key=keys[0],
        second_key=keys[1],
        first_sha256=first.sha256,
        second_sha256=second.sha256,
        rows_px=first.rows,
        lines=first.lines,
        bits=max(first.bits, second.bits),
        notes=notes,
    )


def _open_strips(
    context: JobContext, services: Services, scan: Scan, folder: Path, share: float
) -> tuple[Strip, Strip]:
    if scan.source == "video":
        assert scan.recording_id is not None and scan.cut_1_px is not None and scan.cut_2_px is not None
        video = stills_of(services).open(scan.recording_id)
        return cut_strips(
            video.media.path,
            (scan.cut_1_px, scan.cut_2_px),
            video.time_s,
            along=scan.cut_along or "columns",
            work_dir=folder,
            name=video.recording.name,
            on_progress=lambda fraction: context.progress(share * fraction, Said("job-strips-cutting")),
            is_cancelled=context.is_cancelled,
            stream_number=video.media.stream_number,
        )
    keys = (scan.first_source_key, scan.second_source_key)
    names = (scan.first_name, scan.second_name)
    strips = []
    try:
        for key, name in zip(keys, names, strict=True):
            assert key is not None and name is not None
            path = services.media.local_path(key)
            strips.append(open_strip(path, scan.time_axis, name=name, work_dir=folder))
    except BaseException:
        for strip in strips:
            strip.close()
        raise
    return strips[0], strips[1]


def _store(context: JobContext, strip: Strip, target: Path, begin: float, share: float) -> StoredStrip:
    return store_strip(
        strip,
        target,
        lambda fraction: context.progress(min(0.99, begin + share * fraction), _READING),
        context.is_cancelled,
    )


def _notes(scan: Scan, pair: tuple[Strip, Strip]) -> list[Said]:
    """What the recorder said: lost lines, another line rate than the one that was given."""
    notes = []
    for strip in pair:
        lost = sum(gap.count for gap in strip.notes.dropped)
        if lost:
            notes.append(Said("scan-recorder-lost", name=strip.name, count=lost))
        stated_hz = strip.notes.line_rate_hz
        if stated_hz is not None and abs(stated_hz / scan.rig.line_rate_hz - 1) > 1e-3:
            line_rate_hz = float(f"{scan.rig.line_rate_hz:g}")
            notes.append(
                Said(
                    "scan-recorder-other-rate",
                    name=strip.name,
                    told_hz=float(f"{stated_hz:g}"),
                    line_rate_hz=line_rate_hz,
                )
            )
    return notes


def _saturation(stored: tuple[StoredStrip, StoredStrip]) -> list[Said]:
    return [
        Said("scan-pixels-saturated", percent=round(100 * one.saturated), camera=camera)
        for camera, one in enumerate(stored, 1)
        if one.saturated > MOST_SATURATED
    ]
