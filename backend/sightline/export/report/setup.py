"""Values of the report about survey, set-up, lenses, poses, insets, exclusions and the package itself."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import UTC, date, datetime, timedelta

import numpy as np

from sightline.export.report.facts import (
    CalibrationFacts,
    LensParameter,
    PoseFacts,
    RecordingFacts,
    ReportFacts,
)
from sightline.export.report.pictures import Pictures
from sightline.export.report.said import said, told
from sightline.export.report.settable import Json, Values
from sightline.export.report.units import HEIGHT, SMALL, Scale, decimal, fixed
from sightline.export.report.words import LIGHTING, apart, date_words, day_parts, target_words
from sightline.export.verdicts import VerdictCounts
from sightline.infra.local_time import zone_of

_MOST_VERSIONS = 6
_MOST_IN_HEAD = 70  # characters of a name in the running head


def moment(at: datetime | None) -> str | None:
    """A moment in UTC to the second."""
    if at is None:
        return None
    utc = at.astimezone(UTC)
    return said("report-moment", **day_parts(utc), time=f"{utc:%H:%M:%S}")


def _minute(at: datetime) -> str:
    """A moment by its own clock."""
    return said("report-minute", **day_parts(at), time=f"{at:%H:%M}")


def title(facts: ReportFacts) -> Values:
    """Survey, site, dates, counts."""
    counted = facts.statistics.counted
    name = facts.survey.strip() or said("report-survey")
    return {
        "survey": name,
        "short": name if len(name) <= _MOST_IN_HEAD else f"{name[:_MOST_IN_HEAD]}…",
        "site": facts.site,
        "description": [words for words in facts.description.split("\n\n") if words.strip()],
        "filmed": filmed_words(facts.recordings),
        "place": _place(facts),
        "first_day": _day(facts.first_day),
        "last_day": _day(facts.last_day),
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
        "estimate": fixed(through.estimate, 1),
        "at_most": through.at_most,
        "of": through.count,
    }


def filmed_words(recordings: Sequence[RecordingFacts]) -> str | None:
    """ "2026-05-03 08:10 to 16:40 (Europe/Paris)", each zone apart; None where no start is confirmed."""
    spans: dict[str, list[datetime]] = {}
    for one in recordings:
        if one.started_at:
            zone, start = zone_of(one.time_zone), datetime.fromisoformat(one.started_at).astimezone(UTC)
            ends = (start, start + timedelta(seconds=one.duration_s or 0.0))
            spans.setdefault(one.time_zone, []).extend(end.astimezone(zone) for end in ends)
    words = [_span(min(times), max(times), zone) for zone, times in sorted(spans.items())]
    unsaid = sum(not one.started_at for one in recordings)
    if words and unsaid:
        words.append(said("report-unconfirmed", n=unsaid))
    return apart(words) if words else None


def _span(first: datetime, last: datetime, zone: str) -> str:
    end = f"{last:%H:%M}" if last.date() == first.date() else _minute(last)
    return said("report-span", day=date_words(first), first=f"{first:%H:%M}", last=end, zone=zone)


def _place(facts: ReportFacts) -> str | None:
    """Coordinates, class of the road, lane, travel direction, limit and lamps, as far as said."""
    place, words = facts.place, []
    if place.latitude_deg is not None and place.longitude_deg is not None:
        latitude, longitude = (decimal(f"{at:.5f}") for at in (place.latitude_deg, place.longitude_deg))
        words.append(said("report-coordinates", latitude=latitude, longitude=longitude))
    words += [one for one in (place.road_class, place.lane, place.travel_direction) if one is not None]
    if place.speed_limit_mps is not None:
        factor, unit = (3.6, "km/h") if facts.unit == "m" else (3600 / 1609.344, "mph")
        words.append(said("report-limit", speed=f"{place.speed_limit_mps * factor:.0f} {unit}"))
    if place.street_lamps is not None:
        words.append(said("report-lamps" if place.street_lamps == "present" else "report-no-lamps"))
    return apart(words) if words else None


def _day(day: date | None) -> str | None:
    return None if day is None else date_words(day)


def setup(facts: ReportFacts, pictures: Pictures) -> Values:
    """Photographs and recordings."""
    return {
        "photos": pictures.photos(facts.photos),
        "recordings": [_recording(recording) for recording in facts.recordings],
    }


def _recording(recording: RecordingFacts) -> Values:
    sized = recording.width_px is not None and recording.height_px is not None
    return {
        "name": recording.name,
        "camera": recording.camera or None,
        "lighting": LIGHTING.get(recording.lighting, recording.lighting),
        "start": _minute(datetime.fromisoformat(recording.started_at)) if recording.started_at else None,
        "weather": recording.weather or None,
        "width_px": recording.width_px if sized else None,
        "height_px": recording.height_px if sized else None,
        "frames": recording.frames,
        "duration_s": None if recording.duration_s is None else fixed(recording.duration_s, 1),
        "sha256": recording.sha256[:12] or None,
    }


def calibration(facts: ReportFacts) -> Values:
    """How well the lenses are known, and where the cameras stood."""
    height, small = HEIGHT[facts.unit], SMALL[facts.unit]
    distances = sorted({one.distance_m for pose in facts.poses for one in pose.expected})
    return {
        "lenses": [_lens(lens) for lens in facts.calibrations],
        "distances": [decimal(f"{height.factor * distance:.3g}") for distance in distances],
        "poses": [_pose(pose, distances, height, small) for pose in facts.poses],
        "boards": _boards(facts.poses, height, small),
    }


def _lens(lens: CalibrationFacts) -> Values:
    return {
        "camera": lens.camera,
        "number": lens.number,
        "made_on": date_words(lens.made_on),
        "source": lens.source,
        "model": lens.model,
        "width_px": lens.width_px,
        "height_px": lens.height_px,
        "views_used": lens.views_used,
        "views_given": lens.views_given,
        "rms_px": None if lens.rms_px is None else fixed(lens.rms_px, 3),
        "trusted": lens.trusted,
        "parameters": [_parameter(parameter) for parameter in lens.parameters],
        "warnings": [told(one) for one in lens.warnings],
    }


def _parameter(parameter: LensParameter) -> Values:
    decimals = _decimals(parameter)
    return {
        "name": parameter.name.removesuffix("_px"),
        "unit": "px" if parameter.name.endswith("_px") else None,
        "value": fixed(parameter.value, decimals),
        "u": None if parameter.u is None else fixed(parameter.u, decimals),
    }


def _decimals(parameter: LensParameter) -> int:
    """Two figures of the uncertainty, or what suits the kind of parameter."""
    if parameter.u:
        return int(np.clip(1 - np.floor(np.log10(parameter.u)), 0, 7))
    return 2 if abs(parameter.value) >= 10 else 5


def _pose(pose: PoseFacts, distances: Sequence[float], height: Scale, small: Scale) -> Values:
    expected = {one.distance_m: one.U95_height_m for one in pose.expected}
    return {
        "number": pose.number,
        "recording": pose.recording,
        "camera": pose.camera,
        "calibration": pose.calibration,
        "first_frame": pose.first_frame,
        "last_frame": pose.last_frame,
        "board": pose.board or None,
        "camera_height": height.number(pose.camera_height_m),
        "distance": height.number(pose.distance_m),
        "rms_px": None if pose.rms_px is None else fixed(pose.rms_px, 3),
        "expected": [small.number(expected.get(distance)) for distance in distances],
        "warnings": [told(one) for one in pose.warnings],
    }


def _boards(poses: Sequence[PoseFacts], height: Scale, small: Scale) -> list[Json]:
    """How the boards stood, each with the poses that stood alike."""
    alike: dict[tuple[str | None, ...], list[int]] = {}
    for pose in poses:
        if pose.reference_height_m is not None:
            u_reference, u_lean = pose.u_reference_height_m, pose.u_lean_rad
            stood = (
                height.number(pose.reference_height_m),
                None if u_reference is None else small.number(u_reference),
                None if u_lean is None else fixed(1000 * u_lean, 1),
            )
            alike.setdefault(stood, []).append(pose.number)
    return [
        {
            "poses": numbers,
            "reference_height": reference_height,
            "u_reference_height": u_reference_height,
            "u_lean_mrad": u_lean_mrad,
        }
        for (reference_height, u_reference_height, u_lean_mrad), numbers in alike.items()
    ]


def insets(facts: ReportFacts) -> list[Json]:
    """The insets in force."""
    small = SMALL[facts.unit]
    return [
        {
            "target": target_words(inset.target),
            "inset": small.number(inset.inset_m),
            "u": small.number(inset.u_inset_m),
            "note": told(inset.note) or None,
        }
        for inset in facts.insets
    ]


def exclusions(facts: ReportFacts) -> Values:
    """What counts for no result, and why."""
    rows = facts.exclusions
    return {
        "total": len(rows) if facts.exclusions_total is None else facts.exclusions_total,
        "rows": [
            {
                "measurement": row.measurement,
                "vehicle": row.vehicle,
                "target": target_words(row.target),
                "state": row.state,
                "reason": told(row.reason) or None,
            }
            for row in rows
        ],
    }


def verification(facts: ReportFacts) -> Values:
    """The audit chain's end and the sums of the package's files."""
    return {
        "events": facts.audit_events,
        "head": facts.audit_head,
        "checksums": [{"path": file.path, "sha256": file.sha256} for file in facts.checksums],
    }
