"""Elements of XML files of unknown origin: `LimitedBuilder`."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from typing import Any

MAX_XML_DEPTH = 64  # maximum nesting. Real files have eight


class LimitedBuilder(ET.TreeBuilder):
    """Element tree without document type and with limited depth."""

    def __init__(self) -> None:
        super().__init__()
        self._depth = 0

    def doctype(self, *_: Any) -> None:
        raise ValueError("it declares a document type, which is not read")

    def start(self, tag: str, attrs: dict[str, str]) -> ET.Element:
        self._depth += 1
        if self._depth > MAX_XML_DEPTH:
            raise ValueError(f"more than {MAX_XML_DEPTH} elements are nested")
        return super().start(tag, attrs)

    def end(self, tag: str) -> ET.Element:
        self._depth -= 1
        return super().end(tag)
