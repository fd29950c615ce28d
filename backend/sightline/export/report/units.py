"""Lengths in the reader's unit: heights in metres or feet, errors in millimetres or inches.

`HEIGHT` and `SMALL` say with how many digits a figure is printed, wherever it stands; of the pages
`frontend/src/core/units.ts` does.
"""

from dataclasses import dataclass
from typing import Any

from sightline.enums import LengthUnit
from sightline.export.report.said import Called, sentence_of_key
from sightline.messages import write_fixed

NONE = "–"
_FOOT_M = 0.3048


@dataclass(frozen=True)
class Scale:
    """Factor from metres, the unit's sign, and how many decimals a figure has."""

    factor: float
    sign: str
    digits: int

    def number(self, value_m: float | None, *, signed: bool = False) -> str:
        """The figure without its unit; a dash where there is none."""
        return NONE if value_m is None else format_fixed(self.factor * value_m, self.digits, signed=signed)

    def length(self, value_m: float | None) -> str:
        """The figure with its unit, held together by a space that does not break."""
        return NONE if value_m is None else f"{self.number(value_m)}\u00a0{self.sign}"


HEIGHT: dict[LengthUnit, Scale] = {"m": Scale(1.0, "m", 3), "ft": Scale(1.0 / _FOOT_M, "ft", 3)}
WAY: dict[LengthUnit, Scale] = {"m": Scale(1.0, "m", 2), "ft": Scale(1.0 / _FOOT_M, "ft", 2)}
SPEED: dict[LengthUnit, Scale] = {"m": Scale(3.6, "km/h", 1), "ft": Scale(3600 / 1609.344, "mph", 1)}
SMALL: dict[LengthUnit, Scale] = {"m": Scale(1000.0, "mm", 1), "ft": Scale(12.0 / _FOOT_M, "in", 2)}
SQUARE: dict[LengthUnit, Scale] = {
    "m": Scale(1e4, "cm²", 2),
    "ft": Scale((12.0 / _FOOT_M) ** 2, "in²", 3),
}
OTHER: dict[LengthUnit, LengthUnit] = {"m": "ft", "ft": "m"}
_SCALES = {"height": HEIGHT, "way": WAY, "speed": SPEED, "small": SMALL, "square": SQUARE}
_WORDS = Called("report-unit-")


def unit_words(unit: LengthUnit) -> dict[str, Any]:
    """Signs and words of the units that a report is written in, and of those beside them; their `scales`."""
    other = OTHER[unit]
    return {
        "height": HEIGHT[unit].sign,
        "height_words": _WORDS[HEIGHT[unit].sign],
        "small": SMALL[unit].sign,
        "small_words": _WORDS[SMALL[unit].sign],
        "square": SQUARE[unit].sign,
        "speed": SPEED[unit].sign,
        "other_height": HEIGHT[other].sign,
        "other_small_words": _WORDS[SMALL[other].sign],
        "other_square_words": _WORDS[SQUARE[other].sign.replace("²", "2")],
        "scales": {name: scale[unit] for name, scale in _SCALES.items()},
        "other_scales": {name: scale[other] for name, scale in _SCALES.items()},
    }


def limit(height_m: float, unit: LengthUnit) -> str:
    """The height of a standard with its unit: two decimals, a third only where its metres have one."""
    scale = HEIGHT[unit]
    whole = format_fixed(height_m, 3).endswith("0")
    return f"{format_fixed(scale.factor * height_m, 2 if whole else 3)}\u00a0{scale.sign}"


def format_fixed(value: float, digits: int, *, signed: bool = False) -> str:
    """Fixed decimals with a true minus sign and the language's decimal sign; what rounds to zero has none."""
    shown = write_fixed(abs(value), digits)
    sign = "" if float(shown) == 0 else "−" if value < 0 else "+" if signed else ""
    return sign + decimal(shown)


def decimal(text: str) -> str:
    """A number's text with the decimal sign of the language."""
    return text.replace(".", sentence_of_key("report-decimal-sign"))


def percent(share: float) -> str:
    """A share in per cent."""
    return f"{format_fixed(100.0 * share, 1)}\u00a0%"
