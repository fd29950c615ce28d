"""The account of an adjustment, as `adjusted.json` and a stored pose have it."""

from collections.abc import Sequence
from typing import Any

from sightline.adjustment.adjust import Adjustment, LeftOut


def adjustment_to_dict(adjustment: Adjustment, unread: Sequence[LeftOut] = ()) -> dict[str, Any]:
    """What was used, left out and moved; `unread`: passes that could not even be read."""
    return {
        "passes": adjustment.passes + len(unread),
        "used": adjustment.used,
        "left_out": [
            {"pass": one.name, "reason": one.reason.document} for one in (*unread, *adjustment.left_out)
        ],
        "left_out_points": [
            {"pass": one.name, "frame": one.frame, "point": one.point} for one in adjustment.dropped_points
        ],
        "chi2": adjustment.chi2,
        "degrees_of_freedom": adjustment.degrees_of_freedom,
        "chi2_limit": adjustment.chi2_limit,
        "moved": [
            {"name": one.name, "value": one.value, "u_before": one.u_before, "u_after": one.u_after}
            | ({} if one.of_m is None else {"of_m": one.of_m})
            for one in adjustment.moved
        ],
        "heading_rad": adjustment.heading_rad,
        "u_heading_rad": adjustment.u_heading_rad,
        "notes": [one.document for one in adjustment.notes],
    }
