"""Random changes of a package, each with all sums made to fit: `bench_forgery.py [PACKAGE [COUNT [SEED]]]`.

PACKAGE is a folder that `sightline export` wrote, of a small demonstration unless told (COUNT 200, SEED 0).
Each change is of one cell, line, column, key, byte or file, and `sightline verify` must find it: asked, 0
missed. Then, of 1 change in 20, what is found although the seal, the chain's last event, was written anew as
well and signed with a key of the forger's own: that takes the installation's key, and what rows, drawings and
other events give away without it is a second line only.
"""

from __future__ import annotations

import sys
import tempfile
from collections import Counter
from pathlib import Path
from random import Random
from time import perf_counter

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from tests.load.hostile.run import package_in
from tests.support.mutations import checked, load, mutated, with_sums

_EVERY = 20


def main(place: Path, count: int, seed: int) -> int:
    package, random = load(place), Random(seed)
    whole = checked(package)
    assert whole.ok, whole.problem
    missed, behind, tried, files = [], [], 0, Counter[str]()
    start = perf_counter()
    for n in range(count):
        words, changed = mutated(package, random)
        files[words.partition(",")[0].partition(":")[0]] += 1
        if checked(with_sums(changed, package)).ok:
            missed.append(words)
        if n % _EVERY == 0:
            tried += 1
            if checked(with_sums(changed, package, seal=True)).ok:
                behind.append(words)
    took = perf_counter() - start
    print(f"{count} changes of {len(files)} files, {took:.0f} s; missed {len(missed)}, asked 0")
    print(*missed, sep="\n")
    print(f"sealed and signed anew by others, {tried} tried: {len(behind)} are told by the key alone")
    print(*behind, sep="\n")
    return 1 if missed else 0


if __name__ == "__main__":
    place, count, seed = (*sys.argv[1:], *("", "200", "0")[len(sys.argv) - 1 :])
    with tempfile.TemporaryDirectory() as folder:
        sys.exit(main(Path(place) if place else package_in(Path(folder)), int(count), int(seed)))
