"""Who may talk to the viewer, and what they may set: rules for requests and values, apart from any server.

A server on a loopback port is open to every web page that the user's browser shows: a page may ask for
http://127.0.0.1:8080 itself, or let its own name point to 127.0.0.1 (DNS rebinding) and read the answers as its own.
So a request must name this machine in `Host`, and a websocket must come from the page that was served under that
same host and port (`Origin`); anything else is 403. Through `ssh -L 9000:127.0.0.1:8080` both say port 9000, so the
port is compared between the two, never with the one that is listened on.
"""

from __future__ import annotations

import ipaddress
import math
import re
from collections.abc import Mapping, Sequence
from typing import Any

_HOST = re.compile(r"(?P<name>\[[0-9a-f:.]+\]|[a-z0-9._-]+)(:(?P<port>[0-9]{1,5}))?", re.IGNORECASE)
_MOST_WHOLE = 2**53  # what a browser's numbers hold


def split_host(header: str) -> tuple[str, str] | None:
    """The name and the port ("" where none is given) of a `Host` header in small letters; None for what is neither."""
    match = _HOST.fullmatch(header)
    return (match["name"].lower().rstrip("."), match["port"] or "") if match else None


def is_loopback(name: str) -> bool:
    """Whether a host name or address, with or without brackets, is this machine's loopback."""
    address = as_address(name)
    return name.lower() == "localhost" if address is None else address.is_loopback


def as_address(name: str) -> ipaddress.IPv4Address | ipaddress.IPv6Address | None:
    """The IP address that a host name spells, None for a name."""
    try:
        return ipaddress.ip_address(name.strip("[]"))
    except ValueError:
        return None


class RequestGuard:
    """Which requests are answered.

    Args:
        names: Host names beside loopback's under which the viewer may be asked for, in small letters.
        any_address: Also under any IP address: for a viewer that listens beyond loopback. An address cannot be
            rebound, only a name can.
    """

    def __init__(self, names: frozenset[str] = frozenset(), *, any_address: bool = False):
        self.names, self.any_address = names, any_address

    def refusal(self, headers: Mapping[str, list[str]], *, websocket: bool) -> str:
        """Why a request with these headers (names in small letters) gets 403; "" where it may pass."""
        hosts, origins = headers.get("host", []), headers.get("origin", [])
        host = split_host(hosts[0]) if len(hosts) == 1 else None
        if host is None or not self._is_ours(host[0]):
            return "this viewer does not answer under that host name"
        if len(origins) > 1 or (websocket and not origins):
            return "only the viewer's own page may connect"
        if origins and not _is_same(origins[0], host):
            return "pages from elsewhere may not read this viewer"
        # A page may fetch or embed without sending an Origin; what the browser says of the request tells.
        mode, site = headers.get("sec-fetch-mode", ["navigate"]), headers.get("sec-fetch-site", ["none"])
        if not websocket and mode != ["navigate"] and site not in (["none"], ["same-origin"]):
            return "pages from elsewhere may not read this viewer"
        return ""

    def _is_ours(self, name: str) -> bool:
        return is_loopback(name) or name in self.names or (self.any_address and as_address(name) is not None)


def _is_same(origin: str, host: tuple[str, str]) -> bool:
    """Whether the origin "http://name:port" is that host; https is what a proxy in front may speak."""
    scheme, _, rest = origin.partition("://")
    default = {"http": "80", "https": "443"}.get(scheme.lower())
    named = split_host(rest)
    return (
        default is not None and named is not None and (named[0], named[1] or default) == (host[0], host[1] or default)
    )


def response_headers(host: str, sources: Mapping[str, Sequence[str]] | None = None) -> dict[str, str]:
    """The headers of every answer, for a page that was asked for under this (checked) `Host`.

    The page may run its own scripts and styles alone, which the policy names by their hashes, and reach nothing but its
    own websocket. Notebooks on this machine may frame it, other pages may not.

    Args:
        host: As asked for.
        sources: The hashes of the page's scripts and styles, by "script" and "style"; None for a page without.
    """
    allowed = {kind: " ".join(f"'{one}'" for one in (sources or {}).get(kind, ())) for kind in ("script", "style")}
    policy = [
        "default-src 'none'",
        "script-src " + (allowed["script"] or "'none'"),
        "style-src " + (allowed["style"] or "'none'"),
        "img-src data: blob:",
        f"connect-src ws://{host} wss://{host}",
        "base-uri 'none'",
        "form-action 'none'",
        "frame-ancestors 'self' http://localhost:* https://localhost:* http://127.0.0.1:* https://127.0.0.1:*",
    ]
    return {
        "Content-Security-Policy": "; ".join(policy),
        "X-Content-Type-Options": "nosniff",
        "Referrer-Policy": "no-referrer",
        "Cross-Origin-Resource-Policy": "same-origin",
        "Cache-Control": "no-store",
    }


def control_value(value: Any, current: Any, *, low: Any = None, high: Any = None, options: Any = None) -> Any:
    """What a control is set to by a page that says `value`.

    Args:
        value: As decoded.
        current: The control's value now: the new one must be of its kind.
        low: Its smallest number, None without.
        high: Its largest.
        options: What may be chosen, None for free choice.

    Returns:
        The value, a number brought within the limits and of the control's type, a list as a tuple.

    Raises:
        ValueError: it is of another kind, or no option.
    """
    kind = type(current)
    if kind is tuple:
        if not isinstance(value, list) or len(value) != len(current):
            raise ValueError(f"expected {len(current)} values, got {value!r:.80}")
        return tuple(control_value(a, b, low=low, high=high) for a, b in zip(value, current, strict=True))
    if kind in (int, float):
        if not isinstance(value, int | float) or isinstance(value, bool) or not math.isfinite(value):
            raise ValueError(f"expected a number, got {value!r:.80}")
        if kind is int and (value != int(value) or abs(value) > _MOST_WHOLE):
            raise ValueError(f"expected a whole number, got {value!r:.80}")
        value = value if low is None else max(value, low)
        return kind(value if high is None else min(value, high))
    if type(value) is not kind:
        raise ValueError(f"expected {kind.__name__}, got {value!r:.80}")
    if options is not None and value not in options:
        raise ValueError(f"expected one of {options}, got {value!r:.80}")
    return value
