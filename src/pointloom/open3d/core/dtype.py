"""Data types of tensors."""

from __future__ import annotations

import builtins
import enum
from typing import Any, ClassVar

import numpy as np
from numpy.typing import DTypeLike

from .errors import TensorError


class DtypeCode(enum.Enum):
    Undefined, Bool, Int, UInt, Float, Object = range(6)


_CODES = {"b": DtypeCode.Bool, "i": DtypeCode.Int, "u": DtypeCode.UInt, "f": DtypeCode.Float}


class Dtype:
    """A data type. Compares equal by name; `Dtype.from_numpy` and `numpy` convert."""

    DtypeCode: ClassVar[type[DtypeCode]] = DtypeCode
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
        self.name = name

    @classmethod
    def from_numpy(cls, dtype: DTypeLike) -> Dtype:
        """The `Dtype` of a NumPy type."""
        name = np.dtype(dtype).name
        if name not in _BY_NAME:
            raise TensorError(f"dtype: expected one of {', '.join(_BY_NAME)}, got {name}")
        return _BY_NAME[name]

    @property
    def numpy(self) -> np.dtype[Any]:
        if self.name == "undefined":
            raise TensorError("dtype: expected a type of numbers, got Undefined")
        return np.dtype(self.name)

    def byte_size(self) -> int:
        return 0 if self.name == "undefined" else self.numpy.itemsize

    def byte_code(self) -> DtypeCode:
        return DtypeCode.Undefined if self.name == "undefined" else _CODES[self.numpy.kind]

    def __eq__(self, other: object) -> builtins.bool:
        return isinstance(other, Dtype) and self.name == other.name

    def __hash__(self) -> int:
        return hash(self.name)

    def __repr__(self) -> str:
        return self.name.capitalize().replace("Uint", "UInt")


_BY_NAME = {
    name: Dtype(name)
    for name in ("float32", "float64", *(f"{kind}{bits}" for kind in ("int", "uint") for bits in (8, 16, 32, 64)))
} | {"bool": Dtype("bool")}
float32, float64, int8, int16, int32, int64, uint8, uint16, uint32, uint64, bool8 = _BY_NAME.values()
undefined = Dtype("undefined")
bool = bool8
for _dtype in (*_BY_NAME.values(), undefined):
    setattr(Dtype, repr(_dtype), _dtype)
