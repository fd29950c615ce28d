"""The one file: the page's program (made with the front end), the document, its signature, both pictures.

The document stands in the page as its canonical JSON (RFC 8785), with "<" written as \\u003c so that no text
of it can end its element; the signature is that of the canonical JSON itself.
"""

import base64
import binascii
import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache

from sightline.enums import JsonObject
from sightline.errors import BadInput, Damaged
from sightline.export.evidence.pictures import StripPicture
from sightline.infra.audit.hashing import canonical_json
from sightline.infra.csv_package.schema import sha256_hex
from sightline.settings import default_frontend_dir

_MARK = "<!--evidence-->"
_FILE = "evidence.html"
#: Larger files are not ours: two pictures of 8192 x 4096 pixels that cannot be compressed have 90 MB.
MOST_BYTES = 200_000_000
_DATA = re.compile(
    r'\n<script type="application/json" id="evidence">(?P<document>[^<]*)</script>\n'
    r'<script type="text/plain" id="signature">(?P<signature>[0-9a-f]*)</script>\n'
    r'(?P<pictures>(?:<script type="text/plain" data-picture="[\w.-]+">[A-Za-z0-9+/=]*</script>\n)*)'
)
_PICTURE = re.compile(r'data-picture="([\w.-]+)">([A-Za-z0-9+/=]*)<')


@dataclass(frozen=True)
class ReadPage:
    """What stands in a file: the program's hash, the document and its text, signature, pictures by name."""

    program: str
    document: JsonObject
    is_canonical: bool
    signature: str
    pictures: Mapping[str, bytes]


@cache
def template() -> str | None:
    """The page without its data; None where the front end is not built (a checkout without Node)."""
    place = default_frontend_dir() / _FILE
    return place.read_text("utf-8") if place.is_file() else None


def program_of_page() -> str:
    """The hash of the page's program, which the document names. Raises BadInput where it is not built."""
    found = template()
    if found is None:
        raise BadInput("evidence-pages-not-built")
    return sha256_hex(found.encode())


def written_page(document: JsonObject, signature: str, pictures: Sequence[StripPicture]) -> bytes:
    """The file. Raises BadInput where the page's program is not built."""
    program_of_page()
    before, _, after = (template() or "").partition(_MARK)
    data = [
        f'<script type="application/json" id="evidence">{_escaped(canonical_json(document))}</script>',
        f'<script type="text/plain" id="signature">{signature}</script>',
        *(
            f'<script type="text/plain" data-picture="{one.name}">'
            f"{base64.b64encode(one.content).decode('ascii')}</script>"
            for one in pictures
        ),
    ]
    return "\n".join([before + _MARK, *data, after]).encode()


def read_page(content: bytes) -> ReadPage:
    """A file taken apart. Raises Damaged for one that is not written as this program writes them."""
    try:
        before, mark, rest = content.decode("utf-8").partition(_MARK)
        match = _DATA.match(rest)
        if match is None or not mark:
            raise ValueError
        document = json.loads(match["document"])
        if not isinstance(document, dict):
            raise ValueError
        pictures = {
            name: base64.b64decode(text, validate=True) for name, text in _PICTURE.findall(match["pictures"])
        }
        canonical = _escaped(canonical_json(document)) == match["document"]
    except (ValueError, binascii.Error, RecursionError) as error:
        raise Damaged("evidence-not-one") from error
    program = sha256_hex(f"{before}{_MARK}{rest[match.end() :]}".encode())
    return ReadPage(
        program=program,
        document=document,
        is_canonical=canonical,
        signature=match["signature"],
        pictures=pictures,
    )


def _escaped(text: str) -> str:
    return text.replace("<", "\\u003c")
