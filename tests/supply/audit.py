"""Known faults of the packages in the locks: python -m tests.supply.audit (0: none, 1: some, 2: not asked).

pip-audit has a virtual environment of its own (.build/audit): what it needs is no part of the app.
"""

import json
import subprocess
import sys
import venv
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
TOOL = ROOT / ".build" / "audit"
TIMEOUT_S = 300


class NotAsked(Exception):
    """Why nothing is known."""


def faults_in_python() -> list[str]:
    """What pip-audit says of the lock. Raises NotAsked."""
    program = TOOL / "bin" / "pip-audit"
    if not program.exists():
        venv.create(TOOL, with_pip=True)
        made = _run(str(TOOL / "bin" / "pip"), "--quiet", "install", "pip-audit")
        if made.returncode != 0:
            raise NotAsked("pip-audit cannot be installed here")
    lock = str(ROOT / "requirements.lock")
    asked = _run(str(program), "--disable-pip", "--require-hashes", "-r", lock, "--format", "json")
    return python_faults(asked.stdout)


def python_faults(told: str) -> list[str]:
    """The faults in pip-audit's JSON. Raises NotAsked where there is none."""
    found = _json(told)
    if found is None or "dependencies" not in found:
        raise NotAsked("the list of faults of Python packages cannot be reached from here")
    return [
        f"{one['name']} {one['version']}: {fault['id']}"
        for one in found["dependencies"]
        for fault in one.get("vulns", ())
    ]


def faults_in_pages() -> list[str]:
    """What npm says of the packages that go into the pages. Raises NotAsked."""
    return npm_faults(_run("npm", "--prefix", str(ROOT / "frontend"), "audit", "--omit=dev", "--json").stdout)


def npm_faults(told: str) -> list[str]:
    """The faults in npm's JSON. Raises NotAsked where there is none."""
    found = _json(told)
    if found is None or "vulnerabilities" not in found:
        raise NotAsked("the list of faults of npm packages cannot be reached from here")
    return [f"{name}: {one['severity']}" for name, one in found["vulnerabilities"].items()]


def _json(told: str) -> dict[str, Any] | None:
    try:
        found = json.loads(told)
    except ValueError:
        return None
    return found if isinstance(found, dict) else None


def _run(*command: str) -> "subprocess.CompletedProcess[str]":
    try:
        return subprocess.run(command, capture_output=True, text=True, timeout=TIMEOUT_S, check=False)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise NotAsked(f"{Path(command[0]).name} did not run or did not end") from error


def main() -> int:
    status = 0
    for what, ask in (("requirements.lock", faults_in_python), ("package-lock.json", faults_in_pages)):
        try:
            faults = ask()
        except NotAsked as error:
            print(f"{what}: not checked, for {error}; run it where the network is open.", file=sys.stderr)
            status = 2
            continue
        print(f"{what}: {'; '.join(faults) or 'no known faults'}.")
        status = max(status, int(bool(faults)))
    return status


if __name__ == "__main__":
    sys.exit(main())
