"""Bodies of heights in line scans: rod marks and the line camera's pose, clicks and heights. Metres, rows."""

from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from sightline.enums import DriverSide, Target
from sightline.infra.web.bodies import Finite, In
from sightline.infra.web.named import ScanVehicleId
from sightline.infra.web.quantities import InsetM, SeenRevision, SigmaPx, UInsetM
from sightline.measurements.records import RevisionFacts, ScanHeightValues
from sightline.scans.bodies import DistanceM, Line

Row = Annotated[Finite, Field(ge=-1, le=1e6, description="Row of strip 1, fractional, from the top.")]
MOST_MARKS = 200


class RodMark(In):
    """A mark of the rod, clicked in strip 1."""

    distance_m: DistanceM = Field(description="Horizontal, from the camera's centre to the rod.")
    height_m: Annotated[Finite, Field(ge=-5, le=20, description="Above the road.")]
    row_px: Row
    line: Line


class RodIn(In):
    """Marks of a rod held upright at two or more distances; `u_` are standard uncertainties (k = 1)."""

    marks: Annotated[list[RodMark], Field(max_length=MOST_MARKS)]
    sigma_px: SigmaPx | None = Field(default=1.0, description="Of a mark's row; null: from the residuals.")
    u_distance_m: Annotated[Finite, Field(ge=0, le=10)] = 0.0
    u_lean_rad: Annotated[Finite, Field(ge=0, le=0.5)] = 0.0


class NewLinePose(RodIn):
    """The calibration to store, which supersedes the one that was seen."""

    revision: SeenRevision


class LineClicks(In):
    """Two clicks in strip 1; what is left out is 1 px and the survey's inset. An eye needs inset or side."""

    target: Target
    contact_line: Line
    contact_row_px: Row
    sigma_px: SigmaPx | None = None
    inset_m: InsetM | None = None
    u_inset_m: UInsetM | None = None
    side: Annotated[
        DriverSide | None,
        Field(description="Of an eye: where the driver sits; its inset is the survey's."),
    ] = None


class LineHeightWanted(LineClicks):
    """Without a target's row, what is known of the contact alone is answered."""

    target_line: Line | None = None
    target_row_px: Row | None = None
    vehicle_id: Annotated[
        ScanVehicleId | None,
        Field(description="Whose height it would be: a roof's inset follows from its class."),
    ] = None


class NewLineHeight(LineClicks):
    """The height to store."""

    target_line: Line
    target_row_px: Row
    revision: SeenRevision


@dataclass(frozen=True, slots=True, kw_only=True)
class ScanHeightBody(ScanHeightValues, RevisionFacts):
    """One revision of a target's height; points are (line, row) of strip 1."""

    scan_id: int
    older: Annotated[bool, Field(description="Its calibration or inset was changed since.")]
    U95_distance_m: float | None
    mine: Annotated[bool, Field(description="You clicked or gave some of it, so somebody else reviews it.")]
