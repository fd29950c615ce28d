"""Whether this run is `make proofs`."""

import os

PROOFS = os.environ.get("SIGHTLINE_PROOFS") == "1"
