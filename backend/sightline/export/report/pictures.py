"""The pictures of a report: figures and photographs as files beside the templates, and what names them."""

from collections.abc import Iterable, Mapping

from sightline.export.report.canvas import Drawing
from sightline.export.report.photos import as_svg
from sightline.export.report.settable import Values
from sightline.surveys.photographs.records import PhotographFile


class Pictures:
    """`files`: content by name of every picture that was asked for."""

    def __init__(self, drawn: Mapping[str, Drawing | str]) -> None:
        self._drawn = drawn
        self.files: dict[str, bytes] = {}

    def figures(self, names: Iterable[str]) -> list[Values | str]:
        """Of these figures those that there are, or the sentences that stand in their place."""
        return [self._figure(name) for name in names if name in self._drawn]

    def _figure(self, name: str) -> Values | str:
        drawing = self._drawn[name]
        if isinstance(drawing, str):
            return drawing
        self.files[f"{name}.svg"] = drawing.svg
        return {"file": f"{name}.svg", "title": drawing.title, "caption": drawing.caption}

    def photos(self, photos: Iterable[PhotographFile]) -> list[Values]:
        """Captions with their files; None for a file that cannot be read as PNG or JPEG."""
        return [self._photo(f"photo-{k}.svg", photo) for k, photo in enumerate(photos, start=1)]

    def _photo(self, name: str, photo: PhotographFile) -> Values:
        picture = as_svg(photo.content)
        if picture is None:
            return {"caption": photo.caption, "file": None}
        self.files[name] = picture
        return {"caption": photo.caption, "file": name}
