"""Evidence of one line-scanned vehicle: the rule that it is held against, and the file as it was made."""

from dataclasses import dataclass

from sightline.enums import JsonObject, JudgedQuantity, LimitSide

#: On which side of its limit a quantity must keep, and the unit in which a document holds both.
SIDES: dict[JudgedQuantity, LimitSide] = {"speed": "upper", "time_gap": "lower", "distance_gap": "lower"}
UNITS: dict[JudgedQuantity, str] = {"speed": "m/s", "time_gap": "s", "distance_gap": "m"}


@dataclass(frozen=True, slots=True)
class Rule:
    """A limit (m/s, s or m, by the quantity), the risk of a false decision, and who set the limit."""

    quantity: JudgedQuantity
    limit: float
    risk: float
    source: str = ""


@dataclass(frozen=True, slots=True)
class Evidence:
    """A file as it was made: its name, its bytes, what it says (`document`, signed) and the hash of that."""

    filename: str
    content: bytes
    document: JsonObject
    sha256: str
