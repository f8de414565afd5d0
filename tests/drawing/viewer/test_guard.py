"""The rules of the door, apart from any server."""

from __future__ import annotations

from typing import Any, Literal, Optional

import pytest

from pointloom.drawing.viewer.guard import RequestGuard, control_value, fits, read_message, response_headers, split_host

LOCAL = RequestGuard()
OPEN = RequestGuard(frozenset({"scanner.lab", "scanner"}), any_address=True)


def asked(host: str, **others: str) -> dict[str, list[str]]:
    return {"host": [host]} | {name.replace("_", "-"): [value] for name, value in others.items()}


@pytest.mark.parametrize(
    "host", ["127.0.0.1:8080", "localhost:9000", "LOCALHOST", "[::1]:8080", "127.0.1.1", "localhost.:8080"]
)
def test_loopback_is_answered_under_any_port(host):
    assert LOCAL.refusal(asked(host), websocket=False) == ""
    assert LOCAL.refusal(asked(host, origin=f"http://{host}"), websocket=True) == ""


@pytest.mark.parametrize(
    "host",
    [
        "evil.example:8080", "127.0.0.1.evil.example", "localhost.evil.example", "evil-localhost", "192.168.1.5:8080",
        "", "127.0.0.1:8080:80", "127.0.0.1@evil.example", "[::1", "127.0.0.1:8080/", "0x7f.1", "127.0.0.1 ", "a" * 300,
    ],
)  # fmt: skip
def test_a_name_that_only_points_here_is_refused(host):
    assert LOCAL.refusal(asked(host), websocket=False)
    assert LOCAL.refusal(asked(host, origin=f"http://{host}"), websocket=True)


def test_two_hosts_or_none_are_refused():
    assert LOCAL.refusal({}, websocket=False)
    assert LOCAL.refusal({"host": ["127.0.0.1", "127.0.0.1"]}, websocket=False)


@pytest.mark.parametrize(
    "origin",
    [
        "http://evil.example", "http://127.0.0.1:8081", "http://localhost:8080", "null", "file://", "",
        "127.0.0.1:8080", "http://127.0.0.1:8080.evil.example", "http://127.0.0.1", "ftp://127.0.0.1:8080", "http://127.0.0.1:8080/",
    ],
)  # fmt: skip
def test_a_page_from_elsewhere_is_refused(origin):
    for websocket in (False, True):
        assert LOCAL.refusal(asked("127.0.0.1:8080", origin=origin), websocket=websocket)


def test_a_websocket_without_an_origin_is_refused_and_a_page_is_not():
    assert LOCAL.refusal(asked("127.0.0.1:8080"), websocket=True)
    assert not LOCAL.refusal(asked("127.0.0.1:8080"), websocket=False)
    assert LOCAL.refusal({"host": ["127.0.0.1"], "origin": ["http://127.0.0.1"] * 2}, websocket=True)


def test_default_ports_are_the_same_as_none():
    assert not LOCAL.refusal(asked("localhost", origin="http://localhost:80"), websocket=True)
    assert not LOCAL.refusal(asked("localhost:443", origin="https://localhost"), websocket=True)
    assert LOCAL.refusal(asked("localhost:80", origin="https://localhost"), websocket=True)


@pytest.mark.parametrize("site", ["cross-site", "same-site"])
def test_fetching_and_embedding_from_elsewhere_is_refused_even_without_an_origin(site):
    for mode in ("no-cors", "cors", "same-origin"):
        assert LOCAL.refusal(asked("127.0.0.1", sec_fetch_site=site, sec_fetch_mode=mode), websocket=False)
    assert not LOCAL.refusal(asked("127.0.0.1", sec_fetch_site=site, sec_fetch_mode="navigate"), websocket=False)
    assert not LOCAL.refusal(asked("127.0.0.1", sec_fetch_site="same-origin", sec_fetch_mode="cors"), websocket=False)


def test_a_server_for_others_answers_under_its_addresses_and_its_own_names():
    for host in ("192.168.1.5:8080", "scanner.lab:8080", "Scanner:8080", "[fe80::1]:8080", "localhost:8080"):
        assert not OPEN.refusal(asked(host), websocket=False)
    assert OPEN.refusal(asked("evil.example:8080"), websocket=False)
    assert OPEN.refusal(asked("192.168.1.5:8080", origin="http://192.168.1.6:8080"), websocket=True)


def test_no_header_can_be_smuggled_in_by_a_host():
    for host in ("127.0.0.1\r\nX: y", "127.0.0.1; script-src *", "127.0.0.1 *", "*"):
        assert split_host(host) is None


def test_the_page_may_reach_nothing_but_its_own_server():
    rules = dict(
        rule.split(" ", 1) for rule in response_headers("127.0.0.1:8080")["Content-Security-Policy"].split("; ")
    )
    assert rules["default-src"] == "'none'"
    assert rules["connect-src"].split() == ["'self'", "ws://127.0.0.1:8080", "wss://127.0.0.1:8080", "data:", "blob:"]
    outside = [
        word for name, rule in rules.items() if name != "frame-ancestors" for word in rule.split() if "//" in word
    ]
    assert all("127.0.0.1:8080" in word for word in outside)
    assert "*" not in rules["frame-ancestors"].replace(":*", "")


OPTIONAL = Optional[int]  # noqa: UP045  as viser writes it
HINTS: dict[str, Any] = {"x": float, "n": int, "at": tuple[float, float, float], "text": str, "data": bytes}


@pytest.mark.parametrize(
    ("value", "hint", "does"),
    [
        (1, float, True), (1.5, float, True), (float("nan"), float, False), (float("inf"), float, False),
        ("1", float, False), (True, float, False), (None, float, False),
        ([1.0, 2.0, 3.0], tuple[float, float, float], True), ([1.0, 2.0], tuple[float, float, float], False),
        ([1.0, "2", 3.0], tuple[float, float, float], False), ("abc", tuple[float, float, float], False),
        ([[0.1, 0.2]] * 5, tuple[tuple[float, float], ...], True), ([[0.1]], tuple[tuple[float, float], ...], False),
        ([], tuple[float, ...], True), (None, OPTIONAL, True), ("x", OPTIONAL, False),
        ("click", Literal["click", "rect"], True), ("evil", Literal["click", "rect"], False),
        ([], Literal["click", "rect"], False), ({"a": [1, {}]}, dict[str, Any], True), ({1: 2}, dict[str, Any], False),
        (b"x", bytes, True), ("x", bytes, False), (2**64 - 1, float, True), (1e308, int, False), (7.0, int, True),
        ({}, str, False), (1, bool, False),
    ],
)  # fmt: skip
def test_a_field_is_of_its_type_or_refused(value, hint, does):
    assert fits(value, hint) is does


def encoded(**fields: Any) -> bytes:
    import msgspec

    return msgspec.msgpack.encode(fields)


def read(raw: bytes) -> dict[str, Any] | None:
    return read_message(raw, {"Known": HINTS}.get)


def test_a_message_that_fits_is_read():
    assert read(encoded(type="Known", x=1, at=[0, 0, 1])) == {"type": "Known", "x": 1, "at": [0, 0, 1]}
    large = bytes(1 << 20)
    assert read(encoded(type="Known", data=large, n=3)) == {"type": "Known", "data": large, "n": 3}


def test_what_nobody_listens_to_or_does_not_fit_is_passed_over():
    for fields in (
        {"type": "Other"},
        {"type": "Known", "more": 1},
        {"type": "Known", "x": []},
        {"type": "Known", "n": "7"},
    ):
        assert read(encoded(**fields)) is None


@pytest.mark.parametrize(
    "raw",
    [
        b"", b"\xc1", b"\xff" * 100, b"\x91" * 100_000, b"\xdd\xff\xff\xff\xff", b"\xdf\xff\xff\xff\xff",
        b"\xc6\xff\xff\xff\xff", b"\x80", b"\x90", b"\xc0", b"\x2a", b"\x81\xa4type\xc0", b"\x81\xa4type\xa2\xff\xfe",
        b"\x81\x01\x02", b"\x81\xa4type" + b"\xdc\xff\xff" + b"\x90" * 65535, bytes(300_000), b"\x90" * 300_000,
    ],
)  # fmt: skip
def test_what_is_no_message_is_an_error_and_takes_little(raw):
    with pytest.raises(ValueError, match="not a message"):
        read(raw)


def test_a_large_message_holds_no_lists():
    """4 million empty lists in 4 MB would take 230 MB."""
    with pytest.raises(ValueError, match="not a message"):
        read(encoded(type="Known", at=[[]] * 400_000))


def test_a_control_takes_values_of_its_own_kind_within_its_limits():
    assert control_value(3, 1.5, low=0.0, high=2.0) == 2.0
    assert control_value(-1, 5, low=0, high=9) == 0
    assert control_value(True, False) is True
    assert control_value("viridis", "turbo", options=("viridis", "turbo")) == "viridis"
    assert control_value([300, 0, 0], (1, 2, 3), low=0, high=255) == [255, 0, 0]


@pytest.mark.parametrize(
    ("value", "current", "options"),
    [
        ("3", 1.5, None), (float("nan"), 1.5, None), (None, 1.5, None), (True, 1, None), (1, False, None),
        ([], "text", None), ("evil", "turbo", ("viridis", "turbo")), ([1, 2], (1, 2, 3), None),
        ([1, "2", 3], (1, 2, 3), None), ({}, 1, None), ("abc", (1, 2, 3), None), ({}, None, None),
    ],
)  # fmt: skip
def test_a_control_refuses_what_is_no_value_of_it(value, current, options):
    with pytest.raises(ValueError, match="expected"):
        control_value(value, current, options=options)
