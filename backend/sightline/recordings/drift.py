"""On which frames of a recording the camera was not where its road pose says, as documents and sentences."""

from dataclasses import dataclass

from sightline.enums import JsonObject


@dataclass(frozen=True, slots=True)
class MovedSpan:
    """Frames on which the camera had moved by `moved_px`; heights are then off by up to `change_m`."""

    first_frame: int
    last_frame: int
    moved_px: float
    change_m: float | None


def drift_check_of(drift: JsonObject | None, pose_id: int | None) -> JsonObject | None:
    """What was found against one road pose; None where nobody looked."""
    if drift is None or pose_id is None:
        return None
    found: JsonObject | None = drift["checks"].get(str(pose_id))
    return found


def drift_figures(check: JsonObject) -> JsonObject:
    """What a check found, in a few figures: the largest motion and the largest change of a height where the
    camera moved, None where it did not.
    """
    moved = [span for span in check["spans"] if span["moved"]]
    changes = [abs(span["change_m"]) for span in moved if span["change_m"] is not None]
    return {
        "state": check["state"],
        "floor_px": check.get("floor_px"),
        "moved_px": max((span["moved_px"] for span in moved), default=None),
        "height_m": max(changes, default=None),
        "checked_at": check.get("checked_at"),
    }


def open_spans(drift: JsonObject | None, decision: JsonObject | None, pose_id: int | None) -> list[MovedSpan]:
    """The moved spans against a pose that no decision covers."""
    check = drift_check_of(drift, pose_id)
    if check is None:
        return []
    spans = [MovedSpan(**{name: one[name] for name in _NAMES}) for one in check["spans"] if one["moved"]]
    return [one for one in spans if not _decided(one, decision, pose_id, check["floor_px"])]


_NAMES = ("first_frame", "last_frame", "moved_px", "change_m")


def _decided(span: MovedSpan, decision: JsonObject | None, pose_id: int | None, floor_px: float) -> bool:
    """Whether somebody saw this very motion and let it stand; a larger one found since is another."""
    if decision is None or decision["pose_id"] != pose_id:
        return False
    return any(
        one["first_frame"] <= span.last_frame
        and span.first_frame <= one["last_frame"]
        and span.moved_px <= one["moved_px"] + floor_px
        for one in decision["spans"]
    )


def sentence(span: MovedSpan) -> str:
    """The flag of a measurement on such a frame."""
    off = "" if span.change_m is None else f", heights are off by up to {abs(span.change_m) * 1000:.0f} mm"
    return (
        f"The camera had moved by {span.moved_px:.1f} px since its road pose{off}; take a new road pose for "
        "this part, or decide that the old one is still good."
    )
