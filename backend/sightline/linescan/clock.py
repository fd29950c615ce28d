"""When a vehicle passed, from the line at which its front crossed camera 1, and how well that is known.

Line n was taken at n / line rate after line 0, whose time of day a person or a clock told. Of the moment of
one crossing three things are uncertain: the start, common to all vehicles of a recording; the line rate,
which adds up from the first line on; and the front's own place, known at least as well as the length between
both ends, so that u(length) / speed bounds it from above.
"""

from math import hypot, sqrt

# What is written to the millisecond is off by up to half of one, evenly.
U_WRITTEN_S = 0.001 / sqrt(12)


def since_start_s(front_line_1: float, line_rate_hz: float) -> float:
    """Seconds from line 0 to the crossing of a line."""
    return front_line_1 / line_rate_hz


def u_passing_s(
    since_s: float,
    u_start_s: float | None,
    u_line_rate_ratio: float,
    speed_mps: float | None,
    u_length_m: float | None,
) -> float | None:
    """Standard uncertainty of a time of day, seconds, as written to the millisecond.

    None without that of the start, and for a vehicle without a measured motion: how well its front is known
    is not known.
    """
    if u_start_s is None or not speed_mps or u_length_m is None:
        return None
    own_s = u_length_m / abs(speed_mps)
    return hypot(u_start_s, since_s * u_line_rate_ratio, own_s, U_WRITTEN_S)
