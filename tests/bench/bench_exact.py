"""Who shows the right frame: `python tests/bench/bench_exact.py [names of kinds]`, a Markdown table.

For each container and codec of tests/media/clips.py a clip is written whose every frame carries its number
in the picture. 12 frames at random are asked of the frame server, of OpenCV's set(POS_FRAMES) in a process of
its own, and of Chromium's <video>: sought to the middle of the frame's own time, which only the frame table
tells, and to (n + 0.5) / rate, as annotation tools do. Counted are frames whose picture carries another
number, or none that can be read.
"""

from __future__ import annotations

import base64
import json
import random
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from playwright.sync_api import Page  # noqa: E402

from sightline.errors import SightlineError  # noqa: E402
from sightline.media.images import read_image_bgr  # noqa: E402
from sightline.media.video.decode import frames_of  # noqa: E402
from sightline.media.video.decode_host import DecodeHost  # noqa: E402
from sightline.media.video.frames import FrameServer  # noqa: E402
from sightline.media.video.ingest import Ingested, ingest  # noqa: E402
from sightline.media.video.seeker import RecordingMedia  # noqa: E402
from tests.bench.web_ground import chromium  # noqa: E402
from tests.media.clips import SPECS, Spec, cut_copy, read_number, write  # noqa: E402

ASKED = 12
TURNED_BACK = {0: None, 90: cv2.ROTATE_90_CLOCKWISE, 180: cv2.ROTATE_180, -90: cv2.ROTATE_90_COUNTERCLOCKWISE}
CUT = {"bframes.mp4": "edit list, H.264", "hevc.mp4": "edit list, HEVC"}

# Seeks a <video> and gives its pictures as PNG; null where it does not play, "" where a seek never ends.
SEEK = """async ([data, times]) => {
  const video = document.createElement('video');
  video.muted = true;
  video.preload = 'auto';
  document.body.replaceChildren(video);
  const bytes = Uint8Array.from(atob(data), (one) => one.charCodeAt(0));
  const event = (name, ms) => new Promise((done) => {
    video.addEventListener(name, () => done(true), { once: true });
    video.addEventListener('error', () => done(false), { once: true });
    setTimeout(() => done(false), ms);
  });
  const loaded = event('loadeddata', 6000);
  video.src = URL.createObjectURL(new Blob([bytes]));
  if (!(await loaded) || video.videoWidth === 0) return null;
  const canvas = document.createElement('canvas');
  canvas.width = video.videoWidth;
  canvas.height = video.videoHeight;
  const paint = canvas.getContext('2d');
  const pictures = [];
  for (const time of times) {
    const sought = event('seeked', 3000);
    video.currentTime = time;
    if (!(await sought)) { pictures.push(''); continue; }
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    paint.drawImage(video, 0, 0, canvas.width, canvas.height);
    pictures.push(canvas.toDataURL('image/png'));
  }
  return pictures;
}"""


@dataclass(frozen=True)
class Kind:
    """A clip and what its frames carry: frame n has the number first + n."""

    name: str
    path: Path
    spec: Spec
    first: int
    count: int

    def is_wrong(self, image: NDArray[np.uint8] | None, n: int) -> bool:
        if image is None:
            return True
        code = TURNED_BACK[self.spec.rotation]
        try:
            return read_number(image if code is None else cv2.rotate(image, code)) != self.first + n
        except AssertionError:
            return True


def kinds(folder: Path, wanted: Sequence[str]) -> Iterator[Kind]:
    for spec in SPECS:
        if wanted and spec.name not in wanted:
            continue
        path = write(folder / spec.name, spec)
        yield Kind(spec.name, path, spec, 0, spec.count)
        if spec.name in CUT:
            cut = cut_copy(path, folder / f"cut_{spec.name}", 1.5)
            numbers = [read_number(gray) for _, _, gray in frames_of(cut)]
            yield Kind(f"{spec.name}, {CUT[spec.name]}", cut, spec, numbers[0], len(numbers))


def ours(kind: Kind, found: Ingested, asked: Sequence[int], server: FrameServer) -> str:
    media = RecordingMedia(found.media_path, found.frames.pts, found.frames.crc32, found.frames.key)
    wrong = refused = 0
    for n in asked:
        try:
            wrong += kind.is_wrong(read_image_bgr(server.still(media, n)), n)
        except SightlineError:
            refused += 1
    return f"{wrong}" + (f", {refused} refused" if refused else "")


def opencv(kind: Kind, asked: Sequence[int], folder: Path) -> str:
    """In a process of its own: it may crash or hang."""
    command = [sys.executable, __file__, "--opencv", str(kind.path), str(folder), *map(str, asked)]
    try:
        run = subprocess.run(command, capture_output=True, text=True, timeout=60, check=True)
    except subprocess.SubprocessError as error:
        return f"ended: {type(error).__name__}"
    told = json.loads(run.stdout)
    if not told["opened"]:
        return "does not open"
    pictures = [cv2.imread(str(folder / f"{n}.png")) if n in told["got"] else None for n in asked]
    wrong = sum(kind.is_wrong(image, n) for image, n in zip(pictures, asked, strict=True))
    claim = "" if told["count"] == kind.count else f" (says {told['count']} frames, not {kind.count})"
    return f"{wrong}{claim}"


def opencv_child(path: str, folder: Path, asked: Sequence[int]) -> None:
    reader = cv2.VideoCapture(path)
    got = []
    for n in asked:
        reader.set(cv2.CAP_PROP_POS_FRAMES, n)
        is_there, image = reader.read()
        if is_there:
            cv2.imwrite(str(folder / f"{n}.png"), image)
            got.append(n)
    count = int(reader.get(cv2.CAP_PROP_FRAME_COUNT))
    print(json.dumps({"opened": reader.isOpened(), "got": got, "count": count}))


def browser(page: Page, kind: Kind, asked: Sequence[int], time_of: Callable[[int], float]) -> str:
    data = base64.b64encode(kind.path.read_bytes()).decode()
    pictures = page.evaluate(SEEK, [data, [time_of(n) for n in asked]])
    if pictures is None:
        return "does not play"
    return str(sum(kind.is_wrong(_image(text), n) for text, n in zip(pictures, asked, strict=True)))


def _image(text: str) -> NDArray[np.uint8] | None:
    if not text:
        return None
    data = np.frombuffer(base64.b64decode(text.partition(",")[2]), np.uint8)
    return np.asarray(cv2.imdecode(data, cv2.IMREAD_COLOR), np.uint8)


def row(kind: Kind, page: Page, folder: Path) -> list[str]:
    found = ingest(kind.path, lambda _: None, lambda: False, folder / "thumbs", work_dir=folder / "work")
    asked = random.Random(kind.name).sample(range(kind.count), min(ASKED, kind.count))
    host = DecodeHost(4_000_000)
    server = FrameServer(folder / "cache" / kind.path.name, 1_000_000, 4_000_000, pictures=host)
    times = np.append(found.frames.time_s, 2 * found.frames.time_s[-1] - found.frames.time_s[-2])
    middles = (times[:-1] + times[1:]) / 2
    rate = found.facts.rate_hz or 25.0
    facts = f"{kind.path.suffix[1:]}, {found.facts.codec}, {found.facts.pixel_format}"
    cells = [
        kind.name,
        facts,
        ours(kind, found, asked, server),
        opencv(kind, asked, folder),
        browser(page, kind, asked, lambda n: float(middles[n])),
        browser(page, kind, asked, lambda n: (n + 0.5) / rate),
    ]
    server.close()
    return cells


def main() -> None:
    """Write, ask, print."""
    if sys.argv[1:2] == ["--opencv"]:
        opencv_child(sys.argv[2], Path(sys.argv[3]), [int(one) for one in sys.argv[4:]])
        return
    print(f"Wrong frames of {ASKED} asked for at random\n")
    print("| clip | container, codec, pixels | Sightline | OpenCV | Chromium, frame's time | (n+0.5)/rate |")
    print("| --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as name, chromium() as launched:
        folder = Path(name)
        page = launched.new_page()
        for kind in kinds(folder, sys.argv[1:]):
            print(f"| {' | '.join(row(kind, page, folder))} |", flush=True)


if __name__ == "__main__":
    main()
