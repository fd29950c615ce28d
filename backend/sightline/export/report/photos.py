"""Photographs for the report: turned upright, small enough for print, wrapped as Typst takes them."""

import base64
import io

from PIL import Image, ImageOps, UnidentifiedImageError

_MOST_PX = 1400  # of the longer side: 84 mm at 400 dots an inch
_QUALITY = 88
_MOST_PIXELS = 100_000_000


def as_svg(content: bytes) -> bytes | None:
    """A PNG or JPEG file as an SVG that holds it, upright; None where it is no picture or far too large.

    The picture is made anew, so that nothing goes along that a camera wrote into its file, such as places.
    """
    try:
        with Image.open(io.BytesIO(content), formats=("PNG", "JPEG")) as opened:
            if opened.width * opened.height > _MOST_PIXELS:
                return None
            picture = ImageOps.exif_transpose(opened).convert("RGB")
    except (OSError, UnidentifiedImageError, Image.DecompressionBombError, SyntaxError, ValueError):
        return None
    picture.thumbnail((_MOST_PX, _MOST_PX))
    out = io.BytesIO()
    picture.save(out, "JPEG", quality=_QUALITY)
    data = base64.b64encode(out.getvalue()).decode("ascii")
    size = f'width="{picture.width}" height="{picture.height}"'
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" {size}>'
        f'<image {size} href="data:image/jpeg;base64,{data}"/></svg>'
    ).encode("ascii")
