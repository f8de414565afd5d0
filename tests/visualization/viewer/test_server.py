"""The viewer's server: accepted requests, valid messages, and a clean shutdown."""

import base64
import gc
import gzip
import hashlib
import os
import re
import socket
import subprocess
import sys
import textwrap
import threading
import weakref

import numpy as np
import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect

from pointloom.core.errors import PointloomError
from pointloom.visualization.viewer.link import hub
from pointloom.visualization.viewer.server import MAX_PORTS, ViewerError, ViewerServer

from .events import join_threads, wait_until
from .pages import (
    HELLO,
    count,
    get,
    hear,
    hear_until,
    is_well,
    line_of,
    page_of,
    send,
    send_raw,
    silent_line,
    with_token,
)


@pytest.fixture
def free_port() -> int:
    with socket.create_server(("127.0.0.1", 0)) as line:
        return line.getsockname()[1]


def test_the_server_listens_on_loopback_only(server):
    other = "127.0.0.2"  # also means this machine, and would reach servers that listen on all addresses
    with pytest.raises(ConnectionRefusedError):
        socket.create_connection((other, server.port), timeout=60)
    assert server.url == f"http://127.0.0.1:{server.port}/?token={server.pages.token}"
    assert not server.exposed
    assert server.moved_from is None


def test_the_line_for_ssh_names_both_ports(server, monkeypatch):
    monkeypatch.setenv("SSH_CONNECTION", "10.0.0.9 50000 10.0.0.2 2222")
    with ViewerServer(port=0) as remote:
        assert remote.ssh_line.startswith(f"ssh -p 2222 -L {remote.port}:127.0.0.1:{remote.port} ")
        assert remote.ssh_line.endswith("@10.0.0.2")


def test_a_port_in_use_gives_the_next_one_with_a_message(server):
    with ViewerServer(port=server.port) as second:
        assert server.port < second.port < server.port + MAX_PORTS
        assert second.moved_from == server.port


def test_no_free_port_is_an_error_with_a_remedy(monkeypatch):
    monkeypatch.setattr("pointloom.visualization.viewer.server.MAX_PORTS", 1)
    with ViewerServer(port=0) as server, pytest.raises(ViewerError, match=f"{server.port}:"):
        ViewerServer(port=server.port)


@pytest.mark.parametrize("host", ["203.0.113.7", "no-such-host.invalid", "a" * 300, "127.0.0.1:80"])
def test_an_address_of_others_is_an_error_with_a_remedy(host):
    with pytest.raises(PointloomError, match=r"127\.0\.0\.1"):
        ViewerServer(host, port=0)


def test_a_host_and_a_port_that_are_none_are_refused_by_name():
    for port in (-1, 65536, 1.5, "8080", None, True):
        with pytest.raises(ValueError, match="port:"):
            ViewerServer(port=port)
    for host in ("", None, 7):
        with pytest.raises(ValueError, match="host:"):
            ViewerServer(host, port=0)


def test_the_server_is_exposed_only_on_request_with_a_message():
    with ViewerServer("0.0.0.0", port=0) as server:
        assert server.exposed
        assert server.url == f"http://127.0.0.1:{server.port}/?token={server.pages.token}"
        assert get(server, Host=f"192.168.1.5:{server.port}")[0] == 200
        assert get(server, Host=f"evil.example:{server.port}")[0] == 403


def test_localhost_and_the_other_loopback_are_loopback():
    with ViewerServer("localhost", port=0) as server:
        assert not server.exposed
        assert is_well(server)
    if socket.has_ipv6:
        try:
            socket.create_server(("::1", 0), family=socket.AF_INET6).close()
        except OSError:
            return
        with ViewerServer("::1", port=0) as server:
            assert server.url == f"http://[::1]:{server.port}/?token={server.pages.token}"
            assert not server.exposed


def test_the_page_is_served_under_our_name(server):
    status, headers, body = get(server)
    assert status == 200
    assert headers["content-type"] == "text/html; charset=utf-8"
    assert b"<title>pointloom</title>" in body
    packed = get(server, Accept_Encoding="gzip, br")
    assert packed[1]["content-encoding"] == "gzip"
    assert gzip.decompress(packed[2]) == body


def test_an_unchanged_page_is_sent_once(server):
    tag = get(server)[1]["etag"]
    for etags in (tag, f"W/{tag}", f'"other", {tag}'):
        status, headers, body = get(server, If_None_Match=etags)
        assert (status, body, headers["etag"]) == (304, b"", tag)
    assert get(server, If_None_Match='"other"')[0] == 200
    assert get(server)[1]["cache-control"] == "no-cache"
    status, _, body = get(server, "/", If_None_Match=tag)
    assert status == 403 and b"Open the complete address that the program printed" in body


def test_without_the_token_only_a_text_is_served(server):
    for query in (
        "", "?token=", "?token=wrong", "?token=%ff%00", "?Token={token}", "?token={token}x",
        "?token={token}&token={token}", "?token[]={token}", "?" + "&" * 1000,
    ):  # fmt: skip
        status, _, body = get(server, "/" + query.format(token=server.pages.token))
        assert status in (400, 403) and server.pages.token.encode() not in body and b"<script" not in body, query
    response = send_raw(server, "GET /?token=\u00e4 HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n".encode())
    assert not response or response.startswith((b"HTTP/1.1 403 ", b"HTTP/1.1 400 "))


def test_a_websocket_without_the_token_gets_403(server):
    for address in ("/live", "/live?token=", f"/live?token={'x' * 24}"):
        with pytest.raises(InvalidStatus, match="403"):
            connect(f"ws://127.0.0.1:{server.port}{address}", origin=f"http://127.0.0.1:{server.port}", proxy=None)


def test_each_server_has_its_own_unguessable_token(server):
    with ViewerServer(port=0) as other:
        assert other.pages.token != server.pages.token
        assert len(other.pages.token) >= 22  # 128 bits and more


def test_every_response_has_security_headers(server):
    for response in (get(server), get(server, "/"), get(server, "/other"), get(server, Host="evil.example")):
        headers = response[1]
        assert "default-src 'none'" in headers["content-security-policy"]
        assert "unsafe" not in headers["content-security-policy"]
        assert headers["x-content-type-options"] == "nosniff"
        assert headers["referrer-policy"] == "no-referrer"
        assert headers["cross-origin-resource-policy"] == "same-origin"
        assert headers["cache-control"] == ("no-cache" if response[0] == 200 else "no-store")
        assert "access-control-allow-origin" not in headers
        assert "server" not in headers


def test_the_policy_names_the_scripts_and_styles_that_the_page_has(server):
    _, headers, body = get(server)
    inside = re.findall(rb"<(script|style)\b[^>]*>(.*?)</\1>", body, re.DOTALL)
    assert inside
    for _, text in inside:
        assert (
            f"'sha256-{base64.b64encode(hashlib.sha256(text).digest()).decode()}'" in headers["content-security-policy"]
        )


def test_only_the_page_is_served(server):
    for path in (
        "/etc/passwd", "/../../../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/..%5c..%5cetc", "//etc/passwd", "/.",
        "/index.html", "/%00", "/live", "/LIVE", "/live/", "http://127.0.0.1/", "*",
    ):  # fmt: skip
        status, _, body = get(server, with_token(server, path))
        assert status == 404 and b"root:" not in body, path


def test_another_port_of_the_user_behind_ssh_is_answered(server):
    assert get(server, Host="localhost:9000", Origin="http://localhost:9000")[0] == 200
    with silent_line(server, "localhost", 9000) as line:
        assert line.recv(100).startswith(b"HTTP/1.1 101 ")


def test_other_hosts_and_origins_get_403(server):
    for host in ("evil.example", "127.0.0.1.evil.example", "192.168.1.5"):
        assert get(server, Host=host)[0] == 403
    for origin in ("http://evil.example", "null", f"http://localhost:{server.port}", "http://127.0.0.1:1"):
        assert get(server, Origin=origin)[0] == 403
        with pytest.raises(InvalidStatus, match="403"), line_of(server, origin=origin):
            pass
    with pytest.raises(InvalidStatus, match="403"), line_of(server, origin=None):
        pass
    assert get(server, Origin=f"http://127.0.0.1:{server.port}")[0] == 200


def test_an_outdated_page_gets_a_reload_message(server):
    for offered in (None, ["chat"], ["viser-v1.1.1"]):
        with pytest.raises(InvalidStatus, match="426"), line_of(server, subprotocols=offered):
            pass
    for offered, version in ((["pointloom.0"], 1), (["pointloom.2"], 2), (["pointloom.1"], 2)):
        with line_of(server, subprotocols=offered) as line, pytest.raises(ConnectionClosed) as ended:
            send(line, {**HELLO, "version": version})
            line.recv(timeout=60)
        assert ended.value.rcvd.code == 4001


def test_only_get_is_answered(server):
    for method in ("POST", "PUT", "DELETE", "OPTIONS", "CONNECT", "PATCH"):
        assert b" 200 " not in send_raw(server, f"{method} / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n".encode()), method


def test_invalid_requests_are_rejected(server):
    for data in (
        b"\x00" * 100, b"GET / HTTP/1.1\r\n\r\n", b"GET /\r\n\r\n",
        b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nHost: evil\r\n\r\n",
        b"GET / HTTP/1.1\r\n" + b"A: b\r\n" * 1000 + b"\r\n", b"GET /" + b"a" * 100_000,
        b"\x16\x03\x01\x02\x00" + b"x" * 600, b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 5\r\n\r\nhello",
        b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nOrigin: http://127.0.0.1\r\n\r\n",
    ):  # fmt: skip
        assert b" 200 " not in send_raw(server, data), data[:40]
    assert is_well(server)


def test_closing_frees_the_port_at_once(free_port):
    for _ in range(3):
        with ViewerServer(port=free_port) as server:
            assert server.port == free_port
            with page_of(server) as line:
                hear(line)
                server.close()
                with pytest.raises(ConnectionClosed):
                    while True:
                        line.recv(timeout=60)


def test_closing_frees_the_memory(quick_collection):
    before = set(threading.enumerate())
    with ViewerServer(port=0) as server:
        server.pages.scene.add_points(np.zeros((100_000, 3), np.float32), plain=(255, 0, 0))
        with page_of(server) as line:
            hear(line)
        died = weakref.ref(server.pages)
    join_threads(lambda thread: thread not in before)
    gc.collect()
    assert died() is None


def test_closing_does_not_wait_for_a_page_that_does_not_read(monkeypatch):
    for limit in ("CLOSE_SECONDS", "STALL_SECONDS"):
        monkeypatch.setattr(hub, limit, 1e6)
    with ViewerServer(port=0) as server:
        server.pages.scene.add_points(np.zeros((200_000, 3), np.float32), plain=(255, 0, 0))
        with silent_line(server):
            wait_until(lambda: count(server) == 1)
            thread = server.pages._hub._thread
            server.close()
            thread.join(60)
            assert not thread.is_alive()


def test_pages_receive_the_last_message_before_they_are_closed():
    with ViewerServer(port=0) as server, page_of(server) as line:
        server.pages.end("The program has ended")
        server.close()
        assert hear_until(line, "end")["text"] == "The program has ended"
        with pytest.raises(ConnectionClosed) as ended:
            line.recv(timeout=60)
        assert ended.value.rcvd.code == 1001


def run_python(script: str, **settings) -> subprocess.CompletedProcess[str]:
    source = textwrap.dedent(script)
    return subprocess.run(
        [sys.executable, "-W", "error", "-c", source], capture_output=True, text=True, timeout=300, **settings
    )


SRC = os.pathsep.join(path for path in sys.path if path)


@pytest.mark.parametrize(
    "end",
    [
        "",
        *(pytest.param(end, marks=pytest.mark.slow) for end in (
            "import os, signal; os.kill(os.getpid(), signal.SIGINT)", "server.close()", "import sys; sys.exit(0)",
            "import asyncio\nasync def cell():\n    ViewerServer(port=0).close()\nasyncio.run(cell())",
        )),
    ],
    ids=["end of the script", "Ctrl-C", "close", "sys.exit", "in a running loop"],
)  # fmt: skip
def test_a_script_ends_silently_however_it_ends(end):
    script = f"""
from pointloom.visualization.viewer.server import ViewerServer
server = ViewerServer(port=0)
server.pages.scene.add_group()
try:
    {end.replace(chr(10), chr(10) + "    ") or "pass"}
except KeyboardInterrupt:
    pass
"""
    done = run_python(script, env=os.environ | {"PYTHONPATH": SRC})
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
