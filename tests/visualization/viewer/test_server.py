"""The viewer's server: accepted requests, foreign origins, forked processes, absent clients, and a clean shutdown."""

import base64
import contextlib
import gc
import gzip
import hashlib
import math
import os
import re
import socket
import subprocess
import sys
import threading
import time
import types
import weakref

import numpy as np
import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect

from pointloom.core.errors import PointloomError
from pointloom.visualization.viewer import client_presence, scene_display
from pointloom.visualization.viewer.client_presence import KEEP_ALIVE, Presence
from pointloom.visualization.viewer.guard import RequestGuard, response_headers, split_host
from pointloom.visualization.viewer.link import hub, waiting_connections
from pointloom.visualization.viewer.server import ViewerError, ViewerServer

from ...sigint import sigint_enabled
from . import events
from .events import join_threads, wait_until
from .pages import (
    HELLO,
    get,
    hear,
    hear_until,
    is_well,
    line_of,
    page_of,
    send,
    send_raw,
    silent_line,
    visitor_of,
    with_token,
)


def test_the_server_listens_on_loopback_only(server):
    other = "127.0.0.2"  # also means this machine, and would reach servers that listen on all addresses
    with pytest.raises(ConnectionRefusedError):
        socket.create_connection((other, server.port), timeout=60)
    assert server.url == f"http://127.0.0.1:{server.port}/?token={server.pages.token}"
    assert not server.exposed
    assert server.moved_from is None


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
        digest = base64.b64encode(hashlib.sha256(text).digest()).decode()
        assert f"'sha256-{digest}'" in headers["content-security-policy"]


def test_only_the_page_is_served(server):
    for path in (
        "/etc/passwd", "/../../../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/..%5c..%5cetc", "//etc/passwd", "/.",
        "/index.html", "/%00", "/live", "/LIVE", "/live/", "http://127.0.0.1/", "*",
    ):  # fmt: skip
        status, _, body = get(server, f"{path}?token={server.pages.token}")
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


OTHER_METHODS = ("POST", "PUT", "DELETE", "OPTIONS", "CONNECT", "PATCH")


def test_invalid_requests_and_other_methods_than_get_are_rejected(server):
    for data in (
        b"\x00" * 100, b"GET / HTTP/1.1\r\n\r\n", b"GET /\r\n\r\n",
        b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nHost: evil\r\n\r\n",
        b"GET / HTTP/1.1\r\n" + b"A: b\r\n" * 1000 + b"\r\n", b"GET /" + b"a" * 100_000,
        b"\x16\x03\x01\x02\x00" + b"x" * 600, b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: 5\r\n\r\nhello",
        b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nOrigin: http://127.0.0.1\r\n\r\n",
        *(f"{method} / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n".encode() for method in OTHER_METHODS),
    ):  # fmt: skip
        assert b" 200 " not in send_raw(server, data), data[:40]
    assert is_well(server)


@pytest.mark.parametrize("start", [b"", b"GET / HTTP/1.1\r\n", "GET {path} HTTP/1.1\r\nHost: 127.0.0.1\r\n"])
@pytest.mark.parametrize("limit", ["number", "time", "descriptors"])
def test_unfinished_requests_are_closed_and_pages_are_not(monkeypatch, start, limit):
    if limit == "number":
        monkeypatch.setattr(waiting_connections, "MAX_STRANGERS", 3)
    elif limit == "descriptors":
        resource = pytest.importorskip("resource", reason="Windows has no limit of descriptors")
        monkeypatch.setattr(resource, "getrlimit", lambda _: (12, 12))
    with ViewerServer(port=0) as server, page_of(server) as page, contextlib.ExitStack() as stack:
        data = start.format(path=with_token(server, "/")).encode() if isinstance(start, str) else start
        seconds = waiting_connections.STRANGER_SECONDS
        if limit == "time":  # for these lines alone: the requests of a busy machine take longer
            monkeypatch.setattr(waiting_connections, "STRANGER_SECONDS", 0.01)
        lines = [stack.enter_context(socket.create_connection(("127.0.0.1", server.port), 60)) for _ in range(5)]
        for line in lines:
            line.sendall(data)
        for line in lines[:2]:
            with contextlib.suppress(ConnectionResetError):
                assert line.recv(1) == b""
        monkeypatch.setattr(waiting_connections, "STRANGER_SECONDS", seconds)
        assert is_well(server)
        hear(page)


class Line:
    """A connection that records whether it was aborted."""

    is_aborted = False

    @property
    def transport(self):
        return self

    def abort(self):
        self.is_aborted = True


def test_requests_for_the_page_that_do_not_end_are_limited(monkeypatch):
    monkeypatch.setattr(waiting_connections, "MAX_LOADING", 2)
    waiting, lines = waiting_connections.WaitingConnections(), [Line() for _ in range(4)]
    for line in lines:
        waiting.admit(line)
    assert [line.is_aborted for line in lines] == [True, True, False, False]
    assert len(waiting) == 2


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
            wait_until(lambda: server.pages.client_count == 1)
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


SRC = os.pathsep.join(path for path in sys.path if path)


def run_python(script: str, *options: str) -> tuple[int, str, str]:
    """The exit status, stdout and stderr of a script."""
    environment = os.environ | {"PYTHONPATH": SRC}
    line = [sys.executable, *options, "-c", script]
    done = subprocess.run(line, capture_output=True, text=True, timeout=300, env=environment)
    return done.returncode, done.stdout, done.stderr


@pytest.mark.parametrize(
    "end",
    [
        "",
        *(pytest.param(end, marks=pytest.mark.slow) for end in (
            "import signal, sys; signal.raise_signal(signal.SIGINT); sys.exit(2)", "server.close()",
            "import sys; sys.exit(0)",
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
    with sigint_enabled():
        assert run_python(script, "-W", "error") == (0, "", "")


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


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="no forks here")
def test_a_surviving_child_inherits_neither_port_nor_pages():
    assert run_python(PARENT) == (0, "True\nb'HTTP/1.1 404'\nb''\nTrue (0, 0)\n", "")


def test_a_closed_port_does_not_respond_though_another_process_has_its_socket():
    server = ViewerServer(port=0)
    duplicate = server.pages._hub._bound.dup()  # as in a child without Python's fork hooks
    server.close()
    with pytest.raises(ConnectionRefusedError):
        socket.create_connection(("127.0.0.1", server.port), timeout=60)
    with ViewerServer(port=server.port) as again:
        assert again.port == server.port
    duplicate.close()


LOCAL = RequestGuard()
OPEN = RequestGuard(frozenset({"scanner.lab", "scanner"}), any_address=True)


def is_refused(guard: RequestGuard, host: str, websocket: bool = False, **others: str) -> bool:
    headers = {"host": [host]} | {name.replace("_", "-"): [value] for name, value in others.items()}
    return bool(guard.refusal(headers, websocket=websocket))


LOOPBACK = ["127.0.0.1:8080", "localhost:9000", "LOCALHOST", "[::1]:8080", "127.0.1.1", "localhost.:8080"]
NO_LOOPBACK = [
    "evil.example:8080", "127.0.0.1.evil.example", "localhost.evil.example", "evil-localhost", "192.168.1.5:8080",
    "", "127.0.0.1:8080:80", "127.0.0.1@evil.example", "[::1", "127.0.0.1:8080/", "0x7f.1", "127.0.0.1 ", "a" * 300,
]  # fmt: skip


@pytest.mark.parametrize("host", LOOPBACK + NO_LOOPBACK)
def test_loopback_is_answered_under_any_port_and_a_name_that_only_points_here_is_refused(host):
    for more in ({}, {"websocket": True, "origin": f"http://{host}"}):
        assert is_refused(LOCAL, host, **more) == (host in NO_LOOPBACK)


def test_two_hosts_or_none_are_refused():
    assert LOCAL.refusal({}, websocket=False)
    assert LOCAL.refusal({"host": ["127.0.0.1", "127.0.0.1"]}, websocket=False)


@pytest.mark.parametrize(
    "origin",
    [
        "http://evil.example", "http://127.0.0.1:8081", "http://localhost:8080", "null", "file://", "",
        "127.0.0.1:8080", "http://127.0.0.1:8080.evil.example", "http://127.0.0.1", "ftp://127.0.0.1:8080",
        "http://127.0.0.1:8080/",
    ],
)  # fmt: skip
def test_a_page_from_elsewhere_is_refused(origin):
    assert all(is_refused(LOCAL, "127.0.0.1:8080", websocket, origin=origin) for websocket in (False, True))


def test_a_websocket_without_an_origin_is_refused_and_a_page_is_not():
    assert is_refused(LOCAL, "127.0.0.1:8080", websocket=True) and not is_refused(LOCAL, "127.0.0.1:8080")
    assert LOCAL.refusal({"host": ["127.0.0.1"], "origin": ["http://127.0.0.1"] * 2}, websocket=True)


def test_default_ports_are_the_same_as_none():
    for host, origin in (("localhost", "http://localhost:80"), ("localhost:443", "https://localhost")):
        assert not is_refused(LOCAL, host, websocket=True, origin=origin)
    assert is_refused(LOCAL, "localhost:80", websocket=True, origin="https://localhost")


@pytest.mark.parametrize("site", ["cross-site", "same-site", "same-origin"])
def test_fetching_and_embedding_from_elsewhere_is_refused_even_without_an_origin(site):
    for mode in ("no-cors", "cors", "same-origin", "navigate"):
        refused = site != "same-origin" and mode != "navigate"
        assert is_refused(LOCAL, "127.0.0.1", sec_fetch_site=site, sec_fetch_mode=mode) == refused


def test_a_server_for_others_answers_under_its_addresses_and_its_own_names():
    for host in ("192.168.1.5:8080", "scanner.lab:8080", "Scanner:8080", "[fe80::1]:8080", "localhost:8080"):
        assert not is_refused(OPEN, host)
    assert is_refused(OPEN, "evil.example:8080")
    assert is_refused(OPEN, "192.168.1.5:8080", websocket=True, origin="http://192.168.1.6:8080")


def test_no_header_can_be_smuggled_in_by_a_host():
    for host in ("127.0.0.1\r\nX: y", "127.0.0.1; script-src *", "127.0.0.1 *", "*"):
        assert split_host(host) is None


def test_the_page_may_connect_only_to_its_server_and_run_only_its_scripts():
    headers = response_headers("127.0.0.1:8080", {"script": ["sha256-abc="], "style": []})
    rules = dict(rule.split(" ", 1) for rule in headers["Content-Security-Policy"].split("; "))
    assert rules["default-src"] == "'none'"
    assert rules["connect-src"].split() == ["ws://127.0.0.1:8080", "wss://127.0.0.1:8080"]
    assert (rules["script-src"], rules["style-src"]) == ("'sha256-abc='", "'none'")
    assert "unsafe" not in headers["Content-Security-Policy"]
    assert "*" not in rules["frame-ancestors"].replace(":*", "")


class Waiting:
    """A thread that waits for the last page of a viewer, by a clock that the test sets forward.

    Attributes:
        clock_offset: Offset of the clock [s].
        polls: Number of checks for the end of the wait.
    """

    def __init__(self, viewer, keep_alive, monkeypatch):
        self.clock_offset, self.polls, self.over = 0.0, 0, threading.Event()
        clock = types.SimpleNamespace(monotonic=lambda: time.monotonic() + self.clock_offset)
        for module in (client_presence, scene_display, hub):
            monkeypatch.setattr(module, "time", clock)
        monkeypatch.setattr(client_presence, "CHECK_INTERVAL", 0.001)
        is_over = Presence._is_over

        def look(*args):
            over = is_over(*args)
            self.polls += 1
            return over

        monkeypatch.setattr(Presence, "_is_over", look)
        events.announce(monkeypatch, Presence, "_is_over")
        threading.Thread(target=lambda: (viewer.wait(keep_alive=keep_alive), self.over.set()), daemon=True).start()

    def goes_on(self):
        """True if it still waits after another poll."""
        looks = self.polls
        wait_until(lambda: self.polls > looks + 1 or self.over.is_set())
        return not self.over.is_set()


def test_wait_ends_a_while_after_the_last_page_has_gone(viewer, capfd, monkeypatch):
    with pytest.raises(ValueError, match="seconds"):
        viewer.wait(-1)
    waiting = Waiting(viewer, 100, monkeypatch)
    waiting.clock_offset = 1000.0
    assert waiting.goes_on()  # there was no page yet
    with visitor_of(viewer.server):
        wait_until(lambda: viewer.sessions)
        waiting.clock_offset = 2000.0
        assert waiting.goes_on()
    wait_until(lambda: not viewer.sessions)
    assert waiting.goes_on()
    waiting.clock_offset += 101
    assert waiting.over.wait(60)
    ending = f"ending in 100 s (open {viewer.url} again to stay, Ctrl-C ends now)"
    assert capfd.readouterr() == ("", f"the last page has closed; {ending}\n")


def test_a_reloaded_page_extends_the_wait_on_slow_connections(viewer, capfd, monkeypatch):
    with visitor_of(viewer.server):
        wait_until(lambda: viewer.sessions)
    wait_until(lambda: not viewer.sessions)
    waiting = Waiting(viewer, 100, monkeypatch)
    for _ in range(2):  # the page is requested, but its websocket is late
        waiting.clock_offset += 70
        assert waiting.goes_on()
        assert get(viewer.server)[0] == 200
    with visitor_of(viewer.server):
        wait_until(lambda: "a page is open again" in stderr_of(capfd))
        waiting.clock_offset += 130
        assert waiting.goes_on()
    wait_until(lambda: not viewer.sessions)
    waiting.clock_offset += 101
    assert waiting.over.wait(60)


def test_rejected_requests_count_as_no_page(viewer):
    before = viewer.server.last_request
    assert get(viewer.server, Host="evil.example")[0] == 403
    assert get(viewer.server, "/favicon.ico")[0] == 404
    assert viewer.server.last_request == before
    get(viewer.server)
    assert viewer.server.last_request > before and time.monotonic() - viewer.server.last_request < 60


NOW = 1e10  # [s]


def display_stub(seconds):
    """The pages of a viewer whose last page left `seconds` ago, or that had no page yet."""
    seen = None if seconds is None else NOW - seconds
    server = types.SimpleNamespace(last_request=-math.inf, url="http://u")
    scene = types.SimpleNamespace(wait_until_closed=threading.Event().wait)
    return types.SimpleNamespace(sessions={}, last_closed=seen, server=server, scene=scene)


@pytest.mark.parametrize(
    ("seconds", "keep_alive", "over", "words"),
    [
        (None, 0, False, ""),
        (61, KEEP_ALIVE, True, ""),
        (59, KEEP_ALIVE, False, "ending in 60 s"),
        (1e9, math.inf, False, "waiting for another"),
        (0, 0, True, ""),
    ],
)
def test_polling_reports_once_that_the_last_page_has_gone(capfd, monkeypatch, seconds, keep_alive, over, words):
    monkeypatch.setattr(client_presence, "time", types.SimpleNamespace(monotonic=lambda: NOW))
    one = Presence(display_stub(seconds))
    assert [one.wait(0, keep_alive) for _ in range(3)] == [over] * 3
    with pytest.raises(ValueError, match="keep_alive"):
        one.wait(0, -1)
    lines = stderr_of(capfd).splitlines()
    assert len(lines) == bool(words) and words in "".join(lines)


def stderr_of(capfd):
    out, err = capfd.readouterr()
    assert out == ""
    return err
