"""Validation of messages from pages: `read`. See docs/viewer-protocol.md for types and limits."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping
from typing import Any, NoReturn

import numpy as np

from .camera import MAX_COORDINATE, MAX_PIXELS, MIN_ANGLE, CameraState, nearest_rotation

MAX_BYTES = 1 << 20  # of a message with a file
MAX_SMALL_BYTES = 64 << 10  # of other messages
MAX_INTEGER = 2**53  # exact integers in a browser
MAX_DEPTH = 8  # nested lists

Check = Callable[[Any], bool]


def read(raw: str | bytes) -> dict[str, Any] | None:
    """The validated fields of a message, including "say".

    Returns None for unknown messages and fields out of range. Raises ValueError if it is not a message.
    """
    if not isinstance(raw, str):
        raise ValueError("not a message: expected text")
    if len(raw) > MAX_SMALL_BYTES and '"file"' not in raw[:64]:
        raise ValueError(f"not a message: of {len(raw)} characters")
    try:
        fields = json.loads(raw, parse_constant=_refuse)
    except (ValueError, RecursionError) as error:
        raise ValueError(f"not a message: {error}") from None
    if not isinstance(fields, dict) or not isinstance(fields.get("say"), str):
        raise ValueError("not a message: expected an object with the key say")
    checks = MESSAGES.get(fields["say"])
    if checks is None or (len(raw) > MAX_SMALL_BYTES and fields["say"] != "file"):
        return None
    if not all(name in fields and check(fields[name]) for name, check in checks.items()):
        return None
    return {"say": fields["say"], **{name: fields[name] for name in checks if name in fields}}


def camera_of(fields: Mapping[str, Any]) -> CameraState | None:
    """The camera of a checked message. None if its rotation is invalid."""
    rotation = nearest_rotation(np.reshape(fields["rotation"], (3, 3)))
    if rotation is None:
        return None
    size = (int(fields["size"][0]), int(fields["size"][1]))
    position, pivot = np.array(fields["position"], np.float64), np.array(fields["pivot"], np.float64)
    return CameraState(position, rotation, float(fields["fov"]), size, pivot, fields["orthographic"])


def is_number(value: object) -> bool:
    """True for finite numbers, not for booleans."""
    return isinstance(value, int | float) and not isinstance(value, bool) and is_finite(value)


def is_finite(value: float) -> bool:
    """True if a number is finite as a float. Integers may be too large."""
    try:
        return math.isfinite(value)
    except OverflowError:
        return False


def is_integer(value: Any) -> bool:
    """True for integers that a browser can represent."""
    return is_number(value) and abs(value) <= MAX_INTEGER and value == int(value)


def is_text(value: object, max_length: int = MAX_SMALL_BYTES) -> bool:
    if not isinstance(value, str) or len(value) > max_length:
        return False
    try:
        value.encode()
    except UnicodeEncodeError:  # a lone surrogate would be an error wherever it is written
        return False
    return True


def _refuse(constant: str) -> NoReturn:
    raise ValueError(f"{constant} is no number of JSON")


def _is_switch(value: object) -> bool:
    return isinstance(value, bool)


def _is_position(value: object) -> bool:
    return _numbers(value, 3, MAX_COORDINATE)


def _is_matrix(value: object) -> bool:
    return _numbers(value, 9, 2.0)


def _numbers(value: object, count: int, limit: float) -> bool:
    return isinstance(value, list) and len(value) == count and all(is_number(one) and abs(one) < limit for one in value)


def _is_size(value: object) -> bool:
    return (
        isinstance(value, list) and len(value) == 2 and all(is_integer(one) and 1 <= one <= MAX_PIXELS for one in value)
    )


def _is_angle(value: Any) -> bool:
    return is_number(value) and MIN_ANGLE <= value <= math.pi - MIN_ANGLE


def _is_fraction(value: Any) -> bool:
    return is_number(value) and 0 <= value <= 1


def _is_id(value: Any) -> bool:
    return is_integer(value) and value >= 1


def _is_version(value: Any) -> bool:
    return is_integer(value) and value >= 1


def _is_name(value: object) -> bool:
    return is_text(value, 255)


def _is_content(value: object) -> bool:
    return is_text(value, MAX_BYTES)


def _is_value(value: object) -> bool:
    """True for control values: text, number, boolean, or short lists of those."""
    waiting, depth = [value], 0
    while waiting and depth < MAX_DEPTH:
        if not all(isinstance(one, bool | list) or is_number(one) or is_text(one) for one in waiting):
            return False
        waiting = [inner for one in waiting if isinstance(one, list) for inner in one]
        depth += 1
    return not waiting


MESSAGES: dict[str, dict[str, Check]] = {
    "hello": {"size": _is_size, "version": _is_version},
    "camera": {
        **{"position": _is_position, "rotation": _is_matrix, "fov": _is_angle, "pivot": _is_position, "size": _is_size},
        "orthographic": _is_switch,
    },
    "sign": {"n": _is_id},
    "sync": {"n": _is_id},
    "value": {"id": _is_id, "value": _is_value},
    "press": {"id": _is_id},
    "command": {"id": _is_id},
    "click": {"x": _is_fraction, "y": _is_fraction},
    "file": {"id": _is_id, "name": _is_name, "text": _is_content},
    "resume": {},
}
