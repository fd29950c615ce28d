"""How long tests wait for what must come."""

#: A busy machine is slow, not wrong: only what never comes fails. A run that passes never waits this long.
NEVER_S = 120.0
