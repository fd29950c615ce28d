"""docs/proofs.md: one section a bench, each under a first heading, which its bench alone writes."""

from __future__ import annotations

from pathlib import Path

PAGE = Path(__file__).resolve().parents[2] / "docs" / "proofs.md"


def put_section(text: str, page: Path = PAGE) -> None:
    """Puts a section, which begins with its heading, in the place of the one of the same heading, or last."""
    sections = _sections(page.read_text())
    heading = text.split("\n", 1)[0]
    sections[heading] = text.rstrip("\n")
    page.write_text("\n\n".join(sections.values()) + "\n")


def _sections(text: str) -> dict[str, str]:
    found: dict[str, list[str]] = {}
    for line in text.rstrip("\n").split("\n"):
        if line.startswith("# "):
            lines = found.setdefault(line, [])
        lines.append(line)
    return {heading: "\n".join(lines).rstrip("\n") for heading, lines in found.items()}
