"""The words of a PDF as Typst writes it: a reader for tests, which knows no other PDFs."""

from __future__ import annotations

import re
import zlib

_OBJECT = re.compile(rb"(?:^|\n)(\d+) 0 obj\s(.*?)\nendobj", re.DOTALL)
_PLAIN_SIGNS = rb"\\.|[^\\()]"
_INNER = rb"(?!)"
for _ in range(6):  # brackets within brackets stand as they are: numbers of glyphs may be any bytes
    _INNER = rb"\((?:" + _PLAIN_SIGNS + rb"|" + _INNER + rb")*\)"
_STRING = rb"\(((?:" + _PLAIN_SIGNS + rb"|" + _INNER + rb")*)\)"
_PIECE = re.compile(
    rb"/(f\d+) [\d.]+ Tf|/Span<</ActualText"
    + _STRING
    + rb">>BDC(.*?)EMC|<<.*?>>|"
    + _STRING
    + rb"|<([0-9A-Fa-f]+)>|\b(ET)\b",
    re.DOTALL,
)
_ESCAPE = re.compile(rb"\\([0-7]{1,3}|\r?\n|.)", re.DOTALL)
_PLAIN = {b"n": b"\n", b"r": b"\r", b"t": b"\t", b"b": b"\b", b"f": b"\f"}


def words(pdf: bytes) -> str:
    """All that is written on the pages, in the order of writing; each run of text on a line of its own."""
    return "\n".join(pages(pdf))


def pages(pdf: bytes) -> list[str]:
    """The same, page by page."""
    objects = {int(number): body for number, body in _OBJECT.findall(pdf)}
    return [_page(objects, body) for body in objects.values() if re.search(rb"/Type/Page\b", body)]


def _page(objects: dict[int, bytes], body: bytes) -> str:
    fonts = {
        name: _characters(_stream(objects[_reference(objects[int(number)], rb"/ToUnicode")]))
        for name, number in re.findall(rb"/(f\d+) (\d+) 0 R", _resources(objects, body))
    }
    content = _stream(objects[_reference(body, rb"/Contents")])
    font: dict[int, str] = {}
    found: list[str] = []
    for name, actual, instead, literal, hexed, end in _PIECE.findall(content):
        if name:
            font = fonts[name]
        elif instead:
            said = _ESCAPE.sub(_unescaped, actual)
            found.append(said.decode("utf-16" if said.startswith(b"\xfe\xff") else "latin-1"))
        elif end:
            found.append("\n")
        elif literal or hexed:
            code = bytes.fromhex(hexed.decode()) if hexed else _ESCAPE.sub(_unescaped, literal)
            found += [font.get(int.from_bytes(code[k : k + 2]), "") for k in range(0, len(code), 2)]
    return "".join(found)


def _resources(objects: dict[int, bytes], body: bytes) -> bytes:
    own = re.search(rb"/Resources (\d+) 0 R", body)
    return objects[int(own.group(1))] if own else body


def _reference(body: bytes, key: bytes) -> int:
    found = re.search(key + rb" (\d+) 0 R", body)
    assert found, key
    return int(found.group(1))


def _stream(body: bytes) -> bytes:
    start = re.search(rb"stream\r?\n", body)
    assert start
    return zlib.decompressobj().decompress(body[start.end() :])


def _characters(cmap: bytes) -> dict[int, str]:
    pairs = re.findall(rb"<([0-9A-Fa-f]{4})> <([0-9A-Fa-f]+)>", cmap)
    known = {int(code, 16): bytes.fromhex(to.decode()).decode("utf-16-be", "replace") for code, to in pairs}
    return {code: to for code, to in known.items() if code != 0}


def _unescaped(found: re.Match[bytes]) -> bytes:
    sign = found.group(1)
    if sign[:1].isdigit():
        return bytes([int(sign, 8)])
    return _PLAIN.get(sign, b"" if sign.endswith(b"\n") else sign)
