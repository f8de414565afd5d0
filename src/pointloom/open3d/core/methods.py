"""The methods of tensors that are built from tables: arithmetic, comparisons, reductions and linear algebra."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import elementwise, linalg
from .errors import TensorError, as_tensor_error
from .size_vector import SizeVector


def _binary(name: str, *, reflected: bool = False, in_place: bool = False, as_operator: bool = False) -> Any:
    """A method over `elementwise.BINARY[name]`."""

    @as_tensor_error
    def method(self: Any, other: Any) -> Any:
        operand = self._operand(name, other)
        if operand is NotImplemented:
            if as_operator:
                return operand
            raise TensorError(f"other: expected a tensor, a number or an array, got {type(other).__name__}")
        elementwise.check_kind(name, elementwise.BINARY[name][1], self._numpy_dtype.kind, self.dtype)
        result = self._combined(name, *((operand, self) if reflected else (self, operand)))
        return self._written(result) if in_place else result

    return method


def _unary(name: str, *, in_place: bool = False) -> Any:
    """A method over `elementwise.UNARY[name]`."""

    def method(self: Any) -> Any:
        elementwise.check_kind(name, elementwise.UNARY[name][1], self._numpy_dtype.kind, self.dtype)
        result = self._on_device("unary", name, self._array, self._shape)
        result = self._like(elementwise.unary(name, self._values)) if result is None else result
        return self._written(result) if in_place else result

    return method


def _reduction(name: str) -> Any:
    """A method over `elementwise.REDUCTIONS[name]`."""

    @as_tensor_error
    def method(self: Any, dim: Any = None, keepdim: bool = False) -> Any:
        elementwise.check_kind(name, elementwise.REDUCTIONS[name][1], self._numpy_dtype.kind, self.dtype)
        axes = range(self.ndim) if dim is None else SizeVector(dim)
        result = self._on_device("reduced", name, self._array, self._shape, axes, keepdim)
        return self._like(elementwise.reduced(name, self._values, axes, keepdim)) if result is None else result

    return method


def on_host(function: Any) -> Any:
    """A method over a function of NumPy arrays. On a GPU it copies to the host and back."""

    @as_tensor_error
    def method(self: Any, *args: Any, **keywords: Any) -> Any:
        def values(part: Any) -> Any:
            return self._checked(part)._values if isinstance(part, type(self)) else part

        result = function(self._values, *map(values, args), **{name: values(part) for name, part in keywords.items()})
        if isinstance(result, tuple):
            return tuple(map(self._like, result))
        return self._like(result) if isinstance(result, np.ndarray | np.generic) else result

    method.__doc__ = function.__doc__
    return method


def add_methods(tensor: Any) -> None:
    """Set the methods of the tables, their in-place forms and the operators."""
    for name in (*elementwise.BINARY, *elementwise.UNARY):
        make = _binary if name in elementwise.BINARY else _unary
        setattr(tensor, name, make(name))
        setattr(tensor, f"{name}_", make(name, in_place=True))
    for name in elementwise.REDUCTIONS:
        setattr(tensor, name, _reduction(name))
    operators = {name: f"__{name}__" for name in ("add", "sub", "mul", *elementwise.COMPARISONS)}
    spelled = {"truediv": "div", "floordiv": "div", "and": "logical_and", "or": "logical_or", "xor": "logical_xor"}
    for operator, name in ({n: n for n in operators} | spelled).items():
        setattr(tensor, f"__{operator}__", _binary(name, as_operator=True))
        if name not in elementwise.COMPARISONS:
            setattr(tensor, f"__r{operator}__", _binary(name, reflected=True, as_operator=True))
            setattr(tensor, f"__i{operator}__", _binary(name, in_place=True, as_operator=True))
    for name in ("matmul", "det", "inv", "solve", "lstsq", "svd", "lu", "lu_ipiv", "triu", "tril", "triul", "cross"):
        setattr(tensor, name, on_host(getattr(linalg, name)))
    tensor.__matmul__ = tensor.matmul
    tensor.__neg__ = tensor.neg
