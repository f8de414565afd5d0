"""Who may talk to the viewer, and what they may say: the rules for requests and messages, apart from any server.

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
import types
from collections.abc import Callable, Mapping
from typing import Any, Literal, Union, get_args, get_origin

# Messages of a page are below 1 kB; only pictures and uploaded files are larger. Decoded, a list of empty lists takes
# 56 times its bytes, so what is larger than a small message may hold no lists at all.
MOST_BYTES = 8 << 20
MOST_SMALL_BYTES = 256 << 10

_HOST = re.compile(r"(?P<name>\[[0-9a-f:.]+\]|[a-z0-9._-]+)(:(?P<port>[0-9]{1,5}))?", re.IGNORECASE)
_MOST_WHOLE = 2**53  # what a browser's numbers hold
_BINARY = (0xC4, 0xC5, 0xC6)  # the first byte of msgpack's bin 8, 16 and 32


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


def response_headers(host: str) -> dict[str, str]:
    """The headers of every answer, for a page that was asked for under this (checked) `Host`.

    The page is one file with its scripts and styles inside, unpacked as it loads, and workers made of blobs; it may
    reach nothing but its own websocket. Notebooks on this machine may frame it, other pages may not.
    """
    policy = [
        "default-src 'none'",
        "script-src 'self' 'unsafe-inline' 'unsafe-eval' blob:",
        "style-src 'self' 'unsafe-inline'",
        "img-src 'self' data: blob:",
        "font-src 'self' data:",
        "media-src 'self' data: blob:",
        "worker-src 'self' blob:",
        f"connect-src 'self' ws://{host} wss://{host} data: blob:",
        "base-uri 'none'",
        "form-action 'none'",
        "frame-src 'none'",
        "object-src 'none'",
        "frame-ancestors 'self' http://localhost:* https://localhost:* http://127.0.0.1:* https://127.0.0.1:*",
    ]
    return {
        "Content-Security-Policy": "; ".join(policy),
        "X-Content-Type-Options": "nosniff",
        "Referrer-Policy": "no-referrer",
        "Cross-Origin-Resource-Policy": "same-origin",
        "Cache-Control": "no-store",
    }


def read_message(raw: bytes, hints_of: Callable[[str], Mapping[str, Any] | None]) -> dict[str, Any] | None:
    """A message of a page, checked field by field.

    Args:
        raw: As it came, msgpack.
        hints_of: The names and types of the fields of a kind of message; None for a kind that is not listened to.

    Returns:
        Its fields with "type", None for one to be passed over.

    Raises:
        ValueError: no msgpack, or no message at all.
    """
    import msgspec  # comes with viser

    try:
        if len(raw) <= MOST_SMALL_BYTES:
            fields = msgspec.msgpack.decode(raw)
        else:
            flat = msgspec.msgpack.decode(raw, type=dict[str, msgspec.Raw])
            fields = {name: _decode_flat(bytes(value)) for name, value in flat.items()}
    except (msgspec.MsgspecError, RecursionError, UnicodeDecodeError) as error:
        raise ValueError(f"not a message: {error}") from error
    if not isinstance(fields, dict) or not isinstance(fields.get("type"), str):
        raise ValueError("not a message: a map with a type is expected")
    hints = hints_of(fields["type"])
    if hints is None or not all(
        name == "type" or (name in hints and fits(fields[name], hints[name])) for name in fields
    ):
        return None
    return fields


def _decode_flat(raw: bytes) -> Any:
    """A value that is no list and no map."""
    import msgspec

    return msgspec.msgpack.decode(raw, type=bytes if raw[0] in _BINARY else str | int | float | bool | None)


def fits(value: Any, hint: Any) -> bool:
    """Whether a decoded value is of the annotated type; numbers must be finite, whole ones may come as floats."""
    kind, inner = get_origin(hint), get_args(hint)
    if hint is Any:
        return True
    if kind is Literal:
        return value in inner if isinstance(value, str | int) else value is None and None in inner
    if kind in (Union, types.UnionType):
        return any(fits(value, one) for one in inner)
    if kind is tuple:
        if not isinstance(value, list):
            return False
        inner = inner[:1] * len(value) if inner[1:] == (...,) else inner
        return len(value) == len(inner) and all(map(fits, value, inner))
    if kind is dict:
        return isinstance(value, dict) and all(fits(k, inner[0]) and fits(v, inner[1]) for k, v in value.items())
    if hint in (int, float):
        number = isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)
        return number and (hint is float or abs(value) <= _MOST_WHOLE)
    return isinstance(value, type(None) if hint is None else hint)


def control_value(value: Any, current: Any, *, low: Any = None, high: Any = None, options: Any = None) -> Any:
    """What a control is set to by a page that says `value`.

    Args:
        value: As decoded.
        current: The control's value now: the new one must be of its kind.
        low: Its smallest number, None without.
        high: Its largest.
        options: What may be chosen, None for free choice.

    Returns:
        The value, a number brought within the limits.

    Raises:
        ValueError: it is of another kind, or no option.
    """
    kind = type(current)
    if kind is tuple:
        if not isinstance(value, list) or len(value) != len(current):
            raise ValueError(f"expected {len(current)} values, got {value!r:.80}")
        return [control_value(a, b, low=low, high=high) for a, b in zip(value, current, strict=True)]
    if not fits(value, kind) if kind in (int, float) else not isinstance(value, kind):
        raise ValueError(f"expected {kind.__name__}, got {value!r:.80}")
    if options is not None and value not in options:
        raise ValueError(f"expected one of {options}, got {value!r:.80}")
    if kind in (int, float):
        value = value if low is None else max(value, low)
        value = value if high is None else min(value, high)
    return value
