"""Format numbers and reports as text; imports nothing slow, so that `--help` is fast."""

from __future__ import annotations

import dataclasses
import json
import math
from collections.abc import Iterable, Sequence
from typing import Any

from .escaped_text import escaped, escaped_json

MAX_DECIMALS = 15  # decimals that `rounded` leaves. Python has no more near 1


def few_of(names: Sequence[str], max_names: int) -> str:
    return escaped(", ".join(names[:max_names])) + (", ..." if len(names) > max_names else "")


def format_fraction(fraction: float) -> str:
    """A fraction as a percentage. Only 0 prints 0.0% and only 1 prints 100.0%."""
    rest = min(fraction, 1 - fraction)
    digits = max(1, math.ceil(-math.log10(100 * rest))) if rest > 0 else 1
    return f"{fraction:.{digits}%}"


def format_bytes(count: float) -> str:
    """A size such as "1.5 MiB"."""
    for unit in ("B", "KiB", "MiB"):
        if count < 1024:
            return f"{count:.0f} B" if unit == "B" else f"{count:.1f} {unit}"
        count /= 1024
    return f"{count:.1f} GiB"


def format_seconds(seconds: dict[str, float]) -> str:
    """Seconds per stage and in total: "open 0.02, integrate 1.21, all 1.23"."""
    parts = [f"{stage} {value:.2f}" for stage, value in seconds.items()]
    return ", ".join([*parts, f"all {sum(seconds.values()):.2f}"])


def format_duration(seconds: float) -> str:
    """A rough duration: "40 s", "12 min", "2 h 5 min"."""
    if seconds < 100:
        return f"{max(round(seconds), 1)} s"
    minutes = round(seconds / 60)
    return f"{minutes} min" if minutes < 60 else f"{minutes // 60} h {minutes % 60} min"


def format_times(first: float, last: float) -> str:
    """The first and last time [s], with the digits of a clock since 1970. "none" if first > last."""
    return f"{first:.16g} to {last:.16g} s" if first <= last else "none"


def format_triple(values: Iterable[float]) -> str:
    return "[" + ", ".join(f"{value:.4f}" for value in values) + "]"


def format_bounds(bounds: dict[str, Any] | None) -> str:
    """The corners of a box, or a text if there is none."""
    if bounds is None:
        return "none: no finite point"
    return f"{format_triple(bounds['min'])} to {format_triple(bounds['max'])}"


def json_text(report: dict[str, Any]) -> str:
    return escaped_json(json.dumps(plain(report), indent=2, allow_nan=False, ensure_ascii=False))


def plain(value: Any) -> Any:
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
    if callable(as_list := getattr(value, "tolist", None)):  # NumPy arrays and numbers
        return plain(as_list())
    if callable(as_numpy := getattr(value, "numpy", None)):  # Warp arrays
        return plain(as_numpy())
    if isinstance(value, float):
        return value if value - value == 0 else None
    if value is None or isinstance(value, bool | int | str):
        return value
    return str(value)


def rounded(values: Any, size: float) -> Any:
    """Round numbers, arrays (to lists) or nested lists to a millionth of `size`. Tiny sizes keep all digits."""
    if isinstance(values, list | tuple):
        return type(values)(rounded(value, size) for value in values)
    if hasattr(values, "tolist"):
        return rounded(values.tolist(), size)
    decimals = 6 - math.floor(math.log10(size)) if 0 < size < math.inf else 6
    return values if decimals > MAX_DECIMALS else round(values, decimals) + 0.0  # no -0.0
