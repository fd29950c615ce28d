"""That time ran backwards is written to the log and shown to administrators; nobody is signed out by it."""

import datetime as real
from collections.abc import Iterator
from datetime import timedelta

import pytest

from sightline.infra.audit import trail
from sightline.infra.clock_watch import ClockWatch
from sightline.infra.database import types
from sightline.infra.services import Services
from sightline.infra.web import cookie
from tests.support.app import Client

pytestmark = pytest.mark.dialect


class SetClock(real.datetime):
    by = timedelta(0)

    @classmethod
    def now(cls, tz: real.tzinfo | None = None) -> real.datetime:  # type: ignore[override]
        return real.datetime.now(tz) + cls.by


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Iterator[type[SetClock]]:
    monkeypatch.setattr(types, "datetime", SetClock)
    monkeypatch.setattr(cookie, "datetime", SetClock)
    yield SetClock
    SetClock.by = timedelta(0)


@pytest.mark.parametrize("back_s", [3, 15 * 60])
def test_a_clock_set_back_is_said_and_signs_nobody_out(
    admin: Client,
    operator: Client,
    clock: type[SetClock],
    back_s: int,
    caplog: pytest.LogCaptureFixture,
) -> None:
    assert admin.seen("/system")["clock_set_back"] is None
    clock.by = timedelta(seconds=-back_s)
    assert operator.get("/session").status_code == 200
    found = admin.seen("/system")["clock_set_back"]
    assert found["by_s"] == pytest.approx(back_s, abs=0.5)
    said = [one.getMessage() for one in caplog.records if one.name == "sightline.clock"]
    assert len(said) == 1 and said[0].startswith(f"the clock went back by {found['by_s']:.1f} s")
    # It is set right again, and what was seen stays.
    clock.by = timedelta(0)
    assert admin.seen("/system")["clock_set_back"] == found


@pytest.mark.once
def test_a_clock_that_is_steered_or_goes_ahead_is_not_said(clock: type[SetClock]) -> None:
    watch = ClockWatch()
    for ahead_s in (-0.4, -0.8, 3600.0, 3599.9):
        clock.by = timedelta(seconds=ahead_s)
        watch.look()
    assert watch.set_back is None


def test_a_clock_set_back_while_nothing_ran_is_noticed_at_the_start(
    admin: Client, survey_id: int, services: Services, clock: type[SetClock]
) -> None:
    with services.reading() as session:
        newest = trail.newest_moment(session)
    assert newest is not None
    watch = ClockWatch()
    watch.begin_behind(newest)
    assert watch.set_back is None
    clock.by = newest - types.now() - timedelta(hours=1)  # the ground may have been filled minutes ago
    watch.begin_behind(newest)
    assert watch.set_back is not None and watch.set_back.by_s == pytest.approx(3600, abs=60)
