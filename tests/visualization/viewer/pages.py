"""Raw requests to the viewer's server, and a page's websocket without a browser."""

import contextlib
import http.client
import json
import socket
import struct
import time
from collections.abc import Iterator
from typing import Any

import numpy as np
from websockets.sync.client import ClientConnection, connect

from pointloom.visualization.viewer.link.client import PageClient
from pointloom.visualization.viewer.link.hub import PROTOCOL
from pointloom.visualization.viewer.server import ViewerServer

from .events import TIMEOUT, events, wait_until

HELLO = {"say": "hello", "size": [800, 600], "version": 1}
CAMERA = {
    "say": "camera", "position": [0.0, 0.0, 3.0], "rotation": [1, 0, 0, 0, -1, 0, 0, 0, -1], "fov": 1.0,
    "pivot": [0, 0, 0], "size": [800, 600], "orthographic": False,
}  # fmt: skip


def with_token(server: ViewerServer, path: str = "/") -> str:
    return f"{path}?token={server.pages.token}"


def get(
    server: ViewerServer, path: str | None = None, method: str = "GET", **headers: str
) -> tuple[int, dict[str, str], bytes]:
    """Status, headers (lower case) and body of a response; underscores in names become hyphens.

    The default path is that of the page, with its token.
    """
    line = http.client.HTTPConnection("127.0.0.1", server.port, timeout=TIMEOUT)
    try:
        path = with_token(server) if path is None else path
        line.putrequest(method, path, skip_host="Host" in headers, skip_accept_encoding=True)
        for name, value in headers.items():
            line.putheader(name.replace("_", "-"), value)
        line.endheaders()
        response = line.getresponse()
        return response.status, {name.lower(): value for name, value in response.getheaders()}, response.read()
    finally:
        line.close()


def send_raw(server: ViewerServer, data: bytes) -> bytes:
    """The server's response to these bytes, until it closes the connection."""
    with socket.create_connection(("127.0.0.1", server.port), timeout=TIMEOUT) as line:
        response = b""
        with contextlib.suppress(ConnectionError):
            line.sendall(data)
            line.shutdown(socket.SHUT_WR)
            while block := line.recv(65536):
                response += block
    return response


@contextlib.contextmanager
def line_of(server: ViewerServer, **settings: Any) -> Iterator[ClientConnection]:
    """A websocket as the served page opens it, before its first message."""
    settings = {"origin": f"http://127.0.0.1:{server.port}", "subprotocols": [PROTOCOL]} | settings
    address = f"ws://127.0.0.1:{server.port}{with_token(server, '/live')}"
    with connect(address, compression=None, max_size=None, proxy=None, close_timeout=0.2, **settings) as line:
        yield line


@contextlib.contextmanager
def visitor_of(server: ViewerServer) -> Iterator[ClientConnection]:
    """A page that has sent hello and lets the program choose its camera."""
    with line_of(server) as line:
        send(line, HELLO)
        yield line


@contextlib.contextmanager
def page_of(server: ViewerServer, **settings: Any) -> Iterator[ClientConnection]:
    """A page that has sent hello and its camera, both received by the server."""
    with line_of(server, **settings) as line:
        before = set(server.pages.get_clients())
        send(line, HELLO)
        send(line, CAMERA)
        wait_until(lambda: bool(set(server.pages.get_clients()) - before))
        (client,) = [client for number, client in server.pages.get_clients().items() if number not in before]
        wait_until(lambda: client in events.heard)
        yield line


def client_of(server: ViewerServer) -> PageClient:
    """The program's side of the only page."""
    (client,) = server.pages.get_clients().values()
    return client


def silent_line(server: ViewerServer, name: str = "127.0.0.1", port: int = 0, buffer: int = 4096) -> socket.socket:
    """A page under that name and port that has sent hello and does not read by itself."""
    host = f"{name}:{port or server.port}"
    line = socket.socket()
    line.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, buffer)
    line.settimeout(TIMEOUT)
    line.connect(("127.0.0.1", server.port))
    hello = json.dumps(HELLO).encode()
    frame = bytes([0x81, 0x80 | len(hello), 0, 0, 0, 0]) + hello  # text, masked by zeros
    line.sendall(
        f"GET {with_token(server, '/live')} HTTP/1.1\r\nHost: {host}\r\nOrigin: http://{host}\r\n"
        "Upgrade: websocket\r\nConnection: Upgrade\r\n"
        "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
        f"Sec-WebSocket-Protocol: {PROTOCOL}\r\n\r\n".encode()
        + frame
    )
    return line


def send(line: ClientConnection, message: dict[str, Any]) -> None:
    line.send(json.dumps(message))


def hear(line: ClientConnection, seconds: float = TIMEOUT) -> list[dict[str, Any]]:
    """The operations of the next message."""
    raw = line.recv(timeout=seconds)
    assert isinstance(raw, bytes)
    return unpack(raw)


def unpack(raw: bytes) -> list[dict[str, Any]]:
    """The operations of a message, arrays in place of their numbers."""
    (length,) = struct.unpack("<I", raw[:4])
    assert (4 + length) % 8 == 0
    content = json.loads(raw[4 : 4 + length])
    arrays = []
    for kind, rows, width, offset in content["arrays"]:
        assert offset % 8 == 0
        arrays.append(np.frombuffer(raw, f"<{kind}", rows * width, offset).reshape(rows, width))
    return [
        {name: arrays[value] if name in ARRAYS and type(value) is int else value for name, value in op.items()}
        for op in content["do"]
    ]


ARRAYS = {"positions", "colors", "normals", "indices", "uvs", "texture", "poses", "image", "data"}


def hear_until(line: ClientConnection, name: str, seconds: float = TIMEOUT, **fields: Any) -> dict[str, Any]:
    """The next operation of this name with these fields; earlier ones of its message are dropped."""
    end = time.monotonic() + seconds
    while True:
        for op in hear(line, max(end - time.monotonic(), 0.01)):
            if op["op"] == name and all(op.get(field) == value for field, value in fields.items()):
                return op


def is_well(server: ViewerServer) -> bool:
    """True if a page gets the scene and the server receives its messages."""
    with page_of(server) as line:
        return hear_until(line, "clear")["op"] == "clear"
