"""How much of the scene a page draws, in words: `told`."""

from __future__ import annotations


def told(drawn: int, total: int, triangles: int = 0) -> str:
    """What is drawn, in words: points where there are clouds, triangles where there are surfaces."""
    words = []
    if total >= 1_000_000:
        millions = f"{total / 1e6:.3g}" if total < 1e9 else f"{total / 1e6:,.0f}"
        words.append(f"{drawn / 1e6:.1f} of {millions} million points")
    elif total:
        words.append(_counted(total, "point") if drawn == total else f"{drawn:,} of {_counted(total, 'point')}")
    if triangles:
        words.append(_counted(triangles, "triangle"))
    return ", ".join(words)


def _counted(count: int, name: str) -> str:
    return f"{count:,} {name}{'' if count == 1 else 's'}"
