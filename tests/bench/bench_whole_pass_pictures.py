"""Whole passes followed in pictures: goals beside what is reached, at 3 m and at 6.4 m, 640 x 480.

    python -m tests.bench.bench_whole_pass_pictures [N]             sites that nothing was set on: REPORTED
    python -m tests.bench.bench_whole_pass_pictures --training [N]  those on which the follower was set

N vehicles of each lane of each site (2), one at a time on the road, moved to 3 m or 6.4 m from the camera;
lens, camera, light, noise, speeds and vehicles follow from the site's seed (surveys.py). Every frame that
shows a contact and a target is drawn (not compressed) and followed from the confirmed one, the inset
assumed for it off by 0.1 m (eyes) or 0.05 m (lamps) at random, which the fit is told. The click that begins a
track is taken as exact, for the goals speak of the followed noise; what one of 1 px brings is told without a
goal. Drawn vehicles go exactly along the road, and the fit is told so.
Efficiency is that against the bound for the stated noise: 1 / mean((error / u)^2).
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from time import perf_counter

import cv2
import numpy as np
from scipy.stats import kstest

from sightline.coverage import COVERAGE_95
from sightline.enums import Target
from sightline.geometry.follow_pass import PassFrame, follow_pass
from sightline.geometry.followed_tracks import CONTACT, SECOND, TARGET
from sightline.geometry.whole_pass import WholePass, measure_pass
from sightline.messages.said import Said
from tests.bench.goals import Row, report, rms, row
from tests.bench.surveys import pose_of, site
from tests.simulation.render import render_frame
from tests.simulation.scene import Scene, Vehicle
from tests.simulation.truth import FramePixels, PassTruth, pass_truth

SET_ON = (701, 702, 703, *range(811, 817), *range(821, 827))
REPORTED = (831, 832, 833, 834, 835, 836)
PLACES = {"3 m": ("near", 3.0), "6.4 m": ("far", 6.4)}
TARGETS: tuple[Target, ...] = ("driver_eye", "taillight")
GOALS_MM = {"height": 3.0, "inset": 40.0, "wheelbase": 10.0}
_U_HEADING = 1e-4
_U_INSET_M = {"driver_eye": 0.10, "taillight": 0.05}


@dataclass
class Tally:
    """Of one target at one distance: errors and u, mm, in the order of GOALS_MM; chances; u with clicks of
    1 px; errors of the points along their way, px; passes without a height, by reason.
    """

    asked: int = 0
    errors: list[list[float]] = field(default_factory=list)
    stated: list[list[float]] = field(default_factory=list)
    chances: list[float] = field(default_factory=list)
    clicked_mm: list[float] = field(default_factory=list)
    off_px: list[float] = field(default_factory=list)
    seconds: list[float] = field(default_factory=list)
    lost: Counter[str] = field(default_factory=Counter)
    none: Counter[str] = field(default_factory=Counter)


def alone(scene: Scene, vehicle: Vehicle, distance_m: float) -> tuple[Scene, PassTruth]:
    """The vehicle alone on the road, so far from the camera."""
    moved = replace(vehicle, side_plane_m=scene.camera.centre_m[1] + distance_m)
    one = replace(scene, vehicles=(moved,), frames=moved.last_frame + 20)
    return one, pass_truth(one, moved)


def begun_on(scene: Scene, true: PassTruth, target: str) -> FramePixels | None:
    """The frame that a person would confirm: target and most contacts in sight, nearest to the middle."""
    some = [one for one in true.frames if one.shows(target) and one.contact]
    both = [one for one in some if {"contact_rear", "contact_front"} <= set(one.pixels)]
    middle = scene.camera.width_px / 2
    return min(
        both or some,
        key=lambda one: abs(np.mean([x for x, _ in one.pixels.values()]) - middle),
        default=None,
    )


def _measured(tally: Tally, scene: Scene, true: PassTruth, frames: list[PassFrame], target: Target,
              rng: np.random.Generator) -> None:  # fmt: skip
    first = begun_on(scene, true, target)
    if first is None or first.contact is None:
        return
    tally.asked += 1
    names = {CONTACT: first.contact, TARGET: target}
    if first.contact == "contact_rear" and "contact_front" in first.pixels:
        names[SECOND] = "contact_front"
    points = {point: first.pixels[name] for point, name in names.items()}
    spot, pose = true.spot(target), pose_of(scene)
    assumed = spot.inset_m + float(rng.normal(0, _U_INSET_M[target])), _U_INSET_M[target]
    began = perf_counter()
    found = follow_pass(pose, frames, first.frame, points, target, assumed[0], 0.0)
    tally.seconds.append(perf_counter() - began)
    if isinstance(found, Said):
        tally.none[str(found)] += 1
        return
    tally.lost += Counter(f"{one.point}: {one.reason}" for one in found.lost)
    fit = measure_pass(pose, found.tracks, found.following, _U_HEADING, assumed)
    if fit.height.height_m is None:
        tally.none[str(fit.height.reason)] += 1
        return
    left_out = {one.index for one in fit.dropped}
    tally.lost.update(f"{one.point}: contradicts the others" for one in fit.dropped)
    seen = {one.frame: one.pixels for one in true.frames}
    for i, (n, point) in enumerate(zip(found.tracks.frame, found.tracks.point, strict=True)):
        at = seen.get(int(n), {}).get(names[int(point)])
        if at is not None and i not in left_out:
            tally.off_px.append(float(np.hypot(*(found.tracks.points_px[i] - at))))
    _count(tally, fit, true, target)
    clicked = measure_pass(
        pose, found.tracks, replace(found.following, confirmed_px=1.0), _U_HEADING, assumed
    )
    tally.clicked_mm.append(1000 * (clicked.u_random_height_m or np.nan))


def _count(tally: Tally, fit: WholePass, true: PassTruth, target: str) -> None:
    spot, base = true.spot(target), true.vehicle.model.wheelbase_m
    assert fit.height.height_m is not None and fit.height.u_height_m is not None and fit.inset_m is not None
    errors = [fit.height.height_m - spot.height_m, fit.inset_m.value - spot.inset_m, np.nan]
    stated = [fit.height.u_height_m, fit.inset_m.u, np.nan]
    if fit.wheelbase_m is not None:
        errors[2], stated[2] = fit.wheelbase_m.value - base, fit.wheelbase_m.u
    tally.errors.append([1000 * one for one in errors])
    tally.stated.append([1000 * one for one in stated])
    tally.chances.append(fit.chance or 0.0)


def tallies(seeds: tuple[int, ...], count: int) -> dict[tuple[str, str], Tally]:
    out = {(place, target): Tally() for place in PLACES for target in TARGETS}
    for seed in seeds:
        scene, rng = site(seed), np.random.default_rng(seed)
        for place, (lane, distance_m) in PLACES.items():
            for vehicle in [one for one in scene.vehicles if one.lane == lane][:count]:
                one, true = alone(scene, vehicle, distance_m)
                span = range(true.frames[0].frame, true.frames[-1].frame + 1)
                grays = (cv2.cvtColor(render_frame(one, n), cv2.COLOR_BGR2GRAY) for n in span)
                frames = [PassFrame(n, n / one.fps, gray) for n, gray in zip(span, grays, strict=True)]
                for target in TARGETS:
                    _measured(out[place, target], one, true, frames, target, rng)
        print(f"site {seed} done", flush=True)
    return out


def rows_of(title: str, tally: Tally) -> Iterator[Row]:
    if not tally.errors:
        return
    errors, stated = np.array(tally.errors), np.array(tally.stated)
    yield row(f"{title}: passes with a height", "-", f"{len(errors)} of {tally.asked}", True)
    for i, (name, limit) in enumerate(GOALS_MM.items()):
        e, u = errors[:, i], stated[:, i]
        e, u = e[np.isfinite(e)], u[np.isfinite(u)]
        told = f"{rms(e):.2f} mm (n {len(e)}); mean {e.mean():+.2f}, largest {np.abs(e).max():.1f}"
        told += f", u {rms(u):.2f}"
        yield row(f"{title}, {name}: rms of the error", f"<= {limit:.0f} mm", told, rms(e) <= limit)
        z = rms(e / u)
        told = f"{1 / z**2:.2f}; z rms {z:.2f}"
        yield row(f"{title}, {name}: efficiency for the stated noise", ">= 0.9", told, 1 / z**2 >= 0.9)
        inside = float((np.abs(e) <= COVERAGE_95 * u).mean())
        yield row(f"{title}, {name}: U95 covers", ">= 0.93", f"{inside:.3f}", inside >= 0.93)
    low, p = np.mean(np.array(tally.chances) < 0.05), kstest(tally.chances, "uniform").pvalue
    told = f"{low:.3f} below 0.05; uniform at p = {p:.2g}"
    yield row(f"{title}: chi-square in order", "<= 0.07", told, low <= 0.07)
    told = f"median {np.median(tally.off_px):.2f} px, 95 % {np.percentile(tally.off_px, 95):.2f} px"
    yield row(f"{title}: followed points off by", "-", told, True)
    told = f"{np.median(tally.clicked_mm):.1f} mm; {np.median(tally.seconds):.1f} s a pass"
    yield row(f"{title}: u with clicks of 1 px that begin the tracks", "-", told, True)
    for reason, number in [*tally.none.most_common(2), *tally.lost.most_common(3)]:
        print(f"    {title}: {number} x {reason}", flush=True)


def main() -> int:
    numbers = [int(one) for one in sys.argv[1:] if one.isdigit()]
    seeds = SET_ON if "--training" in sys.argv else REPORTED
    found = tallies(seeds, numbers[0] if numbers else 2)

    def every() -> Iterator[Row]:
        for (place, target), tally in found.items():
            yield from rows_of(f"{place}, {target}", tally)

    return report([every], [])


if __name__ == "__main__":
    raise SystemExit(main())
