"""What intervals hold, in words."""

from collections.abc import Sequence

from sightline.enums import IntervalPart
from sightline.messages.said import Said, join_with_and


def interval_contents(
    parts: Sequence[IntervalPart], sites: int | None, random: Said, *, unlike: bool = False
) -> Said:
    """What intervals hold, one part or more, and for which roads, as the end of a sentence; sites: how many
    clusters, None: one site; random: what is said of the random error; unlike: whether the sites differ as
    much as their vehicles.
    """
    words: dict[IntervalPart, Said] = {
        "sampling": Said("stat-sampling"),
        "sites": Said("stat-sites", sites=sites),
        "shared_errors": Said("stat-shared-errors"),
        "random_error": random,
        "known_heights": Said("stat-known-heights"),
    }
    said = [words[part] for part in parts]
    held = join_with_and(said) if len(said) > 1 else Said("stat-alone", part=said[0])
    if sites is None:
        return Said("stat-holding-place", parts=held)
    if unlike:
        return Said("stat-holding-unlike-sites", parts=held)
    return Said("stat-holding-sites", parts=held)
