"""The report as a list of blocks that the template sets: words, tables, figures. No markup anywhere.

People's words travel as JSON strings and are set as text, so that no sign in them means anything.
"""

from __future__ import annotations

import json
import re
import unicodedata
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from sightline.export.report.canvas import Drawing
from sightline.export.report.fonts import LACKING, LACKING_TOLD, without_lacking
from sightline.export.report.photos import as_svg

Cell = str | tuple[str, str]  # words, or a figure with small words below it
_LONG_RUN = re.compile(r"[!-~\u00c0-\u024f]{19,}")
_STEP = 9
_BREAK = "\u200b"  # where a line may end; the template takes it out


@dataclass(frozen=True)
class Column:
    """One column: `weight` shares out the width that the columns of weight 0 leave."""

    title: str
    weight: float = 0.0
    align: Literal["left", "right", "hash"] = "left"
    unit: str = ""


@dataclass(frozen=True)
class Document:
    """The blocks of a report in order, and the pictures that they name."""

    blocks: list[dict[str, Any]] = field(default_factory=list)
    files: dict[str, bytes] = field(default_factory=dict)

    def section(self, title: str) -> None:
        """A numbered heading."""
        self._add("section", text=title)

    def subsection(self, title: str) -> None:
        """A heading below it."""
        self._add("subsection", text=text(title))

    def words(self, *paragraphs: str, sticky: bool = False) -> None:
        """Paragraphs; empty ones are left out. `sticky`: on the page of what comes next."""
        for one in paragraphs:
            if one.strip():
                self._add("words", text=text(one), sticky=sticky)

    def note(self, *paragraphs: str) -> None:
        """Small words below a table or figure."""
        for one in paragraphs:
            if one.strip():
                self._add("note", text=text(one))

    def warning(self, words: str) -> None:
        """Something to beware of."""
        self._add("warning", text=text(words))

    def listed(self, items: Iterable[str]) -> None:
        """A list with dashes."""
        self._add("list", items=[text(one) for one in items])

    def pairs(self, rows: Iterable[tuple[str, str]]) -> None:
        """Names with what belongs to them; those without anything are left out."""
        self._add("pairs", rows=[[name, text(what)] for name, what in rows if what.strip()])

    def code(self, *lines: str) -> None:
        """Lines to be typed."""
        self._add("code", lines=[text(one) for one in lines])

    def fixed(self, name: str) -> None:
        """A part whose words and equations stand in the template."""
        self._add(name)

    def table(self, caption: str, columns: Sequence[Column], rows: Iterable[Sequence[Cell]]) -> None:
        """A table that may run over pages; its head is repeated."""
        cells = [[[text(part) for part in _parts(cell)] for cell in row] for row in rows]
        heads = [[text(one.title), one.weight, one.align, one.unit] for one in columns]
        self._add("table", caption=text(caption), columns=heads, rows=cells)

    def figures(self, drawn: Iterable[tuple[str, Drawing | str]], across: int = 1) -> None:
        """Figures, `across` of them side by side; or the sentence that stands in the place of one."""
        shown: list[dict[str, str]] = []
        missing: list[str] = []
        for name, one in drawn:
            if isinstance(one, str):
                missing.append(one)
                continue
            self.files[f"{name}.svg"] = one.svg
            shown.append({"file": f"{name}.svg", "title": text(one.title), "caption": text(one.caption)})
        if shown:
            self._add("figures", across=across, figures=shown)
        self.words(*dict.fromkeys(missing))

    def photos(self, pictures: Iterable[tuple[str, bytes]]) -> None:
        """Photographs side by side, each a caption and a PNG or JPEG file."""
        shown, unread = [], []
        for k, (caption, content) in enumerate(pictures, start=1):
            picture = as_svg(content)
            if picture is None:
                unread.append(f"The photograph “{caption}” cannot be read as PNG or JPEG.")
                continue
            self.files[f"photo-{k}.svg"] = picture
            shown.append({"file": f"photo-{k}.svg", "title": text(caption), "caption": ""})
        if shown:
            self._add("figures", across=2, figures=shown)
        self.note(*unread)

    def as_json(self, **head: str) -> bytes:
        """The blocks, behind the title what stands for lacking signs, and what the template asks for."""
        told = json.dumps({**head, "blocks": self.blocks}, ensure_ascii=False)
        if LACKING in told:
            note = {"kind": "note", "text": text(LACKING_TOLD)}
            blocks = [*self.blocks[:1], note, *self.blocks[1:]]
            told = json.dumps({**head, "blocks": blocks}, ensure_ascii=False)
        return told.encode("utf-8")

    def _add(self, kind: str, **what: Any) -> None:
        self.blocks.append({"kind": kind, **what})


def _parts(cell: Cell) -> tuple[str, ...]:
    return (cell,) if isinstance(cell, str) else cell


def text(words: str) -> str:
    """What can be set of it: no controls, half characters or turns of direction; long runs may be broken."""
    kept = "".join(_settable(sign) for sign in words.replace("\r\n", "\n"))
    return _LONG_RUN.sub(_breakable, without_lacking(kept))


def _settable(sign: str) -> str:
    kind = unicodedata.category(sign)
    if kind == "Cs":
        return "\ufffd"
    if kind == "Cc" and sign != "\n":
        return " "
    return "" if unicodedata.bidirectional(sign) in _TURNS else sign


_TURNS = {"LRE", "RLE", "LRO", "RLO", "PDF", "LRI", "RLI", "FSI", "PDI"}


def _breakable(run: re.Match[str]) -> str:
    found = run.group()
    return _BREAK.join(found[k : k + _STEP] for k in range(0, len(found), _STEP))
