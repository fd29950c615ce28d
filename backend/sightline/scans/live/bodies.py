"""Bodies of live streams: what a computer at the roadside sends of its recording. Metres, seconds, lines."""

from collections.abc import Mapping
from datetime import UTC, datetime
from typing import Annotated, Any

from pydantic import AwareDatetime, Field

from sightline.enums import ScanMethod
from sightline.errors import BadInput
from sightline.infra.web.bodies import Finite, Id, In, Out, of_record
from sightline.infra.web.named import UploadId
from sightline.linescan.parts import Entry, Rig
from sightline.linescan.rig import lane_named, require_rig, rig_from
from sightline.messages.said import Said
from sightline.scans.bodies import LaneName, RigIn
from sightline.scans.live.records import LiveHealth
from sightline.scans.records import ScanValues

Lines = Annotated[Finite, Field(ge=-1e12, le=1e12, description="Line number, fractional.")]
NotNegative = Annotated[Finite, Field(ge=0)]
#: Far beyond any vehicle, in either unit.
Positive = Annotated[Finite, Field(gt=0, le=1000)]
Count = Annotated[int, Field(ge=0, le=2**53)]
#: So that no line's time is beyond the calendar.
Moment = Annotated[
    AwareDatetime, Field(ge=datetime(1970, 1, 1, tzinfo=UTC), le=datetime(2200, 1, 1, tzinfo=UTC))
]
Share = Annotated[Finite, Field(ge=0, le=1)]
Brightness = Annotated[Finite, Field(ge=0, le=255)]
Columns = Annotated[list[Finite], Field(max_length=10_000)]
MOST_VEHICLES = 100
#: What an "ok" has and no other.
_MOTION = ("speed_mps", "acceleration_mps2", "length_m")
_WITH_U = (*_MOTION, *(f"u_{name}" for name in _MOTION))


@of_record(Entry, given={"source": Annotated[str, Field(max_length=100)], "u_*": NotNegative})
class EntryIn(In):
    """One line of a vehicle's uncertainty budget."""


class ProfileIn(In):
    """Speed along a vehicle: columns of equal length, one entry a block."""

    line_1: Columns
    speed_mps: Columns
    fitted_mps: Columns
    used: Annotated[list[bool], Field(max_length=10_000)]


_DERIVED = ("cause", "placed_by", "run_id", "rig", "direction", "axles_by")
_WHEELS = ("front_wheel_line", "rear_wheel_line", "wheelbase_m", "u_wheelbase_m")
_MEASURED = {
    "*_line_?": Lines,
    "u_speed_mps": Positive,
    "u_length_m": Positive,
    "u_*": NotNegative,
    "speed_mps": Positive,
    "length_m": Positive,
    "correlation": Annotated[Finite, Field(ge=-1, le=1)],
    "axle_lines": Annotated[list[Lines], Field(max_length=100)],
    "lane": LaneName,
    "warnings": Annotated[list[Said], Field(max_length=100)],
    "code_version": Annotated[str, Field(max_length=60)],
    **dict.fromkeys(("acceleration_mps2", "fit_error_percent"), Finite),
    **dict.fromkeys(("misalignment_px", "gain", "tyres_px"), Finite),
}


@of_record(ScanValues, *_DERIVED, *_WHEELS, given=_MEASURED)
class MeasuredIn(In):
    """A vehicle as it was measured; what follows from this and the rig is not told."""

    budget: Annotated[list[EntryIn], Field(max_length=100)]
    profile: ProfileIn | None

    def told(self, rig: Rig) -> Mapping[str, Any]:
        """By name. Raises BadInput where one value contradicts another."""
        told = dict(self)
        told["budget"] = [dict(one) for one in self.budget]
        told["profile"] = None if self.profile is None else dict(self.profile)
        is_ok, reason = told["status"] == "ok", told["reason"]
        numbers = {told[name] is not None for name in _WITH_U}
        profile = told["profile"]
        if (
            numbers != {is_ok}
            or is_ok != (reason is None)
            or ((told["budget"] or profile or told["correlation"] is not None) and not is_ok)
            or told["lane_by"] != (None if told["lane"] is None else "machine")
            or (told["lane"] is not None and lane_named(rig, told["lane"]) is None)
            or (profile and len({len(column) for column in profile.values()}) > 1)
        ):
            raise BadInput("scans-measured-contradicts", line=told["front_line_1"])
        return told


_HEALTH = {
    "lines": Annotated[Count, Field(le=10**12)],
    "lost_lines": tuple[Count, Count],
    "light_dn": tuple[Brightness | None, Brightness | None],
    "saturated": tuple[Share, Share],
    "clock_offset_s": Finite,
    "*_mib": NotNegative,
    "words": Annotated[tuple[Said, ...], Field(max_length=100)],
}


@of_record(LiveHealth, given=_HEALTH)
class HealthIn(In):
    """How a stream is at the moment."""


class OfStream(In):
    """`rig`: that the stream measures with."""

    rig: RigIn

    def stream_rig(self) -> Rig:
        """Raises BadInput for one that cannot be."""
        rig = rig_from(self.rig.model_dump())
        require_rig(rig)
        return rig


class NewSegment(OfStream):
    """A part of a stream that begins. Sent again, it names the recording that was made of it."""

    number: Count
    stream: Annotated[str, Field(min_length=1, max_length=40, description="The same of all its parts.")]
    source: Annotated[str, Field(max_length=4000)]
    began_at: Annotated[Moment, Field(description="When line 0 was taken.")]
    others: Annotated[list[Id], Field(max_length=1000, description="Recordings of its other parts.")]


class BegunSegment(Out):
    """The number of its recording."""

    id: int


class SegmentGrows(OfStream):
    """Vehicles, of which those that are there are not stored again, and how the stream is."""

    vehicles: Annotated[list[MeasuredIn], Field(max_length=MOST_VEHICLES)]
    health: HealthIn | None = None


class SegmentEnds(OfStream):
    """The strips that were uploaded, or none; and how many vehicles were told."""

    method: ScanMethod
    notes: Annotated[list[Said], Field(max_length=100)]
    told: Count
    first_upload: UploadId | None = None
    second_upload: UploadId | None = None

    def uploads(self) -> tuple[int, int] | None:
        """Raises BadInput for one without the other."""
        if self.first_upload is None and self.second_upload is None:
            return None
        if self.first_upload is None or self.second_upload is None:
            raise BadInput("scans-live-one-strip")
        return self.first_upload, self.second_upload
