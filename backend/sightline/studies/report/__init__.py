"""The report of a study as PDF."""
