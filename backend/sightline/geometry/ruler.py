"""The live axes through a contact click, in plain lists: what a screen draws while the pointer moves."""

from dataclasses import dataclass

from typing_extensions import TypedDict

from sightline.arrays import Floats
from sightline.geometry.road import Overlay, Rung, axes_at_contact, ladder_at_contact
from sightline.geometry.road_pose import RoadPose
from sightline.messages.said import Said

Polyline = list[tuple[float, float]]


class DrawnAxes(TypedDict):
    """The road's axes through one point, as pixel polylines."""

    longitudinal: Polyline
    vertical: Polyline
    transversal: Polyline
    origin_px: tuple[float, float]


class DrawnRung(TypedDict):
    """A line of equal height above the road; `label`: whether its height is written beside it."""

    height_m: float
    points: Polyline
    label: bool


@dataclass(frozen=True)
class Ruler:
    """The axes and the ladder through a contact click, as pixel polylines; or why there are none."""

    ok: bool
    reason: Said | None
    axes: DrawnAxes | None
    ladder: list[DrawnRung]
    x_m: float | None
    y_m: float | None
    distance_m: float | None


def ruler(pose: RoadPose, contact: tuple[float, float], inset_m: float | None) -> Ruler:
    """The road's axes through a contact click and the ladder of heights `inset_m` behind it (None: none)."""
    axes = axes_at_contact(pose, contact)
    rungs: tuple[Rung, ...] | Said = () if inset_m is None else ladder_at_contact(pose, contact, inset_m)
    if isinstance(axes, Said) or isinstance(rungs, Said):
        reason = axes if isinstance(axes, Said) else rungs
        assert isinstance(reason, Said)
        return Ruler(ok=False, reason=reason, axes=None, ladder=[], x_m=None, y_m=None, distance_m=None)
    ladder = [
        DrawnRung(height_m=rung.height_m, points=polyline(rung.polyline_px), label=rung.label)
        for rung in rungs
    ]
    at = axes.contact_m
    away = at - pose.centre_m
    distance_m = float((away @ away) ** 0.5)
    return Ruler(
        ok=True,
        reason=None,
        axes=drawn_axes(axes),
        ladder=ladder,
        x_m=float(at[0]),
        y_m=float(at[1]),
        distance_m=distance_m,
    )


def drawn_axes(axes: Overlay) -> DrawnAxes:
    """An overlay as plain lists, for JSON."""
    x, y = axes.origin_px.tolist()
    return DrawnAxes(
        longitudinal=polyline(axes.longitudinal),
        vertical=polyline(axes.vertical),
        transversal=polyline(axes.transversal),
        origin_px=(x, y),
    )


def polyline(points_px: Floats) -> Polyline:
    """points_px (N, 2) as pairs, for JSON; nothing is computed."""
    return [(x, y) for x, y in points_px.tolist()]
