"""The list of parts (CycloneDX 1.6) out of the two lock files: python -m tests.supply.sbom .build/sbom.json

What is installed is what the locks say, hash by hash, so nothing is asked of a network. Licences are those
that the packages state: the lock of npm holds them, Python's are read where the package is installed.
"""

import base64
import json
import re
import sys
from collections.abc import Iterator
from importlib.metadata import version
from pathlib import Path
from typing import Any
from urllib.parse import quote

from sightline.infra.licences import plain_name, stated_licence

ROOT = Path(__file__).resolve().parents[2]
FORMAT = {"bomFormat": "CycloneDX", "specVersion": "1.6", "version": 1}
_PINNED = re.compile(r"^([\w.-]+)(?:\[[^\]]*\])?==([^\s;\\]+)")
_HASH = re.compile(r"--hash=sha256:([0-9a-f]{64})")


def python_parts(lock: str) -> Iterator[dict[str, Any]]:
    """Every package of a requirements lock; a wheel for each system has its hash."""
    for block in re.split(r"\n(?=\S)", lock):
        if found := _PINNED.match(block):
            name, pinned = plain_name(found[1]), found[2]
            place = f"pkg:pypi/{quote(name)}@{quote(pinned)}"
            hashes = [("SHA-256", one) for one in _HASH.findall(block)]
            yield _part(name, pinned, place, hashes, stated_licence(name))


def npm_parts(lock: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """Every package of npm's lock that goes into the pages; what only builds and tests them does not."""
    for folder, one in lock["packages"].items():
        if folder and not one.get("dev") and not one.get("link"):
            name = folder.rpartition("node_modules/")[2]
            place = f"pkg:npm/{quote(name, safe='/')}@{quote(one['version'])}"
            kind, _, told = one.get("integrity", "").partition("-")
            hashes = [("SHA-512", base64.b64decode(told).hex())] if kind == "sha512" else []
            yield _part(name, one["version"], place, hashes, one.get("license"))


def _part(
    name: str, pinned: str, place: str, hashes: list[tuple[str, str]], licence: str | None
) -> dict[str, Any]:
    part: dict[str, Any] = {"type": "library", "bom-ref": place, "name": name, "version": pinned}
    part["purl"] = place
    part["hashes"] = [{"alg": kind, "content": content} for kind, content in hashes]
    if licence:
        part["licenses"] = [{"license": {"name": licence}}]
    return part


def sbom() -> dict[str, Any]:
    """The document; the same for the same locks and the same installation."""
    parts = [*python_parts((ROOT / "requirements.lock").read_text(encoding="utf-8"))]
    parts += npm_parts(json.loads((ROOT / "frontend" / "package-lock.json").read_text(encoding="utf-8")))
    unique = {part["bom-ref"]: part for part in parts}
    app = {
        "type": "application",
        "bom-ref": "sightline",
        "name": "sightline",
        "version": version("sightline"),
    }
    whole = [{"ref": "sightline", "dependsOn": sorted(unique)}]
    components = [unique[ref] for ref in sorted(unique)]
    return {**FORMAT, "metadata": {"component": app}, "components": components, "dependencies": whole}


if __name__ == "__main__":
    document = sbom()
    Path(sys.argv[1]).write_text(json.dumps(document, indent=2, ensure_ascii=False) + "\n", encoding="utf-8")
    silent = [part["name"] for part in document["components"] if "licenses" not in part]
    print(f"{sys.argv[1]}: {len(document['components'])} parts; no licence stated by: {silent or 'none'}")
