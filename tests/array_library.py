"""A simulated array library: it implements DLPack on the CPU and on CUDA, with its own stream.

It goes by cupy's name, which nothing here has. Its arrays note the streams that are named to them. Tests take it, Warp,
and torch and jax where they are installed, by `fake_library`.
"""

from __future__ import annotations

import importlib.util
import sys
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest
import warp as wp


class ndarray:  # noqa: N801  as cupy has it
    """An array over a Warp array's memory."""

    def __init__(self, memory: wp.array, library: Library):
        self.memory, self.library = memory, library

    def __dlpack_device__(self) -> tuple[int, int]:
        kind, index = self.memory.__dlpack_device__()
        return int(kind), int(index)

    def __dlpack__(self, *, stream: int | None = None) -> Any:
        self.library.requested_streams.append(stream)
        if self.memory.device.is_cuda:
            assert isinstance(stream, int)
            event = self.library.stream.record_event()  # by no wp.Stream: Warp would forget the stream at its end
            wp._src.context.runtime.core.wp_cuda_stream_wait_event(stream, event.cuda_event, False)
        return wp.to_dlpack(self.memory)

    @property
    def pointer(self) -> int:
        return self.memory.ptr

    @property
    def shape(self) -> tuple[int, ...]:
        return tuple(self.memory.shape)

    @property
    def dtype(self) -> np.dtype:
        return np.dtype(wp.dtype_to_numpy(self.memory.dtype))

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> np.ndarray:
        if self.memory.device.is_cuda:
            raise TypeError("Implicit conversion to a NumPy array is not allowed")
        return np.asarray(self.memory.numpy(), dtype)

    def __getitem__(self, key: Any) -> ndarray | Any:
        if isinstance(key, int) and self.memory.ndim == 1:
            return self.get()[key]
        return ndarray(self.memory[key], self.library)

    def __len__(self) -> int:
        return self.shape[0]

    def tolist(self) -> list:
        return self.get().tolist()

    def get(self) -> np.ndarray:
        """On the host, once everything is done."""
        return self.memory.numpy()


ndarray.__module__ = "cupy"


class Library(ModuleType):
    """The module; on a GPU it works on a private stream."""

    def __init__(self, device: str):
        super().__init__("cupy")
        self.device = device
        self.stream: Any = wp.Stream(device) if device != "cpu" else None
        self.requested_streams: list[int | None] = []

    def asarray(self, values: Any) -> ndarray:
        memory = wp.array(np.ascontiguousarray(values), device=self.device)
        if self.stream is not None:
            wp.synchronize_device(self.device)
        return ndarray(memory, self)

    def from_dlpack(self, source: Any) -> ndarray:
        stream = self.stream.cuda_stream if source.__dlpack_device__()[0] == 2 else None
        array: Any = wp.from_dlpack(source.__dlpack__(stream=stream))
        return ndarray(array, self)


def installed(device: str, monkeypatch: Any) -> Library:
    """The library, by cupy's name until the test ends."""
    library = Library(device)
    monkeypatch.setitem(sys.modules, "cupy", library)
    return library


LIBRARIES = ["warp", "cupy", *(name for name in ("torch", "jax") if importlib.util.find_spec(name) is not None)]


def fake_library(name: str, device: str, monkeypatch: Any) -> SimpleNamespace:
    """A library: `make` an array of its of NumPy's where `device` is, its `address`, and back to NumPy by `host`."""
    if name == "cupy":
        cupy = installed(device, monkeypatch)
        return SimpleNamespace(name=name, make=cupy.asarray, address=lambda a: a.pointer, host=lambda a: a.get())
    if name == "warp":

        def make_warp(values):
            return wp.array(np.ascontiguousarray(values), device=device)

        return SimpleNamespace(name=name, make=make_warp, address=lambda a: a.ptr, host=lambda a: a.numpy())
    module = importlib.import_module(name if name == "torch" else "jax.numpy")
    if device != "cpu" and not (name == "torch" and module.cuda.is_available()):
        pytest.skip(f"{name} here has no GPU of its own")

    def make(values):
        made = module.asarray(np.array(values))
        return made.to(device) if name == "torch" else made

    def address(array):
        return array.data_ptr() if name == "torch" else array.unsafe_buffer_pointer()

    def host(array):
        return np.asarray(array.cpu() if name == "torch" else array)

    return SimpleNamespace(name=name, make=make, address=address, host=host)


def package(values: Any) -> str:
    """The library of an array."""
    return type(values).__module__.partition(".")[0].replace("jaxlib", "jax")


def assert_same(library: SimpleNamespace, result: Any, expected: np.ndarray) -> None:
    """An array of the library with NumPy's numbers; jax stores 64 bits in 32 by default."""
    assert package(result) == library.name
    host = library.host(result)
    kind = host.dtype if library.name == "jax" else expected.dtype
    np.testing.assert_array_equal(host, expected.astype(kind), strict=True)
