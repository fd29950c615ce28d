"""What commands print as JSON is one whole object, in which a number that there is not is null."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

from sightline.commands.options import json_text, print_json
from sightline.messages.said import Said


def test_a_number_that_is_not_finite_is_null() -> None:
    found = {"u_m": math.nan, "ends": (-math.inf, np.float64("nan")), "of": [{"height_m": 1.25}], "n": 3}
    told = json.loads(json_text(found))
    assert told == {"u_m": None, "ends": [None, None], "of": [{"height_m": 1.25}], "n": 3}


def test_an_object_is_printed_whole_or_not_at_all(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(TypeError):
        print_json({"first": 1, "what": object()})
    assert capsys.readouterr().out == ""
    print_json({"reason": Said("excluded-not-reviewed")})
    assert json.loads(capsys.readouterr().out) == {"reason": "It has not been reviewed yet."}
