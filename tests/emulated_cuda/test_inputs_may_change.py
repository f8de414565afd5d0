"""The arrays given to a public call may be page-locked, and may change as soon as it returns.

CUDA copies from page-locked memory when the stream reaches the copy. Results of a GPU are page-locked (docs/arrays.md),
as are torch's pinned tensors.
"""

from __future__ import annotations

import functools
import inspect
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
import pytest
import warp as wp

import pointloom as loom
from pointloom.core.devices import resolve_device
from pointloom.kernels.language import pinned_uploads
from pointloom.kernels.memory import download, move, upload

from ..small_scenes import ON_CLOUDS, ONCE, SmallScenes, digest

DEVICE = "cuda:0"


def pinned(values: np.ndarray) -> np.ndarray:
    """A page-locked copy."""
    memory = wp.empty(max(1, values.nbytes), dtype=wp.uint8, device="cpu", pinned=True).numpy()
    out = memory[: values.nbytes].view(values.dtype).reshape(values.shape)
    out[...] = values
    return out


def overwrite(values: np.ndarray) -> None:
    """Fill an array with other numbers, as the next frame of a sensor does."""
    values.view(np.uint8 if values.flags.c_contiguous else values.dtype)[...] = 7


def as_pinned(value: Any, given: list[np.ndarray]) -> Any:
    """The value with page-locked copies of its arrays, which are added to `given`."""
    if isinstance(value, np.ndarray) and value.dtype.kind in "fiub" and value.ndim:
        given.append(pinned(np.ascontiguousarray(value)))
        return given[-1]
    if type(value) in (list, tuple):
        return type(value)(as_pinned(each, given) for each in value)
    return value


def public_callables() -> Iterator[tuple[Any, str]]:
    """Owners and names of the public functions, and of the methods of public classes."""
    modules = [loom, *(getattr(loom, name) for name in ("meshing", "registration", "rgbd", "photogrammetry"))]
    for module in modules:
        for name in module.__all__:
            value = getattr(module, name)
            if inspect.isfunction(value):
                yield module, name
            elif inspect.isclass(value):
                for key, member in vars(value).items():
                    if inspect.isfunction(member) and (key == "__init__" or not key.startswith("_")):
                        yield value, key


@contextmanager
def inputs_change() -> Iterator[set[str]]:
    """Give the outermost public calls page-locked copies of their arrays, which change when the call has returned."""
    depth, called, before = [0], set(), []

    def changed(function: Callable[..., Any], name: str) -> Callable[..., Any]:
        @functools.wraps(function)
        def call(*arguments: Any, **options: Any) -> Any:
            if depth[0]:
                return function(*arguments, **options)
            given: list[np.ndarray] = []
            depth[0] += 1
            try:
                result = function(
                    *(as_pinned(each, given) for each in arguments),
                    **{key: as_pinned(each, given) for key, each in options.items()},
                )
            finally:
                depth[0] -= 1
            if given:
                called.add(name)
            for values in given:
                overwrite(values)
            return result

        return call

    for owner, name in dict.fromkeys(public_callables()):
        function = inspect.getattr_static(owner, name)
        before.append((owner, name, function))
        setattr(owner, name, changed(function, f"{getattr(owner, '__name__', owner)}.{name}"))
    try:
        yield called
    finally:
        for owner, name, function in reversed(before):
            setattr(owner, name, function)


RECORDS = {**ON_CLOUDS, **ONCE}


@pytest.mark.parametrize("name", RECORDS)
def test_arrays_given_to_a_call_may_change_when_it_has_returned(emulated, settings, name):
    settings(lazy=True)
    results = []
    for changes in (False, True):
        scenes = SmallScenes(DEVICE)
        scene = scenes.sample(60, 10) if name in ON_CLOUDS else scenes
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            if changes:
                with inputs_change() as called:
                    result = RECORDS[name](scene)
            else:
                result = RECORDS[name](scene)
        results.append(digest(result))
    print("CALLED", name, sorted(called))
    assert results[0] == results[1]
