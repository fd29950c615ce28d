"""`sightline sightdistance`: what an eye and an object height mean for a crest curve."""

from __future__ import annotations

from typing import Any

import click

from sightline.commands.options import json_option, print_json
from sightline.enums import CurveCase
from sightline.errors import BadInput
from sightline.sightdistance.curves import CrestConstant, crest_constant, crest_k_m, crest_length
from sightline.sightdistance.distances import GREEN_BOOK, METRIC, SightDistance, stopping_distance

FOOT_M = 0.3048


@click.command()
@click.option("--eye", "eye_m", type=float, required=True, help="Height of the eye above the road, metres.")
@click.option("--object", "object_m", type=float, required=True, help="Height of the object, metres.")
@click.option("--distance", "distance_m", type=float, help="Sight distance, metres ...")
@click.option(
    "--speed", "speed_kmh", type=float, help="... or design speed, km/h, to use its stopping sight distance."
)
@click.option("--u-eye", "u_eye_m", type=float, help="u of the eye height, metres.")
@click.option("--u-object", "u_object_m", type=float, help="u of the object height, metres.")
@click.option(
    "--grade-difference",
    "difference_percent",
    type=float,
    help="Grade difference, percent: also computes the length of the crest.",
)
@json_option
def sightdistance(
    eye_m: float,
    object_m: float,
    distance_m: float | None,
    speed_kmh: float | None,
    u_eye_m: float | None,
    u_object_m: float | None,
    difference_percent: float | None,
    as_json: bool,
) -> None:
    """Compute the constant and K of a crest curve from the heights of eye and object."""
    if distance_m is not None and speed_kmh is not None:
        raise BadInput("commands-distance-or-speed")
    stopping = None if speed_kmh is None else stopping_distance(speed_kmh * METRIC.speed_mps)
    seen_m = distance_m if stopping is None else stopping.distance_m
    crest = crest_constant(eye_m, object_m, u_eye_m, u_object_m)
    if difference_percent is not None and seen_m is None:
        raise BadInput("commands-grade-difference-needs-distance")
    answer = _answer(eye_m, object_m, seen_m, crest, stopping) | _length(crest, seen_m, difference_percent)
    notes = _notes(u_eye_m, u_object_m)
    if as_json:
        print_json(answer | ({"notes": notes} if notes else {}))
    else:
        click.echo("\n".join([*_text(answer), *notes]))


def _answer(
    eye_m: float, object_m: float, seen_m: float | None, crest: CrestConstant, stopping: SightDistance | None
) -> dict[str, Any]:
    constant = crest.constant_m
    answer: dict[str, Any] = {"eye_m": eye_m, "object_m": object_m, "constant": constant}
    answer["crest_k_m"] = None if seen_m is None else crest_k_m(seen_m, constant)
    if crest.u_constant_m is not None:
        share = crest.u_constant_m / constant
        answer["u_constant"] = crest.u_constant_m
        answer["u_crest_k_m"] = None if answer["crest_k_m"] is None else share * answer["crest_k_m"]
    answer["distance_m"] = seen_m
    if stopping is not None:
        answer["stopping_distance_m"] = stopping.distance_m
        answer["formula"] = f"{stopping.formula}, t = 2.5 s, a = 3.4 m/s^2, V in km/h ({stopping.source})"
        answer["design_stopping_distance_m"] = stopping.design_m
        answer["design_crest_k_m"] = crest_k_m(stopping.design_m, constant)
    answer["source"] = f"100 (sqrt(2 eye) + sqrt(2 object))^2, K = S^2 / constant for S < L ({GREEN_BOOK})"
    return answer


def _length(crest: CrestConstant, seen_m: float | None, difference_percent: float | None) -> dict[str, Any]:
    if difference_percent is None or seen_m is None:
        return {}
    found = crest_length(seen_m, difference_percent, crest.constant_m)
    return {
        "grade_difference_percent": difference_percent,
        "crest_length_m": found.length_m,
        "case": found.case,
    }


def _notes(u_eye_m: float | None, u_object_m: float | None) -> list[str]:
    if (u_eye_m is None) == (u_object_m is None):
        return []
    return [f"The {'eye' if u_eye_m is None else 'object'}'s height is taken as exact; give its u too."]


def _text(answer: dict[str, Any]) -> list[str]:
    u, k = answer.get("u_constant"), answer["crest_k_m"]
    lines = [
        f"constant            {answer['constant']:.1f} m ({answer['constant'] / FOOT_M:.0f} ft)"
        + (f", u {u:.1f} m" if u is not None else "")
    ]
    if "stopping_distance_m" in answer:
        lines.append(f"stopping distance   {answer['stopping_distance_m']:.1f} m: {answer['formula']}")
    if k is not None:
        u_k = answer.get("u_crest_k_m")
        lines.append(
            f"K of a crest        {k:.2f} m per percent at {answer['distance_m']:.1f} m"
            + (f", u {u_k:.2f}" if u_k is not None else "")
        )
    if "design_crest_k_m" in answer:
        rounded = answer["design_stopping_distance_m"]
        lines.append(
            f"rounded up          {answer['design_crest_k_m']:.1f} at the design distance of {rounded:.0f} m"
        )
    if "crest_length_m" in answer:
        lines.append(f"length of the crest {answer['crest_length_m']:.1f} m ({_CASES[answer['case']]})")
    return lines


_CASES: dict[CurveCase, str] = {
    "S < L": "the sight distance lies within the curve",
    "S > L": "the sight distance reaches beyond the curve",
    "none": "these grades keep the sight distance without a curve",
}
