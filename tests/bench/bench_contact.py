"""Error of the contact assistant against the demonstration's truth, by day and in low light.

    python -m tests.bench.bench_contact [every]

Prints, for a pointer up to 8 px off in x and y: wheels, share refused, median, 90 % and largest error.
"""

import sys
import time

import cv2
import numpy as np

from backend.demonstration import day_scene, low_light_scene, render_frame, truth
from backend.geometry.camera import Camera
from backend.geometry.contact import Proposal, propose
from backend.geometry.road_pose import RoadPose

POINTER_PX = 8.0
FRAMES_A_WHEEL = 3


def main(every: int = 1) -> None:
    for scene in (day_scene(), low_light_scene()):
        c = scene.camera
        size = (c.width_px, c.height_px)
        lens = Camera("drawn", *size, "brown", c.fx_px, c.fy_px, c.cx_px, c.cy_px, np.array(c.distortion))
        pose = RoadPose(lens, c.rotation(), c.translation_m())
        rng = np.random.default_rng(0)
        errors, refused, took = [], 0, 0.0
        for one in truth(scene)[::every]:
            for name in ("contact_rear", "contact_front"):
                frames = [seen for seen in one.frames if name in seen.pixels]
                step = max(1, len(frames) // FRAMES_A_WHEEL)
                for seen in frames[step // 2 :: step][:FRAMES_A_WHEEL]:
                    gray = cv2.cvtColor(render_frame(scene, seen.frame), cv2.COLOR_BGR2GRAY)
                    px = np.array(seen.pixels[name])
                    began = time.perf_counter()
                    found = propose(gray, pose, px + rng.uniform(-POINTER_PX, POINTER_PX, 2))
                    took += time.perf_counter() - began
                    if isinstance(found, Proposal):
                        errors.append(float(np.hypot(*(np.array(found.contact_px) - px))))
                    else:
                        refused += 1
        count = len(errors) + refused
        median, ninety, most = np.percentile(errors, [50, 90, 100])
        print(
            f"{scene.name:10} {count:4} wheels  refused {refused / count:5.1%}  median {median:.2f} px  "
            f"90 % {ninety:.2f} px  largest {most:.2f} px  {1000 * took / count:.0f} ms each"
        )


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 1)
