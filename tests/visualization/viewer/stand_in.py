"""Pages without a browser: `Page` stores received operations; `StandIn` is a viewer with one page, for tools."""

import contextlib
import json
import threading
from collections.abc import Iterator
from typing import Any

import numpy as np

from pointloom.visualization.render.geometries import named_geometries
from pointloom.visualization.render.view import View, fit_view
from pointloom.visualization.viewer.items import make_item
from pointloom.visualization.viewer.link import Gui, PageClient
from pointloom.visualization.viewer.link import Scene as PageScene
from pointloom.visualization.viewer.link.camera import FIRST_STATE
from pointloom.visualization.viewer.link.delivery import Channel, Delivery
from pointloom.visualization.viewer.link.wire import read
from pointloom.visualization.viewer.scene import Scene
from pointloom.visualization.viewer.tools.toolbox import Toolbox

from .events import wait_until


def waves(side: int = 40) -> np.ndarray:
    """A surface with points some ten pixels apart."""
    x, y = (a.ravel() / side * 4 - 2 for a in np.mgrid[:side, :side].astype(float))
    return np.column_stack([x, y, 0.2 * np.sin(2 * x) * np.cos(3 * y) + 0.05 * x * y])


class Seen(dict):
    """A node, a control or another object of the page, its fields by name."""

    __getattr__ = dict.__getitem__


class Page:
    """A page: operations in its outbox are applied on access; `taken` has the operations of each message."""

    def __init__(self, outbox: Any, delivery: Delivery, take: Any, client: PageClient):
        self._outbox, self._delivery, self._take, self.client = outbox, delivery, take, client
        self._lock = threading.RLock()
        self._nodes: dict[int, Seen] = {}
        self._controls: dict[int, Seen] = {}
        self._commands: dict[int, Seen] = {}
        self._others: dict[str, list[Seen]] = {}
        self._rows: dict[str, tuple[Any, ...]] = {}
        self._camera = Seen()
        self.taken: list[list[dict[str, Any]]] = []

    @property
    def nodes(self) -> dict[int, Seen]:
        self.look()
        return self._nodes

    @property
    def controls(self) -> dict[int, Seen]:
        self.look()
        return self._controls

    @property
    def commands(self) -> list[Seen]:
        self.look()
        return list(self._commands.values())

    @property
    def camera(self) -> Seen:
        self.look()
        return self._camera

    @property
    def rows(self) -> dict[str, tuple[Any, ...]]:
        """The rows of its tree: label, visible, color, by key."""
        self.look()
        return self._rows

    def others(self, kind: str) -> list[Seen]:
        """Operations of another kind, such as "notify", in their order."""
        self.look()
        return self._others.get(kind, [])

    def control(self, label: str) -> Seen:
        return next(control for control in self.controls.values() if control.get("label") == label)

    def of_kind(self, kind: str) -> list[Seen]:
        return [control for control in self.controls.values() if control.kind == kind]

    def look(self) -> list[dict[str, Any]]:
        """Apply and return the waiting operations."""
        with self._lock:
            operations = []
            while ops := self._delivery.take(self._outbox)[0]:
                self.taken.append(ops)
                operations += ops
                for op in ops:
                    self._apply(op)
            return operations

    @property
    def own_bytes(self) -> int:
        return self._outbox.own_bytes

    def _apply(self, op: dict[str, Any]) -> None:
        name, fields = op["op"], Seen(op)
        stored = {"node": self._nodes, "control": self._controls, "command": self._commands}
        if name in stored:
            stored[name][op["id"]] = fields
        elif name in ("set", "setcontrol"):
            changed = (self._nodes if name == "set" else self._controls).get(op["id"])
            if changed is not None:
                changed.update({key: value for key, value in op.items() if key != "op"})
        elif name in ("drop", "dropcontrol", "dropcommand"):
            self._drop({"drop": self._nodes, "dropcontrol": self._controls}.get(name, self._commands), op["id"])
        elif name == "camera":
            self._camera.update(op)
        elif name == "rows":
            self._rows.update({key: tuple(row) for key, *row in op["put"]})
            for key in op["drop"]:
                self._rows.pop(key, None)
        else:
            self._others.setdefault(name, []).append(fields)

    def _drop(self, stored: dict[int, Seen], number: int) -> None:
        stored.pop(number, None)
        for child in [child for child, one in stored.items() if one.get("parent") == number]:
            self._drop(stored, child)

    def send(self, kind: str, **fields: Any) -> None:
        """Send a message through all checks; wait until it is processed."""
        message = read(json.dumps({"say": kind, **fields}))
        if message is not None:
            self._take(message)
        self.run_callbacks()

    def run_callbacks(self) -> None:
        """Wait until all callbacks of the page have been called."""
        done = threading.Event()
        if self.client.worker.run(done.set, always=True):
            assert done.wait(60)

    def set(self, label: str, value: Any) -> None:
        control = self.control(label)
        control["value"] = value
        self.send("value", id=control.id, value=value)

    def press(self, label: str) -> None:
        self.send("press", id=self.control(label).id)

    def key(self, key: str) -> None:
        for command in self.commands:
            if command.hotkey == key:
                self.send("command", id=command.id)

    def move(self, position: Any, *, size: Any = None, **fields: Any) -> None:
        """Move its camera, as its mouse does."""
        state = self.client.camera.state
        message = {"position": list(position), "rotation": state.rotation.ravel().tolist(), "fov": state.fov}
        message |= {"pivot": state.pivot.tolist(), "size": list(size or state.size), "orthographic": state.orthographic}
        self.send("camera", **(message | fields))

    def answer(self) -> bool:
        """Acknowledge the last signal request; True if there was one."""
        signs = [op["n"] for op in self.look() if op["op"] == "sign"]
        if signs:
            self.send("sign", n=signs[-1])
        return bool(signs)


@contextlib.contextmanager
def page_in(viewer: Any, size: tuple[int, int] = (800, 600)) -> Iterator[Page]:
    visitor = viewer.server.pages._welcome({"say": "hello", "size": list(size), "version": 1}, lambda: None)
    page = Page(visitor._outbox, viewer.server.pages.delivery, visitor.take, visitor._client)
    page.run_callbacks()
    try:
        yield page
    finally:
        worker = page.client.worker
        visitor.leave()
        if worker._thread is not None:
            worker._thread.join(60)


def toolbox_of(viewer: Any) -> Toolbox:
    """The idle tools of the first page."""
    wait_until(lambda: viewer.sessions)
    session = next(iter(viewer.sessions.values()))
    wait_until(lambda: session.tools is not None)
    session.tools._worker.submit(lambda: None).result(60)
    return session.tools


def page_alone(size: tuple[int, int] = (1000, 800)) -> Page:
    delivery = Delivery()
    shared, private = Channel(delivery, is_shared=True), Channel(delivery, is_shared=False)
    state = type(FIRST_STATE)(**{**vars(FIRST_STATE), "size": size})
    client = PageClient(private, 0, state, (PageScene(shared), Gui(shared)))
    return Page(delivery.join(private, lambda: None), delivery, client.take, client)


class Stream:
    """A cloud of the page that stores the settings of tools."""

    def __init__(self) -> None:
        self.keep: Any = None
        self.visible = True

    def set_keep(self, keep: Any) -> None:
        self.keep = keep

    def set_visible(self, visible: bool) -> None:
        self.visible = visible


class StandIn:
    """A session, and the edits of its scene, that applies view requests at once."""

    def __init__(self, **geometries: Any):
        self.display, self.scene = self, Scene(10**6, 3.0, np.ones(3), (1000, 800))
        self.streams: dict[str, Stream] = {}
        self.page = page_alone()
        self.client, self.closed = self.page.client, False
        for name, geometry in geometries.items():
            self.add(name, geometry)
        self.scene.choose_frame()
        self.now = self.began = fit_view(np.array(self.scene.bounds), width=1000, height=800)
        self.box = Toolbox(self, self, self.client.gui.add_folder("Tools"))  # type: ignore[arg-type]

    @property
    def items(self) -> dict[str, Any]:
        return self.scene.shown

    def add(self, name: str, geometry: Any, **style: Any) -> None:
        ((name, geometry, made),) = named_geometries([{"geometry": geometry, "name": name, **style}])
        self.scene.add_item(make_item(name, self.scene.next_number(), geometry, made))
        self.streams[name] = Stream()

    def remove(self, name: str) -> None:
        self.scene.remove_item(name)
        del self.streams[name]

    def set_pose(self, name: str, T: Any) -> None:
        self.items[name].pose = T
        self.scene.update_bounds(self.items[name])

    def set_visible(self, name: str, visible: bool) -> None:
        self.items[name].visible = visible

    def surface_nodes(self, name: str) -> Any:
        return []

    def camera_view(self) -> View:
        return self.now

    def view_of(self, camera: Any) -> View:
        return self.now

    def look_from(self, view: View) -> None:
        self.now = view

    def look_as(self, state: Any) -> None:
        self.now = self.began

    def recount(self) -> None:
        pass

    def show_counts(self) -> None:
        pass

    def wait(self) -> None:
        """Wait until all requested work is done."""
        self.page.run_callbacks()
        self.box._worker.submit(lambda: None).result(timeout=60)

    def press(self, label: str) -> None:
        """Press the button whose label begins with these words."""
        labels = [str(control.get("label")) for control in self.page.controls.values() if control.kind == "button"]
        self.page.press(next(one for one in labels if one == label or one.startswith(f"{label} (")))
        self.wait()

    def set(self, label: str, value: Any) -> None:
        self.page.set(label, value)
        self.wait()

    def key(self, key: str) -> None:
        self.page.key(key)
        self.wait()

    def click(self, x: float, y: float) -> None:
        camera = self.now.intrinsic
        self.page.send("click", x=(x + 0.5) / camera.width, y=(y + 0.5) / camera.height)
        self.wait()

    @property
    def clicks(self) -> Any:
        return self.client.scene.click_callbacks()

    @property
    def status(self) -> str:
        return self.box.stage.status.value

    @property
    def table(self) -> str:
        return "\n".join(f"| {label} | {text} |" for label, text in self.box.stage.rows.value)
