"""`sightline sightdistance`: what an eye and an object height mean for a crest curve."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from sightline.commands.options import FILE, choice_option, json_option, number_option, refuse_ignored, tell
from sightline.enums import CurveCase, SightKind
from sightline.errors import BadInput

if TYPE_CHECKING:
    from sightline.sightdistance.distances import SightDistance
    from sightline.sightdistance.workbench import Bounded

FOOT_M = 0.3048


@click.command()
@number_option("--eye", "eye_m", help="Height of the eye above the road, metres ...")
@click.option("--eye-heights", type=FILE, help="... or heights.csv: one of its percentiles.")
@number_option("--eye-percentile", default=10.0, help="Percentile of --eye-heights.")
@number_option("--object", "object_m", help="Height of the object, metres ...")
@click.option("--object-heights", type=FILE, help="... or heights.csv: one of its percentiles.")
@number_option("--object-percentile", default=5.0, help="Percentile of --object-heights.")
@number_option("--distance", "distance_m", help="Sight distance, metres ...")
@number_option("--speed", "speed_kmh", help="... or design speed, km/h, to use the sight distance of --kind.")
@choice_option(
    "--kind", of=SightKind, default="stopping", help="Sight distance that --speed is converted into."
)
@number_option("--u-eye", "u_eye_m", help="u of the eye height, metres.")
@number_option("--u-object", "u_object_m", help="u of the object height, metres.")
@number_option(
    "--grade-difference",
    "difference_percent",
    help="Grade difference, percent: also computes the length of the crest.",
)
@number_option("--headlight", "headlight_m", help="Height of the headlight, metres: also a sag.")
@number_option("--u-headlight", "u_headlight_m", help="u of the headlight's height, metres.")
@json_option
def sightdistance(
    eye_m: float | None,
    eye_heights: Path | None,
    eye_percentile: float,
    object_m: float | None,
    object_heights: Path | None,
    object_percentile: float,
    distance_m: float | None,
    speed_kmh: float | None,
    kind: SightKind,
    u_eye_m: float | None,
    u_object_m: float | None,
    difference_percent: float | None,
    headlight_m: float | None,
    u_headlight_m: float | None,
    as_json: bool,
) -> None:
    """Compute the constant and K of a crest curve from the heights of eye and object.

    Give heights, or heights.csv: its percentile of true heights with the total interval is then used, as
    printed by `sightline distribution`. Results have total 95 % intervals if the heights have; groups of the
    same name (shared_group) in both files share one error.
    """
    from sightline.sightdistance.workbench import constant_of, sight_distance, with_u
    from sightline.statistics.shared_errors import correlation_of

    if distance_m is not None and speed_kmh is not None:
        raise BadInput("commands-distance-or-speed")
    for option, other, value in (
        ("kind", "--speed", speed_kmh),
        ("u_headlight_m", "--headlight", headlight_m),
        ("eye_percentile", "--eye-heights", eye_heights),
        ("object_percentile", "--object-heights", object_heights),
    ):
        if value is None:
            refuse_ignored((option,), f"it with {other}")
    groups: dict[str, int] = {}
    eye, of_eye = _height("eye", eye_m, u_eye_m, eye_heights, eye_percentile, groups)
    thing, of_thing = _height("object", object_m, u_object_m, object_heights, object_percentile, groups)
    constant = constant_of(eye, thing, correlation_of(of_eye, of_thing, eye.u, thing.u))
    needed = None if speed_kmh is None else sight_distance(kind, speed_kmh / 3.6)
    seen_m = distance_m if needed is None else needed.distance_m
    if difference_percent is not None and seen_m is None:
        raise BadInput("commands-grade-without-distance")
    if headlight_m is not None and seen_m is None:
        raise BadInput("commands-sag-needs-distance")
    given = eye_heights is None and object_heights is None
    # of a file's percentile there is an interval alone
    u_m = (u_eye_m, u_object_m) if given else (None, None)
    answer = _answer(eye, thing, constant, u_m, seen_m) | _distance(needed, kind, constant)
    answer |= _length(constant, seen_m, difference_percent)
    if headlight_m is not None and seen_m is not None:
        answer |= _sag(with_u(headlight_m, u_headlight_m), seen_m, difference_percent)
    notes = _notes(eye, thing)
    tell(as_json, answer | ({"notes": notes} if notes else {}), *_describe_answer(answer), *notes)


def _height(
    name: str,
    value_m: float | None,
    u_m: float | None,
    heights: Path | None,
    percent: float,
    groups: dict[str, int],
) -> tuple[Bounded, dict[int, float]]:
    """A height that is given, or THE percentile of a file, and what each of the `groups` of errors moves it
    by. Raises BadInput for both, neither, or too few.
    """
    from sightline.commands.distribution import percents_of, read_groups, sample_of
    from sightline.sightdistance.workbench import Bounded, with_u
    from sightline.statistics.total_uncertainty import TotalUncertainty

    if (value_m is None) == (heights is None) or (heights is not None and u_m is not None):
        raise BadInput("commands-height-or-heights", name=name)
    if value_m is not None:
        return with_u(value_m, u_m), {}
    assert heights is not None
    ((_, asked),) = percents_of(format(percent, "g"))
    (rows,) = read_groups(heights, None)[0].values()
    if len(rows.targets) > 1:
        targets = ", ".join(sorted(rows.targets))
        raise BadInput("commands-heights-several-targets", path=heights, targets=targets)
    whole = TotalUncertainty(sample_of(rows, groups))
    found = whole.percentile(asked)
    if found.value is None:
        raise BadInput("commands-too-few-heights", path=heights, reason=found.reason or "")
    return Bounded(found.value, found.U95_low, found.U95_high, found.reason), whole.named_effects_m(asked)


def _answer(
    eye: Bounded,
    thing: Bounded,
    constant: Bounded,
    u_m: tuple[float | None, float | None],
    seen_m: float | None,
) -> dict[str, Any]:
    from sightline.sightdistance.curves import crest_constant
    from sightline.sightdistance.distances import GREEN_BOOK
    from sightline.sightdistance.workbench import k_of

    answer: dict[str, Any] = {
        **_ends("eye_m", eye),
        **_ends("object_m", thing),
        **_ends("constant", constant),
    }
    answer |= {"crest_k_m": None} if seen_m is None else _ends("crest_k_m", k_of(seen_m, constant))
    u_constant_m = crest_constant(eye.value, thing.value, *u_m).u_constant_m
    if u_constant_m is not None:
        share = u_constant_m / constant.value
        answer["u_constant"] = u_constant_m
        answer["u_crest_k_m"] = None if seen_m is None else share * answer["crest_k_m"]
    answer["distance_m"] = seen_m
    answer["source"] = f"100 (sqrt(2 eye) + sqrt(2 object))^2, K = S^2 / constant for S < L ({GREEN_BOOK})"
    return answer


def _ends(name: str, found: Bounded) -> dict[str, Any]:
    """A value and the ends of its interval, where it has one."""
    if found.low is None or found.high is None:
        return {name: found.value}
    return {name: found.value, f"{name}_U95_low": found.low, f"{name}_U95_high": found.high}


def _distance(needed: SightDistance | None, kind: SightKind, constant: Bounded) -> dict[str, Any]:
    """The distance that a design speed asks for, and K at it rounded up."""
    from sightline.sightdistance.workbench import k_of

    if needed is None:
        return {}
    names = ("stopping_distance_m", "design_stopping_distance_m")
    if kind != "stopping":
        names = ("sight_distance_m", "design_sight_distance_m")
    with_words = ", t = 2.5 s, a = 3.4 m/s^2, V in km/h" if kind == "stopping" else ""
    return {
        "kind": kind,
        names[0]: needed.distance_m,
        "formula": f"{needed.formula}{with_words} ({needed.source})",
        names[1]: needed.design_m,
        **_ends("design_crest_k_m", k_of(needed.design_m, constant)),
    }


def _length(constant: Bounded, seen_m: float | None, difference_percent: float | None) -> dict[str, Any]:
    from sightline.sightdistance.curves import crest_length
    from sightline.sightdistance.workbench import map_bounded

    if difference_percent is None or seen_m is None:
        return {}
    found = map_bounded(
        constant, lambda c: crest_length(seen_m, difference_percent, c).length_m, falling=True
    )
    return {
        "grade_difference_percent": difference_percent,
        **_ends("crest_length_m", found),
        "case": crest_length(seen_m, difference_percent, constant.value).case,
    }


def _sag(headlight: Bounded, seen_m: float, difference_percent: float | None) -> dict[str, Any]:
    """A sag that headlights light as far as one has to see."""
    from sightline.sightdistance.curves import sag_k_m, sag_length
    from sightline.sightdistance.workbench import map_bounded

    answer = _ends("headlight_m", headlight)
    answer |= _ends("sag_k_m", map_bounded(headlight, lambda h: sag_k_m(seen_m, h), falling=True))
    if difference_percent is not None:
        found = map_bounded(
            headlight, lambda h: sag_length(seen_m, difference_percent, h).length_m, falling=True
        )
        answer |= _ends("sag_length_m", found)
        answer["sag_case"] = sag_length(seen_m, difference_percent, headlight.value).case
    return answer


def _notes(eye: Bounded, thing: Bounded) -> list[str]:
    notes = [str(one.reason) for one in (eye, thing) if one.reason]
    if (eye.low is None) == (thing.low is None):
        return notes
    return [
        *notes,
        f"The {'eye' if eye.low is None else 'object'}'s height is taken as exact; give its u too.",
    ]


def _describe_answer(answer: dict[str, Any]) -> list[str]:
    def between(name: str, digits: int) -> str:
        if f"{name}_U95_low" not in answer:
            return ""
        low, high = answer[f"{name}_U95_low"], answer[f"{name}_U95_high"]
        return f", 95 % interval {low:.{digits}f} to {high:.{digits}f}"

    constant = answer["constant"]
    lines = [f"constant            {constant:.1f} m ({constant / FOOT_M:.0f} ft){between('constant', 1)}"]
    for name, label in (("stopping_distance_m", "stopping distance"), ("sight_distance_m", "sight distance")):
        if name in answer:
            lines.append(f"{label:<19} {answer[name]:.1f} m: {answer['formula']}")
    if answer["crest_k_m"] is not None:
        lines.append(
            f"K of a crest        {answer['crest_k_m']:.1f} m per percent at {answer['distance_m']:.1f} m"
            + between("crest_k_m", 1)
        )
    if "design_crest_k_m" in answer:
        rounded = answer.get("design_stopping_distance_m") or answer["design_sight_distance_m"]
        lines.append(
            f"rounded up          {answer['design_crest_k_m']:.1f} at the design distance of {rounded:.0f} m"
            + between("design_crest_k_m", 1)
        )
    if "crest_length_m" in answer:
        length = f"{answer['crest_length_m']:.1f} m ({_CASES[answer['case']]})"
        lines.append(f"length of the crest {length}{between('crest_length_m', 1)}")
    if "sag_k_m" in answer:
        lines.append(f"K of a sag          {answer['sag_k_m']:.1f} m per percent{between('sag_k_m', 1)}")
    if "sag_length_m" in answer:
        length = f"{answer['sag_length_m']:.1f} m ({_CASES[answer['sag_case']]})"
        lines.append(f"length of the sag   {length}{between('sag_length_m', 1)}")
    return lines


_CASES: dict[CurveCase, str] = {
    "S < L": "the sight distance lies within the curve",
    "S > L": "the sight distance reaches beyond the curve",
    "none": "these grades keep the sight distance without a curve",
}
