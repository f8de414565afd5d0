"""A user's own function."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from typing import Any, ClassVar

import numpy as np

from ...core.checks import check_positive, shown
from ...pcd.cloud import PointCloud
from ..exact_sums import ExactSums
from .step import Part, Step

ROW = "pointloom_row"  # the attribute by which a step that drops points tells which are left


class Function(Step):
    """A function of a module, with its reach: it takes a cloud and gives one, of the same rows or fewer.

    It must be a pure function of the points within its reach. It may change attributes and drop points, not move or
    add any.
    """

    name, required = "function", ("call", "reach")
    defaults: ClassVar[dict[str, Any]] = {"arguments": {}}

    def check(self) -> None:
        """Set reach and neighbours by the parameters."""
        self.reach = check_positive("reach", self.params["reach"], allow_zero=True)
        call = self.params["call"]
        if callable(call):
            call = f"{getattr(call, '__module__', '')}:{getattr(call, '__qualname__', '')}"
        if not isinstance(call, str) or call.count(":") != 1 or "<" in call or call.startswith("__main__:"):
            remedy = "a function at the top of a module that workers can import, as 'module:function'"
            raise ValueError(f"steps: call: expected {remedy}, got {shown(self.params['call'])}")
        self.params["call"] = call
        self.function()

    def function(self) -> Callable[..., Any]:
        """The function itself."""
        module, _, path = self.params["call"].partition(":")
        try:
            found: Any = importlib.import_module(module)
            for name in path.split("."):
                found = getattr(found, name)
        except (ImportError, AttributeError) as error:
            raise ValueError(f"steps: call: {self.params['call']!r} cannot be imported: {error}") from error
        return found

    def run(self, part: Part, plan: Any, numbers: ExactSums | None) -> Part:
        """The step on a part."""
        given = part.cloud.copy()
        given[ROW] = np.arange(len(given))
        cloud = self.function()(given, **self.params["arguments"])
        if not isinstance(cloud, PointCloud) or ROW not in cloud.attributes:
            raise ValueError(f"{self.params['call']}: expected a PointCloud of some of its rows, got {shown(cloud)}")
        rows = np.asarray(cloud[ROW])
        cloud = cloud.copy()
        del cloud.attributes[ROW]
        left = part.take(rows, cloud)
        if not np.array_equal(part.cloud.points[rows], cloud.points):
            raise ValueError(f"{self.params['call']}: moved points, which a step of a function may not")
        return left
