"""`sightline board`: a checkerboard or ChArUco board to print (docs/formats.md)."""

from pathlib import Path

import click

from sightline.commands.files import write_whole
from sightline.commands.geometry_input import board_options
from sightline.commands.options import output_option
from sightline.geometry.board import Board


@click.command()
@board_options
@click.option(
    "--paper", help="A4 to A0, Letter, Tabloid, or WxH in mm (default: the smallest ISO sheet that fits)."
)
@output_option("PDF to write.")
def board(board: Board, paper: str | None, output: Path) -> None:
    """Make a calibration board as a PDF at true size, with a scale bar to check the print."""
    from sightline.cameras.printing.service import board_pdf

    write_whole(output, board_pdf(board, paper))
    click.echo(f"wrote {output}")
