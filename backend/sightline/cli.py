"""The command line (docs/formats.md): one lazy import per command, one sentence per error."""

import importlib
import os
import sys
from collections.abc import Sequence

import click

from sightline.children import kept_for_good
from sightline.errors import SightlineError

# name -> where it is; a command's module is imported when the command is asked for, so that --help is quick
COMMANDS = {
    "serve": "sightline.commands.serve:serve",
    "demo": "sightline.commands.demo:demo",
    "worker": "sightline.commands.worker:worker",
    "migrate": "sightline.commands.migrate:migrate",
    "sign-in-link": "sightline.commands.sign_in_link:sign_in_link",
    "board": "sightline.commands.board:board",
    "calibrate": "sightline.commands.calibrate:calibrate",
    "import-camera": "sightline.commands.import_camera:import_camera",
    "pose": "sightline.commands.pose:pose",
    "height": "sightline.commands.height:height",
    "follow": "sightline.commands.follow:follow_command",
    "adjust": "sightline.commands.adjust:adjust_command",
    "passes": "sightline.commands.passes:passes",
    "propose": "sightline.commands.propose:propose_command",
    "plan": "sightline.commands.plan:plan",
    "errors": "sightline.commands.errors:errors",
    "sightdistance": "sightline.commands.sightdistance:sightdistance",
    "study": "sightline.commands.study:study",
    "distribution": "sightline.commands.distribution:distribution",
    "catalogue": "sightline.commands.catalogue:catalogue",
    "linescan": "sightline.commands.linescan:linescan",
    "rig": "sightline.commands.rig:rig",
    "stream": "sightline.commands.stream:stream",
    "flow": "sightline.commands.flow:flow",
    "traffic": "sightline.commands.traffic:traffic",
    "import": "sightline.commands.import_:import_command",
    "export": "sightline.commands.export:export",
    "evidence": "sightline.commands.evidence:evidence",
    "verify": "sightline.commands.verify:verify",
    "checkpoint": "sightline.commands.checkpoint:checkpoint",
    "backup": "sightline.commands.backup:backup",
    "restore": "sightline.commands.backup:restore",
}


class LazyCommands(click.Group):
    """A group whose commands are imported by name."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        place = COMMANDS.get(cmd_name)
        if place is None:
            return None
        _one_thread_for_algebra()
        module, name = place.split(":")
        with kept_for_good():
            command = getattr(importlib.import_module(module), name)
        assert isinstance(command, click.Command)
        return command


@click.command(cls=LazyCommands, context_settings={"help_option_names": ["-h", "--help"]})
@click.option(
    "--version",
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=lambda context, _option, asked: _say_version(context) if asked else None,
    help="Show the version with its commit, and exit.",
)
def cli() -> None:
    """Heights of vehicles from roadside video, with their uncertainty and an audit trail."""


def _one_thread_for_algebra() -> None:
    """Before NumPy is loaded: our matrices are small, and threads of BLAS that wait for each other spin.

    The statistics of 1,250 heights: 1.6 s with one thread, 4.6 s (7.9 s of processor time) with two.
    """
    for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"):
        os.environ.setdefault(name, "1")


def _say_version(context: click.Context) -> None:
    from sightline.infra.version import code_version

    click.echo(f"sightline, version {code_version()}")
    context.exit()


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command. Exit status: 0, 2 for bad input, 1 for anything else."""
    try:
        status = cli.main(args=arguments, prog_name="sightline", standalone_mode=False)
        return status if isinstance(status, int) else 0
    except SightlineError as error:
        return _say(error.message, error.exit_status)
    except click.ClickException as error:
        return _say(_sentence(error), error.exit_code)
    except (click.exceptions.Abort, KeyboardInterrupt):
        return _say("Stopped.", 1)
    except BrokenPipeError:
        # Whoever read our output has gone; say nothing more, not even at interpreter exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except OSError as error:
        why = (error.strerror or str(error)).lower()
        return _say(f"{error.filename or 'A file'}: {why}; check it and try again.", 1)
    except Exception as error:
        if os.environ.get("SIGHTLINE_DEBUG"):
            raise
        name = type(error).__name__
        return _say(f"Something went wrong ({name}: {error}); set SIGHTLINE_DEBUG=1 to see where.", 1)


def _sentence(error: click.ClickException) -> str:
    """Click's complaint, with the way to its help."""
    said = " ".join(error.format_message().split()).rstrip(".")
    context = getattr(error, "ctx", None)
    where = context.command_path if context is not None else "sightline"
    return f"{said}; see {where} --help."


def _say(message: str, status: int) -> int:
    """One line on standard error, whatever the message holds."""
    print(" ".join(message.split()), file=sys.stderr)
    return status


if __name__ == "__main__":
    sys.exit(main())
