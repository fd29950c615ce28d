"""What is drawn once and kept: figures and reports, a third of what packages cost in tests, and scenes.

Figures and reports are kept by all that goes into them, so other tables, another unit or another language are
drawn: in every room whose tests make packages, since what builds one and what verifies it draw the same.
`make proofs` draws each time.
"""

import hashlib
import os
import pickle
import sys
from collections.abc import Callable, Iterator
from dataclasses import fields, is_dataclass
from functools import cache, lru_cache
from typing import Any

import numpy as np
import pytest

from tests.simulation import backdrop, board, render, scan_art, scan_strips
from tests.support.kept import run_folder
from tests.support.proofs import PROOFS

# What says of the drawing itself that the same tables give the same bytes draws every time.
_DRAWN_ANEW = ("test_export_language", "test_figures", "test_report")
_SAME_BYTES = ("test_the_same_facts_give_the_same_bytes", "test_the_button_makes_a_package")
# What scenes are drawn of, and the modules that call it.
_SCENERY: tuple[tuple[Any, ...], ...] = (
    (backdrop.empty_road, backdrop),
    (board.board_backdrop, board, render),
    (render.vehicle_kit, render),
    (scan_art._side, scan_art),
    (scan_art._turning, scan_art),
    (scan_art._body, scan_art),
)
_MOST = 400  # what a session keeps; the oldest goes first


class _Kept:
    """A function whose results are kept by the language and what it is given."""

    def __init__(self, make: Callable[..., Any]) -> None:
        self._make = make
        self._made: dict[bytes, bytes] = {}

    def __call__(self, *given: Any, **named: Any) -> Any:
        from sightline.export.report.said import spoken_language

        key = pickle.dumps((spoken_language(), given, named))
        if key not in self._made:
            if len(self._made) == _MOST:
                del self._made[next(iter(self._made))]
            self._made[key] = pickle.dumps(self._make(*given, **named))
        return pickle.loads(self._made[key])


@cache
def _drawing() -> tuple[tuple[Any, str, _Kept], ...]:
    """The functions that draw, where they are called from."""
    from sightline.export import derived
    from sightline.export.report import report
    from sightline.export.report.figures import drawings

    of_tables, pdf = _Kept(drawings), _Kept(report.set_pdf)
    return (derived, "drawings", of_tables), (report, "drawings", of_tables), (report, "set_pdf", pdf)


@pytest.fixture(autouse=True)
def drawn_once(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Packages of equal tables take figures and report from the first of them."""
    if PROOFS or request.path.stem in _DRAWN_ANEW or request.node.name.startswith(_SAME_BYTES):
        return
    if "sightline.export.derived" in sys.modules:  # a room that makes packages has loaded what draws
        for module, name, kept in _drawing():
            monkeypatch.setattr(module, name, kept)


@pytest.fixture(scope="session", autouse=True)
def scenes_drawn_once(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Empty roads, vehicles and strips, by all that goes into them; the workers of a run share them."""
    shared = run_folder(tmp_path_factory)

    def kept(draw: Callable[..., Any]) -> Callable[..., Any]:
        def drawn(*given: Any) -> Any:
            place = shared / f"{draw.__name__}-{hashlib.sha256(pickle.dumps(given)).hexdigest()}"
            if not place.exists():
                part = place.with_suffix(f".{os.getpid()}")
                part.write_bytes(pickle.dumps(draw(*given), pickle.HIGHEST_PROTOCOL))
                part.replace(place)
            return pickle.loads(place.read_bytes())

        return drawn

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(scan_strips, "whole_strips", kept(scan_strips.whole_strips))
        for draw, *places in _SCENERY:
            read = _unchanged(kept(draw.__wrapped__))
            again = lru_cache(maxsize=draw.cache_parameters()["maxsize"])(read)
            for module in places:
                patch.setattr(module, draw.__name__, again)
        yield


def _unchanged(read: Callable[..., Any]) -> Callable[..., Any]:
    """Gives arrays that cannot be written to, for the next test is given the same."""

    def held(*given: Any) -> Any:
        made = read(*given)
        _hold(made)
        return made

    return held


def _hold(made: Any) -> None:
    if isinstance(made, np.ndarray):
        made.flags.writeable = False
    elif isinstance(made, tuple):
        for one in made:
            _hold(one)
    elif is_dataclass(made):
        for field in fields(made):
            _hold(getattr(made, field.name))
