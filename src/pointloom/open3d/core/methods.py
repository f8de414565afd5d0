"""Methods of tensors from tables: arithmetic, comparisons, reductions and linear algebra. `methods.pyi` lists them."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from . import elementwise, linalg
from .errors import TensorError, as_tensor_error
from .size_vector import SizeVector

if TYPE_CHECKING:
    from .tensor import Tensor

Method = Callable[..., Any]


class TensorMethods:
    """Base class of `Tensor` with the methods of the tables, their in-place forms and the operators."""


def _binary(name: str, *, reflected: bool = False, in_place: bool = False, as_operator: bool = False) -> Method:
    """A method over `elementwise.BINARY[name]`."""

    @as_tensor_error
    def method(self: Tensor, other: object) -> Any:
        operand = self._operand(name, other)
        if operand is NotImplemented:
            if as_operator:
                return operand
            raise TensorError(f"other: expected a tensor, a number or an array, got {type(other).__name__}")
        elementwise.check_kind(name, elementwise.BINARY[name][1], self.dtype)
        result = self._combined(name, *((operand, self) if reflected else (self, operand)))
        return self._written(result) if in_place else result

    return method


def _unary(name: str, *, in_place: bool = False) -> Method:
    """A method over `elementwise.UNARY[name]`."""

    def method(self: Tensor) -> Tensor:
        elementwise.check_kind(name, elementwise.UNARY[name][1], self.dtype)
        result = self._on_device("unary", name, self.array, self._shape)
        result = self._like(elementwise.unary(name, self.numpy())) if result is None else result
        return self._written(result) if in_place else result

    return method


def _reduction(name: str) -> Method:
    """A method over `elementwise.REDUCTIONS[name]`."""

    @as_tensor_error
    def method(self: Tensor, dim: int | SizeVector | None = None, keepdim: bool = False) -> Tensor:
        elementwise.check_kind(name, elementwise.REDUCTIONS[name][1], self.dtype)
        axes = range(self.ndim) if dim is None else SizeVector(dim)
        result = self._on_device("reduced", name, self.array, self._shape, axes, keepdim)
        return self._like(elementwise.reduced(name, self.numpy(), axes, keepdim)) if result is None else result

    return method


def on_host(function: Method) -> Method:
    """A method over a function of NumPy arrays. On a GPU it copies to the host and back."""

    @as_tensor_error
    def method(self: Tensor, *args: Any, **keywords: Any) -> Any:
        def values(part: object) -> object:
            return self._checked(part).numpy() if isinstance(part, type(self)) else part

        result = function(self.numpy(), *map(values, args), **{name: values(part) for name, part in keywords.items()})
        if isinstance(result, tuple):
            return tuple(map(self._like, result))
        return self._like(result) if isinstance(result, np.ndarray | np.generic) else result

    method.__doc__ = function.__doc__
    return method


for _name in elementwise.BINARY:
    setattr(TensorMethods, _name, _binary(_name))
    setattr(TensorMethods, f"{_name}_", _binary(_name, in_place=True))
for _name in elementwise.UNARY:
    setattr(TensorMethods, _name, _unary(_name))
    setattr(TensorMethods, f"{_name}_", _unary(_name, in_place=True))
for _name in elementwise.REDUCTIONS:
    setattr(TensorMethods, _name, _reduction(_name))
for _name in elementwise.COMPARISONS:
    setattr(TensorMethods, f"__{_name}__", _binary(_name, as_operator=True))
for _operator, _name in elementwise.OPERATORS.items():
    setattr(TensorMethods, f"__{_operator}__", _binary(_name, as_operator=True))
    setattr(TensorMethods, f"__r{_operator}__", _binary(_name, reflected=True, as_operator=True))
    setattr(TensorMethods, f"__i{_operator}__", _binary(_name, in_place=True, as_operator=True))
for _name in ("matmul", "det", "inv", "solve", "lstsq", "svd"):
    setattr(TensorMethods, _name, on_host(getattr(linalg, _name)))
for _operator in ("matmul", "neg"):
    setattr(TensorMethods, f"__{_operator}__", getattr(TensorMethods, _operator))
