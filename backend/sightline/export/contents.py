"""What an export says of itself: its tables, its other files, and what it was made with."""

from collections.abc import Collection, Mapping, Sequence
from functools import cache
from importlib.metadata import version
from typing import Any

from sightline.export.page import page_version
from sightline.export.readme import README
from sightline.export.seal import AUDIT_SCRIPT, CHECKPOINT, FIGURES, PAGE, REPORT
from sightline.infra.csv_package.audit import AUDIT
from sightline.infra.csv_package.schema import PARQUET, About, AnyTable, Other, Written, description_of
from sightline.infra.source_hash import source_hash
from sightline.infra.version import code_version
from sightline.measurements.verify import HEIGHTS
from sightline.scans.heights.verify import LINES
from sightline.surveys.photographs.csv import FOLDER as PHOTOGRAPHS_FOLDER

_OTHERS = (
    (README, "text/plain", "What came out, what the package holds, and how to check it."),
    (PAGE, "text/html", "This package as a page: open it in a browser; it checks itself, without a server."),
    (REPORT, "application/pdf", "Report: site, set-up, calibration, method, errors, figures, exclusions."),
    (FIGURES, "image/svg+xml", "A figure of the statistics."),
    (PHOTOGRAPHS_FOLDER, "image/jpeg", "A photograph of the set-up."),
    ("poses/", "application/json", "A road pose with its camera (sightline-pose-1)."),
    ("calibrations/", "application/json", "A calibration (sightline-camera-1)."),
    (
        "records/",
        "application/json",
        "A pose or calibration whole, as the audit chain vouches for it.",
    ),
    (PARQUET, "application/vnd.apache.parquet", "A table as Parquet: what its CSV holds, typed."),
    ("clicks/", "text/csv", "The clicks of one road pose, as `sightline height --clicks` reads them."),
)
_ABOUT = (
    "Heights of vehicles measured from roadside video with Sightline. Lengths are in metres with six "
    "decimals; u_ is a standard uncertainty (k = 1), U95_ the half-width of the 95 % interval; pixels have "
    "(0, 0) at the centre of the top-left pixel. `sightline verify` checks this folder; `sightline height "
    "--pose poses/pose-N.json --clicks clicks/pose-N.csv` computes its heights again. statistics/ is made of "
    "the accepted measurements in these tables, heights to the micrometre. An apostrophe stands before any "
    "text that a spreadsheet would run as a formula. The last event of audit.csv seals the package: it "
    "names every other file by its SHA-256. checkpoint.json signs that event with the installation's key "
    "(Ed25519): compare its key with the one that the installation shows. A signature proves what the "
    "holder of the key signed, not that it is true. An event's hash is sha256(previous_hash + "
    "content_sha256), its content_sha256 that of the event as JSON by RFC 8785."
)


def describe_package(
    about: About, language: str, tables: Sequence[AnyTable], written: Mapping[str, Written]
) -> dict[str, Any]:
    """`datapackage.json`. It comes before the seal, and so names no hash of the table that ends with it.

    language: that of figures and report.
    """
    without = {
        path: one for path, one in written.items() if path not in (AUDIT.path, AUDIT_SCRIPT, CHECKPOINT)
    }
    return {**description_of(about, tables, others_of(without), without), "language": language}


def others_of(paths: Collection[str]) -> tuple[Other, ...]:
    """The files that are described beside the tables; crops are described by crops.csv."""
    return tuple(
        Other(path, mediatype, meaning)
        for start, mediatype, meaning in _OTHERS
        for path in sorted(paths)
        if path.startswith(start)
    )


def about_of(name: str, site: str, description: str, created: str | None, only: str | None = None) -> About:
    """What the package of a survey says of itself; it is dated by its last event, not by the clock.

    only: the vehicles that its statistics are of, in words; None: all.
    """
    parts = [
        description.strip(),
        f"Statistics, figures and report are only of: {only}." if only else "",
        _ABOUT,
    ]
    title = f"{name}, {site}" if site else name
    return About(title, "\n\n".join(part for part in parts if part), created, made_with())


WORDS, STATISTICS, DRAWING = "words", "statistics", "drawing"
PARTS: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    HEIGHTS: (
        (
            "sightline.measurements.height_of_clicks",
            "sightline.measurements.moved",
            "sightline.measurements.sheets.states",
        ),
        (),
    ),
    LINES: (
        ("sightline.scans.heights.service", "sightline.scans.rig.calibrating", "sightline.linescan.gaps"),
        (),
    ),
    WORDS: (("sightline.messages.said",), (".ftl",)),
    STATISTICS: (
        (
            "sightline.export.measured",
            "sightline.export.statistics_csv",
            "sightline.export.exclusions",
            "sightline.export.response",
        ),
        (".ftl",),
    ),
    # templates and words of the report; its fonts come with Matplotlib and Typst, named by version
    DRAWING: (("sightline.export.derived", "sightline.export.page"), (".typ", ".ftl")),
}
#: The libraries whose versions a part's results depend on in the last digits, or in how they are drawn.
LIBRARIES = {
    HEIGHTS: (),
    LINES: (),
    WORDS: ("fluent.runtime", "babel"),
    STATISTICS: ("numpy", "scipy"),
    DRAWING: ("numpy", "scipy", "matplotlib", "pillow", "typst", "fluent.runtime", "babel"),
}


def made_with() -> dict[str, str]:
    """The program and its parts, by the hash of each part with all that it imports: what was made by the same
    parts and libraries, a check makes again and compares.
    """
    return {
        "sightline": code_version(),
        **{part: source_hash(*modules, texts=texts) for part, (modules, texts) in PARTS.items()},
        "page": page_version(),
        **{name: _version(name) for name in LIBRARIES[DRAWING]},
    }


_version = cache(version)  # reads and parses a file each time
