"""Instants by the clocks of a place: its time zone (IANA), hours that clocks skip or show twice."""

from datetime import UTC, date, datetime, timedelta
from functools import cache
from zoneinfo import ZoneInfo

from sightline.errors import BadInput

_CLOCK_0 = datetime(1970, 1, 1)


@cache
def zone_of(name: str) -> ZoneInfo:
    """A time zone by its IANA name, as Europe/Paris. Raises BadInput for one that is not on the list."""
    try:
        if not name or not name[0].isalpha():
            raise ValueError(name)
        return ZoneInfo(name)
    except (ValueError, OSError, KeyError) as error:  # ZoneInfoNotFoundError is a KeyError
        raise BadInput("local-time-unknown-zone", zone=name[:60]) from error


def instant_of(local: str, zone: str) -> datetime:
    """The instant (UTC) at which clocks of a zone show `local`: ISO 8601, its offset where it comes twice.

    Raises BadInput: no time, a time that clocks skip, one that comes twice without saying which, an offset
    that the zone does not have then.
    """
    of, shown = zone_of(zone), _read_local_time(local)
    bare = shown.replace(tzinfo=None)
    first, second = (bare.replace(tzinfo=of, fold=fold) for fold in (0, 1))
    try:
        back = [one.astimezone(UTC).astimezone(of) for one in (first, second)]
    except OverflowError as error:
        raise BadInput("local-time-cannot-read", text=local[:40]) from error
    time = f"{bare:%Y-%m-%d %H:%M}"
    passes = [
        one for one, shows in zip((first, second), back, strict=True) if shows.replace(tzinfo=None) == bare
    ]
    if not passes:
        raise BadInput(
            "local-time-skipped", time=time, zone=zone, before=f"{back[1]:%H:%M}", after=f"{back[0]:%H:%M}"
        )
    offsets = {one.utcoffset(): one for one in passes}
    if shown.tzinfo is not None:
        chosen = offsets.get(shown.utcoffset())
        if chosen is None:
            raise BadInput("local-time-other-offset", time=time, zone=zone, offset=_offset(passes[0]))
        return chosen.astimezone(UTC)
    if len(offsets) > 1:
        raise BadInput("local-time-twice", time=time, zone=zone, first=_offset(first), second=_offset(second))
    return passes[0].astimezone(UTC)


def _read_local_time(local: str) -> datetime:
    try:
        return datetime.fromisoformat(local.strip())
    except ValueError as error:
        raise BadInput("local-time-cannot-read", text=local[:40]) from error


def to_millisecond(at: datetime) -> datetime:
    """The full millisecond that lies nearest."""
    later = at + timedelta(microseconds=500)
    return later - timedelta(microseconds=later.microsecond % 1000)


def local_text(instant: datetime, zone: str, seconds: float = 0.0) -> str:
    """So many seconds after an instant, by the clocks of a zone: ISO 8601 with offset, milliseconds."""
    at = instant + timedelta(milliseconds=round(1000.0 * seconds))
    return at.astimezone(zone_of(zone)).isoformat(timespec="milliseconds")


def local_us(instant: datetime, zone: str, seconds: float = 0.0) -> int:
    """What a zone's clocks show so many seconds after an instant, in microseconds of theirs since 1970."""
    at = instant + timedelta(milliseconds=round(1000.0 * seconds))
    return (at.astimezone(zone_of(zone)).replace(tzinfo=None) - _CLOCK_0) // timedelta(microseconds=1)


def local_date(instant: datetime, zone: str) -> date:
    """The date that clocks of a zone show at an instant."""
    return instant.astimezone(zone_of(zone)).date()


def day_start(day: date, zone: str) -> datetime:
    """The instant (UTC) at which clocks of a zone first show a date: midnight, or what they skip it to."""
    return datetime.combine(day, datetime.min.time(), zone_of(zone)).astimezone(UTC)


def _offset(at: datetime) -> str:
    return at.isoformat()[-6:]
