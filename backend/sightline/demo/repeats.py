"""Second clicks of the demonstration's people, so that the page of repeats has figures to show.

Their scatter is known: the operator's is that of the first clicks, the reviewer's a little larger, and both
click beside where things are in the picture, without a leaning of their own.
"""

from uuid import UUID, uuid5

import numpy as np

from sightline.demo.clicks import CLICK_NOISE_PX, Pass, scatter_click, sight_of
from sightline.infra.database import Session
from sightline.measurements.records import Clicks, Measurement
from sightline.measurements.service import store_measurement

REVIEWER_NOISE_PX = 0.8
OF_EACH = 12
_NAMESPACE = UUID("0b8f3c57-8f43-4a0c-b9a7-6d7f6a2d9e35")


def click_again(
    session: Session,
    passes: list[Pass],
    stored: dict[int, list[Measurement]],
    *,
    operator: int,
    reviewer: int,
) -> None:
    """Operator and reviewer click some of the measurements again; not those of the vehicle with the slip."""
    rng = np.random.default_rng(20190704)
    slipped = {one.vehicle.id for one in passes if one.fate == "slipped"}
    truths = {one.vehicle.id: one.truth for one in passes}
    found = [one for key, made in stored.items() if key not in slipped for one in made]
    for actor, noise_px in ((operator, CLICK_NOISE_PX), (reviewer, REVIEWER_NOISE_PX)):
        for index in sorted(rng.permutation(len(found))[:OF_EACH]):
            first = found[int(index)]
            sight = sight_of(truths[first.vehicle_id], first.values.target)
            assert sight is not None
            frame, contact, point = sight
            clicks = Clicks(
                target=first.values.target,
                frame=frame,
                contact=scatter_click(contact, rng, noise_px),
                target_point=scatter_click(point, rng, noise_px),
            )
            key = str(uuid5(_NAMESPACE, f"{first.id} {actor}"))
            store_measurement(session, first.vehicle_id, key, clicks, repeat_of=first.id, actor=actor)
