"""The text under the audit chain: one for equal values, readable again, and RFC 8785's to the byte."""

import json
import math
import struct
from collections.abc import Callable
from datetime import UTC, datetime, timedelta, timezone
from typing import Any

import numpy as np
import pytest
import rfc8785
from hypothesis import given
from hypothesis import strategies as st
from sqlalchemy import Dialect
from sqlalchemy.dialects import sqlite

from sightline.infra.audit.hashing import LARGEST_INTEGER, canonical_json, content_hash, to_plain_json
from sightline.infra.database.types import CanonicalJson

pytestmark = pytest.mark.once

TEXT = st.text(st.characters(exclude_categories=["Cs"]), max_size=12)
NUMBERS = st.floats(allow_nan=False, allow_infinity=False) | st.integers(-(2**70), 2**70)
SCALARS = st.none() | st.booleans() | NUMBERS | TEXT
VALUES = st.recursive(
    SCALARS,
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(TEXT, inner, max_size=4),
    max_leaves=20,
)


def turned(value: Any) -> Any:
    """The same value, every object's keys put in the other way round."""
    if isinstance(value, dict):
        return {key: turned(value[key]) for key in reversed(value)}
    return [turned(item) for item in value] if isinstance(value, list) else value


@given(VALUES)
def test_the_text_does_not_depend_on_the_order_of_keys(value: Any) -> None:
    assert canonical_json(turned(value)) == canonical_json(value)


@given(VALUES)
def test_the_text_is_that_of_the_library(value: Any) -> None:
    """Ours is written in one pass; `rfc8785` writes what `to_plain_json` makes of the value."""
    assert canonical_json(value) == rfc8785.dumps(to_plain_json(value)).decode()


@given(
    st.floats(allow_nan=False, allow_infinity=False)
    | st.floats(-1e-3, 1e-3)
    | st.floats(1e14, 1e23)
    | st.integers(-(2**60), 2**60).map(float)
    | st.builds(lambda digits, power: digits * 10.0**power, st.integers(-99999, 99999), st.integers(-12, 24))
)
def test_each_double_is_written_as_the_library_does(number: float) -> None:
    assert canonical_json(number) == rfc8785.dumps(number).decode()


@given(st.text(max_size=40))
def test_each_text_is_written_or_refused_as_the_library_does(text: str) -> None:
    try:
        expected = rfc8785.dumps({text: text}).decode()
    except ValueError:
        with pytest.raises(ValueError):
            canonical_json({text: text})
    else:
        assert canonical_json({text: text}) == expected


def read(text: str) -> Any:
    """JSON as every language reads it: a number that no double tells from its neighbours is a double."""
    return json.loads(
        text, parse_int=lambda digits: float(digits) if abs(int(digits)) > LARGEST_INTEGER else int(digits)
    )


@given(VALUES)
def test_the_text_read_again_gives_the_same_value_and_the_same_text(value: Any) -> None:
    text = canonical_json(value)
    assert read(text) == to_plain_json(value)
    assert canonical_json(read(text)) == text


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_a_double_read_again_is_the_same_double(number: float) -> None:
    assert float(json.loads(canonical_json(number))) == number


def bits(value: Any) -> Any:
    """The value with its doubles as their eight bytes and every scalar with its type."""
    if isinstance(value, dict):
        return {key: bits(item) for key, item in value.items()}
    if isinstance(value, list):
        return [bits(item) for item in value]
    return struct.pack(">d", value) if isinstance(value, float) else (type(value), value)


@given(VALUES)
def test_a_document_column_keeps_every_double_to_the_bit(value: Any) -> None:
    column, dialect = CanonicalJson(), _sqlite()
    stored = column.process_bind_param(value, dialect)
    assert bits(column.process_result_value(stored, dialect)) == bits(value)


def _sqlite() -> Dialect:
    return sqlite.dialect()  # type: ignore[no-untyped-call]


@pytest.mark.parametrize(
    ("value", "text"),
    [
        # RFC 8785, 3.2.2.3, 3.2.3 and appendix B
        ([333333333.33333329, 1e30, 4.50, 2e-3, 1e-27], "[333333333.3333333,1e+30,4.5,0.002,1e-27]"),
        ('\u20ac$\u000f\nA\'B"\\\\"/', '"€$\\u000f\\nA\'B\\"\\\\\\\\\\"/"'),
        ({"\ufb33": 1, "\U0001f600": 2, "1": 3, "\r": 4}, '{"\\r":4,"1":3,"\U0001f600":2,"\ufb33":1}'),
        ([1.0, -0.0, 5e-324, 1e21, 999999999999999900000.0], "[1,0,5e-324,1e+21,999999999999999900000]"),
        # ours: what JSON cannot hold, or other languages would round
        ([LARGEST_INTEGER, -LARGEST_INTEGER], "[9007199254740991,-9007199254740991]"),
        ([2**53, -(2**63)], '["9007199254740992","-9223372036854775808"]'),
        (datetime(2026, 5, 4, 10, tzinfo=UTC), '"2026-05-04T10:00:00.000000+00:00"'),
        (
            datetime(2026, 5, 4, 12, tzinfo=timezone(timedelta(hours=2))),
            '"2026-05-04T10:00:00.000000+00:00"',
        ),
        ((np.float64(0.1), np.int64(2**60), np.bool_(True)), '[0.1,"1152921504606846976",true]'),
    ],
)
def test_the_rules(value: Any, text: str) -> None:
    assert canonical_json(value) == text


@pytest.mark.parametrize(
    "value",
    [math.nan, math.inf, np.float64("nan"), "\ud800", datetime(2026, 5, 4), b"x", {1, 2}],
    ids=["nan", "infinity", "numpy nan", "half a pair", "no zone", "bytes", "set"],
)
@pytest.mark.parametrize("call", [canonical_json, lambda value: content_hash({"a": [value]})])
def test_what_no_json_holds_is_refused(call: Callable[[Any], str], value: Any) -> None:
    with pytest.raises(ValueError):
        call(value)
