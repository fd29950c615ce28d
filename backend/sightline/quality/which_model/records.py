"""What was measured of a vehicle, and the models of the catalogue that fit it."""

from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from sightline.enums import ModelSize
from sightline.messages.said import Said
from sightline.statistics.which_model import CANNOT_FIT_P
from sightline.vehicles.catalogue.records import CatalogueEntry


@dataclass(frozen=True, slots=True, kw_only=True)
class MeasuredSize:
    """A size of the vehicle, metres; `reason`: why there is none."""

    size: ModelSize
    value_m: float | None = None
    u_m: float | None = None
    reason: Said | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class SizeDifference:
    """Measured minus the catalogue's size, and the u of that difference, metres."""

    size: ModelSize
    difference_m: float
    u_m: float


@dataclass(frozen=True, slots=True, kw_only=True)
class FittingModel:
    """A model and how it fits; `differences` are those of all sizes compared."""

    entry: CatalogueEntry
    chi_square: float
    compared: Annotated[int, Field(description="How many sizes could be compared.")]
    p: Annotated[float, Field(description="How often the right model differs at least as much.")]
    cannot: Annotated[bool, Field(description="Differs by more than the uncertainties allow.")]
    differences: tuple[SizeDifference, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class WhichModel:
    """The models that fit, and how the one filled in fits.

    Ranked by lengths, never by a height: heights are what is held against the model afterwards.
    """

    measured: tuple[MeasuredSize, ...]
    fitting: Annotated[
        tuple[FittingModel, ...], Field(description="Those that fit, the likeliest first; none that cannot.")
    ] = ()
    ranked_by: Annotated[
        tuple[ModelSize, ...],
        Field(description="The sizes that rank; none: the vehicle's class first, then by name."),
    ] = ()
    fit: Annotated[int, Field(description="How many models can be it.")] = 0
    cannot_fit: Annotated[int, Field(description="How many cannot, and are not among `fitting`.")] = 0
    chosen: Annotated[
        FittingModel | None, Field(description="The row of make and model filled in; of several the best.")
    ] = None
    limit_p: Annotated[float, Field(description="Below this p a model cannot fit.")] = CANNOT_FIT_P
    reason: Annotated[Said | None, Field(description="Why nothing can be said.")] = None
