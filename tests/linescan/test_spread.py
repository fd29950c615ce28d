"""The covariance of a fit: whether it covers what it says where few pieces of a vehicle err together."""

import numpy as np
import pytest

from sightline.linescan import spread
from sightline.linescan.registration import Fit, Look, Prior, State
from sightline.linescan.spread import Slopes, covariance
from sightline.linescan.warp import Course
from tests.support.proofs import every

pytestmark = pytest.mark.once
CLUSTERS, EACH = 12, 20


def _fit(jacobian: np.ndarray, residual: np.ndarray) -> Fit:
    n = len(residual)
    seen = Look(residual, jacobian, np.ones(n, bool), np.zeros(n), np.ones(n), np.ones(n))
    # a scale so wide that every weight is one: plain least squares, whose truth is known
    state = State(Course(10.0, 0.0, 0.593))
    return Fit(state, seen, np.ones(n), jacobian.T @ jacobian, 1e6, np.zeros(5), True)


def _covariance(
    first: np.ndarray, second: np.ndarray, residual: np.ndarray, cluster: np.ndarray, free: int, prior: Prior
) -> np.ndarray:
    """With residuals' derivatives as strip 1 and as strip 2 shows them, (n, 5) each."""
    slope = first[:, :free, None] * second[:, None, :free]
    slopes = Slopes(first[:, :free] * residual[:, None], slope, np.ones(free))
    return covariance(slopes, cluster, _fit(first, residual), prior)


def test_it_covers_95_per_cent_with_a_dozen_clusters_whose_errors_go_together():
    rng = np.random.default_rng(5)
    cluster = np.repeat(np.arange(CLUSTERS), EACH)
    slopes = np.zeros((len(cluster), 5))
    slopes[:, 0], slopes[:, 1] = 1.0, np.linspace(-1, 1, len(cluster))
    inside = []
    for _ in range(600):
        error = rng.normal(size=CLUSTERS)[cluster] + 0.3 * rng.normal(size=len(cluster))
        answer = np.linalg.lstsq(slopes[:, :2], error, rcond=None)[0]
        left = error - slopes[:, :2] @ answer
        told = _covariance(slopes, slopes, left, cluster, 2, Prior())
        inside.append(np.abs(answer) < 1.96 * np.sqrt(np.diag(told)))
    assert np.mean(inside, axis=0).min() > 0.93 and np.mean(inside, axis=0).max() < 0.985


def test_noise_in_the_first_gradients_does_not_make_it_surer():
    rng = np.random.default_rng(6)
    cluster = np.repeat(np.arange(40), 50)
    true = np.zeros((len(cluster), 5))
    true[:, 0] = rng.normal(size=len(cluster))
    noisy = true.copy()
    noisy[:, 0] += rng.normal(size=len(cluster))
    residual = rng.normal(size=len(cluster))
    own = _covariance(noisy, noisy, residual, cluster, 1, Prior())[0, 0]
    honest = _covariance(noisy, true, residual, cluster, 1, Prior())[0, 0]
    # the gradients' squares are twice too large by the noise, so the variance would be a quarter
    assert honest / own == pytest.approx(4.0, rel=0.25)
    expected = 2.0 / len(cluster)
    assert honest == pytest.approx(expected, rel=0.6)


def test_a_known_shift_is_as_sure_as_it_was_said_to_be():
    rng = np.random.default_rng(7)
    cluster = np.repeat(np.arange(15), 20)
    slopes = rng.normal(size=(len(cluster), 5))
    residual = rng.normal(size=len(cluster))
    free = _covariance(slopes, slopes, residual, cluster, 5, Prior())
    held = _covariance(slopes, slopes, residual, cluster, 5, Prior(0.0, 1e-3))
    assert free[2, 2] > 1e-3 and np.sqrt(held[2, 2]) == pytest.approx(1e-3, rel=0.05)


@pytest.mark.parametrize(
    "held",
    every(3, [(10, 6, 2, 2, 2, 6, 2, 2, 2, 2, 6, 8), (8, 5, 4, 4, 3, 3, 3, 3, 4, 4, 5, 7), (1,) * 12]),
)
def test_of_few_clusters_that_hold_most_it_is_right_in_the_mean_and_knows_how_it_scatters(
    monkeypatch: pytest.MonkeyPatch, held: tuple[float, ...]
):
    """A drawn car's front and rear hold more than half of what is seen."""
    asked = list[float]()
    monkeypatch.setattr(spread, "widening", lambda freedom: asked.append(freedom) or 1.0)
    rng = np.random.default_rng(8)
    cluster = np.repeat(np.arange(CLUSTERS), EACH)
    slopes = np.zeros((len(cluster), 5))
    slopes[:, 0] = np.array(held)[cluster] * rng.normal(size=len(cluster))
    slopes[:, 1] = slopes[:, 0] * np.linspace(-1, 1, len(cluster))
    seen = slopes[:, :2]
    root = np.linalg.cholesky(seen.T @ seen)
    over_true = []
    for _ in range(3000):
        error = rng.normal(size=len(cluster))
        left = error - seen @ np.linalg.lstsq(seen, error, rcond=None)[0]
        over_true.append(root.T @ _covariance(slopes, slopes, left, cluster, 2, Prior()) @ root)
    assert np.mean(over_true, axis=0) == pytest.approx(np.eye(2), abs=0.05)
    freedom = 2 * 3 / np.var(over_true, axis=0).sum()
    assert np.unique(asked) == pytest.approx([freedom], rel=0.1)
