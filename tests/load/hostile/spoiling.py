"""Ways to spoil a file: of bytes anywhere, and of the text of a table or document."""

from __future__ import annotations

import random

from tests.media.fuzz import mutated

ODD = (
    b"nan",
    b"inf",
    b"-inf",
    b"1e999",
    b"-1e308",
    b"1" * 400,
    b"",
    b" ",
    b"0",
    b"-1",
    b"1,5",
    b"null",
    b"true",
    b"[]",
    b"{}",
    b'"',
    b"'",
    b"\0",
    b"\xff\xfe",
    "\u202e\u0661\u0662".encode(),
    b"=1+1",
    b"x" * 100_000,
)


def spoiled_bytes(whole: bytes, rng: random.Random) -> bytes:
    """As a bad disk, a broken line or a fuzzer does it."""
    return mutated(whole, rng)


def spoiled_text(whole: bytes, rng: random.Random) -> bytes:
    """A value changed for an odd one, a line or a piece lost, doubled or moved; sometimes any bytes."""
    kind = rng.randrange(6)
    if kind == 0:
        return mutated(whole, rng)
    if kind == 1:
        lines = whole.splitlines(keepends=True)
        at = rng.randrange(len(lines))
        lines[at : at + 1] = rng.choice(([], [lines[at]] * 2, [rng.choice(lines)], [b"\r\n"]))
        return b"".join(lines)
    if kind == 2:
        return whole * rng.randrange(2, 4)
    text = whole
    for _ in range(rng.choice((1, 1, 3))):
        text = _odd_value(text, rng)
    return text


def _odd_value(whole: bytes, rng: random.Random) -> bytes:
    """One value between separators in place of another."""
    ends = [at for at, sign in enumerate(whole) if sign in b',\n:"[]{}']
    at = rng.randrange(len(ends))
    start, end = ends[at] + 1, ends[at + 1] if at + 1 < len(ends) else len(whole)
    return whole[:start] + rng.choice(ODD) + whole[end:]
