"""Hostile pages in two languages, while threads of the program work: `python -m tests.drawing.viewer.fuzz_pages`.

    --messages 10000    from Python, and as many from Node where it is on the path
    --seed 0            of what is said

Prints what happened in one line of JSON each; the exit status is 1 where anything was raised in a thread of the program
or logged as an error, or where the server does not serve any more.
"""

from __future__ import annotations

import argparse
import contextlib
import itertools
import json
import logging
import random
import shutil
import subprocess
import sys
import threading
import time
import traceback
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
from websockets.exceptions import ConnectionClosed
from websockets.protocol import State
from websockets.sync.client import ClientConnection

import pointloom as loom
from pointloom.drawing.viewer.server import ViewerServer

from .hostile_pages import hostile_messages, near_messages
from .pages import CAMERA, HELLO, is_well, line_of, say, with_token

ENDING: list[str | bytes] = [
    "", "{", "[", "null", '{"say": NaN}', "[" * 60_000, b"\x00" * 100, "x" * 70_000, '{"say": "value", "n": Infinity}',
    '{"say":"file","text":"' + "\\u0000" * 100_000, '{"say":"file","x":' + "[[]," * 200_000,
]  # fmt: skip


class Program:
    """What a user's program does with its viewer, in threads, and what was raised there."""

    def __init__(self, viewer: loom.Viewer):
        self.viewer, self.server = viewer, viewer.server
        self.raised: list[str] = []
        self.calls = 0
        self._done = threading.Event()
        self.handles = _controls(viewer.server)
        steps = (self._use_link, self._use_viewer)
        self._threads = [threading.Thread(target=self._work, args=(step,)) for step in steps]

    def __enter__(self) -> Program:
        for thread in self._threads:
            thread.start()
        return self

    def __exit__(self, *_: Any) -> None:
        self._done.set()
        for thread in self._threads:
            thread.join()

    def _work(self, step: Callable[[np.random.Generator], None]) -> None:
        generator = np.random.default_rng(0)
        while not self._done.wait(0.01):
            try:
                step(generator)
                self.calls += 1
            except Exception:
                self.raised.append(traceback.format_exc())

    def _use_viewer(self, generator: np.random.Generator) -> None:
        self.viewer.add("cloud", loom.PointCloud(generator.random((500, 3), np.float32)))
        self.viewer.set_pose("cloud", np.eye(4))
        view = self.viewer.get_view()
        assert np.isfinite(view.T_world_camera).all()
        self.viewer.point_size = 1 + generator.random()
        self.viewer.remove("cloud")

    def _use_link(self, generator: np.random.Generator) -> None:
        pages = self.server.pages
        with pages.atomic():
            node = pages.scene.add_points(generator.random((1000, 3), np.float32))
            node.place(np.eye(3), generator.random(3))
            node.set(size=1 + generator.random())
        for client in pages.get_clients().values():
            state = client.camera.state
            assert np.isfinite(state.position).all() and 0 < state.fov < np.pi
            assert np.abs(state.rotation @ state.rotation.T - np.eye(3)).max() < 1e-12
            assert all(1 <= side <= 16384 for side in state.size)
            client.camera.put(position=state.position, rotation=state.rotation)
            client.ask_for_sign()
        for handle in self.handles:
            if handle.kind in ("range", "histogram"):
                assert handle.value[0] <= handle.value[1]
        node.remove()


def _controls(server: ViewerServer) -> list[Any]:
    gui = server.pages.gui
    tree = gui.add_tree(lambda client_id, keys, visible: None)
    for number in range(100):
        tree.put("a" if number == 0 else str(number), f"group/{number}", True)
    server.pages.scene.on_click(lambda event: event.camera.position + 1)
    handles = [
        gui.add_slider("slider", 0, 10, 1, 5), gui.add_range("range", 0, 1, 0.1, (0.2, 0.8)), gui.add_text("text", "x"),
        gui.add_dropdown("dropdown", ("a", "b")), gui.add_rgb("rgb", (1, 2, 3)), gui.add_checkbox("checkbox", True),
        gui.add_number("number", 3), gui.add_button("button"), gui.add_button_group("buttons", ("a", "b")), tree,
        gui.add_upload_button("upload"), gui.add_timeline(0, 9, 1, 0), gui.add_command("command", "R"),
        gui.add_histogram("histogram", [1, 2, 3], (0, 3), (0, 3)), gui.add_words("words"),
    ]  # fmt: skip
    for handle in handles:
        for name in ("on_update", "on_click", "on_trigger", "on_upload"):
            register: Callable[..., Any] | None = getattr(handle, name, None)
            if register is not None:
                register(lambda event: (event.client_id, event.value))
    return handles


def _messages(ids: list[int], count: int, seed: int) -> Iterator[str | bytes]:
    picker = random.Random(seed)
    every = itertools.chain(hostile_messages(ids[:20]), near_messages(ids, 10**9, seed))
    for message in itertools.islice(every, count):
        chance = picker.random()
        if chance < 0.001:
            yield picker.randbytes(picker.randrange(1, 5000))
        elif chance < 0.003:
            yield picker.choice(ENDING)
        else:
            yield message


def fuzz_from_python(server: ViewerServer, ids: list[int], count: int, seed: int) -> dict[str, int]:
    """Say these messages over eight lines at once, each opened again when it ends."""
    shares = [list(_messages(ids, count, seed))[number::8] for number in range(8)]
    told = {"sent": 0, "lines": 0}

    def talk(messages: list[str | bytes]) -> None:
        left = iter(messages)
        while True:
            told["lines"] += 1
            with contextlib.suppress(ConnectionClosed), line_of(server, ping_interval=None) as line:
                threading.Thread(target=_listen, args=(line,), daemon=True).start()
                say(line, HELLO)
                say(line, CAMERA)
                for number, message in enumerate(left):
                    told["sent"] += 1
                    line.send(message)
                    if number % 20 == 0:
                        _wait_until_read(line)
                return

    threads = [threading.Thread(target=talk, args=(share,)) for share in shares]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return told


def _wait_until_read(line: ClientConnection) -> None:
    """Else a line would take all that is left, and end at its first word that is no message."""
    pong = line.ping()
    while not pong.wait(0.1) and line.state is State.OPEN:
        pass


def _listen(line: ClientConnection) -> None:
    """Read what the server sends, else it would be waited for."""
    with contextlib.suppress(ConnectionClosed):
        while True:
            line.recv()


def fuzz_from_node(server: ViewerServer, ids: list[int], count: int, seed: int) -> dict[str, int] | None:
    """The same from Node; None where it is not there."""
    node = shutil.which("node")
    if node is None:
        return None
    address = f"ws://127.0.0.1:{server.port}{with_token(server, '/live')}"
    script = str(Path(__file__).with_suffix(".mjs"))
    numbers = ",".join(map(str, ids))
    origin = f"http://127.0.0.1:{server.port}"
    done = subprocess.run(
        [node, "--experimental-websocket", script, address, origin, str(count), str(seed), numbers],
        capture_output=True,
        text=True,
    )
    if done.returncode:
        raise RuntimeError(done.stderr)
    return json.loads(done.stdout)


def resident_megabytes() -> float:
    """Of this process now."""
    lines = Path("/proc/self/status").read_text().splitlines()
    return next(int(line.split()[1]) / 1024 for line in lines if line.startswith("VmRSS"))


class _Errors(logging.Handler):
    """Keeps what is logged as an error."""

    def __init__(self) -> None:
        super().__init__(logging.ERROR)
        self.messages: list[str] = []

    def emit(self, record: logging.LogRecord) -> None:
        self.messages.append(f"{record.getMessage()}: {record.exc_info[1] if record.exc_info else ''}")


def main() -> int:
    """Run both; returns the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--messages", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    errors = _Errors()
    logging.getLogger("pointloom.viewer").addHandler(errors)
    faults = 0
    with loom.Viewer(port=0) as viewer, Program(viewer) as program:
        viewer.add("stays", loom.PointCloud(np.random.default_rng(0).random((1000, 3), np.float32)))
        server, ids = (
            viewer.server,
            list(range(1, 200)),
        )  # the viewer's own controls, the program's, and numbers of none
        for name, fuzz in (("python", fuzz_from_python), ("node", fuzz_from_node)):
            before, calls, start = resident_megabytes(), program.calls, time.process_time()
            told = fuzz(server, ids, options.messages, options.seed)
            if told is None:
                print(json.dumps({"from": name, "left out": "not on the path"}))
                continue
            result = {"from": name, **told, "calls meanwhile": program.calls - calls, "raised": program.raised[:3]}
            result |= {"logged as errors": errors.messages[:3], "serves": is_well(server)}
            result |= {"CPU seconds": round(time.process_time() - start, 1)}
            result |= {"RSS MB": [round(before), round(resident_megabytes())]}
            print(json.dumps(result), flush=True)
            faults += bool(program.raised or errors.messages or not result["serves"])
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
