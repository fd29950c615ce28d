"""Renders the demonstration's videos with one process a core, in order, without holding a video in memory.

The processes are plain children that write raw frames to a pipe: a worker of the job queue may not have
children of multiprocessing's kind, and a child whose reader was killed ends by itself at its next write.

    python -m sightline.demo.rendering SCENE PART PARTS
"""

from __future__ import annotations

import fcntl
import os
import queue
import subprocess
import sys
import threading
from collections.abc import Generator
from contextlib import suppress
from dataclasses import replace
from itertools import pairwise
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from sightline.children import child_environment
from sightline.errors import SightlineError
from sightline.simulation.render import render_frame
from sightline.simulation.scene import Scene, day_scene, low_light_scene

Image = NDArray[np.uint8]
SCENES = ("day", "low_light")
MOST_PROCESSES = 8
# A frame is 0.9 MB: as many as this may wait, in each process's queue, to be encoded.
AHEAD = 64
_CHUNK = 32
_PIPE_BYTES = 1 << 20


def scene_named(name: str) -> Scene:
    """The scene "day" or "low_light"; "day:2" is only its board and first two vehicles (for tests)."""
    kind, _, vehicles = name.partition(":")
    scene = day_scene() if kind == "day" else low_light_scene()
    if not vehicles:
        return scene
    kept = scene.vehicles[: int(vehicles)]
    return replace(scene, vehicles=kept, frames=kept[-1].last_frame + 1)


def chunks_of(scene: Scene) -> list[range]:
    """All frames in pieces: one a vehicle, whose textures are then painted by one process only, and short
    ones where there is none.
    """
    cuts = sorted({0, *(vehicle.first_frame for vehicle in scene.vehicles), scene.frames})
    spans = [range(first, last) for first, last in pairwise(cuts)]
    board = [range(n, min(n + _CHUNK, spans[0].stop)) for n in range(0, spans[0].stop, _CHUNK)]
    return board + spans[1:]


def rendered(name: str, processes: int | None = None) -> Generator[Image, None, None]:
    """Frame after frame of a scene, (480, 640, 3) BGR.

    Raises SightlineError when a child breaks. Closing the generator ends the children.
    """
    scene = scene_named(name)
    parts = min(MOST_PROCESSES, processes or os.cpu_count() or 1)
    children = [_Child(scene, name, part, parts) for part in range(parts)]
    try:
        for index, chunk in enumerate(chunks_of(scene)):
            for _ in chunk:
                yield children[index % parts].next()
    finally:
        for child in children:
            child.end()


class _Child:
    """One rendering process and the thread that reads its frames ahead."""

    def __init__(self, scene: Scene, name: str, part: int, parts: int) -> None:
        command = [sys.executable, "-m", "sightline.demo.rendering", name, str(part), str(parts)]
        self._process = subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, env=child_environment()
        )
        assert self._process.stdout is not None
        with suppress(OSError, AttributeError):  # fewer turns for a frame; where it is not Linux, as it is
            fcntl.fcntl(self._process.stdout, fcntl.F_SETPIPE_SZ, _PIPE_BYTES)
        self._shape = (scene.camera.height_px, scene.camera.width_px, 3)
        self._frames: queue.Queue[Image | None] = queue.Queue(AHEAD)
        self._stopped = threading.Event()
        threading.Thread(target=self._read, name=f"rendered-{part}", daemon=True).start()

    def next(self) -> Image:
        """The next frame of this child's chunks."""
        frame = self._frames.get()
        if frame is None:
            raise SightlineError("demo-drawing-demonstration-stopped-middle-start-server")
        return frame

    def end(self) -> None:
        """Stop the process, whatever it is at."""
        self._stopped.set()
        self._process.kill()
        self._process.wait()

    def _read(self) -> None:
        assert self._process.stdout is not None
        size = int(np.prod(self._shape))
        with self._process.stdout as pipe:
            while len(data := pipe.read(size)) == size:
                self._offer(np.frombuffer(data, np.uint8).reshape(self._shape))
        self._offer(None)

    def _offer(self, frame: Image | None) -> None:
        """Put into the queue, unless nobody takes from it any more."""
        while not self._stopped.is_set():
            with suppress(queue.Full):
                self._frames.put(frame, timeout=0.5)
                return


def render_to(pipe: BinaryIO, name: str, part: int, parts: int) -> None:
    """Write the raw frames of one part."""
    import cv2

    cv2.setNumThreads(1)
    scene = scene_named(name)
    for chunk in chunks_of(scene)[part::parts]:
        for n in chunk:
            pipe.write(render_frame(scene, n).tobytes())
    pipe.flush()


if __name__ == "__main__":
    with suppress(BrokenPipeError, KeyboardInterrupt):
        render_to(sys.stdout.buffer, sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))
    # Nobody reads any more or all is said: either way nothing is left to flush.
    os._exit(0)
