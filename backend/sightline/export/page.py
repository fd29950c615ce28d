"""The page that a package carries: index.html, which shows the package and checks it without a server.

The program of the page is made with the front end (`frontend/src/package`, one file); an export puts the
package's tables into it, for a page that is opened from a folder may not read its neighbours. The seal names
the page as any other file. The audit chain ends with the seal, so it cannot stand in the page: `audit.js`
beside it repeats audit.csv and checkpoint.json for the page, as they are and after both.
"""

import base64
import binascii
import html
import json
import re
import zlib
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence, Set
from functools import cache
from typing import Any

from sightline.errors import Damaged
from sightline.export.readme import README
from sightline.export.report.said import speaking
from sightline.export.report.words import selection_words
from sightline.export.seal import AUDIT_SCRIPT, CHECKPOINT, PAGE
from sightline.infra.csv_package.audit import AUDIT
from sightline.infra.csv_package.columns import said_in, words_of
from sightline.infra.csv_package.files import Files, Staging, read_columns, read_whole
from sightline.infra.csv_package.schema import CHECKSUMS, CODE, DESCRIPTION, AnyTable, Written, sha256_hex
from sightline.infra.version import code_version
from sightline.messages import languages, name_of
from sightline.messages.recognised import translated_meaning
from sightline.results.csv import selection_in
from sightline.results.usual_standards import in_language, standards_in
from sightline.settings import default_frontend_dir
from sightline.surveys.csv import INSETS
from sightline.surveys.records import note_in

_MARK = "<!--package-->"
_FILE = "package.html"
#: A browser holds and reads this much of one table in a few seconds; larger ones the page does not carry.
MOST_BYTES = 128_000_000
_NAMES = (
    "survey",
    "measurements",
    "budget",
    "crops",
    "vehicles",
    "recordings",
    "poses",
    "people",
    "insets",
    "selection",
    "exclusions",
    "error_table",
    "percentiles",
    "total_uncertainty",
    "same_rule",
    "shares",
    "lateral_positions",
    "response",
    "corrections",
    "agreement",
)
_POSES = re.compile(r"records/pose-\d+\.json")
_ABOUT = re.compile(r'<script type="application/json" id="about">(.*?)</script>\n', re.DOTALL)
_BLOCK = re.compile(r'<script type="text/plain" data-path="([\w./-]+)">([A-Za-z0-9+/=]*)</script>\n')
_TITLE = re.compile(r"<title>([^<]*)</title>")
_WIDTH = re.compile(r'<svg [^>]*\bwidth="(\d+(?:\.\d+)?)pt"')
_HALF_PT = 300.0  # between the widths of the sheets that figures are drawn on
_SCRIPT = "globalThis.sightlineAudit = "
#: Written with or after the page, so that its sizes leave them out.
_LATER = (PAGE, DESCRIPTION, AUDIT.path, AUDIT_SCRIPT, CHECKPOINT, CHECKSUMS)


@cache
def template() -> str | None:
    """The page without a package; None where the front end is not built (a checkout without Node)."""
    place = default_frontend_dir() / _FILE
    return place.read_text("utf-8") if place.is_file() else None


def page_version() -> str:
    """What tells one program of the page from another: the hash of it all, "none" where it is not built."""
    found = template()
    return "none" if found is None else sha256_hex(found.encode())


def write_page(staging: Staging, tables: Sequence[AnyTable], language: str) -> None:
    """index.html over what is written so far, opened in a language; nothing without a built front end."""
    found = template()
    if found is None:
        return
    before, _, after = found.partition(_MARK)
    files, written = staging.files(), dict(staging.written)
    with staging.file(PAGE) as out:
        out.write(f"{before}{_MARK}\n{_about_block(files, tables, written, language)}".encode())
        for path in _carried(tables, written):
            packed = _packed(read_whole(files, path))
            out.write(f'<script type="text/plain" data-path="{path}">{packed}</script>\n'.encode())
        out.write(after.encode())


def write_audit_script(staging: Staging) -> None:
    """audit.js, once the chain and its checkpoint are written; nothing where there is no page."""
    if PAGE not in staging.written:
        return
    files = staging.files()
    small = staging.written[AUDIT.path].size <= MOST_BYTES
    paths = (AUDIT.path, CHECKPOINT) if small else ()
    told = json.dumps({path: _packed(read_whole(files, path)) for path in paths})
    staging.add(AUDIT_SCRIPT, f"{_SCRIPT}{told};\n".encode())


def check_page(
    files: Files,
    made_with: Mapping[str, Any],
    tables: Sequence[AnyTable],
    written: Mapping[str, Written],
    language: str,
    *,
    same_program: bool,
) -> bool:
    """The page is the program that the description names, and what it carries is the package. Raises Damaged.

    tables: as the package describes them. Returns False where another program made it: what the page says of
    the package is then sealed, and not compared.
    """
    version = made_with.get("page", "none")
    if version == "none" or PAGE not in files.paths:
        if version != "none" or {PAGE, AUDIT_SCRIPT} & files.paths:
            raise Damaged("export-page-not-described", path=PAGE)
        return True
    try:
        text = read_whole(files, PAGE).decode("utf-8")
    except UnicodeDecodeError as error:
        raise Damaged("export-page-another-program", path=PAGE) from error
    before, mark, rest = text.partition(f"{_MARK}\n")
    about = _ABOUT.match(rest)
    blocks = list(_blocks(rest, about.end() if about else 0))
    after = rest[blocks[-1].end() if blocks else 0 :]
    if about is None or not mark or sha256_hex(f"{before}{_MARK}{after}".encode()) != version:
        raise Damaged("export-page-another-program", path=PAGE)
    for block in blocks:
        if block[1] not in files.paths or _unpacked(block[2]) != read_whole(files, block[1]):
            raise Damaged("export-page-carries-another", path=block[1])
    told = _about_block(files, tables, written, language, str(json.loads(about[1]).get("made_with")))
    agrees = about[0] == told and [block[1] for block in blocks] == list(_carried(tables, written))
    if version == page_version() and same_program and not agrees:
        raise Damaged("export-page-another-program", path=PAGE)
    _check_audit_script(files)
    return agrees and version == page_version()


def _check_audit_script(files: Files) -> None:
    """audit.js holds this chain and checkpoint, or nothing where they are too large."""
    text = read_whole(files, AUDIT_SCRIPT).decode("utf-8", "replace")
    try:
        told = json.loads(text.removeprefix(_SCRIPT).removesuffix(";\n"))
        same = f"{_SCRIPT}{json.dumps(told)};\n" == text and list(told) in ([], [AUDIT.path, CHECKPOINT])
        same = same and all(_unpacked(packed) == read_whole(files, path) for path, packed in told.items())
    except (ValueError, AttributeError, TypeError) as error:
        raise Damaged("export-page-carries-another", path=AUDIT_SCRIPT) from error
    if not same:
        raise Damaged("export-page-carries-another", path=AUDIT_SCRIPT)


def tables_of_page(tables: Sequence[AnyTable]) -> list[AnyTable]:
    """Those that the page shows, each column with its meaning, in the page's order."""
    known = {table.name: table for table in tables}
    return [known[name] for name in _NAMES if name in known]


def _blocks(rest: str, start: int) -> Iterator[re.Match[str]]:
    while found := _BLOCK.match(rest, start):
        yield found
        start = found.end()


def _carried(tables: Sequence[AnyTable], written: Mapping[str, Written]) -> Iterator[str]:
    """The files that the page carries, in their order: its tables and the poses that are not too large."""
    poses = sorted(path for path in written if _POSES.fullmatch(path))
    for path in (README, *(table.path for table in tables_of_page(tables)), *poses):
        if path in written and written[path].size <= MOST_BYTES:
            yield path


def _about_block(
    files: Files,
    tables: Sequence[AnyTable],
    written: Mapping[str, Written],
    language: str,
    version: str | None = None,
) -> str:
    with speaking(language):
        only = selection_words(selection_in(files))
    carried = set(_carried(tables, written))
    said = {one: _translate_cells(files, tables, carried, one) for one in languages()}
    told = {
        "language": language,
        "only": only,
        "said": said,
        **_describe_package(files, tables, written, version),
    }
    text = json.dumps(told, ensure_ascii=False).replace("<", "\\u003c")
    return f'<script type="application/json" id="about">{text}</script>\n'


def _translate_cells(
    files: Files, tables: Sequence[AnyTable], carried: Set[str], language: str
) -> dict[str, str]:
    """What the tables say in English that the page shows as sentences, in a language: by the code beside it;
    what their columns mean; the words of the program's standards and insets.
    """
    translations: dict[str, str] = {}
    for one in standards_in(files):
        if one.code is not None:
            translations |= dict(zip(one.words, in_language(one, language).words, strict=True))
    translations |= {note: note_in(note, language) for (note,) in read_columns(files, INSETS.key, ("note",))}
    for table in tables_of_page(tables):
        if table.path not in carried:
            continue
        translations |= {one.meaning: translated_meaning(one.meaning, language) for one in table.columns}
        if table.key == "budget.csv":
            sources = {source for (source,) in read_columns(files, table.path, ("source",))}
            translations |= {source: name_of("budget-of", source, language) for source in sources}
        names = [one.name for one in table.columns]
        for column in (one for one in names if f"{one}{CODE}" in names):
            for text, code in set(map(tuple, read_columns(files, table.path, (column, f"{column}{CODE}")))):
                translations[text] = words_of(said_in(code), language) or text
    return {text: translations[text] for text in sorted(translations) if translations[text] != text}


def _figure(files: Files, path: str) -> dict[str, object]:
    """A drawing's title, and whether it is as wide as a sheet, as its file says them."""
    text = read_whole(files, path).decode("utf-8", "replace")
    title, width = _TITLE.search(text), _WIDTH.search(text)
    wide = width is not None and float(width[1]) > _HALF_PT
    return {"path": path, "title": path if title is None else html.unescape(title[1]), "wide": wide}


def _describe_package(
    files: Files, tables: Sequence[AnyTable], written: Mapping[str, Written], version: str | None
) -> dict[str, object]:
    """What the page says of the package: sizes by folder, figures, tables with their columns' meaning."""
    folders: dict[str, list[int]] = defaultdict(lambda: [0, 0])
    for path in sorted(written):
        if path not in _LATER:
            size = folders[path.rpartition("/")[0].partition("/")[0] + "/" if "/" in path else ""]
            size[0], size[1] = size[0] + 1, size[1] + written[path].size
    carried = set(_carried(tables, written))
    there = tables_of_page(tables)
    return {
        "made_with": version or code_version(),
        "folders": [
            {"folder": name, "files": files, "bytes": size} for name, (files, size) in sorted(folders.items())
        ],
        "figures": [_figure(files, path) for path in sorted(written) if path.startswith("figures/")],
        "left_out": [table.path for table in there if table.path not in carried],
        "tables": [
            {
                "path": table.path,
                "name": table.name,
                "columns": {column.name: column.meaning for column in table.columns},
            }
            for table in there
            if table.path in carried
        ],
    }


def _packed(content: bytes) -> str:
    """Base64 of raw DEFLATE (RFC 1951), which a browser undoes by itself."""
    packer = zlib.compressobj(6, zlib.DEFLATED, -15)
    return base64.b64encode(packer.compress(content) + packer.flush()).decode("ascii")


def _unpacked(text: str) -> bytes | None:
    """What was packed; None for what is not, whole and nothing behind it."""
    unpacker = zlib.decompressobj(-15)
    try:
        content = unpacker.decompress(base64.b64decode(text, validate=True), MOST_BYTES + 1)
    except (zlib.error, binascii.Error):
        return None
    whole = unpacker.eof and not unpacker.unused_data and not unpacker.unconsumed_tail
    return content if whole else None
