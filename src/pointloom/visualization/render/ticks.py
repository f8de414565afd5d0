"""Round numbers along an axis: `choose_ticks`, `with_ends`."""

from __future__ import annotations

import dataclasses
import math

MAX_DIGITS = 7  # of a label. Longer ones use an offset
MIN_LARGE_VALUE, MAX_SMALL_VALUE = (
    1e7,
    1e-4,
)  # ticks from MIN_LARGE_VALUE on, and up to MAX_SMALL_VALUE, share a power of 10
MIN_RELATIVE_RANGE = 1e-12  # relative: smaller ranges count as empty


@dataclasses.dataclass(frozen=True)
class Ticks:
    """Ticks at ascending `values` of an axis. An empty range is widened. Labels are (value - offset) / 10^exponent."""

    low: float
    high: float
    values: tuple[float, ...]
    texts: tuple[str, ...]
    offset: float = 0.0
    exponent: int = 0

    def title(self, text: str) -> str:
        """A title such as "height [m]" with offset and exponent: "height [1e-9 m]"."""
        if self.offset:
            text = f"{text} {'−' if self.offset > 0 else '+'} {_plain(abs(self.offset))}"
        if not self.exponent:
            return text
        head, bracket, unit = text.partition("[")
        if not bracket:
            return f"{text} [1e{self.exponent}]".strip()
        return f"{head}[1e{self.exponent} {unit}"


def choose_ticks(low: float, high: float, max_count: int) -> Ticks:
    """At most `max_count` (>= 2) ticks at multiples of 1, 2 or 5 times a power of 10.

    Example:
        >>> choose_ticks(0.0, 0.9, 6).texts
        ('0.0', '0.2', '0.4', '0.6', '0.8')
        >>> choose_ticks(0.0, 3e-9, 4).title("distance [m]")
        'distance [1e-9 m]'
    """
    low, high = widen(low, high)
    step, power = _step(low, high, max(max_count, 2))
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    values = [k * step for k in range(first, last + 1)]
    largest = max(abs(low), abs(high))
    offset = 0.0
    if _power(largest) - power >= MAX_DIGITS:
        unit = 10.0 ** (_power(high - low) + 1)
        offset = math.floor(low / unit) * unit
        largest = max(abs(low - offset), abs(high - offset))
    exponent = 0
    if largest >= MIN_LARGE_VALUE or largest <= MAX_SMALL_VALUE:
        exponent = 3 * (_power(largest) // 3)
    digits = max(0, exponent - power)
    texts = [_text((value - offset) / 10.0**exponent, digits) for value in values]
    return Ticks(low, high, tuple(values), tuple(texts), offset, exponent)


def with_ends(ticks: Ticks, apart: float) -> Ticks:
    """Add both ends of the axis with one more digit. Ticks nearer to an end than `apart` of the axis are removed.

    Example:
        >>> with_ends(choose_ticks(0.13, 1.94, 4), 0.1).texts
        ('0.13', '0.5', '1.0', '1.5', '1.94')
    """
    span = ticks.high - ticks.low
    digits = len(ticks.texts[0].partition(".")[2]) if ticks.texts else 0
    known = dict(zip(ticks.values, ticks.texts, strict=True))
    near = [value for value in known if min(value - ticks.low, ticks.high - value) < apart * span]
    ends = []
    for end in (ticks.low, ticks.high):
        same = next((text for value, text in known.items() if abs(value - end) <= 1e-9 * span), None)
        number = (end - ticks.offset) / 10.0**ticks.exponent
        is_short = float(f"{number:.{digits + 1}f}") == float(f"{number:.{digits}f}")
        ends.append((end, same or _text(number, digits if is_short else digits + 1)))
    inner = [(value, text) for value, text in known.items() if value not in near]
    values, texts = zip(ends[0], *inner, ends[1], strict=True)
    return dataclasses.replace(ticks, values=values, texts=texts)


def count_ticks(length: int, size: int) -> int:
    """Number of ticks for a length and font size [px]: at least 4 if they fit."""
    return max(2, min(4, round(length / (1.5 * size))), length // (3 * size))


def widen(low: float, high: float) -> tuple[float, float]:
    """Ends of a nonempty axis. 0 and 1 if not finite."""
    if not (math.isfinite(low) and math.isfinite(high) and math.isfinite(high - low)):
        return 0.0, 1.0
    largest = max(abs(low), abs(high))
    if high - low > MIN_RELATIVE_RANGE * largest and high - low > 1e-290:
        return low, high
    pad = 0.05 * largest if largest > 1e-280 else 0.5
    return low - pad, high + pad


def _step(low: float, high: float, max_count: int) -> tuple[float, int]:
    power = _power((high - low) / max_count)
    while True:
        for factor in (1, 2, 5):
            step = factor * 10.0**power if power >= 0 else factor / 10.0**-power
            if math.floor(high / step + 1e-9) - math.ceil(low / step - 1e-9) + 1 <= max_count:
                return step, power
        power += 1


def _power(value: float) -> int:
    return math.floor(math.log10(value)) if value > 0 else 0


def _text(value: float, digits: int) -> str:
    text = f"{value:.{digits}f}"
    return text.replace("-", "−") if float(text) else f"{0:.{digits}f}"


def _plain(value: float) -> str:
    return f"{value:.10g}"
