"""Heights that standards of road design are set by, to be drawn into distributions. An editable beginning."""

from dataclasses import dataclass

from sightline.enums import StandardHeight


@dataclass(frozen=True)
class Standard:
    """One height of one standard. `what`: which distribution it belongs to."""

    name: str
    what: StandardHeight
    height_m: float
    source: str


STANDARDS = (
    Standard("AASHTO (USA)", "driver_eye", 1.08, "A Policy on Geometric Design of Highways and Streets"),
    Standard("AASHTO (USA)", "object", 0.60, "A Policy on Geometric Design of Highways and Streets"),
    Standard("United Kingdom", "driver_eye", 1.05, "Design Manual for Roads and Bridges, CD 109"),
    Standard("United Kingdom, low", "object", 0.26, "Design Manual for Roads and Bridges, CD 109"),
    Standard("United Kingdom, high", "object", 2.00, "Design Manual for Roads and Bridges, CD 109"),
    Standard("France", "driver_eye", 1.00, "as cited by Dupuis et al., Sensors 2019"),
    Standard("France", "object", 0.60, "as cited by Dupuis et al., Sensors 2019"),
)
