"""Search parameters and their pointloom keywords."""

from __future__ import annotations

import enum
from typing import Any

from ...core.attribute_hints import HintedNames


class SearchType(enum.IntEnum):
    """Return values of `get_search_type`."""

    KNNSearch, RadiusSearch, HybridSearch = range(3)


class KDTreeSearchParam(HintedNames):
    """Base class: search by number, by radius, or by both."""

    _internal = ("native_keywords",)

    Type = SearchType
    _fields: tuple[str, ...] = ()
    _type = SearchType.KNNSearch

    def get_search_type(self) -> SearchType:
        return self._type

    def native_keywords(self) -> dict[str, Any]:
        """`radius` and `max_nn` of pointloom."""
        raise NotImplementedError

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={getattr(self, name)!r}' for name in self._fields)})"


class KDTreeSearchParamKNN(KDTreeSearchParam):
    """The nearest `knn`: pointloom's `max_nn=knn`."""

    _fields = ("knn",)

    def __init__(self, knn: int = 30):
        self.knn = knn

    def native_keywords(self) -> dict[str, Any]:
        return {"radius": None, "max_nn": self.knn}


class KDTreeSearchParamRadius(KDTreeSearchParam):
    """All within a radius: pointloom's `radius=radius, max_nn=None`."""

    _fields, _type = ("radius",), SearchType.RadiusSearch

    def __init__(self, radius: float):
        self.radius = radius

    def native_keywords(self) -> dict[str, Any]:
        return {"radius": self.radius, "max_nn": None}


class KDTreeSearchParamHybrid(KDTreeSearchParam):
    """The nearest `max_nn` within a radius: pointloom's `radius=radius, max_nn=max_nn`."""

    _fields, _type = ("radius", "max_nn"), SearchType.HybridSearch

    def __init__(self, radius: float, max_nn: int):
        self.radius, self.max_nn = radius, max_nn

    def native_keywords(self) -> dict[str, Any]:
        return {"radius": self.radius, "max_nn": self.max_nn}


def keywords_of(search_param: object) -> dict[str, Any]:
    """`radius` and `max_nn` of a search parameter. Raises TypeError."""
    if not isinstance(search_param, KDTreeSearchParam):
        raise TypeError(
            f"search_param: expected a KDTreeSearchParam, got {type(search_param).__name__}; "
            "o3d.geometry.KDTreeSearchParamHybrid(radius=0.1, max_nn=30) is one"
        )
    return search_param.native_keywords()
