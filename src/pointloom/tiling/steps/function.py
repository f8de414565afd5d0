"""User-defined functions as steps.

Files never contain code: functions are passed in Python or registered as entry points. Steps and manifests store names.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterable
from importlib.metadata import entry_points
from typing import Any, ClassVar

import numpy as np

from ...core.checks import check_positive, shown
from ...pcd.cloud import PointCloud
from ..exact_sums import ExactSums
from ..plan_check import TilePlan
from .step import Part, Step

GROUP = "pointloom.steps"  # of entry points
ROW = "pointloom_row"  # attribute that marks remaining rows after a step that drops points
_TOP_LEVEL = "a top-level function of a module that workers can import"

UserFunction = Callable[..., Any]


class Function(Step):
    """A user's function with its radius, from a cloud to one with the same rows or fewer. It must depend only on points
    within the radius, and must not move or add points. `call` is the function or the name of an entry point in the
    group `pointloom.steps`."""

    name, required = "function", ("call", "reach")
    defaults: ClassVar[dict[str, Any]] = {"arguments": {}}
    function: UserFunction | None = None

    def check(self) -> None:
        """Validate parameters. The name of a passed function replaces it in them."""
        self.radius = check_positive("reach", self.params["reach"], allow_zero=True)
        call, arguments = self.params["call"], self.params["arguments"]
        if not isinstance(arguments, dict) or not all(isinstance(name, str) for name in arguments):
            raise ValueError(f"steps: arguments: expected a dictionary of names and values, got {shown(arguments)}")
        if callable(call):
            self.params["call"], self.function = name_of(call), call
        elif not isinstance(call, str) or not call:
            raise ValueError(f"steps: call: expected a function or the name of an entry point, got {shown(call)}")

    @property
    def is_passed(self) -> bool:
        """True if the function was passed in Python, False if it is an entry point."""
        return ":" in self.params["call"]

    def resolve(self, passed: dict[str, UserFunction]) -> None:
        """Set the function by name, `module:function`, from those passed in Python or the entry points."""
        call = self.params["call"]
        if self.function is None:
            self.function = passed.get(call) if self.is_passed else _registered(call)
        if self.function is None:
            remedy = f"Pass the function itself in Python, or register it as an entry point in the group {GROUP!r}"
            raise ValueError(f"steps: call: {shown(call)}: a file cannot name a Python function. {remedy}")

    def run(self, part: Part, plan: TilePlan, numbers: ExactSums | None) -> Part:
        self.resolve({})
        assert self.function is not None
        given = part.cloud.copy()
        given[ROW] = np.arange(len(given))
        cloud = self.function(given, **self.params["arguments"])
        if not isinstance(cloud, PointCloud) or ROW not in cloud.attributes:
            raise ValueError(f"{self.params['call']}: expected a PointCloud with some of its rows, got {shown(cloud)}")
        rows = np.asarray(cloud[ROW])
        cloud = cloud.copy()
        del cloud.attributes[ROW]
        left = part.take(rows, cloud)
        if not np.array_equal(part.cloud.points[rows], cloud.points):
            raise ValueError(f"{self.params['call']}: expected points at their positions, got moved points")
        return left


def resolve_functions(steps: Iterable[Step], passed: Iterable[UserFunction | str] = ()) -> list[UserFunction]:
    """Set the function of each `function` step. Returns the used ones that were passed in Python."""
    functions = [_imported(one) if isinstance(one, str) else one for one in passed]
    by_name = {name_of(function): function for function in functions}
    chosen = [step for step in steps if isinstance(step, Function)]
    for step in chosen:
        step.resolve(by_name)
    return [step.function for step in chosen if step.is_passed and step.function is not None]


def name_of(function: Any) -> str:
    """Import name of a function, `module:function`. ValueError if a worker cannot import it."""
    name = f"{getattr(function, '__module__', '')}:{getattr(function, '__qualname__', '')}"
    if name.count(":") != 1 or "<" in name or name.startswith("__main__:"):
        raise ValueError(f"steps: call: expected {_TOP_LEVEL}, got {shown(function)}")
    if _imported(name) is not function:
        raise ValueError(f"steps: call: expected {_TOP_LEVEL}, but {name!r} is another object than {shown(function)}")
    return name


def _imported(name: str) -> UserFunction:
    """Import a function by `module:function`. The name must come from the caller, never from a file."""
    module, _, path = name.partition(":")
    try:
        value: Any = importlib.import_module(module)
        for part in path.split("."):
            value = getattr(value, part)
    except (ImportError, AttributeError, ValueError) as error:
        raise ValueError(f"steps: call: {name!r} cannot be imported: {error}") from error
    return value


def _registered(name: str) -> UserFunction:
    known = entry_points(group=GROUP)
    matches = {point.value: point for point in known if point.name == name}
    if not matches:
        names = ", ".join(sorted(known.names)) or "none is installed"
        remedy = f"expected the name of an entry point in the group {GROUP!r} ({names}), or a function in Python"
        raise ValueError(f"steps: call: {remedy}, got {shown(name)}")
    if len(matches) > 1:
        raise ValueError(f"steps: call: several packages register {name!r}: {', '.join(sorted(matches))}; remove one")
    (point,) = matches.values()
    try:
        function = point.load()
    except (ImportError, AttributeError) as error:
        raise ValueError(f"steps: call: the entry point {name!r} ({point.value}) cannot be loaded: {error}") from error
    if not callable(function):
        raise ValueError(f"steps: call: the entry point {name!r} is {shown(function)}, expected a function")
    return function
