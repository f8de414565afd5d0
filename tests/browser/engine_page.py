"""A page with the engine alone, without a server."""

from __future__ import annotations

import base64
import io
import json
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from pointloom.visualization.page import sources

from .pixels import picture, ready

PAGE = """<!doctype html><html><head><meta charset="utf-8"><link rel="icon" href="data:,"><title>engine</title>
<style>html, body {{ margin: 0; height: 100%; }} #stage {{ position: relative; height: 100%; }}
canvas#scene {{ position: absolute; inset: 0; width: 100%; height: 100%; outline: none; }}
{style}</style></head><body><div id="stage"><canvas id="scene" tabindex="0"></canvas>
<div id="overlay" class="overlay"></div></div><script>{script}</script></body></html>"""

# Arrays come as base64; `f2` is half floats, as the engine takes them.
START = """
window.reported = { cameras: [], clicks: [], lost: [] };
window.types = { f4: Float32Array, f2: Uint16Array, u1: Uint8Array, i2: Int16Array, u4: Uint32Array };
window.unpack = (arrays) => Object.fromEntries(Object.entries(arrays).map(([name, [kind, text]]) =>
  [name, new types[kind](Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer)]));
window.engine = new Engine(document.getElementById("scene"), document.getElementById("overlay"), {
  onCamera: (camera) => reported.cameras.push(camera),
  onClick: (x, y) => reported.clicks.push([x, y]),
  onLost: (ids) => reported.lost.push(ids),
});
window.pointloom = { ready: () => engine.ready() };
"""


def write_engine_page(path: Path) -> None:
    """The engine's modules and an empty scene."""
    modules = "\n".join(sources.read_source(f"{name}.js") for name in sources.ENGINE)
    script = f'"use strict";(() => {{\n{modules}\n{START}}})();'
    path.write_text(PAGE.format(style=sources.read_source("engine.css"), script=script), encoding="utf-8")


def pack(arrays: Mapping[str, np.ndarray]) -> dict[str, list[str]]:
    """Arrays for `unpack`."""
    return {name: [each.dtype.str[1:], base64.b64encode(each.tobytes()).decode()] for name, each in arrays.items()}


def add(page: Any, number: int, kind: str, *, parent: int = 0, arrays: Any = None, **props: Any) -> None:
    """A node of the engine."""
    given = [number, parent, kind, props, pack(arrays or {})]
    page.evaluate("([id, parent, kind, props, arrays]) => engine.add(id, parent, kind, props, unpack(arrays))", given)


def set_node(page: Any, number: int, *, arrays: Any = None, **props: Any) -> None:
    """Change a node."""
    arguments = [number, props, pack(arrays or {})]
    page.evaluate("([id, props, arrays]) => engine.set(id, props, unpack(arrays))", arguments)


def at(x: float, y: float, z: float, scale: float = 1.0) -> list[float]:
    """A pose without a rotation."""
    return [scale, 0, 0, x, 0, scale, 0, y, 0, 0, scale, z]


def look_down(page: Any, height: float = 10.0, *, middle: tuple[float, float, float] = (0, 0, 0)) -> None:
    """A camera over a point, x to the right and y up in the image; 48 px per unit at a height of 480 and 10 units."""
    x, y, z = middle
    rotation, fov = [1, 0, 0, 0, -1, 0, 0, 0, -1], 2 * math.atan(0.5)
    camera = {"position": [x, y, z + height], "rotation": rotation, "pivot": [x, y, z], "up": [0, 1, 0], "fov": fov}
    bounds = [[x - 5, y - 5, z - 1], [x + 5, y + 5, z + 1]]
    page.evaluate("([low, high]) => engine.setBounds(low, high)", bounds)
    page.evaluate("(camera) => engine.setCamera(camera)", camera)


def seen(page: Any) -> np.ndarray:
    """The image at rest, without axes and frames."""
    page.evaluate("document.querySelectorAll('.view').forEach((each) => (each.style.opacity = 0))")
    ready(page)
    return picture(page, panels=True)


def png(image: np.ndarray) -> np.ndarray:
    """An image as the bytes of a PNG, uint8 [k]."""
    file = io.BytesIO()
    Image.fromarray(image).save(file, "PNG")
    return np.frombuffer(file.getvalue(), np.uint8)


def statistics(page: Any) -> dict[str, Any]:
    return json.loads(page.evaluate("JSON.stringify(engine.statistics())"))
