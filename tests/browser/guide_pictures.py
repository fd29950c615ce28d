"""Pictures of the guide, made by `make screenshots`: screens of the demonstration in each language.

Writes `docs/guide/LANGUAGE/pictures/NAME.webp`; the guide names them as `pictures/NAME.webp`, so that a page
of any language shows the screens in its own. With a data folder as first argument a copy of it is used.
"""

import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import cv2
import numpy as np
from playwright.sync_api import Browser, Page, sync_playwright

from sightline import messages
from sightline.people.service import FIRST_ADMIN

from .conftest import chromium_path, wait_for_demonstration
from .server import ROOT, Server, start
from .test_screens import SCREENS, settle

#: Of each picture: the screen that it shows (`test_screens.SCREENS`).
PICTURES = {
    "overview": "survey",
    "pose": "pose",
    "measurement": "measure",
    "review": "review",
    "statistics": "statistics",
    "study": "study",
    "scan": "scan",
}
#: Screens that are not among those, or of which more is waited for, in their place.
OWN = {
    "study": ("/study?id={study}", "[data-testid=figure-study-driver_eye] svg"),
    "pose": (SCREENS["pose"][0], "[data-testid=found-board]"),
}
#: What is pressed first: a measurement whose points are shown, not one that is clicked blind.
PRESSED = {"review": ".review__row:has-text('±')"}
#: What is brought to the top of the picture first.
SCROLLED_TO = {"statistics": "[data-testid=target-driver_eye]"}
WIDTH_PX, HEIGHT_PX = 1280, 800
MOST_BYTES = 60_000
PATIENCE_MS = 300_000
QUALITIES = range(85, 20, -5)


def picture_of(png: bytes) -> bytes:
    """As WebP of at most MOST_BYTES. Raises ValueError where no quality gives that."""
    image = cv2.imdecode(np.frombuffer(png, np.uint8), cv2.IMREAD_COLOR)
    assert image is not None
    for quality in QUALITIES:
        _, made = cv2.imencode(".webp", image, [cv2.IMWRITE_WEBP_QUALITY, quality])
        if len(made) <= MOST_BYTES:
            return made.tobytes()
    raise ValueError(f"the picture is larger than {MOST_BYTES} bytes at quality {QUALITIES[-1]}")


def places_of(page: Page) -> dict[str, int]:
    """The demonstration survey and a vehicle of it with three heights."""
    survey, me = wait_for_demonstration(page), page.request.get("/api/session").json()
    while any(page.request.get(f"/api/jobs?state={state}").json() for state in ("queued", "running")):
        time.sleep(1)  # pictures show a survey at rest
    vehicles = page.request.get(f"/api/surveys/{survey}/vehicles").json()
    measured = next(one for one in vehicles if len(one["measurements"]) >= 3)
    return {
        "survey": survey,
        "study": page.request.get("/api/studies").json()[0]["id"],
        "recording": measured["recording_id"],
        "vehicle": measured["id"],
        "frame": measured["measurements"][0]["frame"],
        "person": me["person"]["id"],
    }


def sign_in_link(server: Server) -> str:
    """What the server printed, if its database is new; else a link made by the command."""
    link = re.compile(r"(/sign-in\?token=[\w.~-]+)")
    if printed := link.search(server.log.read_text()):
        return printed[1]
    command = [sys.executable, "-m", "sightline.cli", "sign-in-link", FIRST_ADMIN[1], "--data-dir"]
    done = subprocess.run([*command, str(server.data_dir)], capture_output=True, text=True, check=True)
    made = link.search(done.stdout + done.stderr)
    assert made, done.stdout
    return made[1]


def take_all(browser: Browser, server: Server) -> None:
    signed_in = browser.new_context(base_url=server.url)
    signed_in.set_default_timeout(PATIENCE_MS)  # the demonstration may still be drawn
    page = signed_in.new_page()
    page.goto(sign_in_link(server))
    page.wait_for_url(lambda url: "sign-in" not in url)
    places, state = places_of(page), signed_in.storage_state()
    signed_in.close()
    for language in messages.languages():
        context = browser.new_context(
            base_url=server.url,
            viewport={"width": WIDTH_PX, "height": HEIGHT_PX},
            storage_state=state,
            locale="en-GB" if language == messages.SOURCE else language,
            reduced_motion="reduce",
            bypass_csp=True,  # what waits for the page is a script of ours
        )
        # the tour was offered before
        context.add_init_script(f"localStorage.setItem('sightline.tour', '[{places['person']}]')")
        take(context.new_page(), places, ROOT / "docs" / "guide" / language / "pictures")
        context.close()


def take(page: Page, places: dict[str, int], folder: Path) -> None:
    folder.mkdir(exist_ok=True)
    for name, screen in PICTURES.items():
        address, sign = OWN.get(screen) or SCREENS[screen]
        page.goto(address.format(**places))
        page.locator(sign).first.wait_for()
        settle(page)
        if name in PRESSED:
            page.locator(PRESSED[name]).first.click()
            settle(page)
        if name in SCROLLED_TO:
            page.locator(SCROLLED_TO[name]).evaluate("one => one.scrollIntoView()")
        page.wait_for_timeout(1000)
        made = picture_of(page.screenshot())
        (folder / f"{name}.webp").write_bytes(made)
        print(f"{folder.parent.name}/{name}: {len(made)} bytes")


def main() -> None:
    given = Path(sys.argv[1]) if len(sys.argv) > 1 else None
    with tempfile.TemporaryDirectory() as folder:
        data_dir = Path(folder) / "data"
        if given is not None:
            shutil.copytree(given, data_dir)
        server = start("demo", data_dir)
        try:
            server.wait(300)
            with sync_playwright() as playwright:
                browser = playwright.chromium.launch(executable_path=chromium_path(), args=["--no-sandbox"])
                take_all(browser, server)
        finally:
            server.stop()


if __name__ == "__main__":
    main()
