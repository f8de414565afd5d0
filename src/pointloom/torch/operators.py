"""Custom operators of torch over kernels: tensors as device arrays, and two operators from which gradients are built.

`gather_rows` and `scatter_sum` are each other's gradients, so formulas made of them and of torch's own operations have
derivatives of every order. Neither uses float atomics: results are bitwise identical in each run.
"""

import functools
from collections.abc import Callable
from typing import Any

import torch
import warp as wp

from ..core.array_libraries import hand_out, view_as
from ..core.devices import resolve_device
from ..core.exchange import share
from ..kernels.arrays.scattered_sums import sum_by_index
from ..kernels.lang import float32, float64, int32, int64
from ..kernels.memory import upload

NAMESPACE = "pointloom"
HALF_TYPES = (torch.float16, torch.bfloat16)
ELEMENTS = {torch.float32: float32, torch.float64: float64, torch.int32: int32, torch.int64: int64}


Tensors = tuple[torch.Tensor | None, ...]


class Operator:
    """The operator `pointloom::<name>` of torch from a function of tensors and numbers, which changes no argument.

    It runs without gradients. Give it a fake implementation (`register_fake`), so that graphs of `torch.compile`
    include it, and a formula (`register_autograd`), or `refuse_gradients`. `register_tangents` takes the forward-mode
    formula: a function of the arguments, their tangents and the result, which returns the tangents of the result, None
    for integers. Without it, an argument with a tangent raises. Graphs contain the operator. Outside of them
    `torch.func` needs a `torch.autograd.Function`, which has the same formulas.
    """

    def __init__(self, function: Callable[..., Any]) -> None:
        self.name = f"{NAMESPACE}::{function.__name__}"
        self.made = torch.library.custom_op(self.name, function, mutates_args=())
        self.register_fake = self.made.register_fake
        self._backward: Any = None
        self._save: Any = None
        self._tangents: Any = None
        self._vmap: Any = None
        self._function = _function_of(self)

    def register_autograd(
        self, backward: Callable[..., Any], *, setup_context: Callable[..., None] | None = None
    ) -> None:
        self.made.register_autograd(backward, setup_context=setup_context)
        self._backward, self._save = backward, setup_context

    def register_vmap(self, rule: Callable[..., Any]) -> None:
        self.made.register_vmap(rule)
        self._vmap = rule

    def register_tangents(self, formula: Callable[..., Any]) -> None:
        self._tangents = formula

    def __call__(self, *given: Any) -> Any:
        if torch.compiler.is_compiling():
            return self.made(*given)
        return self._function.apply(*given)


def _function_of(operator: Operator) -> type[torch.autograd.Function]:
    class Function(torch.autograd.Function):
        generate_vmap_rule = False

        @staticmethod
        def forward(*given: Any) -> Any:
            return operator.made(*given)

        @staticmethod
        def setup_context(ctx: Any, inputs: tuple, output: Any) -> None:
            if operator._save is not None:
                operator._save(ctx, inputs, output)
            results = output if isinstance(output, tuple) else (output,)
            ctx.mark_non_differentiable(*(each for each in results if not each.is_floating_point()))
            ctx.numbers = [None if isinstance(value, torch.Tensor) else value for value in inputs]
            ctx.save_for_forward(*(value for value in (*inputs, *results) if isinstance(value, torch.Tensor)))

        @staticmethod
        def backward(ctx: Any, *grads: Any) -> Any:
            return operator._backward(ctx, *grads)

        @staticmethod
        def jvp(ctx: Any, *tangents: Any) -> Any:
            if operator._tangents is None:
                raise NotImplementedError(
                    f"{operator.name} has no forward-mode derivative. Use reverse mode (backward, torch.func.grad or "
                    "jacrev), or detach its arguments"
                )
            saved = iter(ctx.saved_tensors)
            values = [next(saved) if number is None else number for number in ctx.numbers]
            results = list(saved)
            return operator._tangents(values, tangents, tuple(results) if len(results) > 1 else results[0])

        @staticmethod
        def vmap(info: Any, in_dims: tuple, *given: Any) -> Any:
            rule = operator._vmap or functools.partial(_one_by_one, operator)
            return rule(info, in_dims, *given)

    return Function


def _one_by_one(operator: Operator, info: Any, in_dims: tuple, *given: Any) -> tuple[Any, Any]:
    """The batches of `torch.vmap` one after the other."""
    moved = unbatched(info.batch_size, in_dims, given)
    results: list[Any] = [
        operator(*(value[k] if isinstance(value, torch.Tensor) else value for value in moved))
        for k in range(info.batch_size)
    ]
    if isinstance(results[0], torch.Tensor):
        return torch.stack(results), 0
    return tuple(torch.stack(parts) for parts in zip(*results, strict=True)), (0,) * len(results[0])


def device_array(tensor: torch.Tensor, dtype: type | None = None) -> wp.array:
    """A tensor as a device array. Shares its memory if it is contiguous. On CUDA it is ordered after torch's current
    stream, without a wait of the host. `dtype`: the type of elements, such as vec3 for float32 (n, 3).
    """
    tensor = tensor.detach().contiguous()
    scalar = ELEMENTS[tensor.dtype]
    dtype = dtype or scalar
    if tensor.device.type == "cpu":
        return upload(tensor.numpy(), dtype, resolve_device("cpu"), copied=False)
    array = share("tensor", tensor)
    width = len(getattr(dtype, "_shape_", ()))
    return array if dtype == scalar else view_as(array, dtype, tuple(tensor.shape[: tensor.ndim - width]))


def tensor_of(array: wp.array) -> torch.Tensor:
    """A device array that has no other owner as a tensor over its memory. On CUDA torch's stream waits for it."""
    return hand_out(array, "torch")


def computed(tensor: torch.Tensor) -> torch.Tensor:
    """The tensor in the type of the computation: float16 and bfloat16 as float32."""
    return tensor.float() if tensor.dtype in HALF_TYPES else tensor


def check_device(name: str, tensor: torch.Tensor, like: torch.Tensor | None = None) -> None:
    if tensor.device.type not in ("cpu", "cuda"):
        raise ValueError(f"{name}: expected a tensor on the CPU or on a CUDA device, got {tensor.device}")
    if like is not None and tensor.device != like.device:
        raise ValueError(f"{name}: expected a tensor on {like.device}, as the points, got one on {tensor.device}")


def check_tensor(name: str, value: object) -> None:
    if not isinstance(value, torch.Tensor):
        raise TypeError(f"{name}: expected a torch tensor, got {type(value).__name__}. Convert it by torch.as_tensor")


def check_floats(name: str, tensor: torch.Tensor) -> None:
    check_tensor(name, tensor)
    if tensor.dtype not in (torch.float32, torch.float64, *HALF_TYPES):
        raise TypeError(f"{name}: expected float32, float64, float16 or bfloat16, got {tensor.dtype}")


def check_integers(name: str, tensor: torch.Tensor) -> None:
    check_tensor(name, tensor)
    if tensor.dtype not in (torch.int32, torch.int64, torch.int16, torch.int8, torch.uint8):
        raise TypeError(f"{name}: expected integers, got {tensor.dtype}")


def refuse_gradients(made, what: str) -> None:
    """Let the gradient of an operator raise, for functions that have none."""

    def backward(ctx, *grads):
        raise RuntimeError(f"{what} has no derivative. Detach its arguments, or its result")

    made.register_autograd(backward)


@Operator
def gather_rows(values: torch.Tensor, index: torch.Tensor) -> torch.Tensor:
    """Rows `index`, int64 (n), of values (r, c): (n, c). Rows outside 0 .. r - 1 are 0."""
    rows = values.shape[0]
    if not rows:
        return values.new_zeros((index.shape[0], values.shape[1]))
    gathered = values.index_select(0, index.clamp(0, rows - 1))
    return gathered.masked_fill_(((index < 0) | (index >= rows))[:, None], 0)


@gather_rows.register_fake
def _(values: torch.Tensor, index: torch.Tensor) -> torch.Tensor:
    return values.new_empty((index.shape[0], values.shape[1]))


@Operator
def scatter_sum(values: torch.Tensor, index: torch.Tensor, rows: int) -> torch.Tensor:
    """Sums (rows, c) of the rows of values (n, c), float32 or float64, with each index, int64 (n). Others, such as -1,
    are skipped. Added up in float64.
    """
    return tensor_of(sum_by_index(device_array(values), device_array(index), rows))


@scatter_sum.register_fake
def _(values: torch.Tensor, index: torch.Tensor, rows: int) -> torch.Tensor:
    return values.new_empty((rows, values.shape[1]))


def _save_gather(ctx, inputs, output) -> None:
    values, index = inputs
    ctx.save_for_backward(index)
    ctx.rows = values.shape[0]


def _save_scatter(ctx, inputs, output) -> None:
    ctx.save_for_backward(inputs[1])


gather_rows.register_autograd(
    lambda ctx, grad: (scatter_sum(grad, ctx.saved_tensors[0], ctx.rows), None), setup_context=_save_gather
)
scatter_sum.register_autograd(
    lambda ctx, grad: (gather_rows(grad, ctx.saved_tensors[0]), None, None), setup_context=_save_scatter
)
gather_rows.register_tangents(lambda values, tangents, _: gather_rows(tangents[0], values[1]))  # both are linear
scatter_sum.register_tangents(lambda values, tangents, _: scatter_sum(tangents[0], *values[1:]))


def unbatched(size: int, in_dims: tuple[int | None, ...], given: tuple) -> list:
    """The arguments of an operator under `torch.vmap`, each tensor with the axis of the batches first."""
    moved = []
    for value, axis in zip(given, in_dims, strict=True):
        if not isinstance(value, torch.Tensor):
            moved.append(value)
        else:
            moved.append(value.expand(size, *value.shape) if axis is None else value.movedim(axis, 0))
    return moved


@gather_rows.register_vmap
def _(info, in_dims, *given):
    values, index = unbatched(info.batch_size, in_dims, given)
    size, rows, columns = values.shape
    shifts = torch.arange(size, device=index.device)[:, None] * rows
    flat = torch.where((index < 0) | (index >= rows), -1, index + shifts).reshape(-1)
    return gather_rows(values.reshape(-1, columns), flat).reshape(size, -1, columns), 0


@scatter_sum.register_vmap
def _(info, in_dims, *given):
    values, index, rows = unbatched(info.batch_size, in_dims, given)
    size, _, columns = values.shape
    shifts = torch.arange(size, device=index.device)[:, None] * rows
    flat = torch.where((index < 0) | (index >= rows), -1, index + shifts).reshape(-1)
    return scatter_sum(values.reshape(-1, columns), flat, size * rows).reshape(size, rows, columns), 0


def checks_values(tensor: torch.Tensor) -> bool:
    """True if checks may read values: not on a GPU, where the host would wait, nor while torch traces."""
    return tensor.device.type == "cpu" and not torch.compiler.is_compiling()
