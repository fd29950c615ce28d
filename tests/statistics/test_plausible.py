"""What is asked about at once, and what is not."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sightline.statistics.plausible import Height, doubts


def asked(
    category: str | None = None, maker_m: float | None = None, **heights_m: float
) -> list[tuple[str, str]]:
    heights = {name: Height(value, 0.01) for name, value in heights_m.items()}
    return [(one.target, one.kind) for one in doubts(heights, category, maker_m)]  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("category", "heights"),
    [
        # Fiat 500, VW Golf, Volvo XC90, VW Transporter, a tractor unit: makers' roofs, usual eyes and lamps
        ("hatchback", {"roof": 1.488, "driver_eye": 1.13, "taillight": 0.75, "headlight": 0.68}),
        ("hatchback", {"roof": 1.456, "driver_eye": 1.11}),
        ("suv", {"roof": 1.776, "driver_eye": 1.45, "headlight": 0.85}),
        ("van", {"roof": 1.990, "driver_eye": 1.68, "taillight": 0.95}),
        ("lorry", {"roof": 3.80, "driver_eye": 2.50, "headlight": 0.95}),
        (None, {"roof": 1.2}),
    ],
)
def test_vehicles_that_there_are_raise_no_question(category: str | None, heights: dict[str, float]) -> None:
    assert asked(category, **heights) == []


def test_an_eye_above_the_roof_and_a_lamp_above_the_eye_are_asked_about() -> None:
    assert asked(roof=1.4, driver_eye=1.45) == [("driver_eye", "above_roof")]
    assert asked(driver_eye=1.1, headlight=1.2) == [("driver_eye", "below_lamp")]


def test_a_height_outside_its_class_is_asked_about_but_not_in_another() -> None:
    assert asked("saloon", roof=2.007) == [("roof", "outside_class")]
    assert asked("van", roof=2.007) == asked(roof=2.007) == []


def test_a_roof_far_from_the_makers_is_asked_about_where_uncertainty_does_not_explain_it() -> None:
    assert asked(maker_m=1.45, roof=1.60) == [("roof", "far_from_maker")]
    assert asked(maker_m=1.45, roof=1.50) == []
    coarse = doubts({"roof": Height(1.60, 0.1)}, None, 1.45)
    assert coarse == ()


@given(
    st.dictionaries(
        st.sampled_from(["roof", "driver_eye", "taillight", "headlight", "other"]), st.floats(0, 5)
    )
)
def test_only_what_was_measured_is_asked_about_and_each_but_once(heights: dict[str, float]) -> None:
    found = asked("suv", 1.7, **heights)
    assert len(found) == len(set(found)) and {target for target, _ in found} <= set(heights) - {"other"}
