"""Data types of tensors."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np
from numpy.typing import DTypeLike


class Dtype:
    """A data type. Compares equal by name; `Dtype.from_numpy` and `numpy` convert."""

    Float32: ClassVar[Dtype]
    Float64: ClassVar[Dtype]
    Int8: ClassVar[Dtype]
    Int16: ClassVar[Dtype]
    Int32: ClassVar[Dtype]
    Int64: ClassVar[Dtype]
    UInt8: ClassVar[Dtype]
    UInt16: ClassVar[Dtype]
    UInt32: ClassVar[Dtype]
    UInt64: ClassVar[Dtype]
    Bool: ClassVar[Dtype]
    Undefined: ClassVar[Dtype]

    def __init__(self, name: str):
        self._name = name

    @classmethod
    def from_numpy(cls, dtype: DTypeLike) -> Dtype:
        """The `Dtype` of a NumPy type."""
        name = np.dtype(dtype).name
        if name not in _BY_NAME:
            raise TypeError(f"dtype: expected one of {', '.join(_BY_NAME)}, got {name}")
        return _BY_NAME[name]

    @property
    def numpy(self) -> np.dtype[Any]:
        return np.dtype(self._name)

    def byte_size(self) -> int:
        return self.numpy.itemsize

    def byte_code(self) -> int:
        raise NotImplementedError

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Dtype) and self._name == other._name

    def __hash__(self) -> int:
        return hash(self._name)

    def __repr__(self) -> str:
        return self._name.capitalize().replace("Uint", "UInt")


bool8, float32, float64, int8, int16, int32, int64, uint8, uint16, uint32, uint64, undefined = (
    Dtype(name)
    for name in ("bool", "float32", "float64", "int8", "int16", "int32", "int64", "uint8", "uint16", "uint32", "uint64",
                 "undefined")
)  # fmt: skip
_BY_NAME = {dtype._name: dtype for dtype in (bool8, float32, float64, int8, int16, int32, int64, uint8, uint16, uint32,
                                             uint64)}  # fmt: skip
for _dtype in (*_BY_NAME.values(), undefined):
    setattr(Dtype, repr(_dtype), _dtype)
