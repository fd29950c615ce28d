"""Adjustment by the traffic: what is left of the shared uncertainty, and whether it covers; goal beside
reached.

    python tests/bench/bench_adjustment.py [SURVEYS] [PART ...]

Each survey is drawn afresh by tests/adjustment/survey.py, which shares no code with what is tested: lens
and pose by a draw of their stated covariance, lean, roll, height and square of the board, the catalogue's
common error, every vehicle's own. Heights are of an eye at 6.4 m, clicked without error: what is left is
the shared part.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from tests.adjustment.cases import EYE_M, Case, case  # noqa: E402
from tests.adjustment.survey import BoardBudget, Fleet  # noqa: E402
from tests.bench.goals import Row, report, rms, row  # noqa: E402

SURVEYS = 500
FLEETS = {
    "50 vehicles, u(wheelbase) 10 mm": Fleet(),
    "the same, 5 % wrong models": Fleet(u_roof=0.01, wrong_share=0.05),
    "the same, 1 % of points 15 px off": Fleet(blunder_share=0.01),
    "20 vehicles, roofs to 10 mm alone": Fleet(20, u_wheelbase=None, u_roof=0.01),
    "100 vehicles, u(wheelbase) 20 mm": Fleet(100, u_wheelbase=0.02),
}


def error(one: Case) -> float:
    assert one.after.height_m is not None
    return one.after.height_m - EYE_M


def u_of(one: Case) -> float:
    assert one.after.u_height_m is not None
    return one.after.u_height_m


def coverage() -> Iterator[Row]:
    for number, (name, fleet) in enumerate(FLEETS.items()):
        cases = [case(fleet, 1000 * number + seed) for seed in range(SURVEYS)]
        before = np.mean([one.before.u_height_m for one in cases])
        u, errors = np.array([u_of(one) for one in cases]), np.array([error(one) for one in cases])
        share = float((np.abs(errors) <= 1.96 * u).mean())
        reached = f"{1e3 * before:.1f} -> {1e3 * u.mean():.2f} mm, rms error {1e3 * rms(errors):.2f} mm"
        limit = 0.003 if number == 0 else 0.006
        yield row(f"{name}: u(eye)", f"{1e3 * limit:.0f} mm", reached, u.mean() <= limit)
        chance = 1.96 * (0.95 * 0.05 / SURVEYS) ** 0.5
        reached = f"{share:.3f} (+- {chance:.3f} by chance)"
        ok = abs(share - 0.95) <= 0.01 + chance
        yield row(f"{name}: U95 covers, {SURVEYS} surveys", "0.95 +- 0.01", reached, ok)
        if fleet.wrong_share:
            yield from named(name, cases)


def named(name: str, cases: list[Case]) -> Iterator[Row]:
    wrong = sum(len(one.wrong) for one in cases)
    told = [{left.name for left in one.adjustment.left_out} for one in cases]
    hit = sum(len(out & set(one.wrong)) for out, one in zip(told, cases, strict=True))
    false = sum(len(out - set(one.wrong)) for out, one in zip(told, cases, strict=True))
    vehicles = sum(one.adjustment.passes for one in cases)
    reached = f"{hit} of {wrong}; of {vehicles - wrong} right ones {false}"
    yield row(
        f"{name}: wrong models named",
        ">= 80 %, <= 1 %",
        reached,
        hit >= 0.8 * wrong and false <= 0.01 * vehicles,
    )


def tilted() -> Iterator[Row]:
    """A board that leans by 10 mrad where it was said to lean by nothing to speak of."""
    for u in (0.005, 0.001, 0.0):
        cases = [case(Fleet(), seed, replace(BoardBudget(), lean=u), 0.01) for seed in range(40)]
        before = rms([one.before.height_m - EYE_M for one in cases if one.before.height_m is not None])
        after = rms([error(one) for one in cases])
        reached = f"{1e3 * before:.1f} -> {1e3 * after:.2f} mm rms"
        yield row(f"board tilted by 10 mrad, stated {1e3 * u:.0f} mrad", "3 mm", reached, after <= 0.003)


def tight() -> Iterator[Row]:
    """A good lens and many frames, so that only the board's lean is in doubt: then the tilt has a name."""
    budget = BoardBudget(
        lean=0.001, noise_px=0.01, lens=(0.05, 0.05, 0.05, 0.05, 1e-4, 1e-4, 1e-5, 1e-5, 1e-4)
    )
    cases = [case(Fleet(), seed, budget, 0.01) for seed in range(40)]
    said = np.mean([any("board_lean_rad" in note for note in one.adjustment.notes) for one in cases])
    after = rms([error(one) for one in cases])
    reached = f"named in {100 * said:.0f} %, {1e3 * after:.2f} mm rms"
    yield row("tilt of 10 mrad, stated 1, lens known", "95 %, 3 mm", reached, said >= 0.95 and after <= 0.003)


def nothing_known() -> Iterator[Row]:
    cases = [case(Fleet(u_wheelbase=None), seed) for seed in range(3)]
    shares = [u_of(one) / (one.before.u_height_m or 1.0) for one in cases]
    yield row("nothing known: u after / u before", "1", f"{min(shares):.6f}", abs(min(shares) - 1.0) < 1e-6)


if __name__ == "__main__":
    numbers = [int(word) for word in sys.argv[1:] if word.isdigit()]
    SURVEYS = numbers[0] if numbers else SURVEYS
    wanted = [word for word in sys.argv[1:] if not word.isdigit()]
    sys.exit(report([coverage, tilted, tight, nothing_known], wanted))
