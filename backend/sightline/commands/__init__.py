"""The commands of the command line, one module each; `sightline.cli` imports them when they are asked for."""
