"""Which vehicle a reference is of, by the time that its line gives: one alone within a tolerance, or none."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta

from sightline.errors import BadInput
from sightline.infra.local_time import instant_of, local_date
from sightline.recordings.filming import Filming

USUAL_TOLERANCE_S, MOST_TOLERANCE_S = 1.0, 60.0
_TIME = re.compile(r"^\d{1,2}:\d{2}:\d{2}(?:[.,]\d{1,9})?$")
_DATED = re.compile(r"^\d{4}-\d{2}-\d{2}[T ]\d{2}:\d{2}:\d{2}(?:[.,]\d{1,9})?(?:Z|[+-]\d{2}:?\d{2})?$")
_DAY = timedelta(days=1)


@dataclass(frozen=True, slots=True)
class PassedAt:
    """A vehicle by its number, and when its front reached camera 1."""

    number: int
    at: datetime


@dataclass(frozen=True, slots=True)
class Matching:
    """What lines with a time are matched with: the recording's clock, its length, and who passed when."""

    filming: Filming
    duration_s: float
    u_start_s: float
    passed: tuple[PassedAt, ...]
    tolerance_s: float

    def instant(self, text: str) -> datetime:
        """The instant that a line's time says: ISO 8601, or a time of day by the clocks of the recording.

        Raises BadInput for what is no time with seconds, what clocks skip or show twice, and a time of day
        that comes several times within the recording.
        """
        stripped = text.strip()
        if _DATED.match(stripped):
            shown = datetime.fromisoformat(stripped.replace(",", "."))
            if shown.tzinfo is not None:
                return shown.astimezone(UTC)
            return instant_of(shown.isoformat(), self.filming.time_zone)
        if not _TIME.match(stripped):
            raise BadInput("reference-line-no-time", text=stripped[:40])
        return self._of_the_day(_padded(stripped))

    def _of_the_day(self, time: str) -> datetime:
        start, end = self.filming.started_at, self._end
        slack = timedelta(seconds=self.tolerance_s)
        instants: list[datetime] = []
        problem: BadInput | None = None
        first, last = (local_date(at, self.filming.time_zone) for at in (start, end))
        for n in range(-1, (last - first).days + 2):
            day = first + n * _DAY
            try:
                instants.append(instant_of(f"{day.isoformat()}T{time}", self.filming.time_zone))
            except BadInput as error:
                problem = error if first <= day <= last else problem
                twice = error.values if error.code == "local-time-twice" else {}
                offsets = [twice[name] for name in ("first", "second") if name in twice]
                shown = [f"{day.isoformat()}T{time}{offset}" for offset in offsets]
                instants += [instant_of(one, self.filming.time_zone) for one in shown]
        inside = [at for at in instants if start - slack <= at <= end + slack]
        if len({local_date(at, self.filming.time_zone) for at in inside}) > 1:
            raise BadInput("reference-line-no-date", time=time)
        if len(inside) > 1 or (not inside and (problem is not None or not instants)):
            raise problem or BadInput("reference-line-no-time", text=time)
        return inside[0] if inside else min(instants, key=lambda at: max(start - at, at - end))

    @property
    def _end(self) -> datetime:
        return self.filming.started_at + timedelta(seconds=self.duration_s)

    def vehicle_at(self, at: datetime, text: str) -> tuple[int, float]:
        """(number of the one vehicle that passed then, line's time minus its time in seconds).

        Raises BadInput where nobody passed within the tolerance, naming the nearest; Ambiguous where several
        did, naming them.
        """
        near = [one for one in self.passed if abs(apart_s(at, one)) <= self.tolerance_s]
        time, tolerance_s = text.strip()[:40], f"{self.tolerance_s:g}"
        if len(near) > 1:
            raise Ambiguous(
                "reference-line-several", numbers=_listed(near), time=time, tolerance_s=tolerance_s
            )
        if not near and not self.passed:
            raise BadInput("reference-line-nobody", time=time, tolerance_s=tolerance_s)
        if not near:
            nearest = min(self.passed, key=lambda one: abs(apart_s(at, one)))
            raise BadInput(
                "reference-line-nobody-near",
                number=nearest.number,
                apart_s=f"{abs(apart_s(at, nearest)):.1f}",
                time=time,
                tolerance_s=tolerance_s,
            )
        return near[0].number, apart_s(at, near[0])

    def require_near(self, number: int, at: datetime) -> float:
        """The line's time minus that of the vehicle that it names. Raises BadInput beyond the tolerance."""
        of = next((one for one in self.passed if one.number == number), None)
        if of is None:
            raise BadInput("reference-vehicle-without-time", number=number)
        apart = apart_s(at, of)
        if abs(apart) > self.tolerance_s:
            raise BadInput(
                "reference-time-of-another",
                number=number,
                apart_s=f"{abs(apart):.1f}",
                tolerance_s=f"{self.tolerance_s:g}",
            )
        return apart


class Ambiguous(BadInput):
    """Several vehicles, or several lines, fit one another: a person says which."""


def apart_s(at: datetime, one: PassedAt) -> float:
    """An instant minus the one at which a vehicle passed, in seconds."""
    return (at - one.at).total_seconds()


def _padded(time: str) -> str:
    """A time of day as ISO 8601 wants it: two digits of the hour, a point before the fraction."""
    return f"0{time}".replace(",", ".") if time[1] == ":" else time.replace(",", ".")


def _listed(found: Sequence[PassedAt]) -> str:
    return ", ".join(str(one.number) for one in found[:6]) + (" ..." if len(found) > 6 else "")
