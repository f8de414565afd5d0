"""Child processes of a program with a viewer inherit neither its port nor its pages."""

import os
import socket
import subprocess
import sys
from pathlib import Path

import pytest

from pointloom.visualization.viewer.server import ViewerServer

ROOT = Path(__file__).resolve().parents[3]
PARENT = """
import os, signal, socket, warnings
from pointloom.visualization.viewer.server import ViewerServer
warnings.simplefilter("ignore", DeprecationWarning)  # of forks beside threads
server, other = ViewerServer(port=0), socket.create_server(("127.0.0.1", 0))
line = socket.create_connection(("127.0.0.1", server.port))
line.sendall(b"GET / HTTP/1.1\\r\\nHost: ")  # a page that still asks
with socket.create_connection(("127.0.0.1", server.port)) as next_one:  # is accepted after that one
    next_one.sendall(b"GET / HTTP/1.1\\r\\nHost: 127.0.0.1\\r\\n\\r\\n")
    next_one.recv(1)
read, write = os.pipe()
child = os.fork()
if child == 0:
    server.close()
    os.write(write, f"{server.closed} {other.getsockname()[1]}".encode())
    signal.pause()
    os._exit(0)
try:
    print(os.read(read, 1000).decode() == f"True {other.getsockname()[1]}")
    with socket.create_connection(("127.0.0.1", server.port)) as one:
        one.sendall(b"GET /none HTTP/1.1\\r\\nHost: 127.0.0.1\\r\\n\\r\\n")
        print(one.recv(12))
    server.close()
    line.settimeout(60)
    print(line.recv(1))
    with ViewerServer(port=server.port) as again:
        print(again.port == server.port, os.waitpid(child, os.WNOHANG))
finally:
    os.kill(child, signal.SIGKILL)
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no forks here")
def test_a_surviving_child_inherits_neither_port_nor_pages():
    environment = os.environ | {"PYTHONPATH": str(ROOT / "src")}
    completed = subprocess.run(
        [sys.executable, "-c", PARENT], capture_output=True, text=True, env=environment, timeout=300
    )
    assert (completed.stdout.splitlines(), completed.stderr) == (["True", "b'HTTP/1.1 404'", "b''", "True (0, 0)"], "")


def test_a_closed_port_does_not_respond_though_another_process_has_its_socket():
    server = ViewerServer(port=0)
    duplicate = server.pages._hub._bound.dup()  # as in a child without Python's fork hooks
    server.close()
    with pytest.raises(ConnectionRefusedError):
        socket.create_connection(("127.0.0.1", server.port), timeout=60)
    with ViewerServer(port=server.port) as again:
        assert again.port == server.port
    duplicate.close()
