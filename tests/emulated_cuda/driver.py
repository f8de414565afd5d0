"""The functions of CUDA's driver that pointloom calls past Warp, as its library has them."""

from __future__ import annotations

from typing import Any

from .streams import NON_BLOCKING, Stream, Streams, address_of

NAMES = ("libcuda.so.1", "libcuda.so", "nvcuda.dll")
SUCCESS, INVALID_VALUE, INVALID_CONTEXT, INVALID_HANDLE = 0, 1, 201, 400


def is_driver(name: str) -> bool:
    """Whether a library of this name is the driver."""
    return name in NAMES


class Driver:
    """libcuda.so; each function returns CUDA's number of an error, 0 for none."""

    def __init__(self, streams: Streams) -> None:
        self._streams = streams

    def cuStreamCreate(self, out: Any, flags: Any) -> int:
        """A stream of the current context; flags say whether it and the legacy stream wait for each other."""
        number = getattr(flags, "value", flags)
        if self._streams.contexts[-1] is None:
            return INVALID_CONTEXT
        if number not in (0, NON_BLOCKING):
            return INVALID_VALUE
        out._obj.value = self._streams.add(Stream(0, blocks=number != NON_BLOCKING))
        return SUCCESS

    def cuStreamDestroy_v2(self, stream: Any) -> int:
        """Forget a stream once what is queued on it has run."""
        found = self._streams.streams.pop(address_of(stream), None)
        if found is None:
            return INVALID_HANDLE
        self._streams.flush(found)
        return SUCCESS
