"""Invalid messages that pages of pointloom never send: `hostile_messages` and `near_messages`."""

import json
import random
from collections.abc import Iterator, Sequence
from typing import Any

from .pages import CAMERA, HELLO

HOSTILE_VALUES = [
    None, True, False, -1, 0, 1, 2**53, 2**63, -(2**63), 1e308, -1e308, 5e-324, 1.5, "", "x", "__class__",
    "../../etc/passwd", "<script>alert(1)</script>", "\0", "\ud800", "\u202e", "x" * 3000, [], [None], [[]], [1] * 4,
    [1e308] * 9, [0] * 1000, [[[[[[[[[[1]]]]]]]]]], {}, {"value": []}, [{}], [["a"], True], [["a"], 1], [[1], True],
    ["a", True], [0.9, 0.1],
]  # fmt: skip
KNOWN = {
    "hello": HELLO, "camera": CAMERA, "sign": {"n": 1}, "value": {"id": 1, "value": 1},
    "press": {"id": 1}, "command": {"id": 1}, "click": {"x": 0.5, "y": 0.5},
    "file": {"id": 1, "name": "a.json", "text": "{}"}, "resume": {},
}  # fmt: skip


def hostile_messages(ids: Sequence[int]) -> Iterator[str]:
    """Each field of each message with each hostile value, missing, and with additional fields."""
    for name, fields in KNOWN.items():
        message = {"say": name, **fields}
        for field in fields.keys() - {"say"}:
            yield json.dumps({key: value for key, value in message.items() if key != field})
            for value in HOSTILE_VALUES:
                yield json.dumps(message | {field: value})
        yield json.dumps(message | {"extra": 1, "__class__": {}, "constructor": None})
    for number in ids:
        for value in HOSTILE_VALUES:
            yield json.dumps({"say": "value", "id": number, "value": value})
        for name in ("press", "command"):
            yield json.dumps({"say": name, "id": number, "value": "__class__"})
        yield json.dumps({"say": "file", "id": number, "name": "../x", "text": "\0"})
    for name in ("", "Hello", "take", "__init__", "fraction", "node", "drop", "eval"):
        yield json.dumps({"say": name, "id": 1})


def near_messages(ids: Sequence[int], count: int, seed: int = 0) -> Iterator[str]:
    """Random messages with mostly valid fields."""
    picker = random.Random(seed)
    for _ in range(count):
        name = picker.choice(tuple(KNOWN))
        message: dict[str, Any] = {"say": name, **KNOWN[name]}
        if "id" in message:
            message["id"] = picker.choice(ids)
        if name == "camera":
            message["position"] = [picker.uniform(-5, 5) for _ in range(3)]
        if picker.random() < 0.7 and len(message) > 1:
            message[picker.choice([key for key in message if key != "say"])] = picker.choice(HOSTILE_VALUES)
        yield json.dumps(message)
