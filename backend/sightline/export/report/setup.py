"""Values of the report about the survey itself and what counts for none of its results."""

from collections.abc import Sequence
from datetime import UTC, datetime, timedelta

from sightline.export.report.facts import ReportFacts, Row
from sightline.export.report.said import day_parts, sentence_of_key, sentence_of_said
from sightline.export.report.settable import Values
from sightline.export.report.units import SPEED, decimal, format_fixed
from sightline.export.report.words import date_words, join_with_semicolons
from sightline.export.verdicts import VerdictCounts
from sightline.infra.csv_package.columns import code_in
from sightline.infra.local_time import zone_of
from sightline.messages import write_fixed

_MOST_VERSIONS = 6
_MOST_IN_HEAD = 70  # characters of a name in the running head


def title(facts: ReportFacts) -> Values:
    """Survey, site, dates, counts."""
    counted = facts.statistics.counted
    name = facts.survey.strip() or sentence_of_key("report-survey")
    return {
        "survey": name,
        "short": name if len(name) <= _MOST_IN_HEAD else f"{name[:_MOST_IN_HEAD]}…",
        "site": facts.site,
        "description": [words for words in facts.description.split("\n\n") if words.strip()],
        "filmed": filmed_words(facts.recordings),
        "place": _place(facts),
        "first_day": facts.first_day,
        "last_day": facts.last_day,
        "counts": facts.counts,
        "measurements": counted.measurements,
        "vehicles": counted.vehicles,
        "with_reference": counted.with_reference,
        "verdicts": _verdicts(facts.verdicts),
        "selection": facts.selection,
        "versions": facts.code_versions[:_MOST_VERSIONS],
        "more_versions": max(len(facts.code_versions) - _MOST_VERSIONS, 0),
    }


def _verdicts(counts: VerdictCounts) -> Values | None:
    """Who was judged how; None where nothing was judged by lot."""
    through = counts.outgoing
    if through is None:
        return None
    return {
        "individual": counts.individual,
        "by_lot": counts.by_lot,
        "lots": counts.lots,
        "estimate": format_fixed(through.estimate, 1),
        "at_most": through.at_most,
        "of": through.count,
    }


def filmed_words(recordings: Sequence[Row]) -> str | None:
    """ "2026-05-03 08:10 to 16:40 (Europe/Paris)", each zone apart; None where no start is confirmed."""
    spans: dict[str, list[datetime]] = {}
    for recording in recordings:
        if recording["started_at"] is not None:
            zone, start = zone_of(recording["time_zone"] or ""), recording["started_at"].astimezone(UTC)
            ends = (start, start + timedelta(seconds=recording["duration_s"] or 0.0))
            spans.setdefault(recording["time_zone"] or "", []).extend(end.astimezone(zone) for end in ends)
    words = [_span(min(times), max(times), zone) for zone, times in sorted(spans.items())]
    unsaid = sum(recording["started_at"] is None for recording in recordings)
    if words and unsaid:
        words.append(sentence_of_key("report-unconfirmed", n=unsaid))
    return join_with_semicolons(words) if words else None


def _span(first: datetime, last: datetime, zone: str) -> str:
    end = f"{last:%H:%M}"
    if last.date() != first.date():
        end = sentence_of_key("report-minute", **day_parts(last), time=end)
    return sentence_of_key("report-span", day=date_words(first), first=f"{first:%H:%M}", last=end, zone=zone)


def _place(facts: ReportFacts) -> str | None:
    """Coordinates, class of the road, lane, travel direction, limit and lamps, as far as said."""
    place, words = facts.place, []
    if place.latitude_deg is not None and place.longitude_deg is not None:
        degrees = (place.latitude_deg, place.longitude_deg)
        latitude, longitude = (decimal(write_fixed(at, 5)) for at in degrees)
        words.append(sentence_of_key("report-coordinates", latitude=latitude, longitude=longitude))
    words += [one for one in (place.road_class, place.lane, place.travel_direction) if one is not None]
    if place.speed_limit_mps is not None:
        speed = SPEED[facts.unit]
        words.append(
            sentence_of_key("report-limit", speed=f"{place.speed_limit_mps * speed.factor:.0f} {speed.sign}")
        )
    if place.street_lamps is not None:
        words.append(
            sentence_of_key("report-lamps" if place.street_lamps == "present" else "report-no-lamps")
        )
    return join_with_semicolons(words) if words else None


def exclusions(facts: ReportFacts) -> Values:
    """What counts for no result, and why."""
    rows = facts.exclusions
    return {
        "total": len(rows) if facts.exclusions_total is None else facts.exclusions_total,
        "rows": [
            {**row, "reason": sentence_of_said(code_in(row["reason_code"] or "") or row["reason"] or "")}
            for row in rows
        ],
    }
