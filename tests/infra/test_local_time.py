"""Instants by the clocks of a place: gaps, hours that come twice, unknown zones."""

from datetime import UTC, datetime, timedelta

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sightline.errors import BadInput
from sightline.infra.local_time import instant_of, local_text, local_us

PARIS = "Europe/Paris"


def test_a_time_is_that_of_the_clocks_of_the_place() -> None:
    assert instant_of("2026-05-03T08:10:00", PARIS) == datetime(2026, 5, 3, 6, 10, tzinfo=UTC)
    assert instant_of("2026-01-03 08:10", PARIS) == datetime(2026, 1, 3, 7, 10, tzinfo=UTC)
    assert instant_of("2026-05-03T08:10:00", "Asia/Kathmandu") == datetime(2026, 5, 3, 2, 25, tzinfo=UTC)
    assert (
        local_text(datetime(2026, 5, 3, 6, 10, tzinfo=UTC), PARIS, 1.2346) == "2026-05-03T08:10:01.235+02:00"
    )


def test_a_time_that_clocks_skip_is_refused_and_its_neighbours_named() -> None:
    with pytest.raises(BadInput) as refused:
        instant_of("2026-03-29T02:30:00", PARIS)
    assert refused.value.code == "local-time-skipped"
    assert "01:30 before the change, 03:30 after it" in refused.value.message


def test_a_time_that_comes_twice_needs_its_offset() -> None:
    with pytest.raises(BadInput) as refused:
        instant_of("2026-10-25T02:30:00", PARIS)
    assert (refused.value.code, refused.value.values["first"]) == ("local-time-twice", "+02:00")
    first, second = (instant_of(f"2026-10-25T02:30:00{offset}", PARIS) for offset in ("+02:00", "+01:00"))
    assert (second - first).total_seconds() == 3600
    # the shift by half an hour of Lord Howe, where clocks go back from 02:00 to 01:30
    with pytest.raises(BadInput, match="occurs twice"):
        instant_of("2026-04-05T01:45:00", "Australia/Lord_Howe")


@pytest.mark.parametrize(
    ("local", "zone", "code"),
    [
        ("2026-05-03T08:10:00+05:00", PARIS, "local-time-other-offset"),
        ("at ten", PARIS, "local-time-cannot-read"),
        ("", PARIS, "local-time-cannot-read"),
        ("0001-01-01T00:00:00", PARIS, "local-time-cannot-read"),
        ("2026-05-03T08:10:00", "Europe/Nowhere", "local-time-unknown-zone"),
        ("2026-05-03T08:10:00", "", "local-time-unknown-zone"),
        ("2026-05-03T08:10:00", "../etc/passwd", "local-time-unknown-zone"),
        ("2026-05-03T08:10:00", "Europe", "local-time-unknown-zone"),
    ],
)
def test_what_cannot_be_used_is_refused(local: str, zone: str, code: str) -> None:
    with pytest.raises(BadInput) as refused:
        instant_of(local, zone)
    assert refused.value.code == code


@given(
    st.datetimes(datetime(1996, 1, 1), datetime(2030, 1, 1)),
    st.sampled_from((PARIS, "America/St_Johns", "Pacific/Apia", "Australia/Lord_Howe", "UTC")),
)
def test_what_is_shown_is_read_back(moment: datetime, zone: str) -> None:
    at = moment.replace(microsecond=moment.microsecond // 1000 * 1000, tzinfo=UTC)
    text = local_text(at, zone)
    assert datetime.fromisoformat(text) == at
    assert instant_of(text, zone) == at
    shown = datetime.fromisoformat(text).replace(tzinfo=None)
    assert local_us(at, zone) == (shown - datetime(1970, 1, 1)) // timedelta(microseconds=1)
