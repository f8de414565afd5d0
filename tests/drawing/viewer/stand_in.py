"""A page without a browser: what of viser and of the viewer the tools use, kept in lists."""

from __future__ import annotations

import asyncio
import contextlib
import threading
from types import SimpleNamespace
from typing import Any

import numpy as np

from pointloom.drawing.render.geometries import named_geometries
from pointloom.drawing.render.view import View, fit_view
from pointloom.drawing.viewer.items import Frame, make_item
from pointloom.drawing.viewer.tools.toolbox import Toolbox


class Control:
    """A control of the panel, or a node of the scene: values and callbacks."""

    def __init__(self, owner: list[Any] | None = None, **values: Any):
        self.__dict__.update(values)
        self._owner, self._callbacks = owner, []
        if owner is not None:
            owner.append(self)

    def __enter__(self) -> Control:
        return self

    def __exit__(self, *_: Any) -> None:
        pass

    def on(self, callback: Any) -> Any:
        self._callbacks.append(callback)
        return callback

    on_click = on_update = on_trigger = on

    def fire(self) -> None:
        for callback in self._callbacks:
            answer = callback(SimpleNamespace(target=self))
            if asyncio.iscoroutine(answer):
                asyncio.run(answer)

    def remove(self) -> None:
        if self._owner is not None:
            self._owner.remove(self)


class Gui:
    def __init__(self) -> None:
        self.controls: list[Any] = []
        self.keys: dict[str, Control] = {}

    def __getattr__(self, name: str) -> Any:
        if not name.startswith("add_"):
            raise AttributeError(name)
        return lambda label="", *values, **options: self._add(name[4:], label, values, options)

    def _add(self, kind: str, label: Any, values: tuple[Any, ...], options: dict[str, Any]) -> Control:
        if kind == "command":
            self.keys[options["hotkey"]] = Control(label=label)
            return self.keys[options["hotkey"]]
        first = {"dropdown": 0, "slider": 3, "multi_slider": 3}.get(kind, 0)
        value = options.pop("initial_value", values[first] if len(values) > first else None)
        if kind == "dropdown":
            options["options"], value = tuple(values[0]), value if isinstance(value, str) else values[0][0]
        if "slider" in kind:
            options |= {"min": values[0], "max": values[1], "step": values[2]}
        return Control(self.controls, kind=kind, label=label, value=value, content=label, color=None, **options)

    def find(self, label: str) -> Control:
        return next(control for control in self.controls if control.label == label)


class Client:
    def __init__(self) -> None:
        self.gui, self.nodes = Gui(), []
        self.clicks: list[Any] = []
        self.camera = SimpleNamespace(near=0.01, far=100.0, max_orbit_distance=1e4)
        self.scene = self

    def atomic(self) -> Any:
        return contextlib.nullcontext()

    def on_click(self) -> Any:
        return self.clicks.append

    def remove_click_callback(self, callback: Any) -> None:
        self.clicks.remove(callback)

    def __getattr__(self, name: str) -> Any:
        if not name.startswith("add_"):
            raise AttributeError(name)
        return lambda path, *values, **options: Control(self.nodes, kind=name[4:], name=path, values=values)


class Stream:
    def __init__(self) -> None:
        self.keep: Any = None
        self.visible = True

    def set_keep(self, keep: Any) -> None:
        self.keep = keep

    def set_visible(self, visible: bool) -> None:
        self.visible = visible


class StandIn:
    """A viewer with one page, which looks where it is told at once."""

    def __init__(self, files: Any, **geometries: Any):
        self.viewer = self
        self.lock, self.items, self._nodes = threading.RLock(), {}, {}
        self.streams: dict[str, Stream] = {}
        self.client, self.closed, self.looked = Client(), False, []
        for name, geometry in geometries.items():
            self.add(name, geometry)
        self.frame = Frame.around(self.bounds)
        self.now = fit_view(np.array(self.bounds), width=1000, height=800)
        self.box = Toolbox(self, Control(), files=files)  # type: ignore[arg-type]

    # the viewer

    def add(self, name: str, geometry: Any, **style: Any) -> None:
        ((name, geometry, made),) = named_geometries([{"geometry": geometry, "name": name, **style}])
        self.items[name] = make_item(name, len(self.items), geometry, made)
        self.streams[name] = Stream()

    def remove(self, name: str) -> None:
        del self.items[name], self.streams[name]

    def set_pose(self, name: str, T: Any) -> None:
        self.items[name].pose = T

    def set_visible(self, name: str, visible: bool) -> None:
        self.items[name].visible = visible

    @property
    def bounds(self) -> Any:
        found = [item.world_bounds() for item in self.items.values()]
        return np.min([low for low, _ in found], axis=0), np.max([high for _, high in found], axis=0)

    def surface_nodes(self, name: str) -> Any:
        return self._nodes[name].surfaces() if name in self._nodes else []

    # the session

    def camera_view(self) -> View:
        return self.now

    def look_from(self, view: View) -> None:
        self.now = view

    def rest(self, callback: Any) -> None:
        self.looked.append(callback)

    def tell(self) -> None:
        pass

    # the one who uses it

    def wait(self) -> None:
        """Until all is done that was asked for."""
        self.box._worker.submit(lambda: None).result(timeout=60)

    def press(self, label: str) -> None:
        self.client.gui.find(label).fire()
        self.wait()

    def key(self, key: str) -> None:
        self.client.gui.keys[key].fire()
        self.wait()

    def click(self, x: float, y: float) -> None:
        camera = self.now.intrinsic
        share = (x + 0.5) / camera.width, (y + 0.5) / camera.height
        for callback in list(self.client.clicks):
            asyncio.run(callback(SimpleNamespace(screen_pos=share)))
        self.wait()

    @property
    def told(self) -> str:
        return self.box.stage.status.content

    @property
    def table(self) -> str:
        return self.box.stage.rows.content
