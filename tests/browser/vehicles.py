"""A vehicle of each test's own, over a pass of the demonstration: what one test stores is in no other's way.

The scene's truth says where the vehicle is in the picture; the application itself never reads it.
"""

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Literal, get_args

from playwright.sync_api import Page, expect
from sqlalchemy import update

from sightline.demo.made import TRUTH
from sightline.enums import ProposedPoint
from sightline.infra.services import open_services
from sightline.recordings.store import get_recording
from sightline.settings import load_settings
from sightline.vehicles.proposing.plan_store import choose_free_plan, get_free_plan
from sightline.vehicles.proposing.records import PointProposal
from sightline.vehicles.proposing.store import replace_proposals
from sightline.vehicles.proposing.tables import proposals

from .conftest import wait_for_demonstration
from .picture import on_screen
from .server import Server
from .waits import wait_until

SceneName = Literal["day", "low_light"]
LIGHTING: dict[SceneName, str] = {"day": "daytime", "low_light": "low_light"}
TARGETS = ("roof", "driver_eye", "taillight")
#: Of each scene, the place of a car (no lorry, whose tyres and lamps are others) of which all is seen.
USUAL: dict[SceneName, int] = {"day": 7, "low_light": 1}
Pixel = tuple[float, float]


@dataclass(frozen=True)
class OwnVehicle:
    """A vehicle without measurements or facts, and where its points are on a frame that shows them all."""

    survey: int
    vehicle: dict[str, Any]
    truth: dict[str, Any]
    frame: int
    pixels: dict[str, Pixel]

    @property
    def address(self) -> str:
        recording = self.vehicle["recording_id"]
        return (
            f"/surveys/{self.survey}/measure?recording={recording}&vehicle={self.vehicle['id']}"
            f"&frame={self.frame}"
        )


def scene_truth(scene: SceneName) -> dict[str, Any]:
    """A scene's truth as the renderer wrote it."""
    found: dict[str, Any] = json.loads(TRUTH.read_text())["scenes"][scene]
    return found


def recording_of(page: Page, survey: int, scene: SceneName) -> dict[str, Any]:
    """The demonstration's recording of a scene."""
    recordings = page.request.get(f"/api/surveys/{survey}/recordings").json()
    found: dict[str, Any] = next(one for one in recordings if one["lighting"] == LIGHTING[scene])
    return found


def whole_frames(one: dict[str, Any]) -> list[dict[str, Any]]:
    """A pass's frames that show its rear contact and all targets uncovered, those nearest its best first."""
    found = [
        frame
        for frame in one["frames"]
        if {"contact_rear", *TARGETS} <= set(frame["pixels"]) and not set(TARGETS) & set(frame["hidden"])
    ]
    return sorted(found, key=lambda frame: abs(int(frame["frame"]) - int(one["best_frame"])))


def whole_passes(scene: SceneName) -> list[dict[str, Any]]:
    """The passes of a scene that have such a frame."""
    return [one for one in scene_truth(scene)["passes"] if whole_frames(one)]


def own_vehicle(page: Page, scene: SceneName = "low_light", over: dict[str, Any] | None = None) -> OwnVehicle:
    """A new vehicle over a pass of the scene: over a usual car that can be seen whole, unless told which."""
    survey = wait_for_demonstration(page)
    one = over or scene_truth(scene)["passes"][USUAL[scene]]
    made = page.request.post(
        f"/api/recordings/{recording_of(page, survey, scene)['id']}/vehicles",
        headers={"X-Sightline": "1"},
        data={
            **{name: one[name] for name in ("first_frame", "last_frame", "best_frame")},
            "direction": "right" if one["direction"] > 0 else "left",
        },
    )
    assert made.ok, made.text()
    frame = whole_frames(one)[0]
    pixels = {name: (x, y) for name, (x, y) in frame["pixels"].items()}
    return OwnVehicle(survey, made.json(), one, int(frame["frame"]), pixels)


def put_proposals(
    server: Server, ones: Sequence[OwnVehicle], targets: Sequence[str] = ("roof", "taillight")
) -> None:
    """Proposes the rear contact and targets of vehicles of one recording where they are; eyes are refused."""
    made = [proposal for one in ones for proposal in proposals_of(one, targets)]
    services = open_services(load_settings(data_dir=server.data_dir))
    try:
        with services.writing() as session:
            recording_id = int(ones[0].vehicle["recording_id"])
            pose_id = get_recording(session, recording_id).pose_id
            assert pose_id is not None
            plan = get_free_plan(session, ones[0].survey)
            choose_free_plan(session, ones[0].survey, free_one_in=0, version=plan.version, actor=None)
            replace_proposals(session, recording_id, pose_id, made, actor=None)
    finally:
        services.close()


def draw_free(server: Server, one: OwnVehicle) -> None:
    """Has a vehicle with proposals measured free, as if the server had drawn it."""
    services = open_services(load_settings(data_dir=server.data_dir))
    try:
        with services.writing() as session:
            of = proposals.c.vehicle_id == one.vehicle["id"]
            session.execute(update(proposals).where(of).values(withheld=True))
    finally:
        services.close()


def proposals_of(one: OwnVehicle, targets: Sequence[str]) -> list[PointProposal]:
    """The points of a vehicle's truth as proposals."""
    made: list[PointProposal] = []
    for point in get_args(ProposedPoint):
        at = one.pixels[point] if point == "contact_rear" or point in targets else None
        made.append(
            PointProposal(
                vehicle_id=one.vehicle["id"],
                point=point,
                frame=one.frame,
                point_px=at,
                expected_px=None if at is None else 0.4,
                reason="proposals-eye-not-seen" if at is None else None,
            )
        )
    return made


def stored(page: Page, vehicle_id: int) -> dict[str, dict[str, Any]]:
    """What the server has of a vehicle and has not withdrawn, by target."""
    vehicle = page.request.get(f"/api/vehicles/{vehicle_id}").json()
    standing = [m for m in vehicle["measurements"] if not m["withdrawn"]]
    assert len(standing) == len({m["target"] for m in standing}), standing
    return {m["target"]: m for m in standing}


def until(page: Page, vehicle_id: int, wanted: Callable[[dict[str, dict[str, Any]]], bool]) -> None:
    """Waits until what the server has of a vehicle is as wanted."""
    wait_until(page, lambda: wanted(stored(page, vehicle_id)), lambda: stored(page, vehicle_id))


def until_stored(page: Page, vehicle_id: int, field: str, wanted: object) -> None:
    """Waits until the server has what was said of a vehicle."""

    def found() -> object:
        return page.request.get(f"/api/vehicles/{vehicle_id}").json()[field]

    wait_until(page, lambda: found() == wanted, found)


def click_at(page: Page, pixel: Pixel) -> None:
    """Moves the pointer to an image pixel and clicks."""
    x, y = on_screen(page, pixel)
    page.mouse.move(x, y)
    page.mouse.click(x, y)


def open_pass(page: Page, number: int) -> None:
    """Clicks a pass in the list once the current one is in sight: the list scrolls a frame after it."""
    expect(page.locator(".passes .pass[aria-current=true]")).to_be_in_viewport(ratio=0.9)
    page.get_by_test_id(f"pass-{number}").click()
