"""A callable truth value: `cloud.has_normals` and, as in Open3D, `cloud.has_normals()`."""

from __future__ import annotations


class CallableBool(int):
    """1 or 0, printed as True or False. Calling it returns the bool."""

    def __new__(cls, value: object) -> CallableBool:
        return super().__new__(cls, bool(value))

    def __call__(self) -> bool:
        return bool(self)

    def __repr__(self) -> str:
        return repr(bool(self))

    __str__ = __repr__
