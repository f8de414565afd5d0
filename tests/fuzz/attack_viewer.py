"""Attack the viewer's server from the network: `python tests/fuzz/attack_viewer.py`.

Each attack runs against one server process. Afterward a page with the token must be answered within 5 s, and the
process must have no more threads or open files than before, and at most 64 MiB more memory. The exit code is 1 if an
attack succeeds.
"""

from __future__ import annotations

import os
import random
import re
import socket
import subprocess
import sys
import time
import urllib.request
from collections.abc import Callable
from pathlib import Path

from pointloom.visualization.viewer.link.hub import PROTOCOL

MAX_ANSWER = 5.0  # [s]
MAX_GROWTH = 64 * 2**20  # [bytes] of resident memory
CLOSE_TIMEOUT = 90.0  # [s] for silent connections to be closed
SERVER = """
import sys
from pointloom.visualization.viewer.server import ViewerServer
with ViewerServer(port=0) as server:
    print(server.url, flush=True)
    sys.stdin.read()
"""


class Target:
    """A server process under attack."""

    def __init__(self) -> None:
        self.process = subprocess.Popen(
            [sys.executable, "-c", SERVER], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )
        assert self.process.stdout is not None
        self.url = self.process.stdout.readline().strip()
        match = re.fullmatch(r"http://127\.0\.0\.1:(\d+)/\?token=(.+)", self.url)
        assert match is not None
        self.port, self.token = int(match[1]), match[2]

    def connect(self) -> socket.socket:
        return socket.create_connection(("127.0.0.1", self.port), timeout=5)

    def send(self, data: bytes) -> bytes:
        """The beginning of the response to raw bytes; empty if the connection is closed without one."""
        with self.connect() as line:
            try:
                line.sendall(data)
                return line.recv(4096)
            except OSError:
                return b""

    def get(self, path: str, *headers: str) -> int:
        """Status of a GET request; 0 if there is no response."""
        lines = [f"GET {path} HTTP/1.1", *(headers or (f"Host: 127.0.0.1:{self.port}",)), "", ""]
        response = self.send("\r\n".join(lines).encode("latin-1")).split(b" ", 2)
        return int(response[1]) if len(response) > 1 else 0

    def is_well(self) -> bool:
        begin = time.monotonic()
        try:
            with urllib.request.urlopen(self.url, timeout=MAX_ANSWER) as page:
                return page.status == 200 and time.monotonic() - begin < MAX_ANSWER
        except OSError:
            return False

    def usage(self) -> tuple[int, int, int]:
        """Threads, open files and resident bytes of the process."""
        folder = Path("/proc") / str(self.process.pid)
        pages = int((folder / "statm").read_text().split()[1])
        return (
            len(list((folder / "task").iterdir())),
            len(list((folder / "fd").iterdir())),
            pages * os.sysconf("SC_PAGE_SIZE"),
        )

    def upgrade(self, token: str) -> bytes:
        """A request for a websocket."""
        return (
            f"GET /live?token={token} HTTP/1.1\r\nHost: 127.0.0.1:{self.port}\r\nOrigin: http://127.0.0.1:{self.port}\r\n"
            f"Sec-WebSocket-Protocol: {PROTOCOL}\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
            "Sec-WebSocket-Version: 13\r\n"
            "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n"
        ).encode()


def guessed_tokens(target: Target) -> bool:
    rng = random.Random(0)
    tokens = ["", target.token[:-1], target.token + "a", target.token.swapcase()]
    tokens += ["".join(rng.choices("abcdef0123456789-_", k=len(target.token))) for _ in range(500)]
    return any(target.get(f"/?token={token}") == 200 for token in tokens)


def paths_outside(target: Target) -> bool:
    parts = ("..", "%2e%2e", "..%2f", "%252e%252e", "..\\\\", "....//", "%00", "file:", "//etc")
    paths = [f"/{'/'.join([part] * depth)}/etc/passwd" for part in parts for depth in (1, 3, 8)]
    paths += [f"{path}?token={target.token}" for path in paths]
    return any(target.get(path) == 200 for path in paths)


def hosts_and_origins(target: Target) -> bool:
    path, local = f"/?token={target.token}", f"127.0.0.1:{target.port}"
    hosts = (["evil.example"], [f"{local}.evil.example"], [local, local], [""])
    headers = [[f"Host: {host}" for host in each] for each in hosts]
    for origin in ("http://evil.example", "null", "file://", f"http://{local}.evil.example"):
        headers.append([f"Host: {local}", f"Origin: {origin}"])
    return any(target.get(path, *each) == 200 for each in headers)


def broken_requests(target: Target) -> bool:
    rng = random.Random(1)
    complete = target.upgrade("wrong")
    for _ in range(500):
        data = bytearray(complete)
        for _ in range(rng.randint(1, 8)):
            data[rng.randrange(len(data))] = rng.randrange(256)
        with target.connect() as line:
            line.sendall(bytes(data[: rng.randint(1, len(data))]))
    return False


def giant_headers(target: Target) -> bool:
    for data in (b"A" * 2**24, b"GET / HTTP/1.1\r\n" + b"X: y\r\n" * 2**20, b"GET /" + b"a" * 2**24 + b" HTTP/1.1\r\n"):
        if b" 200 " in target.send(data):
            return True
    return False


def giant_messages(target: Target) -> bool:
    """Frames that announce more than the limit, as one and in parts, from pages with the token."""
    for header in (b"\x81\xff" + (2**40).to_bytes(8, "big"), b"\x01\xff" + (2**19).to_bytes(8, "big")):
        for _ in range(20):
            with target.connect() as line:
                line.sendall(target.upgrade(target.token))
                if b" 101 " not in line.recv(4096):
                    raise RuntimeError("the page with the token was refused")
                try:
                    for _ in range(64):
                        line.sendall(header + bytes(4) + b"a" * 2**19)
                except OSError:
                    pass  # closed, as required
    return False


def silent_connections(target: Target) -> bool:
    """Incomplete requests on 200 connections: other requests are answered, and the connections end."""
    lines = [target.connect() for _ in range(200)]
    for line in lines:
        line.sendall(b"GET / HTTP/1.1\r\nHost: ")
    if not target.is_well():
        return True
    end = time.monotonic() + CLOSE_TIMEOUT
    for line in lines:
        line.settimeout(max(0.1, end - time.monotonic()))
        try:
            while line.recv(4096):
                pass
        except TimeoutError:
            return True
        except OSError:
            pass
        line.close()
    return False


ATTACKS: dict[str, Callable[[Target], bool]] = {
    "504 guessed tokens": guessed_tokens,
    "54 paths outside the page": paths_outside,
    "8 foreign hosts and origins": hosts_and_origins,
    "500 broken requests": broken_requests,
    "3 headers of 16 MiB": giant_headers,
    "40 messages beyond 1 MiB": giant_messages,
    "200 silent connections": silent_connections,
}


def main() -> int:
    """Run the attacks and print one row for each; returns the exit code."""
    target, faults = Target(), 0
    target.is_well()
    print("| attack | result | threads | open files | memory [MiB] |\n|---|---|---|---|---|")
    for name, attack in ATTACKS.items():
        before = target.usage()
        is_through = attack(target)
        is_well, end = target.is_well(), time.monotonic() + 30
        while True:  # connections end after the client has closed them
            threads, files, memory = (after - start for after, start in zip(target.usage(), before, strict=True))
            is_freed = threads <= 0 and files <= 0 and memory < MAX_GROWTH
            if is_freed or time.monotonic() > end:
                break
            time.sleep(0.2)
        is_repelled = is_well and is_freed and not is_through
        faults += not is_repelled
        result = "repelled" if is_repelled else "SUCCEEDED"
        print(f"| {name} | {result} | {threads:+} | {files:+} | {memory / 2**20:+.0f} |", flush=True)
    target.process.kill()
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
