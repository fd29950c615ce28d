"""Shared ground of the media tests: an ingest without ceremony, the folder of real data."""

from __future__ import annotations

import hashlib
import os
import pickle
import tempfile
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

from sightline.media.video.frames import FrameServer
from sightline.media.video.ingest import Ingested, ingest
from sightline.media.video.seeker import RecordingMedia
from tests.media.clips import Spec, write
from tests.support.kept import run_folder

ROOT = Path(__file__).resolve().parents[2]
Ingest = Callable[..., Ingested]
Clip = Callable[..., Path]


@pytest.fixture(scope="session")
def clip(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Path]:
    """Clips by their spec, written once a run for all tests; not to be changed in place."""
    shared = run_folder(tmp_path_factory)

    def get(spec: Spec, count: int | None = None) -> Path:
        home = shared / f"clip-{hashlib.sha256(pickle.dumps((spec, count))).hexdigest()}"
        if not home.exists():
            part = Path(tempfile.mkdtemp(dir=shared))
            write(part / spec.name, spec, count)
            with suppress(OSError):  # another worker was first
                part.rename(home)
        return home / spec.name

    return get


@pytest.fixture
def take_in(tmp_path: Path) -> Ingest:
    def run(path: Path, **asked: Any) -> Ingested:
        thumbs, work = tmp_path / "thumbs", tmp_path / "work"
        return ingest(path, lambda _: None, lambda: False, thumbs, work_dir=work, **asked)

    return run


@pytest.fixture
def server(tmp_path: Path) -> FrameServer:
    return FrameServer(tmp_path / "cache", 64_000_000, 64_000_000)


@pytest.fixture(scope="session")
def shared_data() -> Path:
    folder = Path(os.environ.get("SIGHTLINE_SHARED_DATA", ROOT.parent / "shared" / "data"))
    if not folder.is_dir():
        pytest.skip(f"the folder of real data, {folder.name}, is absent")
    return folder


def media_of(result: Ingested) -> RecordingMedia:
    return RecordingMedia(result.media_path, result.frames.pts, result.frames.crc32, result.frames.key)
