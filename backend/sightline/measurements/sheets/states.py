"""The state of a vehicle, which is never stored: the one rule for what lists show and what packages hold."""

from collections.abc import Collection, Iterable
from typing import get_args

from sightline.enums import AcceptedVerdict, AskedTarget, VehicleState

#: Of a standing measurement (current, not withdrawn, no repeat): target, status and verdict.
Standing = tuple[str, str, str]


def state_of(
    standing: Collection[Standing],
    asked: Iterable[AskedTarget],
    not_visible: Iterable[AskedTarget],
    *,
    discarded: bool,
    wanted: bool,
) -> VehicleState:
    """What a vehicle's standing measurements make of it, by what is asked for: heights and `not_visible`
    answer, clicks that give no height do not. `wanted`: it is in the sample, or checks the measuring.
    """
    if discarded:
        return "discarded"
    if not standing and not wanted:
        return "out_of_sample"
    verdicts = {verdict for _, _, verdict in standing}
    if "rejected" in verdicts:
        return "rejected"
    unseen = set(not_visible)
    if not set(asked) <= {target for target, status, _ in standing if status == "ok"} | unseen:
        return "partial" if standing or unseen else "to_do"
    if not standing:
        return "not_visible"
    return "accepted" if verdicts <= {*get_args(AcceptedVerdict)} else "measured"
