"""The heights of standards that a survey is read against until it has a table of its own.

They lie in `standards.csv`, in the form that a package has it: an editable beginning.

Nothing in it was read in the standards themselves unless `cited_by` is empty: it says who cites the value, or
that nobody was seen to. A percentile is the rule behind a value where a source states it.
"""

from pathlib import Path

from sightline.infra.csv_package.files import FolderFiles
from sightline.results.csv import standards_in

STANDARDS = standards_in(FolderFiles(Path(__file__).parent))
