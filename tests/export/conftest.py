"""Figures and reports made once for equal tables: drawing them is a third of what packages cost in tests.

They are kept by all that goes into them, so other tables, another unit or another language are drawn.
"""

import pickle
from collections.abc import Callable
from typing import Any

import pytest

from sightline.export import derived
from sightline.export.report import report
from sightline.export.report.figures import drawings
from sightline.export.report.said import spoken

# What says of the drawing itself that the same tables give the same bytes draws every time.
_DRAWN_ANEW = ("test_export_package", "test_export_language", "test_figures", "test_report")
_SAME_BYTES = "test_the_same_facts_give_the_same_bytes"
_MOST = 400  # what a session keeps; the oldest goes first


class _Kept:
    """A function whose results are kept by the language and what it is given."""

    def __init__(self, make: Callable[..., Any]) -> None:
        self._make = make
        self._made: dict[bytes, bytes] = {}

    def __call__(self, *given: Any, **named: Any) -> Any:
        key = pickle.dumps((spoken(), given, named))
        if key not in self._made:
            if len(self._made) == _MOST:
                del self._made[next(iter(self._made))]
            self._made[key] = pickle.dumps(self._make(*given, **named))
        return pickle.loads(self._made[key])


_drawings = _Kept(drawings)
_set_pdf = _Kept(report.set_pdf)


@pytest.fixture(autouse=True)
def drawn_once(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Packages of equal tables take figures and report from the first of them."""
    if request.path.stem in _DRAWN_ANEW or request.node.name.startswith(_SAME_BYTES):
        return
    monkeypatch.setattr(derived, "drawings", _drawings)
    monkeypatch.setattr(report, "drawings", _drawings)
    monkeypatch.setattr(report, "set_pdf", _set_pdf)
