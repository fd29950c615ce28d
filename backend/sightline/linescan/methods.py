"""Motion by either method: the default's warped registration, or the paper's block matching."""

from collections.abc import Callable

from sightline.enums import ScanMethod
from sightline.linescan.direct import measure_direct
from sightline.linescan.paper import measure_paper
from sightline.linescan.parts import Motion, Passage, Rig

MEASURE: dict[ScanMethod, Callable[[Passage, Rig], Motion]] = {
    "direct": measure_direct,
    "paper": measure_paper,
}
