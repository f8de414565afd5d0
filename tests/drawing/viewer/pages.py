"""Strangers at the viewer's door: raw requests, and a page's websocket without a browser."""

from __future__ import annotations

import contextlib
import http.client
import socket
import time
from collections.abc import Callable, Iterator
from typing import Any

import msgspec
import viser
import zstandard
from websockets.sync.client import ClientConnection, connect

from pointloom.drawing.viewer.server import ViewerServer

PROTOCOL = f"viser-v{viser.__version__}"
CAMERA = {
    "type": "ViewerCameraMessage", "wxyz": [1, 0, 0, 0], "position": [0.0, 0.0, 3.0], "fov": 1.0, "near": 0.1,
    "far": 10.0, "image_height": 600, "image_width": 800, "look_at": [0, 0, 0], "up_direction": [0, 0, 1],
}  # fmt: skip


def get(
    server: ViewerServer, path: str = "/", method: str = "GET", **headers: str
) -> tuple[int, dict[str, str], bytes]:
    """Status, headers (in small letters) and body of an answer; an underscore in a name stands for a hyphen."""
    line = http.client.HTTPConnection("127.0.0.1", server.port, timeout=10)
    try:
        line.putrequest(method, path, skip_host="Host" in headers, skip_accept_encoding=True)
        for name, value in headers.items():
            line.putheader(name.replace("_", "-"), value)
        line.endheaders()
        answer = line.getresponse()
        return answer.status, {name.lower(): value for name, value in answer.getheaders()}, answer.read()
    finally:
        line.close()


def send_raw(server: ViewerServer, data: bytes) -> bytes:
    """What the server answers to these bytes before it hangs up."""
    with socket.create_connection(("127.0.0.1", server.port), timeout=10) as line:
        answer = b""
        with contextlib.suppress(ConnectionError):
            line.sendall(data)
            line.shutdown(socket.SHUT_WR)
            while block := line.recv(65536):
                answer += block
    return answer


@contextlib.contextmanager
def page_of(server: ViewerServer, *, camera: bool = True, **settings: Any) -> Iterator[ClientConnection]:
    """A websocket as the served page opens it; with its first camera, which makes it a client."""
    settings = {"origin": f"http://127.0.0.1:{server.port}", "subprotocols": [PROTOCOL]} | settings
    with connect(
        f"ws://127.0.0.1:{server.port}", compression=None, max_size=None, proxy=None, close_timeout=0.2, **settings
    ) as line:
        if camera:
            before = set(server.viser.get_clients())
            say(line, CAMERA)
            wait_until(lambda: bool(set(server.viser.get_clients()) - before))
        yield line


def silent_line(server: ViewerServer, name: str = "127.0.0.1", port: int = 0, buffer: int = 4096) -> socket.socket:
    """A websocket asked for under that name and port, whose other end does not read by itself."""
    host = f"{name}:{port or server.port}"
    line = socket.socket()
    line.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, buffer)
    line.settimeout(10)
    line.connect(("127.0.0.1", server.port))
    line.sendall(
        f"GET / HTTP/1.1\r\nHost: {host}\r\nOrigin: http://{host}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
        f"Sec-WebSocket-Protocol: {PROTOCOL}\r\n\r\n".encode()
    )
    return line


def say(line: ClientConnection, message: dict[str, Any]) -> None:
    """Send a message as a page does."""
    line.send(msgspec.msgpack.encode(message))


def hear(line: ClientConnection, seconds: float = 5.0) -> list[dict[str, Any]]:
    """The messages of the next window that the server sends."""
    raw = line.recv(timeout=seconds)
    assert isinstance(raw, bytes)
    packed = raw[16 : 16 + int.from_bytes(raw[8:16], "little")]
    return msgspec.msgpack.decode(zstandard.ZstdDecompressor().decompress(packed))["messages"]


def hear_until(line: ClientConnection, kind: str, seconds: float = 5.0) -> dict[str, Any]:
    """The next message of a kind."""
    end = time.monotonic() + seconds
    while True:
        for message in hear(line, max(end - time.monotonic(), 0.01)):
            if message["type"] == kind:
                return message


def wait_until(claim: Callable[[], bool], seconds: float = 5.0) -> None:
    """Return once the claim holds."""
    end = time.monotonic() + seconds
    while not claim():
        assert time.monotonic() < end, "it never came"
        time.sleep(0.005)


def is_well(server: ViewerServer) -> bool:
    """Whether a page gets the scene, and the server hears it."""
    with page_of(server) as line:
        return hear_until(line, "ReplayDoneMessage")["type"] == "ReplayDoneMessage"


def count(server: ViewerServer) -> int:
    """How many pages are connected."""
    return server.viser._websock_server._client_count  # type: ignore[attr-defined]
