"""Access rules for requests and values, independent of the server.

Every web page in the user's browser can reach a loopback port, directly or by DNS rebinding. So `Host` must name this
machine, and a websocket's `Origin` must equal that host and port. Other requests get 403. The port is not compared with
the listening port, as both headers contain the local one behind `ssh -L`.
"""

from __future__ import annotations

import ipaddress
import math
import re
from collections.abc import Mapping, Sequence
from typing import Any

_HOST = re.compile(r"(?P<name>\[[0-9a-f:.]+\]|[a-z0-9._-]+)(:(?P<port>[0-9]{1,5}))?", re.IGNORECASE)
_MAX_INTEGER = 2**53  # exact integers in a browser


def split_host(header: str) -> tuple[str, str] | None:
    """Lowercase name and port ("" if missing) of a `Host` header. None if invalid."""
    match = _HOST.fullmatch(header)
    return (match["name"].lower().rstrip("."), match["port"] or "") if match else None


def is_loopback(name: str) -> bool:
    """True if a host name or address, with or without brackets, is loopback."""
    address = as_address(name)
    return name.lower() == "localhost" if address is None else address.is_loopback


def as_address(name: str) -> ipaddress.IPv4Address | ipaddress.IPv6Address | None:
    try:
        return ipaddress.ip_address(name.strip("[]"))
    except ValueError:
        return None


class RequestGuard:
    """Decides which requests are answered: for loopback, host `names`, and with `any_address` IP addresses.

    Addresses cannot be rebound, unlike names.
    """

    def __init__(self, names: frozenset[str] = frozenset(), *, any_address: bool = False):
        self.names, self.any_address = names, any_address

    def refusal(self, headers: Mapping[str, list[str]], *, websocket: bool) -> str:
        """Reason for a 403 response, given lowercase headers; "" if allowed."""
        hosts, origins = headers.get("host", []), headers.get("origin", [])
        host = split_host(hosts[0]) if len(hosts) == 1 else None
        if host is None or not self._is_allowed_host(host[0]):
            return "this viewer does not answer under that host name"
        if len(origins) > 1 or (websocket and not origins):
            return "only the viewer's own page may connect"
        if origins and not _is_same(origins[0], host):
            return "pages from elsewhere may not read this viewer"
        # requests without Origin (fetch, embedding) are identified by the browser's Sec-Fetch headers
        mode, site = headers.get("sec-fetch-mode", ["navigate"]), headers.get("sec-fetch-site", ["none"])
        if not websocket and mode != ["navigate"] and site not in (["none"], ["same-origin"]):
            return "pages from elsewhere may not read this viewer"
        return ""

    def _is_allowed_host(self, name: str) -> bool:
        return is_loopback(name) or name in self.names or (self.any_address and as_address(name) is not None)


def _is_same(origin: str, host: tuple[str, str]) -> bool:
    """True if the origin is that host. HTTPS may be used by a proxy."""
    scheme, _, rest = origin.partition("://")
    default = {"http": "80", "https": "443"}.get(scheme.lower())
    named = split_host(rest)
    return (
        default is not None and named is not None and (named[0], named[1] or default) == (host[0], host[1] or default)
    )


def response_headers(host: str, sources: Mapping[str, Sequence[str]] | None = None) -> dict[str, str]:
    """Headers of every response to a (checked) `Host`.

    The policy allows only the page's own scripts and styles, by hashes in `sources`, and its websocket. Notebooks on
    this machine may frame the page.
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
    """Validate a value that a page sets: the type of `current`, clipped to `low` and `high`, one of `options`.

    Lists become tuples. Raises ValueError for another type or an unknown option.
    """
    kind = type(current)
    if kind is tuple:
        if not isinstance(value, list) or len(value) != len(current):
            raise ValueError(f"expected {len(current)} values, got {value!r:.80}")
        return tuple(control_value(a, b, low=low, high=high) for a, b in zip(value, current, strict=True))
    if kind in (int, float):
        if not isinstance(value, int | float) or isinstance(value, bool) or not math.isfinite(value):
            raise ValueError(f"expected a number, got {value!r:.80}")
        if kind is int and (value != int(value) or abs(value) > _MAX_INTEGER):
            raise ValueError(f"expected a whole number, got {value!r:.80}")
        value = value if low is None else max(value, low)
        return kind(value if high is None else min(value, high))
    if type(value) is not kind:
        raise ValueError(f"expected {kind.__name__}, got {value!r:.80}")
    if options is not None and value not in options:
        raise ValueError(f"expected one of {options}, got {value!r:.80}")
    return value
