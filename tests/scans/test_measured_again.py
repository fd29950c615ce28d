"""What stays of the doubt about found boundaries where a motion is measured again between them."""

import pytest

from sightline.linescan.parts import Crossings, Entry, Motion
from sightline.scans.vehicles.measure import _u_ends


@pytest.mark.parametrize(
    ("front_m", "rear_m", "kept"),
    [
        (0.003, 0.004, (0.003, 0.004)),
        # the cameras disagreed about the front, which says nothing of the rear
        (0.090, 0.004, (0.005, 0.004)),
        # and about both
        (0.090, 0.050, (0.005, 0.005)),
    ],
)
def test_an_end_keeps_its_own_doubt_where_the_cameras_disagreed_about_the_other(
    front_m: float, rear_m: float, kept: tuple[float, float]
) -> None:
    """The rear's was 0.2 mm, for it had its share of what was found as of what they disagreed."""
    budget = (Entry("front", 0.0, 0.0, front_m), Entry("rear", 0.0, 0.0, rear_m))
    at = Crossings(0.0, 100.0, 50.0, 150.0)
    motion = Motion("direct", at, "ok", None, 20.0, budget=budget, u_boundaries_m=0.005)
    assert _u_ends(motion) == pytest.approx(kept)


def test_ends_of_before_and_of_the_papers_method_share_their_doubt() -> None:
    at = Crossings(0.0, 100.0, 50.0, 150.0)
    for method, sources in (("direct", ("boundaries",)), ("paper", ("front", "rear")), ("direct", ())):
        budget = tuple(Entry(source, 0.0, 0.0, 0.005) for source in sources)
        motion = Motion(method, at, "ok", None, 20.0, budget=budget, u_boundaries_m=0.005)
        assert _u_ends(motion) == pytest.approx((0.005 / 2**0.5,) * 2)
