"""Types of kernels and reductions as their launches use them. lang.py, which imports the launches, has the classes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Protocol

from .kernel_cache import CachedKernel
from .source import Source
from .structs import FieldPath


class Launched(Protocol):
    """A kernel or a reduction."""

    name: str
    module: str

    @property
    def source(self) -> Source: ...
    @property
    def cached(self) -> CachedKernel | None: ...
    @property
    def takes(self) -> dict[str, Any]: ...
    @property
    def types(self) -> list[Any]: ...
    @property
    def field_paths(self) -> list[FieldPath]: ...
    @property
    def unpack_structs(self) -> Callable[[str, Sequence[Any]], list[Any]] | None: ...
    @property
    def first_device(self) -> Callable[[Sequence[Any]], Any]: ...
    @property
    def accept(self) -> Callable[[Sequence[Any]], tuple[list[Any], Any] | None]: ...
    @property
    def prepared(self) -> dict[str, Any]: ...
    @property
    def on_host(self) -> Any: ...
    @property
    def cuda(self) -> Any: ...
    @property
    def taichi(self) -> Any: ...
    @property
    def twin(self) -> Launched: ...
    @property
    def waits_for_block(self) -> bool: ...


class LaunchedReduction(Launched, Protocol):
    """A reduction."""

    vector: Any
    segmented: bool
