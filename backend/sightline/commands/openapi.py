"""Writes the API's description, for the front end's types: python -m sightline.commands.openapi FILE."""

import json
import sys
from pathlib import Path

from sightline.app import describe


def main(arguments: list[str]) -> int:
    """Write the description; exit status 2 without a file to write."""
    if len(arguments) != 1:
        print("Name the file to write: python -m sightline.commands.openapi FILE", file=sys.stderr)
        return 2
    target = Path(arguments[0])
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(json.dumps(describe(), indent=1) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
