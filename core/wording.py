"""Results in words: numbers as people read them, and reports as JSON text.

Nothing heavy is imported here, so that `--help` stays quick.
"""

from __future__ import annotations

import dataclasses
import json
import math
from collections.abc import Iterable, Sequence
from typing import Any

from .escaped_text import escaped, escaped_json

MOST_DECIMALS = 15  # that `rounded` leaves; Python has no more of numbers near 1


def few_of(names: Sequence[str], most: int) -> str:
    """The first of some names, and dots where there are more."""
    return escaped(", ".join(names[:most])) + (", ..." if len(names) > most else "")


def format_share(share: float) -> str:
    """A share as a percentage, with digits enough that only nothing is 0.0% and only all is 100.0%."""
    rest = min(share, 1 - share)
    digits = max(1, math.ceil(-math.log10(100 * rest))) if rest > 0 else 1
    return f"{share:.{digits}%}"


def format_bytes(count: float) -> str:
    """A number of bytes as people read it: "1.5 MiB"."""
    for unit in ("B", "KiB", "MiB"):
        if count < 1024:
            return f"{count:.0f} B" if unit == "B" else f"{count:.1f} {unit}"
        count /= 1024
    return f"{count:.1f} GiB"


def format_seconds(seconds: dict[str, float]) -> str:
    """Seconds of each stage and of all: "open 0.02, integrate 1.21, all 1.23"."""
    parts = [f"{stage} {value:.2f}" for stage, value in seconds.items()]
    return ", ".join([*parts, f"all {sum(seconds.values()):.2f}"])


def format_triple(values: Iterable[float]) -> str:
    """Three coordinates, to a tenth of a millimetre."""
    return "[" + ", ".join(f"{value:.4f}" for value in values) + "]"


def format_bounds(bounds: dict[str, Any] | None) -> str:
    """The lowest and highest corner of a box, or that there is none."""
    if bounds is None:
        return "none: no finite point"
    return f"{format_triple(bounds['min'])} to {format_triple(bounds['max'])}"


def json_text(report: dict[str, Any]) -> str:
    """A report as JSON text, indented; what is not a finite number becomes null."""
    return escaped_json(json.dumps(plain(report), indent=2, allow_nan=False, ensure_ascii=False))


def plain(value: Any) -> Any:
    """A value in JSON's own types; what is not a finite number becomes None."""
    if callable(getattr(value, "to_dict", None)):  # a Report
        return value.to_dict()
    if hasattr(value, "json_value"):  # a LengthUnit
        return value.json_value
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return {field.name: plain(getattr(value, field.name)) for field in dataclasses.fields(value)}
    if isinstance(value, dict):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    if callable(as_list := getattr(value, "tolist", None)):  # NumPy's arrays and numbers
        return plain(as_list())
    if isinstance(value, float):
        return value if value - value == 0 else None
    if value is None or isinstance(value, bool | int | str):
        return value
    return str(value)


def rounded(values: Any, size: float) -> Any:
    """Numbers as they are shown of what has a size, to a millionth of it; of tiny ones all digits.

    Args:
        values: A number, an array (which becomes lists), or lists and tuples of such.
        size: A length in the same unit.
    """
    if isinstance(values, list | tuple):
        return type(values)(rounded(value, size) for value in values)
    if hasattr(values, "tolist"):
        return rounded(values.tolist(), size)
    decimals = 6 - math.floor(math.log10(size)) if 0 < size < math.inf else 6
    return values if decimals > MOST_DECIMALS else round(values, decimals) + 0.0  # no -0.0
