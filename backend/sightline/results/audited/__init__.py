"""The audit trail as people read it: what was done to which vehicle, not which row."""
