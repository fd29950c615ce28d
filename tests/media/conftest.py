"""Shared ground of the media tests: an ingest without ceremony, the folder of real data."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sightline.media.video.frames import FrameServer
from sightline.media.video.ingest import Ingested, ingest
from sightline.media.video.seeker import RecordingMedia
from tests.media.clips import Spec, write

ROOT = Path(__file__).resolve().parents[2]
Ingest = Callable[..., Ingested]
Clip = Callable[..., Path]


@pytest.fixture(scope="session")
def clip(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Path]:
    """Clips by their spec, written once for all tests; not to be changed in place."""
    folder = tmp_path_factory.mktemp("clips")
    made: dict[tuple[Spec, int | None], Path] = {}

    def get(spec: Spec, count: int | None = None) -> Path:
        key = (spec, count)
        if key not in made:
            home = folder / str(len(made))
            home.mkdir()
            made[key] = write(home / spec.name, spec, count)
        return made[key]

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
