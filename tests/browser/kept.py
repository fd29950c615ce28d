"""What a test chooses for the demonstration survey is put back after it, by the API.

Files share a server and its survey. Vehicles that a test makes (`vehicles.py`) are its own and stay; so do
cameras, packages and people, which the API does not erase. Every change leaves an audit event: while the
`newest` is the same nothing has changed, and nothing is asked again.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from typing import Any

from playwright.sync_api import APIRequestContext

Answer = dict[str, Any]
#: By method and address: what is chosen there, and which version of it was seen.
Choices = dict[tuple[str, str], tuple[Answer, Answer]]

SURVEY = ("name", "site", "description", "traffic", "place", "asked", "sampling", "insets", "classes")
OF_SURVEY = {
    "": SURVEY,
    "/review-plan": ("blind_one_in",),
    "/free-plan": ("free_one_in",),
    "/standards": ("standards",),
}
RIG = (
    *("baseline_m", "u_baseline_m", "baseline_correlation", "line_rate_hz", "u_line_rate_ratio"),
    *("divergence_rad", "u_divergence_rad", "distance_m", "u_distance_m"),
    *("misalignment_px", "u_misalignment_px", "shadow_share"),
)
WAITS = ("to_review", "reopened")
ROD = ("marks", "sigma_px", "u_distance_m", "u_lean_rad")
OF_VEHICLE = {
    "facts": ("make", "model", "year", "category", "facts_source", "run_of", "lighting", "notes"),
    "boundaries": ("front_line_1", "rear_line_1", "front_line_2", "rear_line_2", "method"),
    "wheels": ("front_wheel_line", "rear_wheel_line"),
}


def picked(told: Answer, names: tuple[str, ...]) -> Answer:
    return {name: told[name] for name in names}


def ask(api: APIRequestContext, address: str) -> Any:
    answer = api.get(address, max_retries=3)
    assert answer.ok, answer.text()
    return answer.json()


def newest(api: APIRequestContext) -> int:
    """The number of the last audit event."""
    return int(ask(api, "/api/audit?limit=1")[0]["id"])


@cache
def chosen(api: APIRequestContext, survey_id: int, newest: int) -> Choices:
    """All that can be chosen for a survey, its recordings and its line scans."""
    survey, found = f"/api/surveys/{survey_id}", Choices()
    for part, names in OF_SURVEY.items():
        told = ask(api, survey + part)
        found["PUT", survey + part] = picked(told, names), picked(told, ("version",))
    for one in ask(api, f"{survey}/recordings"):
        start = {"local": one["started_local"], "time_zone": one["time_zone"]}
        of_it = {"start": start, **picked(one, ("camera_id", "pose_id", "weather"))}
        found["PUT", f"/api/recordings/{one['id']}"] = of_it, {}
    for scan in ask(api, f"{survey}/scans"):
        found |= chosen_of_scan(api, scan)
    return found


def chosen_of_scan(api: APIRequestContext, scan: Answer) -> Choices:
    address, found = f"/api/scans/{scan['id']}", Choices()
    names = {"local": "started_local", "time_zone": "time_zone", "u_s": "u_start_s"}
    start = {name: scan[of] for name, of in names.items()}
    found["PATCH", address] = {"start": start, **picked(scan["rig"], RIG)}, picked(scan, ("version",))
    if rod := ask(api, f"{address}/line-pose")["current"]:
        found["PUT", f"{address}/line-pose"] = picked(rod, ROD), picked(rod, ("revision",))
    for one in ask(api, f"{address}/vehicles"):
        seen, motion = picked(one, ("version",)), one["measurement"]
        for part, of_it in {"facts": one, "boundaries": motion, "wheels": motion}.items():
            found["PUT", f"/api/scan-vehicles/{one['id']}/{part}"] = picked(of_it, OF_VEHICLE[part]), seen
    return found


@cache
def made(api: APIRequestContext, survey_id: int, newest: int) -> dict[str, str]:
    """What can be made and taken away again: by the address that does so, the version that was seen."""
    found = {}
    for listed in ask(api, "/api/studies"):
        place = f"/api/studies/{listed['id']}"
        found[f"{place}?version="] = str(ask(api, place)["study"]["version"])
    for scan in ask(api, f"/api/surveys/{survey_id}/scans"):
        for one in ask(api, f"/api/scans/{scan['id']}/vehicles"):
            for told in one["references"]:
                place = f"/api/scan-vehicles/{one['id']}/references/{told['quantity']}/{told['source']}"
                found[f"{place}?revision="] = str(told["revision"])
        for height in ask(api, f"/api/scans/{scan['id']}/heights"):
            if not height["withdrawn"]:
                place = f"/api/scan-vehicles/{height['vehicle_id']}/heights?target={height['target']}"
                found[f"{place}&revision="] = str(height["revision"])
    return found


@cache
def verdicts(api: APIRequestContext, survey_id: int, newest: int) -> dict[str, tuple[str, Answer]]:
    """By where it is given: the verdict on each height that the asker may judge, and what it is given on."""
    me = ask(api, "/api/session")["person"]["id"]
    found: dict[str, tuple[str, Answer]] = {}
    for vehicle in ask(api, f"/api/surveys/{survey_id}/vehicles"):
        for one in vehicle["measurements"]:
            if not one["withdrawn"] and (one["created_by"] or {}).get("id") != me:
                address = f"/api/measurements/{one['id']}/reviews"
                found[address] = one["review"]["verdict"], picked(one, ("revision",))
    for scan in ask(api, f"/api/surveys/{survey_id}/scans"):
        for one in ask(api, f"/api/scans/{scan['id']}/heights"):
            if not one["mine"]:
                address = f"/api/measurements/{one['id']}/reviews"
                found[address] = one["review"]["verdict"], picked(one, ("revision",))
    return found


def send(api: APIRequestContext, method: str, address: str, body: Answer | None = None) -> None:
    answer = api.fetch(address, method=method, data=body, headers={"X-Sightline": "1"})
    assert answer.ok, f"{method} {address} {body}: {answer.text()}"


@contextmanager
def put_back(api: APIRequestContext, survey_id: int) -> Iterator[None]:
    """After what is done within, the survey is as it was before; `api` asks as an administrator."""
    of = api, survey_id, (at := newest(api))
    before, there, judged = chosen(*of), made(*of), verdicts(*of)
    lots = {one["lot"]["id"] for one in ask(api, f"/api/surveys/{survey_id}/lots")}
    yield
    if newest(api) == at:
        return
    for one in ask(api, f"/api/surveys/{survey_id}/lots"):
        step = {"open": "dissolve", "accepted": "take-back"}.get(one["state"])
        if step and one["lot"]["id"] not in lots:
            send(api, "POST", f"/api/lots/{one['lot']['id']}/{step}")
    for address, (verdict, seen) in verdicts(api, survey_id, newest(api)).items():
        if verdict not in WAITS and judged.get(address, ("",))[0] in WAITS:
            send(api, "POST", address, {"verdict": "reopened", **seen})
    for address, version in made(api, survey_id, newest(api)).items():
        if address not in there:
            send(api, "DELETE", address + version)
    for _ in range(1 + len(before)):  # one after the other: what is written has another version
        now = chosen(api, survey_id, newest(api))
        other = [place for place in before if now[place][0] != before[place][0]]
        if not other:
            return
        method, address = place = other[0]
        send(api, method, address, {**before[place][0], **now[place][1]})
    raise AssertionError(f"not put back: {other}")
