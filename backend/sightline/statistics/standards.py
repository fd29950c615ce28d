"""A height that a standard of road design is set by, to be drawn into distributions."""

from dataclasses import dataclass

from sightline.enums import StandardHeight


@dataclass(frozen=True)
class Standard:
    """One height of one standard.

    `what`: what it is a height of; `percent`: which percentile of `vehicle_class` it stands for, None where
    no source says; `cited_by`: who cites it, "" where the source itself was read; `drawn`: whether
    distributions are read against it (not what is superseded, nor the upper end of a range).
    """

    name: str
    what: StandardHeight
    height_m: float
    source: str
    edition: str = ""
    year: int | None = None
    percent: float | None = None
    vehicle_class: str = ""
    cited_by: str = ""
    drawn: bool = True
