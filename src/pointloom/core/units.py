"""Units of length: name, symbol and length in meters.

A cloud of unknown unit is treated as meters (docs/adr/0029-lengths-have-units.md). EPSG register, units 9001 (meter),
9002 (foot), 9003 (US survey foot), 9102 (degree).
"""

from __future__ import annotations

import contextlib
import dataclasses
import math
import sys
import warnings
from collections.abc import Iterable, Iterator
from contextvars import ContextVar

from .argument_errors import HIDDEN_FILE
from .checks import check_positive, shown
from .escaped_text import escaped

SAME_FRACTION = 1e-7  # relative rounding tolerance of a known unit: the two feet differ by 2e-6
_silenced: ContextVar[tuple[type[Warning], ...]] = ContextVar("silenced", default=())
_NEAR_FRACTION = 1e-5  # relative tolerance of a rounded length against the unit named with it


_FOR_USERS = ("pointloom.cli.", "pointloom.open3d.")  # packages that only forward user calls
_AROUND_CALLS = ("pointloom.core.dropped_results", "pointloom.core.argument_errors")  # decorators of operations
_PASSED_OVER = ("pointloom.", "numpy.", "contextlib")  # modules where warnings are never the user's


class UnitWarning(UserWarning):
    """Lengths of different units are mixed, or probably are: a radius, scale or limit does not match the data.

    Also issued if float32 is coarser than the steps of a file that is read or written.

    Example:
        >>> import warnings, pointloom as loom
        >>> with warnings.catch_warnings():
        ...     warnings.simplefilter("error", loom.UnitWarning)  # make it an error
    """


class NonFiniteWarning(UserWarning):
    """Normals, covariances, colors or speeds of some points are NaN or infinite. These points are not used.

    Example:
        >>> import warnings, pointloom as loom
        >>> from pointloom.core.units import NonFiniteWarning
        >>> with warnings.catch_warnings():
        ...     warnings.simplefilter("error", NonFiniteWarning)  # make it an error
    """


@dataclasses.dataclass(frozen=True, eq=False)
class LengthUnit:
    """The unit of coordinates. It equals its name: `cloud.unit == "foot"`.

    Attributes:
        name: Such as "foot".
        symbol: The suffix of numbers.
        meters: Length of one unit [m]. None for degrees of longitude and latitude.

    Raises:
        TypeError: Name or symbol is no string, or the length is no number.
        ValueError: Name or symbol is empty or not one line of ASCII, or the length is not positive.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.core.units import LengthUnit
        >>> cloud = loom.PointCloud([[0, 0, 0], [0, 0, 10]], unit="foot")
        >>> cloud.unit
        LengthUnit(name='foot', symbol='ft', meters=0.3048)
        >>> link = LengthUnit("Gunter's link", "li", 0.201168)  # a unit that is not known by name
        >>> loom.PointCloud([[0, 0, 10]], unit=link).to_unit("metre").points.round(5).tolist()
        [[0.0, 0.0, 2.01168]]
    """

    name: str
    symbol: str
    meters: float | None

    def __post_init__(self) -> None:
        for what, text in (("name", self.name), ("symbol", self.symbol)):
            if not isinstance(text, str):
                raise TypeError(f"{what}: expected text, got {type(text).__name__}")
            if not text.strip() or not (text.isprintable() and text.isascii()):
                raise ValueError(f"{what}: expected a line of ASCII, got {shown(text)}")
        if self.meters is not None:
            object.__setattr__(self, "meters", check_positive("meters", self.meters))

    def __str__(self) -> str:
        return self.name

    @property
    def json_value(self) -> str:
        """Its name, for reports."""
        return self.name

    def in_words(self) -> str:
        """Its name and length in words."""
        if self.meters is None:
            return f"{self.name}, of longitude and latitude"
        return self.name if self.meters == 1 else f"{self.name} ({self.meters:.12g} m)"

    def __eq__(self, other: object) -> bool:
        if isinstance(other, LengthUnit):
            return (self.name, self.meters) == (other.name, other.meters)
        return self.name == other if isinstance(other, str) else NotImplemented

    def __hash__(self) -> int:
        return hash(self.name)


METRE = LengthUnit("metre", "m", 1.0)
FOOT = LengthUnit("foot", "ft", 0.3048)
US_FOOT = LengthUnit("US survey foot", "US ft", 1200 / 3937)
DEGREE = LengthUnit("degree", "deg", None)
KNOWN = (
    METRE, FOOT, US_FOOT, DEGREE, LengthUnit("kilometre", "km", 1000.0), LengthUnit("centimetre", "cm", 0.01),
    LengthUnit("millimetre", "mm", 0.001), LengthUnit("inch", "in", 0.0254), LengthUnit("yard", "yd", 0.9144),
)  # fmt: skip

# Other spellings, lower case without `_` and `-`.
_OTHER_NAMES = {
    "meter": "metre", "meters": "metre", "metres": "metre", "kilometer": "kilometre", "centimeter": "centimetre",
    "millimeter": "millimetre", "feet": "foot", "international foot": "foot", "foot intl": "foot",
    "us foot": "US survey foot", "us feet": "US survey foot", "us survey feet": "US survey foot",
    "foot us": "US survey foot", "foot survey us": "US survey foot", "survey foot": "US survey foot",
    "inches": "inch", "yards": "yard", "degrees": "degree",
}  # fmt: skip
_BY_NAME = {**{u.name.lower(): u for u in KNOWN}, **{u.symbol.lower(): u for u in KNOWN}}
_BY_NAME |= {other: _BY_NAME[name.lower()] for other, name in _OTHER_NAMES.items()}


def unit_by_name(name: str) -> LengthUnit | None:
    """The unit with this name or symbol in any common spelling, or None."""
    return _BY_NAME.get(" ".join(name.lower().replace("_", " ").replace("-", " ").split()))


def check_unit(name: str, value: object) -> LengthUnit | None:
    if value is None or isinstance(value, LengthUnit):
        return value
    if not isinstance(value, str):
        raise TypeError(f"{name}: expected the name of a unit, such as 'foot', got {type(value).__name__}")
    known_unit = unit_by_name(value)
    if known_unit is None:
        known = ", ".join(unit.name for unit in KNOWN)
        raise ValueError(
            f"{name}: expected one of {known}, got {shown(value)}; create others with LengthUnit(name, symbol, m)"
        )
    return known_unit


def unit_by_length(name: str, meters: float) -> LengthUnit | None:
    """The unit with this name and length [m]. None if they contradict each other."""
    if not (math.isfinite(meters) and meters > 0):
        return None
    named = unit_by_name(name)
    if named is not None and (named.meters is None or abs(meters / named.meters - 1) > _NEAR_FRACTION):
        return None
    for unit in KNOWN:
        if unit.meters is not None and abs(meters / unit.meters - 1) <= SAME_FRACTION:
            return unit
    if named is not None:  # of few digits
        return named
    if not (name.strip() and name.isprintable() and name.isascii()):
        name = f"unit of {meters:.9g} m"
    return LengthUnit(name, name, meters)


def text_of(unit: LengthUnit) -> str:
    """A unit as one line for files: its name, and its length if the name is not known."""
    is_known = unit.meters is None or unit_by_name(unit.name) == unit
    return unit.name if is_known else f"{unit.name} = {unit.meters!r} m"


def unit_of_text(text: str) -> LengthUnit | None:
    """Inverse of `text_of`. None for other text."""
    name, separator, length = text.strip().rpartition(" = ")
    if not separator:
        unit = unit_by_name(text)
        return unit if unit == text.strip() else None
    number, _, metre = length.partition(" ")
    try:
        return unit_by_length(name, float(number)) if metre == "m" else None
    except ValueError:
        return None


def is_same(a: LengthUnit | None, b: LengthUnit | None) -> bool:
    return a is None or b is None or a.meters == b.meters


def symbol_of(unit: LengthUnit | None) -> str:
    return "m" if unit is None else unit.symbol


def common_unit(name: str, units: Iterable[LengthUnit | None]) -> LengthUnit | None:
    """The common unit. Unknown units adopt that of the others. Returns None with a warning if units differ."""
    known = [unit for unit in units if unit is not None]
    other = next((unit for unit in known if not is_same(unit, known[0])), None)
    if other is None:
        return known[0] if known else None
    remedy = 'Convert a cloud with to_unit("metre"), or set cloud.unit if a unit is wrong'
    if None in (known[0].meters, other.meters):
        remedy = "Convert degrees with project_to_utm(cloud), or set cloud.unit if a unit is wrong"
    warn_of_units(f"{name}: expected one unit of length, got {known[0]} and {other}. {remedy}")
    return None


@contextlib.contextmanager
def without_warnings(category: type[Warning]) -> Iterator[None]:
    """Silence a category of `warn_of_units` in this thread; `warnings.catch_warnings` would affect all threads."""
    token = _silenced.set((*_silenced.get(), category))
    try:
        yield
    finally:
        _silenced.reset(token)


def warn_of_units(message: str, category: type[Warning] = UnitWarning) -> None:
    """Warn at the user's line, unless `without_warnings` encloses the call."""
    if not issubclass(category, _silenced.get()):
        warnings.warn(escaped(message), category, stacklevel=_user_level())


def called_by_user() -> bool:
    """True if the calling operation was called by user code or a command, not by another operation."""
    frame = sys._getframe(2)
    operation_module = frame.f_globals.get("__name__", "")
    while frame.f_back is not None and frame.f_globals.get("__name__", "") in (operation_module, *_AROUND_CALLS):
        frame = frame.f_back
    name = frame.f_globals.get("__name__", "")
    return not name.startswith("pointloom.") or name.startswith(_FOR_USERS)


def _user_level() -> int:
    """The stack level of the user's code, as seen from `warn_of_units`."""
    level, frame = 2, sys._getframe(2)
    while frame.f_back is not None and frame.f_globals.get("__name__", "").startswith(_PASSED_OVER):
        level, frame = level + (frame.f_code.co_filename != HIDDEN_FILE), frame.f_back  # as `warnings` counts
    return level
