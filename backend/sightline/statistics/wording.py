"""What intervals hold, in words."""

from collections.abc import Sequence

from sightline.messages.said import Said, listed


def holding(parts: Sequence[Said], sites: int | None) -> Said:
    """What intervals hold, one part or more, and for which roads, as the end of a sentence; sites: how many
    clusters, None: one site.
    """
    held = listed(parts) if len(parts) > 1 else Said("stat-alone", part=parts[0])
    return Said("stat-holding-place", parts=held) if sites is None else Said("stat-holding-sites", parts=held)
