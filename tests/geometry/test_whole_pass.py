"""Whole passes: unbiased, as certain as stated, as good as the Cramer-Rao bound allows."""

import dataclasses

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.stats import chi2, kstest

from sightline.coverage import COVERAGE_95, chance_of_larger
from sightline.geometry.followed_tracks import EXACT_PX, Following, Tracks, u_of_rounded_times
from sightline.geometry.height import shared_covariance
from sightline.geometry.multiframe import measure_frames
from sightline.geometry.road import road_point
from sightline.geometry.road_pose import BoardOnRoad, RoadPose
from sightline.geometry.whole_pass import measure_pass
from sightline.messages.said import Said
from tests.geometry.passing import CONTACT, FAR, FPS, NEAR, TARGET, Drawn, bound, covariance, frames_of, look
from tests.geometry.scenes import LENSES, pose_of
from tests.geometry.simulate import Scene
from tests.support.proofs import PROOFS

ALONE = Following(confirmed_px=0.0)


def tracks_of(scene, car, sigma=0.4, row_time=0.0, points=(0, 1, 2), noise=None, step=1):
    frame, point, t = frames_of(scene, car, points, row_time)
    every = (frame - frame.min()) % step == 0
    frame, point, t = frame[every], point[every], t[every]
    pixels = look(scene, car, point, t, row_time)
    if noise is not None:
        pixels = pixels + noise(frame, point)
    return Tracks(frame, t + 7.0, point, pixels, np.full(len(frame), sigma))


def test_what_has_no_freedom_left_contradicts_nothing() -> None:
    assert np.isnan(chance_of_larger(0.1, 0)) and np.isnan(chance_of_larger(0.1, -1))
    for value, freedom in ((0.0, 1), (3.84, 1), (40.0, 12), (900.0, 250)):
        assert chance_of_larger(value, freedom) == pytest.approx(chi2.sf(value, freedom), rel=1e-12)


@pytest.mark.parametrize("lens", LENSES)
@pytest.mark.parametrize("row_time", [0.0, 3e-5])
@pytest.mark.parametrize("way", [1, -1])
def test_exact_points_give_exact_numbers(lens, row_time, way) -> None:
    scene = Scene(lens, (0.1, -4.0, 1.5), 6.0, 5.0, 2.0)
    car = Drawn(speed=9.0 * way, ahead=-0.9 * way, wheelbase=-2.6 * way, acceleration=0.8)
    tracks = tracks_of(scene, car, row_time=row_time, sigma=0.01)
    found = measure_pass(pose_of(scene), tracks, dataclasses.replace(ALONE, row_time_s=row_time), None)
    assert found.height.status == "ok", found.height.reason
    assert found.height.height_m == pytest.approx(1.16, abs=1e-7)
    assert found.inset_m.value == pytest.approx(0.45, abs=1e-6)
    assert found.wheelbase_m.value == pytest.approx(2.6, abs=1e-6)
    assert found.heading_rad.value == pytest.approx(0.01, abs=1e-7)
    assert found.acceleration_mps2.value == pytest.approx(0.8, abs=1e-5)
    assert found.dropped == ()
    assert found.frames == len(np.unique(tracks.frame))


@pytest.mark.parametrize(
    ("inset", "measured"),
    [(-0.4, True), (0.3, True), (2.5, True), (2.8, False), (3.44, False), (-0.7, False)],
)
def test_an_inset_that_no_vehicle_has_gives_no_height_and_says_what_two_frames_say(inset, measured) -> None:
    car = Drawn(inset=inset, height=1.3)
    tracks = tracks_of(FAR, car, sigma=0.05)
    found = measure_pass(pose_of(FAR), tracks, ALONE, None)
    if measured:
        assert found.height.height_m == pytest.approx(1.3, abs=1e-6)
        assert found.inset_m.value == pytest.approx(inset, abs=1e-5)
        return
    assert (found.height.status, found.height.height_m) == ("not_measurable", None)
    assert found.inset_m is None and found.wheelbase_m is None and found.covariance == ()
    both = np.intersect1d(tracks.frame[tracks.point == CONTACT], tracks.frame[tracks.point == TARGET])
    first, last = both[[0, -1]]
    contacts, targets = (
        [tracks.points_px[(tracks.frame == n) & (tracks.point == of)][0] for n in (first, last)]
        for of in (CONTACT, TARGET)
    )
    assert found.height.reason == measure_frames(pose_of(FAR), contacts, targets, 0.05, None).height.reason
    assert f"inset of {inset:.2f} m is not plausible" in str(found.height.reason)


@settings(max_examples=500 if PROOFS else 12)
@given(
    st.floats(0.2, 3.5),
    st.floats(-0.02, 0.02),
    st.floats(0.0, 1.3),
    st.floats(0.4, 2.2),
    st.floats(2.2, 4.0),
    st.sampled_from([-1, 1]),
    st.booleans(),
)
def test_whatever_passes_is_found_again(thirds_mps, heading, inset, height, wheelbase, way, far) -> None:
    """Exact points of any vehicle, at 0.6 to 10.5 m/s: its own numbers, none dropped."""
    car = Drawn(
        heading=heading,
        speed=3.0 * thirds_mps * way,
        ahead=-0.4 * wheelbase * way,
        inset=inset,
        height=height,
        wheelbase=-wheelbase * way,
    )
    scene = FAR if far else NEAR
    frame, _, _ = frames_of(scene, car)
    found = measure_pass(pose_of(scene), tracks_of(scene, car, sigma=0.05), ALONE, None)
    if found.height.status != "ok":
        assert found.height.reason and len(np.unique(frame)) < 12  # too short a way in view
        return
    assert found.dropped == ()
    assert found.height.height_m == pytest.approx(height, abs=1e-6)
    assert found.inset_m.value == pytest.approx(inset, abs=1e-5)
    assert found.wheelbase_m.value == pytest.approx(wheelbase, abs=1e-5)


@pytest.mark.parametrize(
    ("scene", "confirmed", "drift", "passes"),
    [
        (NEAR, 0.8, 0.1, 200),
        pytest.param(NEAR, 0.8, 0.1, 400, marks=pytest.mark.proof),
        pytest.param(FAR, 0.8, 0.1, 400, marks=pytest.mark.proof),
        pytest.param(NEAR, 0.0, 0.0, 400, marks=pytest.mark.proof),
        pytest.param(FAR, 0.0, 0.0, 400, marks=pytest.mark.proof),
    ],
)
def test_scatter_bias_coverage_and_efficiency(scene, confirmed, drift, passes) -> None:
    """Against the bound of the drawn noise."""
    car, sigma = Drawn(), 0.4
    frame, point, t = frames_of(scene, car)
    begun_on = int(np.median(frame))
    cov = covariance(frame, point, sigma, confirmed, drift, begun_on)
    names, limit = bound(scene, car, frame, point, t, cov, np.deg2rad(1.0))
    root, pose, rng = np.linalg.cholesky(cov), pose_of(scene), np.random.default_rng(17)
    pixels = look(scene, car, point, t)
    following = Following(confirmed_px=confirmed, drift_px=drift, begun_on=begun_on)
    keys, rows, chances = ("height", "inset", "wheelbase", "speed"), [], []
    for _ in range(passes):
        # a heading that is as the prior has it: the bound is that of both
        seen = pixels + root @ rng.normal(size=(len(frame), 2))
        found = measure_pass(pose, Tracks(frame, t, point, seen, np.full(len(frame), sigma)), following)
        assert found.height.status == "ok", found.height.reason
        solved = (found.inset_m, found.wheelbase_m, found.speed_mps)
        rows.append(
            [(found.height.height_m, found.height.u_height_m), *((abs(s.value), s.u) for s in solved)]
        )
        chances.append(found.chance)
    values, u = np.moveaxis(np.array(rows), 2, 0)
    true = np.abs([getattr(car, key) for key in keys])
    scatter = values.std(axis=0, ddof=1)
    best = np.sqrt([limit[names.index(key), names.index(key)] for key in keys])
    assert (np.abs(values.mean(axis=0) - true) < 4 * scatter / np.sqrt(passes) + 0.03 * scatter).all()
    assert scatter == pytest.approx(u.mean(axis=0), rel=0.11)
    assert ((best / scatter) ** 2 > 0.8).all()  # the scatter of so many draws; the bench has more
    assert u.mean(axis=0) == pytest.approx(best, rel=0.03)
    inside = (np.abs(values - true) < COVERAGE_95 * u).mean(axis=0)
    assert (np.abs(inside - 0.95) < 0.033).all()
    assert kstest(chances, "uniform").pvalue > 1e-3


@pytest.mark.parametrize(
    ("scene", "passes"),
    [
        (FAR, 60),
        pytest.param(FAR, 120, marks=pytest.mark.proof),
        pytest.param(NEAR, 120, marks=pytest.mark.proof),
    ],
)
def test_places_that_count_from_the_confirmed_frame(scene, passes) -> None:
    """Shifts of all frames err; the confirmed one is where it was clicked."""
    car, sigma, rng = Drawn(), 0.4, np.random.default_rng(23)
    frame, point, t = frames_of(scene, car)
    begun_on, pose, pixels = int(np.median(frame)), pose_of(scene), look(scene, car, point, t)
    following = Following(0.0, begun_on=begun_on, matched=True)
    rows, chances = [], []
    for _ in range(passes):
        off = rng.normal(0, sigma, (len(frame), 2))
        seen = pixels + off
        for one in np.unique(point):
            seen[point == one] -= off[(point == one) & (frame == begun_on)]
        seen += rng.normal(0, EXACT_PX, seen.shape) * (frame == begun_on)[:, None]
        tracks = Tracks(frame, t, point, seen, np.full(len(frame), sigma))
        found = measure_pass(pose, tracks, following, None)  # its heading is always the same one
        assert found.height.status == "ok", found.height.reason
        rows.append((found.height.height_m - car.height, found.height.u_height_m))
        chances.append(found.chance)
    error, u = np.array(rows).T
    assert error.std() == pytest.approx(u.mean(), rel=0.2)
    assert abs((np.abs(error) < COVERAGE_95 * u).mean() - 0.95) < 0.06
    assert kstest(chances, "uniform").pvalue > 1e-3


def test_the_budget_adds_up_and_names_what_vehicles_share() -> None:
    board = BoardOnRoad(6, 4, 0.1, "top", 0.9, 0.003, 0.005, 3.0)
    a = np.random.default_rng(2).normal(size=(15, 15)) * np.array([*[0.3] * 4, *[1e-3] * 11])[:, None]
    pose = dataclasses.replace(pose_of(NEAR), covariance=a @ a.T, board=board)
    following = Following(0.7, 0.1, None, 5e-4, 2e-5, 2e-6, 0.004)
    found = measure_pass(pose, tracks_of(NEAR, Drawn(), row_time=2e-5), following)
    entries = {entry.source: entry.u_m for entry in found.height.budget}
    own = {"following", "confirmed points", "drift", "frame times"}
    shared = {"heading", "row time", "lens and pose", "board lean", "board roll", "board height"}
    assert set(entries) == own | shared
    assert found.height.u_height_m == pytest.approx(np.sqrt(sum(v**2 for v in entries.values())))
    assert found.u_random_height_m == pytest.approx(np.sqrt(sum(entries[name] ** 2 for name in own)))
    index = found.solved_for.index("height_m")
    assert found.covariance[index][index] == pytest.approx(found.height.u_height_m**2)
    (shared_m2,) = np.diag(shared_covariance(pose, [found.inset_parts]))
    assert found.inset_m.u == pytest.approx(np.hypot(found.inset_parts.u_own, np.sqrt(shared_m2)))


def test_lens_and_pose_part_equals_resolving() -> None:
    step, a = 1e-4, np.zeros((15, 15))
    a[9, 9] = step**2
    pose, tracks = pose_of(FAR), tracks_of(FAR, Drawn())
    stated = {
        entry.source: entry.u_m
        for entry in measure_pass(dataclasses.replace(pose, covariance=a), tracks, ALONE).height.budget
    }
    c, s = np.cos(step), np.sin(step)
    turn = np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
    moved = RoadPose(pose.camera, turn @ pose.rotation, turn @ pose.translation_m)
    before, after = (measure_pass(p, tracks, ALONE).height.height_m for p in (pose, moved))
    assert stated["lens and pose"] == pytest.approx(abs(after - before), rel=0.02)


def test_times_in_whole_milliseconds_are_as_uncertain_as_their_rounding() -> None:
    """A file of 29.97 frames a second whose clock ticks each millisecond: no pass disagrees with itself."""
    rng, chances = np.random.default_rng(12), []
    frame, point, t = frames_of(NEAR, Drawn())
    for _ in range(8):
        exact = t * FPS * 1.001 / 30 + rng.uniform(0, 1)
        seen = look(NEAR, Drawn(), point, exact - exact.mean()) + rng.normal(0, 0.1, (len(t), 2))
        told_s = np.round(exact, 3)
        tracks = Tracks(frame, told_s, point, seen, np.full(len(t), 0.1))
        u_s = u_of_rounded_times(told_s, 1e-3)
        assert u_s == pytest.approx(1e-3 / np.sqrt(12))
        found = measure_pass(pose_of(NEAR), tracks, Following(0.0, u_time_s=u_s), None)
        assert found.height.status == "ok" and found.dropped == ()
        assert abs(found.height.height_m - 1.16) < 4 * found.height.u_height_m
        chances.append(found.chance)
    assert min(chances) > 1e-3


@pytest.mark.parametrize(
    ("ticks", "tick_s", "of_ticks"),
    [
        ([0, 33, 67, 100], 1e-3, 1.0),
        ([0, 40, 80, 160], 1e-3, 0.0),  # 25 a second, one frame lost
        ([0, 1, 2, 4], 0.04, 0.0),  # a file that counts frames
        ([0, 1001, 2002], 1 / 30_000, 0.0),
        ([0, 33 * 16, 67 * 16], 1 / 16_000, 16.0),  # copied from one of milliseconds
        ([0, 2.5, 5.0, 7.5], 1e-3, 0.0),  # no times of this clock
        ([0], 1e-3, 0.0),
        ([0, 33, 67], 0.0, 0.0),
    ],
)
def test_whether_times_were_rounded_is_told_by_their_intervals(ticks, tick_s, of_ticks) -> None:
    time_s = 5.0 + np.array(ticks) * (tick_s or 1e-3)
    assert u_of_rounded_times(time_s, tick_s) == pytest.approx(of_ticks * tick_s / np.sqrt(12))


@pytest.mark.parametrize("way", [1, -1])
@pytest.mark.parametrize("row_time", [0.0, 3e-5])
def test_contact_and_wheelbase_are_those_of_the_frame_clicked_on_and_so_is_their_covariance(
    way, row_time
) -> None:
    car = Drawn(speed=9.0 * way, ahead=-0.9 * way, wheelbase=-2.6 * way, acceleration=-3.0 * way)
    tracks = tracks_of(NEAR, car, row_time=row_time, sigma=0.01)
    begun_on = int(np.unique(tracks.frame[tracks.point == CONTACT])[-2])
    following = Following(0.0, begun_on=begun_on, row_time_s=row_time)
    pose, step = pose_of(NEAR), 1e-4
    found = measure_pass(pose, tracks, following, None)
    at = road_point(pose, tracks.points_px[(tracks.frame == begun_on) & (tracks.point == CONTACT)][0])
    assert (found.height.x_m, found.height.y_m) == pytest.approx(tuple(at[:2]), abs=1e-6)
    assert found.height.distance_m == pytest.approx(np.linalg.norm(pose.centre_m - at), abs=1e-6)
    turned = np.zeros((15, 15))
    turned[10, 10] = step**2
    stated = measure_pass(dataclasses.replace(pose, covariance=turned), tracks, following, None)
    where = [found.solved_for.index(name) for name in TOLD]
    by_pose = np.subtract(stated.covariance, found.covariance)[np.ix_(where, where)]
    c, s = np.cos(step), np.sin(step)
    turn = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    moved = RoadPose(pose.camera, turn @ pose.rotation, turn @ pose.translation_m)
    change = np.subtract(told(measure_pass(moved, tracks, following, None)), told(found))
    scale = np.outer(np.abs(change), np.abs(change))
    assert np.abs(by_pose / scale - np.outer(change, change) / scale).max() < 0.1


TOLD = ("x_m", "y_m", "heading_rad", "speed_mps", "inset_m", "height_m", "wheelbase_m", "acceleration_mps2")


def told(found):
    height = found.height
    solved = [getattr(found, name).value for name in TOLD if name[0] not in "xy" and name != "height_m"]
    return [height.x_m, height.y_m, *solved[:3], height.height_m, *solved[3:]]


@pytest.mark.parametrize("passes", [60, *(pytest.param(n, marks=pytest.mark.proof) for n in (100, 200))])
def test_frame_times_that_jitter_are_covered(passes: int) -> None:
    rng, pose, hits = np.random.default_rng(5), pose_of(FAR), []
    frame, point, t = frames_of(FAR, Drawn())
    for _ in range(passes):
        late = dict(zip(np.unique(frame), rng.normal(0, 1e-3, len(np.unique(frame))), strict=True))
        seen = look(FAR, Drawn(), point, t + np.array([late[f] for f in frame]))
        seen = seen + rng.normal(0, 0.4, seen.shape)
        tracks = Tracks(frame, t, point, seen, np.full(len(frame), 0.4))
        found = measure_pass(pose, tracks, Following(0.0, u_time_s=1e-3))
        hits.append(abs(found.height.height_m - 1.16) < COVERAGE_95 * found.height.u_height_m)
    assert 0.91 <= np.mean(hits) <= 0.99


def test_points_that_went_astray_are_dropped_with_a_reason() -> None:
    rng = np.random.default_rng(3)
    tracks = tracks_of(NEAR, Drawn(), noise=lambda f, p: rng.normal(0, 0.4, (len(f), 2)))
    wrong = np.flatnonzero(tracks.point == TARGET)[-2:]
    pixels = tracks.points_px.copy()
    pixels[wrong] += [[6.0, 2.0], [9.0, 3.0]]
    found = measure_pass(pose_of(NEAR), dataclasses.replace(tracks, points_px=pixels), ALONE)
    assert {one.index for one in found.dropped} == set(wrong.tolist())
    assert all("px from the position given by the other frames" in str(one.reason) for one in found.dropped)
    assert {one.point for one in found.dropped} == {"target"}
    assert abs(found.height.height_m - 1.16) < 3 * found.height.u_height_m


@pytest.mark.parametrize("passes", [30, pytest.param(60, marks=pytest.mark.proof)])
def test_an_acceleration_is_solved_for_only_where_the_points_demand_it(passes: int) -> None:
    rng = np.random.default_rng(8)

    def found(acceleration):
        car = dataclasses.replace(Drawn(), acceleration=acceleration)
        noise = rng.normal(0, 0.4, (400, 2))
        return measure_pass(
            pose_of(FAR), tracks_of(FAR, car, noise=lambda f, p: noise[: len(f)]), ALONE
        ).acceleration_mps2

    assert sum(found(0.0) is not None for _ in range(passes)) <= passes // 30
    braking = found(-4.0)
    assert abs(braking.value + 4.0) < 4 * braking.u


def test_a_curved_way_is_flagged_by_chi_square() -> None:
    tracks = tracks_of(FAR, Drawn(), sigma=0.2)
    t = tracks.time_s - 7.0
    bent = tracks.points_px + np.column_stack([np.zeros(len(t)), 12.0 * t**2])
    found = measure_pass(pose_of(FAR), dataclasses.replace(tracks, points_px=bent), ALONE)
    refused = found.height.status == "not_measurable"
    assert refused or found.dropped or any("deviate from" in str(flag) for flag in found.height.flags)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda k: k.only(k.frame > 10**6), "No point was followed"),
        (lambda k: k.only(k.point != TARGET), "target was followed on 0 usable frames"),
        (lambda k: k.only(k.point != CONTACT), "contact was followed on 0 usable frames"),
        (lambda k: dataclasses.replace(k, sigma_px=0 * k.sigma_px), "not positive"),
        (lambda k: dataclasses.replace(k, time_s=k.time_s * np.nan), "not a finite number"),
        (lambda k: dataclasses.replace(k, frame=0 * k.frame), "twice on one frame"),
        (lambda k: dataclasses.replace(k, time_s=0 * k.time_s), "only 0.00 m"),
    ],
)
def test_reasons(change, words) -> None:
    found = measure_pass(pose_of(NEAR), change(tracks_of(NEAR, Drawn())), ALONE)
    assert found.height.status == "not_measurable" and words in str(found.height.reason)
    assert found.inset_m is None and found.height.height_m is None


def test_what_lies_out_of_sight_is_left_out_and_said() -> None:
    tracks = tracks_of(NEAR, Drawn())
    pixels = tracks.points_px.copy()
    pixels[0] = [-5.0, 20.0]
    found = measure_pass(pose_of(NEAR), dataclasses.replace(tracks, points_px=pixels), ALONE)
    assert [(one.index, one.reason) for one in found.dropped] == [(0, Said("followed-outside-picture"))]


def test_times_are_those_of_the_frames() -> None:
    assert measure_pass(pose_of(NEAR), tracks_of(NEAR, Drawn()), ALONE).speed_mps.value == pytest.approx(9.0)
    assert FPS == 25.0
