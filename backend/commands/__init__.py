"""The commands of the command line, one module each; `backend.cli` imports them when they are asked for."""
