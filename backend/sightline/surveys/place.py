"""The place of a survey: where it lies, what road it is, and whose clocks are told."""

from dataclasses import dataclass, replace

from sightline.enums import StreetLamps
from sightline.errors import BadInput
from sightline.infra.local_time import zone_of
from sightline.infra.meaning import explained_as

_FASTEST_MPS = 60.0


@dataclass(frozen=True, slots=True)
@explained_as("survey")
class Place:
    """Where a survey's site lies, what road it is, and whose clocks are told; null while nobody has said."""

    latitude_deg: float | None = None
    longitude_deg: float | None = None
    road_class: str | None = None
    lane: str | None = None
    travel_direction: str | None = None
    speed_limit_mps: float | None = None
    street_lamps: StreetLamps | None = None
    time_zone: str | None = None


PLACE: tuple[str, ...] = tuple(Place.__dataclass_fields__)


def checked_place(place: Place) -> Place:
    """The place, its words without blanks around them. Raises BadInput for what cannot be true."""
    latitude, longitude = place.latitude_deg, place.longitude_deg
    if (latitude is None) != (longitude is None):
        raise BadInput("surveys-place-half-coordinates")
    if latitude is not None and not -90.0 <= latitude <= 90.0:
        raise BadInput("surveys-place-latitude", latitude=format(latitude, "g"))
    if longitude is not None and not -180.0 <= longitude <= 180.0:
        raise BadInput("surveys-place-longitude", longitude=format(longitude, "g"))
    limit = place.speed_limit_mps
    if limit is not None and not 0.0 < limit <= _FASTEST_MPS:
        raise BadInput(
            "surveys-place-speed-limit", kmh=f"{3.6 * limit:.0f}", fastest=f"{3.6 * _FASTEST_MPS:.0f}"
        )
    zone = _strip_or_none(place.time_zone)
    if zone is not None:
        zone_of(zone)
    return replace(
        place,
        road_class=_strip_or_none(place.road_class),
        lane=_strip_or_none(place.lane),
        travel_direction=_strip_or_none(place.travel_direction),
        time_zone=zone,
    )


def _strip_or_none(said: str | None) -> str | None:
    return (said or "").strip() or None
