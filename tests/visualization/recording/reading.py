"""Reads a page as its player does: `Page`."""

import base64
import json
import re
import zlib
from html.parser import HTMLParser
from pathlib import Path

import numpy as np


class _Elements(HTMLParser):
    """Collects all elements with their attributes, and the text of each script, title and style."""

    def __init__(self):
        super().__init__()
        self.elements: list[tuple[str, dict[str, str | None]]] = []
        self.texts: list[tuple[str, dict[str, str | None], str]] = []
        self._open = None

    def handle_starttag(self, tag, attrs):
        self.elements.append((tag, dict(attrs)))
        self._open = None
        if tag in ("script", "style", "title"):
            self.texts.append((tag, dict(attrs), ""))
            self._open = tag

    def handle_endtag(self, tag):
        self._open = None

    def handle_data(self, data):
        if self._open:
            tag, attributes, text = self.texts[-1]
            self.texts[-1] = tag, attributes, text + data


class Page:
    """The content of a page: `description`, `arrays`, `elements` and texts of scripts, style and title."""

    def __init__(self, path: Path):
        self.text = path.read_text(encoding="utf-8")
        parser = _Elements()
        parser.feed(self.text)
        parser.close()
        self.elements, texts = parser.elements, parser.texts
        self.title = "".join(text for tag, _, text in texts if tag == "title")
        self.styles = [text for tag, _, text in texts if tag == "style"]
        self.scripts = [text for tag, attributes, text in texts if tag == "script" and "type" not in attributes]
        (described,) = (text for _, attributes, text in texts if attributes.get("id") == "description")
        self.description = json.loads(described)
        pieces: dict[int, bytes] = {}
        for _, attributes, text in texts:
            if "data-array" in attributes:
                number = int(attributes["data-array"] or 0)
                pieces[number] = pieces.get(number, b"") + base64.b64decode(text, validate=True)
        table, block = self.description["arrays"], self.description["block"]
        self.arrays = [_join(zlib.decompress(pieces[number], -15), each, block) for number, each in enumerate(table)]

    def array(self, number: int | None) -> np.ndarray | None:
        return None if number is None else self.arrays[number]

    def pose(self, number: int) -> np.ndarray:
        return np.vstack([self.arrays[self.description["poses"]][number].reshape(3, 4), [0, 0, 0, 1]])

    def shown(self, frame: int) -> dict[str, tuple[list[int], np.ndarray]]:
        placements = [self.description["placements"][number] for number in self.description["frames"][frame]["shown"]]
        return {self.description["items"][item]: (shapes, self.pose(pose)) for item, shapes, pose in placements}

    def policy(self) -> dict[str, list[str]]:
        (content,) = (a["content"] for tag, a in self.elements if a.get("http-equiv") == "Content-Security-Policy")
        assert content is not None
        return {words[0]: words[1:] for words in map(str.split, content.split(";"))}


def _join(data: bytes, described: dict, block: int) -> np.ndarray:
    """Restore bytes that were split by significance."""
    dtype, rows, width = np.dtype("<" + described["kind"]), described["rows"], described["width"]
    stride, parts, start = dtype.itemsize * width, [np.empty((0, width), dtype)], 0
    for row in range(0, rows, block):
        count = min(block, rows - row)
        planes = np.frombuffer(data, np.uint8, count * stride, start).reshape(stride, count)
        parts.append(np.ascontiguousarray(planes.T).view(dtype))
        start += count * stride
    assert start == len(data)
    return np.concatenate(parts)


def outside_addresses(text: str) -> list[str]:
    """All strings that could refer to another host."""
    return re.findall(r"(?:https?:|wss?:|ftp:)?//[\w.-]+\.\w+[^\s\"'<>]*", text)
