"""The request rules of the server, tested without a server."""

import pytest

from pointloom.visualization.viewer.guard import RequestGuard, control_value, response_headers, split_host

LOCAL = RequestGuard()
OPEN = RequestGuard(frozenset({"scanner.lab", "scanner"}), any_address=True)


def request_headers(host: str, **others: str) -> dict[str, list[str]]:
    return {"host": [host]} | {name.replace("_", "-"): [value] for name, value in others.items()}


@pytest.mark.parametrize(
    "host", ["127.0.0.1:8080", "localhost:9000", "LOCALHOST", "[::1]:8080", "127.0.1.1", "localhost.:8080"]
)
def test_loopback_is_answered_under_any_port(host):
    assert LOCAL.refusal(request_headers(host), websocket=False) == ""
    assert LOCAL.refusal(request_headers(host, origin=f"http://{host}"), websocket=True) == ""


@pytest.mark.parametrize(
    "host",
    [
        "evil.example:8080", "127.0.0.1.evil.example", "localhost.evil.example", "evil-localhost", "192.168.1.5:8080",
        "", "127.0.0.1:8080:80", "127.0.0.1@evil.example", "[::1", "127.0.0.1:8080/", "0x7f.1", "127.0.0.1 ", "a" * 300,
    ],
)  # fmt: skip
def test_a_name_that_only_points_here_is_refused(host):
    assert LOCAL.refusal(request_headers(host), websocket=False)
    assert LOCAL.refusal(request_headers(host, origin=f"http://{host}"), websocket=True)


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
    for websocket in (False, True):
        assert LOCAL.refusal(request_headers("127.0.0.1:8080", origin=origin), websocket=websocket)


def test_a_websocket_without_an_origin_is_refused_and_a_page_is_not():
    assert LOCAL.refusal(request_headers("127.0.0.1:8080"), websocket=True)
    assert not LOCAL.refusal(request_headers("127.0.0.1:8080"), websocket=False)
    assert LOCAL.refusal({"host": ["127.0.0.1"], "origin": ["http://127.0.0.1"] * 2}, websocket=True)


def test_default_ports_are_the_same_as_none():
    assert not LOCAL.refusal(request_headers("localhost", origin="http://localhost:80"), websocket=True)
    assert not LOCAL.refusal(request_headers("localhost:443", origin="https://localhost"), websocket=True)
    assert LOCAL.refusal(request_headers("localhost:80", origin="https://localhost"), websocket=True)


@pytest.mark.parametrize("site", ["cross-site", "same-site"])
def test_fetching_and_embedding_from_elsewhere_is_refused_even_without_an_origin(site):
    for mode in ("no-cors", "cors", "same-origin"):
        assert LOCAL.refusal(request_headers("127.0.0.1", sec_fetch_site=site, sec_fetch_mode=mode), websocket=False)
    assert not LOCAL.refusal(
        request_headers("127.0.0.1", sec_fetch_site=site, sec_fetch_mode="navigate"), websocket=False
    )
    assert not LOCAL.refusal(
        request_headers("127.0.0.1", sec_fetch_site="same-origin", sec_fetch_mode="cors"), websocket=False
    )


def test_a_server_for_others_answers_under_its_addresses_and_its_own_names():
    for host in ("192.168.1.5:8080", "scanner.lab:8080", "Scanner:8080", "[fe80::1]:8080", "localhost:8080"):
        assert not OPEN.refusal(request_headers(host), websocket=False)
    assert OPEN.refusal(request_headers("evil.example:8080"), websocket=False)
    assert OPEN.refusal(request_headers("192.168.1.5:8080", origin="http://192.168.1.6:8080"), websocket=True)


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


def test_a_control_takes_values_of_its_own_kind_within_its_limits():
    assert control_value(3, 1.5, low=0.0, high=2.0) == 2.0
    assert control_value(-1, 5, low=0, high=9) == 0
    assert type(control_value(3, 1.5)) is float
    assert type(control_value(3.0, 1)) is int
    assert control_value(True, False) is True
    assert control_value("viridis", "turbo", options=("viridis", "turbo")) == "viridis"
    assert control_value([300, 0, 0], (1, 2, 3), low=0, high=255) == (255, 0, 0)


@pytest.mark.parametrize(
    ("value", "current", "options"),
    [
        ("3", 1.5, None), (float("nan"), 1.5, None), (None, 1.5, None), (True, 1, None), (1, False, None),
        ([], "text", None), ("evil", "turbo", ("viridis", "turbo")), ([1, 2], (1, 2, 3), None),
        ([1, "2", 3], (1, 2, 3), None), ({}, 1, None), (1.5, 1, None), (2**60, 1, None),
        ("abc", (1, 2, 3), None), ({}, None, None),
    ],
)  # fmt: skip
def test_a_control_rejects_invalid_values(value, current, options):
    with pytest.raises(ValueError, match="expected"):
        control_value(value, current, options=options)
