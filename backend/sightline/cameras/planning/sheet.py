"""The set-up sheet of a planned site: one page with the drawing to scale, the numbers, and a check list."""

import json
from math import degrees, pi, tan
from pathlib import Path
from typing import Any

from sightline.geometry.camera import Camera
from sightline.geometry.plan import Plan
from sightline.geometry.site import BOARD_TOP_M, PLANNING_BOARD
from sightline.messages import SOURCE, Value, say

_TEMPLATE = Path(__file__).parent / "sheet.typ"
_XY = tuple[float, float]
# A passenger car for the drawing only: width and length.
_CAR_M = (1.75, 4.3)
# Room in the drawings on the far side, and on the near one for the camera.
_ROOM_M, _NEAR_M = 0.3, 0.12
_CHECKS = (
    "sheet-check-calibrated",
    "sheet-check-board",
    "sheet-check-place",
    "sheet-check-exposure",
    "sheet-check-stood",
    "sheet-check-row",
    "sheet-check-filmed",
    "sheet-check-watch",
    "sheet-check-own",
    "sheet-check-again",
)
# What is written down on the day alone.
_ASKED = ("sheet-row", "sheet-zoom", "sheet-exposure", "sheet-start", "sheet-traffic", "sheet-weather")


def sheet_pdf(
    plan: Plan,
    camera: Camera,
    survey: str,
    site: str,
    *,
    field_of_view_deg: float | None = None,
    language: str = SOURCE,
) -> bytes:
    """The sheet of a plan as PDF, in a language of the catalogue.

    `survey`, `site`: their names. `field_of_view_deg`: of a camera that is not calibrated yet, else None.
    """
    from sightline.infra.typesetting.pdf import set_pdf  # here, so that a server starts without Typst

    values = _Sheet(plan, camera, field_of_view_deg, language).values(survey, site)
    written = json.dumps(values, ensure_ascii=False).encode()
    return set_pdf({"main.typ": _TEMPLATE.read_bytes(), "values.json": written}, 0)


class _Sheet:
    """What stands on the sheet, in one language."""

    def __init__(self, plan: Plan, camera: Camera, field_of_view_deg: float | None, language: str) -> None:
        self.plan, self.camera, self.language = plan, camera, language
        self.field_of_view_deg = field_of_view_deg
        site = plan.site
        self.far_m = max(site.distance_m + _CAR_M[0], site.board_m) + _ROOM_M

    def say(self, key: str, **values: Value) -> str:
        return say(key, values, self.language)

    def metres(self, length_m: float) -> str:
        return self.say("sheet-metres", metres=length_m)

    def values(self, survey: str, site: str) -> dict[str, Any]:
        checks = [self.say(key) for key in _CHECKS]
        return {
            "lang": self.language,
            "title": self.say("sheet-title"),
            "of": self.say("sheet-of", survey=survey, site=site) if site else survey,
            "lead": self.say("sheet-lead"),
            "planned": self.say("sheet-planned"),
            "built": self.say("sheet-built"),
            "wide_m": _NEAR_M + self.far_m,
            "drawings": [self.along(), self.above()],
            "facts": self.facts(),
            "targets": self.targets(),
            "passing": self.passing(),
            "checks": {"title": self.say("sheet-checks"), "items": checks},
        }

    def facts(self) -> list[tuple[str, str]]:
        site = self.plan.site
        size = {"width_px": self.camera.width_px, "height_px": self.camera.height_px}
        planned = [
            ("planning-camera", self.say("sheet-camera-value", name=self.camera_name(), **size)),
            ("planning-camera-height", self.metres(site.camera_height_m)),
            ("planning-distance", self.metres(site.distance_m)),
            ("planning-board-distance", self.metres(site.board_m)),
            ("planning-direction", self.say("sheet-degrees", degrees=round(degrees(site.direction_rad), 1))),
        ]
        return [(self.say(key), value) for key, value in planned] + [(self.say(key), "") for key in _ASKED]

    def camera_name(self) -> str:
        """Its own; of a plain camera the field of view that was planned with."""
        if self.field_of_view_deg is None:
            return self.camera.name
        return self.say("sheet-camera-plain", degrees=self.field_of_view_deg)

    def targets(self) -> dict[str, Any]:
        rows = []
        for target in self.plan.targets:
            U95_m = target.result.U95_height_m
            value = "sheet-none" if U95_m is None else "sheet-millimetres"
            values = {} if U95_m is None else {"millimetres": 1000.0 * U95_m}
            rows.append(
                [
                    self.say(f"planning-target-{target.target}"),
                    self.metres(target.height_m),
                    self.say(value, **values),
                ]
            )
        head = [self.say("planning-target"), self.say("planning-planned-height"), "U95"]
        return {"title": self.say("planning-targets-title"), "head": head, "rows": rows}

    def passing(self) -> dict[str, Any]:
        rows = [
            [
                self.say("sheet-kmh", kmh=3.6 * passing_row.speed_mps),
                self.say("planning-passing-fraction", part=passing_row.shutter),
                self.say("sheet-blur", pixels=passing_row.blur_px),
                str(passing_row.frames[0]),
            ]
            for passing_row in self.plan.passing
        ]
        head = [self.say(f"planning-passing-{name}") for name in ("speed", "exposure", "blur", "frames-30")]
        return {"title": self.say("planning-passing-title"), "head": head, "rows": rows}

    def along(self) -> dict[str, Any]:
        """The cross-section: metres to the right of the camera's foot, and down from the drawing's top."""
        plan, site = self.plan, self.plan.site
        roof = max(one.height_m for one in plan.targets)
        top = max(roof, site.camera_height_m, BOARD_TOP_M) + 0.2

        def at(x: float, up: float) -> _XY:
            return _NEAR_M + x, top - up

        car = [(0.0, 0.2), (0.0, 0.85), (0.06, 0.98), (0.3, roof - 0.05), (0.42, roof)]
        outline = [*car, *((_CAR_M[0] - x, up) for x, up in reversed(car))]
        low = BOARD_TOP_M - (PLANNING_BOARD.rows - 1) * PLANNING_BOARD.square_m
        foot, camera = at(0.0, 0.0), at(0.0, site.camera_height_m)
        return self.drawn(
            "along",
            height_m=top + 0.05,
            camera=camera,
            areas=[self.view(plan.outlook.top_rad, plan.outlook.bottom_rad, site.camera_height_m, at)],
            outlines=[[at(site.distance_m + x, up) for x, up in outline]],
            lines=[(foot, at(self.far_m, 0.0)), (foot, camera)],
            board=[(at(site.board_m, low - 0.1), at(site.board_m, BOARD_TOP_M + 0.1))],
            points=[at(site.distance_m + one.inset_m, one.height_m) for one in plan.targets],
            words=[("planning-camera-height", site.camera_height_m), ("planning-distance", site.distance_m)],
        )

    def above(self) -> dict[str, Any]:
        """From above: metres across the road to the right of the camera, and along it downwards."""
        plan, site = self.plan, self.plan.site
        aside = site.distance_m * tan(site.direction_rad)
        half = 0.5 * _CAR_M[1] + 0.2
        top, bottom = max(half, aside + half), max(half, half - aside)

        def at(across: float, along: float) -> _XY:
            return _NEAR_M + across, top - along

        length, width = 0.5 * _CAR_M[1], _CAR_M[0]
        corners = [(0.0, -length), (width, -length), (width, length), (0.0, length)]
        board_at = site.board_m * tan(site.direction_rad)
        board = 0.5 * (PLANNING_BOARD.columns + 1) * PLANNING_BOARD.square_m
        return self.drawn(
            "above",
            height_m=top + bottom,
            camera=at(0.0, 0.0),
            areas=[self.view(plan.outlook.right_rad, plan.outlook.left_rad, 0.0, at)],
            outlines=[[at(site.distance_m + x, aside + y) for x, y in corners]],
            lines=[(at(site.distance_m, top), at(site.distance_m, -bottom))],
            board=[(at(site.board_m, board_at - board), at(site.board_m, board_at + board))],
            points=[],
            words=[("planning-board-distance", site.board_m)],
        )

    def drawn(self, which: str, *, words: list[tuple[str, float]], **parts: Any) -> dict[str, Any]:
        title = self.say(f"planning-{which}-title")
        told = [
            self.say("sheet-metres-in-words", what=self.say(key), metres=length_m) for key, length_m in words
        ]
        return {"title": title, "alt": f"{title}. {'; '.join(told)}", "words": told, **parts}

    def view(self, one_rad: float | None, other_rad: float | None, from_m: float, at: Any) -> list[_XY]:
        """What the picture shows, as far as the drawing goes; empty where the lens has no such direction."""
        if one_rad is None or other_rad is None:
            return []
        ends = [min(max(angle, 0.02 - 0.5 * pi), 0.5 * pi - 0.02) for angle in (one_rad, other_rad)]
        return [at(0.0, from_m), *(at(self.far_m, from_m + self.far_m * tan(angle)) for angle in ends)]
