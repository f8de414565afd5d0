"""Check of the number of matches between two sequences, such as poses by time or images by name."""

from __future__ import annotations

from .wording import format_fraction

# Minimum fraction of the possible matches. With fewer, most of the data has no partner: figures of the rest do
# not describe it, and the clocks or names probably differ.
MIN_MATCHED = 0.5


def why_few_matched(matched: int, possible: int, what: str, remedy: str) -> str | None:
    """Warning if less than half of the possible matches were found, else None.

    Example:
        >>> why_few_matched(2, 50, "poses match in time", "use times of one clock")
        'only 2 of 50 poses match in time (4.0%): use times of one clock'
        >>> why_few_matched(25, 50, "poses match in time", "use times of one clock")
    """
    if matched >= MIN_MATCHED * possible:
        return None
    return f"only {matched:,} of {possible:,} {what} ({format_fraction(matched / possible)}): {remedy}"
