"""The one form of a package's JSON files."""

import json
import math
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sightline.infra.csv_package.schema import json_bytes

WHOLE = st.integers(-(2**53) + 1, 2**53 - 1)
VALUES = st.recursive(
    st.none() | st.booleans() | WHOLE | st.floats(allow_nan=False, allow_infinity=False) | st.text(),
    lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner),
)


@given(VALUES)
def test_what_is_written_is_read_again(value: Any) -> None:
    content = json_bytes(value)
    assert content.endswith(b"\n") and json.loads(content) == value
    assert json_bytes(json.loads(content)) == content


def test_keys_stand_as_given_two_blanks_in() -> None:
    written = '{\n  "b": [\n    1,\n    "é"\n  ],\n  "a": {}\n}\n'
    assert json_bytes({"b": [1, "é"], "a": {}}) == written.encode()


@pytest.mark.parametrize("value", [math.nan, math.inf, [-math.inf], {"u_m": math.nan}, "\ud800", 2**70])
def test_what_json_cannot_hold_is_refused(value: object) -> None:
    with pytest.raises(ValueError):
        json_bytes(value)


def test_what_is_nested_too_deeply_is_refused() -> None:
    deep: list[Any] = []
    for _ in range(400):
        deep = [deep]
    with pytest.raises(ValueError):
        json_bytes(deep)
