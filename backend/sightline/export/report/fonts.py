"""The fonts that a report is set from, and what stands for signs that none of them has.

They come along with Matplotlib and Typst, so that a report has the same bytes on every machine. Latin, Greek,
Cyrillic, Hebrew and Arabic are among them; no font of all Chinese, Japanese and Korean signs is small enough
to be installed along.
"""

import unicodedata
from functools import cache

from matplotlib.ft2font import FT2Font

from sightline.infra.typesetting.pdf import FONTS

LACKING = "[…]†"
_READ = ("DejaVuSans.ttf", "STIXGeneral.ttf")


@cache
def signs() -> frozenset[int]:
    """The code points that the fonts have between them."""
    return frozenset(code for name in _READ for code in FT2Font(str(FONTS / name)).get_charmap())


def without_lacking(words: str) -> str:
    """The words, each run of signs that no font has replaced by LACKING."""
    if words.isascii():
        return words
    kept: list[str] = []
    for sign in words:
        if ord(sign) in signs() or unicodedata.category(sign) in ("Zs", "Cf") or sign == "\n":
            kept.append(sign)
        elif not kept or kept[-1] != LACKING:
            kept.append(LACKING)
    return "".join(kept)
