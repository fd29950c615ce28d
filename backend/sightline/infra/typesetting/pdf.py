"""PDF by Typst, from templates and values, set in the fonts that come along with Matplotlib and Typst."""

from functools import cache
from pathlib import Path
from typing import Any

import matplotlib
import typst

#: The fonts, the same on every machine.
FONTS = Path(matplotlib.get_data_path()) / "fonts" / "ttf"
# Archives keep PDF/A; screen readers want the tags and alternative texts of PDF/UA.
_STANDARDS = ["a-2a", "ua-1"]


def set_pdf(files: dict[str, bytes], stamp: int) -> bytes:
    """What Typst makes of templates, values and pictures; it begins at main.typ. `stamp`: Unix seconds.

    PDF/A-2a and PDF/UA-1, but for a sign in a name that no font at hand can show: then not for the archive,
    but still to be read.
    """
    try:
        return _compiled(files, stamp, _STANDARDS)
    except typst.TypstError:
        return _compiled(files, stamp, [])


@cache
def _fonts() -> typst.Fonts:
    """Without the machine's own. Read once a process: it takes 14 ms, longer than setting a page."""
    return typst.Fonts(include_system_fonts=False, font_paths=[str(FONTS)])


def _compiled(files: dict[str, bytes], stamp: int, standards: list[Any]) -> bytes:
    compiler: Any = typst.compile  # its types leave out the dictionary of files
    pdf: bytes = compiler(
        files,
        font_paths=_fonts(),
        format="pdf",
        pdf_standards=standards,
        timestamp=stamp,
    )
    return pdf
