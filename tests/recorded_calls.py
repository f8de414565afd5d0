"""Valid arguments of public functions, taken from the records of operations (benchmarks/operation.py)."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Collection, Iterable, Iterator
from contextlib import contextmanager
from functools import cache
from types import CodeType, FunctionType
from typing import Any

import pointloom as loom

from .hostile import faults_of
from .small_scenes import ON_CLOUDS, ONCE, SmallScenes

COUNT = 60  # points of a cloud
MODULES = (loom, loom.meshing, loom.registration, loom.rgbd)


def names_in(function: Any, seen: set[Any] | None = None) -> set[str]:
    """The names in the code of a function and of the functions of its module that it calls."""
    seen = set() if seen is None else seen
    function = getattr(function, "call", function)
    if not isinstance(function, FunctionType) or function in seen:
        return set()
    seen.add(function)
    names = names_of(function.__code__)
    inner = [function.__globals__.get(name) for name in names]
    return names.union(*(names_in(each, seen) for each in inner if inspect.isfunction(each)))


def names_of(code: CodeType) -> set[str]:
    """The names in code and in the functions that it defines."""
    inner = (names_of(constant) for constant in code.co_consts if isinstance(constant, CodeType))
    return set(code.co_names).union(*inner)


@cache
def _records() -> list[tuple[Callable[[Any], Any], bool, set[str]]]:
    """Records, whether their scene is a cloud, and the names in their code: those on clouds first, then short ones."""
    records = [(record, True, names_in(record)) for record in ON_CLOUDS.values()]
    others = [(record, False, names_in(record)) for record in ONCE.values()]
    return records + sorted(others, key=lambda record: len(record[2]))


def has_record(name: str) -> bool:
    """True if a record may call a public function or method, such as PointCloud.crop."""
    return any(name.rpartition(".")[2] in names for *_, names in _records())


def owner_of(name: str) -> Any:
    """The class of a method, or the module of a function."""
    kind, _, last = name.rpartition(".")
    module = next(module for module in MODULES if (kind or last) in module.__all__)
    return getattr(module, kind) if kind else module


@contextmanager
def recorded(name: str) -> Iterator[list[inspect.BoundArguments]]:
    """Record the arguments of each call of a public function or method."""
    owner, last = owner_of(name), name.rpartition(".")[2]
    function, calls = getattr(owner, last), []
    signature = inspect.signature(function)

    def call(*arguments: Any, **options: Any) -> Any:
        calls.append(signature.bind(*arguments, **options))
        return function(*arguments, **options)

    own = vars(owner).get(last)
    setattr(owner, last, call)
    try:
        yield calls
    finally:
        if own is None:
            delattr(owner, last)
        else:
            setattr(owner, last, own)


@cache
def valid_call(name: str) -> tuple[Callable[..., Any], dict[str, Any]]:
    """A public function or bound method and its arguments: of the recorded call that passes most, and defaults."""
    scenes, calls = SmallScenes("cpu"), []
    surface = scenes.sample(COUNT, 10)
    for record, is_cloud, names in _records():
        if name.rpartition(".")[2] in names and (is_cloud or not calls):
            with recorded(name) as each:
                record(surface if is_cloud else scenes)
            calls += each
    assert calls, f"no record of an operation calls {name}"
    given = max(calls, key=lambda call: len(call.arguments))
    given.apply_defaults()
    kinds = {p.kind: p.name for p in given.signature.parameters.values()}
    arguments = dict(given.arguments)
    arguments |= arguments.pop(kinds.get(inspect.Parameter.VAR_KEYWORD, ""), {})
    arguments.pop(kinds.get(inspect.Parameter.VAR_POSITIONAL, ""), None)
    return getattr(arguments.pop("self", owner_of(name)), name.rpartition(".")[2]), arguments


def faults_of_recorded(name: str, arguments: Iterable[str], clouds: Collection[str]) -> list[str]:
    """Faults of a public function for hostile values of its arguments, of which some are `clouds`."""
    function, valid = valid_call(name)
    faults = []
    for argument in arguments:
        annotation = str(inspect.signature(function).parameters[argument].annotation)
        is_number = annotation.removesuffix(" | None") in ("int", "float")
        faults += faults_of(function, valid, argument, clouds=argument in clouds, number=is_number)
    return faults
