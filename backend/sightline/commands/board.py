"""`sightline board`: a checkerboard or ChArUco board to print (docs/formats.md)."""

from __future__ import annotations

from pathlib import Path

import click

from sightline.commands.files import write_whole
from sightline.commands.geometry import board_options, parse_board


@click.command()
@board_options
@click.option(
    "--paper", help="A4 to A0, Letter, Tabloid, or WxH in mm (default: the smallest ISO sheet that fits)."
)
@click.option("-o", "--output", type=click.Path(path_type=Path), required=True, help="PDF to write.")
def board(
    board_text: str,
    square_m: float,
    charuco: str | None,
    marker_m: float | None,
    paper: str | None,
    output: Path,
) -> None:
    """Make a calibration board as a PDF at true size, with a scale bar to check the print."""
    from sightline.cameras.printing.service import board_pdf

    made = board_pdf(parse_board(board_text, square_m, charuco, marker_m), paper)
    write_whole(output, made)
    click.echo(f"wrote {output}")
