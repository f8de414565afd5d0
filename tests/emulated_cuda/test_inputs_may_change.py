"""The arrays given to a public call may be page-locked, and may change as soon as it returns.

CUDA copies from page-locked memory when the stream reaches the copy. Results of a GPU are page-locked (docs/arrays.md),
as are torch's pinned tensors.
"""

from __future__ import annotations

import functools
import inspect
import re
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
import warp as wp

import pointloom as loom

from ..products import few_quick
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
    if values.flags.writeable:
        values.view(np.uint8)[...] = 7


def with_copies(value: Any, copied: Callable[[np.ndarray], np.ndarray], given: list[np.ndarray]) -> Any:
    """The value with copies of its arrays, which are added to `given`."""
    if isinstance(value, np.ndarray) and value.dtype.kind in "fiub" and value.ndim:
        given.append(copied(np.ascontiguousarray(value)))
        return given[-1]
    if type(value) in (list, tuple):
        return type(value)(with_copies(each, copied, given) for each in value)
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
def inputs_change(copied: Callable[[np.ndarray], np.ndarray]) -> Iterator[set[str]]:
    """Give the outermost public calls copies of their arrays, which change when the call has returned."""
    depth, called, before = [0], set(), []

    def changed(function: Callable[..., Any], name: str) -> Callable[..., Any]:
        @functools.wraps(function)
        def call(*arguments: Any, **options: Any) -> Any:
            if depth[0]:
                return function(*arguments, **options)
            given: list[np.ndarray] = []
            depth[0] += 1
            try:
                return function(
                    *(with_copies(each, copied, given) for each in arguments),
                    **{key: with_copies(each, copied, given) for key, each in options.items()},
                )
            finally:
                depth[0] -= 1
                called.update([name] if given else [])
                for values in given:
                    overwrite(values)

        return call

    for owner, name in dict.fromkeys(public_callables()):
        function = inspect.getattr_static(owner, name)
        before.append((owner, name, function))
        setattr(owner, name, changed(function, f"{owner.__name__}.{name}"))
    try:
        yield called
    finally:
        for owner, name, function in reversed(before):
            setattr(owner, name, function)


def outcome(name: str, copied: Callable[[np.ndarray], np.ndarray]) -> tuple[str, set[str]]:
    """The digest of a record's result or its error, and the names of the calls that got arrays."""
    scenes = SmallScenes(DEVICE)
    scene = scenes.sample(60, 10) if name in ON_CLOUDS else scenes
    with warnings.catch_warnings(), inputs_change(copied) as called:
        warnings.simplefilter("ignore")
        try:
            return digest(RECORDS[name](scene)), called
        except (ValueError, TypeError, RuntimeError, loom.FileError) as error:  # poses that were overwritten
            return re.sub(r"/tmp/\S+", "", f"{type(error).__name__}: {error}"), called


RECORDS = {**ONCE, **ON_CLOUDS}


@few_quick(40, "name", list(RECORDS))
def test_page_locked_inputs_have_the_results_of_others(settings, name):
    """The arrays change after the call. Some objects keep the given arrays (poses), so pageable ones change, too."""
    settings(lazy=True)
    (expected, called), (result, _) = (outcome(name, copied) for copied in (np.array, pinned))
    assert result == expected, called
