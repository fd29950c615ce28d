"""What is said is a code with values: one form stored, hashed and sent, a sentence in any language."""

import json
import pickle
from copy import deepcopy

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import TypeAdapter

from sightline.errors import BadInput
from sightline.infra.audit.hashing import canonical_json, content_hash
from sightline.infra.csv_package.columns import code_of, said_in, words_of
from sightline.infra.database.types import document_text
from sightline.infra.web.spoken import translate_body
from sightline.messages.said import Said, join_with_and, with_commas
from sightline.quality.drift.drift_job import words_of as words_of_check
from sightline.recordings.drift import DriftCheck, DriftSpan

HORIZON = Said("height-contact-above-horizon")
MOVED = Said("height-flag-camera-moved-height", moved_px=2.5, error_m=0.0142)

names = st.text("abcdefghijklmnopqrstuvwxyz_", min_size=1, max_size=6).filter(lambda name: name != "code")
plain_values = st.one_of(
    st.text(st.characters(exclude_categories=["C"]), max_size=20),
    st.integers(-(2**53) + 1, 2**53 - 1),
    st.floats(-1e15, 1e15),
)


def sayings(values: st.SearchStrategy[object]) -> st.SearchStrategy[Said]:
    return st.builds(
        lambda code, held: Said(code, **held),
        st.sampled_from(["said", "height-of-frame", "no-such-code"]),
        st.dictionaries(names, values, max_size=4),
    )


any_saying = sayings(st.one_of(plain_values, sayings(plain_values)))


@given(any_saying)
def test_what_is_stored_is_read_back_as_it_was(one: Said) -> None:
    for text in (document_text(one), canonical_json(one), code_of(one) or ""):
        assert Said.read(json.loads(text)) == one
    assert said_in(code_of([one, HORIZON]) or "") == [one, HORIZON]
    assert pickle.loads(pickle.dumps(one)) == deepcopy(one) == one
    assert content_hash({"reason": one}) == content_hash({"reason": one.document})


@given(any_saying, any_saying)
def test_two_are_equal_where_their_canonical_texts_are(one: Said, other: Said) -> None:
    assert (one == other) == (canonical_json(one) == canonical_json(other))
    assert one != other or hash(one) == hash(other)


@given(any_saying)
def test_it_always_has_words(one: Said) -> None:
    """A code that this program does not know, or with other values, is said as it is."""
    assert isinstance(str(one), str) and isinstance(one.sentence("fr"), str)


def test_words_in_the_language_of_the_reader() -> None:
    assert "(height error at these clicks: 14 mm); compute" in str(MOVED)
    french = MOVED.sentence("fr")
    assert (
        "bougé de 2,5 px après le calcul de la pose (erreur de hauteur à ces pointés\u00a0: 14 mm)" in french
    )
    within = Said("height-of-frame", frame=2, frames=3, reason=HORIZON)
    assert str(within) == f"Frame 2 of 3: {HORIZON}"
    assert HORIZON.sentence("fr") in within.sentence("fr")
    assert str(Said("height-contact-above-horizons")) == "height-contact-above-horizons"


def test_what_an_earlier_program_stored_says_itself() -> None:
    assert str(Said.read("The side plane is seen at less than 10 degrees.")).endswith("10 degrees.")
    assert Said.read("An old one.").document == {"code": "said", "values": {"sentence": "An old one."}}


def test_values_are_plain() -> None:
    one = Said("said", sentence=np.float64(2.5), n=np.int64(3), no=float("nan"), yes=True)
    assert one.document["values"] == {"sentence": 2.5, "n": 3, "no": "nan", "yes": "True"}
    assert [type(one.values[name]) for name in ("n", "sentence")] == [int, float]


def test_an_answer_holds_code_values_and_message_and_the_edge_translates_the_message() -> None:
    within = Said("height-of-frame", frame=2, frames=3, reason=HORIZON)
    body = TypeAdapter(list[Said]).dump_json([MOVED, within])
    assert json.loads(body)[0] == {**MOVED.document, "message": str(MOVED)}
    french = json.loads(translate_body(body, "fr"))
    assert [one["message"] for one in french] == [MOVED.sentence("fr"), within.sentence("fr")]
    assert french[1]["values"]["reason"]["message"] == HORIZON.sentence("fr")
    assert TypeAdapter(Said).validate_python(within.document) == within


def test_a_verdict_on_a_camera_has_its_words() -> None:
    """What was found of its movement, by each way that it may have moved."""
    still = Said("drift-still-of-height", floor_px=0.05, floor_m=0.0004)
    assert str(still) == "No camera movement detected, within 0.05 px (0.4 mm of height)."
    assert still.sentence("fr").endswith("détecté, à 0,05 px près (0,4 mm de hauteur).")
    span: DriftSpan = {
        **{"first_frame": 3, "last_frame": 9, "moved": True, "moved_px": 2.52, "u_px": 0.1, "points": 9},
        **{"x_px": 2.5, "y_px": 0.0, "turn_rad": 0.0, "scale": 1.0, "change_m": -0.0104, "distance_m": 3.0},
    }  # type: ignore[typeddict-item]
    check: DriftCheck = {"state": "moved", "spans": [span], "bumps": []}  # type: ignore[typeddict-item]
    drifted, near = words_of_check(check, float)
    assert str(near) == "The height errors are those of a target 1.2 m high, 3 m across from the camera."
    assert str(drifted) == (
        "The camera drifted at 0:03.0 (frame 3) by 2.5 px (height error up to 10 mm on the nearest road in "
        "the picture, different at other distances), frames 3 to 9."
    )
    check["bumps"] = [{"after": 1, "frame": 3, "time_s": 0.1, "by_px": 2.5}]
    assert str(words_of_check(check, float)[0]).startswith("The camera moved at 0:03.0")
    check["spans"] = [{**span, "first_frame": 0, "change_m": None, "distance_m": None}] * 5
    first, _, _, more = words_of_check(check, float)
    assert str(first) == "The camera had already moved at 0:00.0 (frame 0) by 2.5 px, frames 0 to 9."
    assert str(more) == "2 more movements."


def test_an_error_is_one_too() -> None:
    refused = BadInput("measurements-not-followed", reason=HORIZON)
    assert refused.said.values["reason"] == HORIZON and str(HORIZON) in refused.message
    assert HORIZON.sentence("fr") in refused.said.sentence("fr")


@pytest.mark.parametrize("cell", ["{", "3", '{"code":"a"}', '{"values":{},"code":[]}', '[{"code":1}]'])
def test_a_spoiled_cell_is_no_crash(cell: str) -> None:
    from sightline.errors import Damaged

    with pytest.raises(Damaged, match="a code and its values"):
        said_in(cell)


def test_a_cell_of_several_has_their_words() -> None:
    assert words_of([HORIZON, MOVED]) == f"{HORIZON}; {MOVED}"
    assert (words_of(None), words_of([]), code_of(None), code_of([]), said_in("")) == (None,) * 5


@pytest.mark.parametrize(
    ("said", "english", "french"),
    [
        (Said("stat-density-needs", least=10, count=0), "there is none.", "il n’y en a aucun."),
        (Said("stat-density-needs", least=10, count=1), "there is 1.", "il y en a 1."),
        (Said("stat-density-needs", least=10, count=2), "there are 2.", "il y en a 2."),
        (Said("stat-too-few", count=1, needed=5), "1 vehicle is too few", "1 véhicule ne suffit pas"),
        (Said("stat-too-few", count=2, needed=5), "2 vehicles are too few", "2 véhicules ne suffisent pas"),
        (Said("overview-remeasure", count=1), "1 rejected measurement.", "une mesure rejetée."),
        (Said("overview-remeasure", count=2), "2 rejected measurements.", "2 mesures rejetées."),
        (Said("passes-were-found", found=0), "No passes were found", "Aucun passage"),
        (Said("passes-were-found", found=1), "1 pass was found.", "Un passage trouvé."),
    ],
)
def test_a_number_has_the_form_that_its_language_wants(said: Said, english: str, french: str) -> None:
    assert english in str(said) and french in said.sentence("fr")


def test_a_number_of_any_size_is_said() -> None:
    """Babel refuses those of more than 13 digits before the point."""
    sizes = {1e300: "1e+300", -1e13: "-1e+13", 9e12: "9000000000000", 10**20: "1" + 20 * "0"}
    for square_m, written in sizes.items():
        assert f"A square of {written} m is" in str(Said("geometry-square-implausible", square_m=square_m))
        assert written in Said("geometry-square-implausible", square_m=square_m).sentence("fr")


def test_sayings_in_a_row_are_one_saying() -> None:
    expected = [Said("pose-expected-at", U95_height_m=0.015, distance_m=3)]
    expected.append(Said("pose-expected-at", U95_height_m=0.03, distance_m=5))
    assert with_commas(expected).sentence("fr") == "± 15 mm à 3 m, ± 30 mm à 5 m"
    assert str(join_with_and([Said("said", sentence=one) for one in "abc"])) == "a, b and c"
    assert join_with_and(expected[:1]) == with_commas(expected[:1]) == expected[0]
