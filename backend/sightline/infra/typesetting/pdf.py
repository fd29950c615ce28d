"""PDF by Typst, from templates and values, set in the fonts that come along with Matplotlib and Typst."""

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


def _compiled(files: dict[str, bytes], stamp: int, standards: list[Any]) -> bytes:
    compiler: Any = typst.compile  # its types leave out the dictionary of files
    pdf: bytes = compiler(
        files,
        font_paths=[str(FONTS)],
        ignore_system_fonts=True,
        format="pdf",
        pdf_standards=standards,
        timestamp=stamp,
    )
    return pdf
