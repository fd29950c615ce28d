"""Hostile input by the thousand, from a seed: `make hostile` (python -m tests.load.hostile.run)."""
