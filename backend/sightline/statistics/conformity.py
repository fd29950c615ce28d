"""Whether a measured value keeps a limit, decided with guard bands on both sides (JCGM 106:2012, 8.3).

The value is taken as normal about what was measured, with its standard uncertainty. An answer is given only
where the chance that it is false is no larger than the risk that was stated: w = z(1 - risk) u away from the
limit on either side. Between, nothing is decided. The risk is that of this one answer (specific risk, JCGM
106:2012, 9.3.2), for nothing is known of the values that others have.
"""

from dataclasses import dataclass
from math import isfinite

import scipy

from sightline.enums import Conformity, LimitSide
from sightline.errors import BadInput

#: Risks that may be stated. At a half there is no guard band, and a coin decides at the limit.
LEAST_RISK, MOST_RISK = 1e-6, 0.49


@dataclass(frozen=True, slots=True)
class Decision:
    """An answer and what it rests on; `guard_band` and the two bounds are in the unit of the value.

    conforming: on the good side of `conforming_to`; not conforming: beyond `not_conforming_from`. `factor`:
    the guard band over u. `chance_false`: that the answer is false; of undecided, that the better one were.
    """

    answer: Conformity
    factor: float
    guard_band: float
    conforming_to: float
    not_conforming_from: float
    chance_false: float


def require_risk(risk: float) -> None:
    """Raises BadInput for a risk out of LEAST_RISK to MOST_RISK."""
    if not LEAST_RISK <= risk <= MOST_RISK:
        raise BadInput("statistics-risk-cannot-be", risk=f"{risk:g}", least=LEAST_RISK, most=MOST_RISK)


def decide(value: float, u: float, limit: float, side: LimitSide, risk: float) -> Decision:
    """The answer for a value (any unit, the same for u and limit) against an upper or a lower limit.

    Raises BadInput for a risk that cannot be, ValueError for numbers that are none or a u that is not above
    0. JCGM 106:2012, 8.3.2 and 8.3.3.
    """
    require_risk(risk)
    if not (isfinite(value) and isfinite(limit) and isfinite(u) and u > 0):
        raise ValueError("a decision needs a value, a limit and a standard uncertainty above 0")
    sign = 1.0 if side == "upper" else -1.0
    factor = float(scipy.stats.norm.isf(risk))
    beyond_u = sign * (value - limit) / u
    answer: Conformity = "undecided"
    if beyond_u <= -factor:
        answer = "conforming"
    elif beyond_u >= factor:
        answer = "not_conforming"
    return Decision(
        answer=answer,
        factor=factor,
        guard_band=factor * u,
        conforming_to=limit - sign * factor * u,
        not_conforming_from=limit + sign * factor * u,
        chance_false=float(scipy.stats.norm.sf(abs(beyond_u))),
    )
