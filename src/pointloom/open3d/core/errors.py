"""The error of tensors."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any

from ...core.errors import DeviceError
from ...core.escaped_text import escaped


class TensorError(RuntimeError, ValueError, IndexError, TypeError):
    """A wrong argument of a tensor: a RuntimeError, as in Open3D, and also the class that NumPy raises."""

    def __init__(self, message: object = ""):
        super().__init__(escaped(message, lines=True))


def as_tensor_error(function: Callable[..., Any]) -> Any:
    """Raise NumPy's errors as `TensorError`."""

    @wraps(function)
    def checked(*args: Any, **keywords: Any) -> Any:
        try:
            return function(*args, **keywords)
        except (TensorError, DeviceError):
            raise
        except (ValueError, IndexError) as error:
            raise TensorError(str(error)) from error

    return checked
