"""Validation of user input: shapes, types and ranges. Every message names the argument."""

from __future__ import annotations

import math
import operator
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..kernels.linear_algebra import det, matmul, norm
from .masked_arrays import unmasked
from .progress import ReportProgress
from .verbosity import LoggedProgress

MAX_SEED = 2**31 - 1
MAX_COUNT = 2**31 - 1  # device code counts in 32 bits
LARGEST_NUMBER = 1e100  # larger than any length in pixels or meters; products of three larger numbers overflow
RIGID_TOLERANCE = 0.02  # tolerance of R R^T - I: rotations of real data sets are rounded to a few digits
FEW_NUMBERS = 16  # numbers that Python checks faster than NumPy
CLEARLY_REGULAR = 1e-12  # determinant over the cubed norm: 1,500 times the limit of `matrix_rank`
SMALLEST_ENTRY = 1e-90  # of a clearly invertible matrix
MAX_SHOWN_CHARACTERS = 80  # of a quoted value
DLPACK_GPUS = (2, 13)  # kDLCUDA, kDLCUDAManaged


def shown(value: object) -> str:
    if isinstance(value, int) and value.bit_length() > 128:
        return f"an integer of {value.bit_length()} bits"
    text = repr(value)
    return text if len(text) <= MAX_SHOWN_CHARACTERS else text[: MAX_SHOWN_CHARACTERS - 3] + "..."


def is_on_gpu(values: object) -> bool:
    if isinstance(values, np.ndarray | list | tuple | int | float | type):
        return False
    where = getattr(values, "__dlpack_device__", None)
    if where is None:
        return hasattr(values, "__cuda_array_interface__")
    try:
        kind = where()[0]
    except (RuntimeError, TypeError, ValueError, BufferError):
        return False  # an array that cannot be shared: the reader explains why
    return int(getattr(kind, "value", kind)) in DLPACK_GPUS


def unreadable(values: object) -> str:
    """Why an array of torch, jax or Warp cannot be used, with a remedy. "" if there is no known reason."""
    kind, dtype, layout = type(values).__name__, getattr(values, "dtype", ""), str(getattr(values, "layout", ""))
    type_name = getattr(dtype, "__name__", str(dtype)).removeprefix("torch.")
    if getattr(values, "requires_grad", False) is True and hasattr(values, "detach"):
        return f"a {kind} that requires a gradient, which only pointloom.torch computes; pass tensor.detach()"
    if str(getattr(values, "device", "")) == "meta":
        return f"a {kind} on the device meta, which has a shape, but no numbers"
    if "sparse" in layout:
        return f"a sparse {kind}; pass tensor.to_dense()"
    if type_name.startswith(("qint", "quint")):
        return f"a quantized {kind} of {type_name}; pass tensor.dequantize()"
    if type_name.startswith("complex"):
        return type_name
    if type_name.startswith(("bfloat", "float8", "float4", "int4", "uint4", "int2", "uint2")):
        return f"{type_name}, which NumPy does not have; convert it to float32 or int32 first"
    if kind.endswith("Tracer") and type(values).__module__.startswith("jax"):
        return f"a {kind}, which has no numbers; call pointloom outside of jax.jit, jax.grad and jax.vmap"
    return ""


def check_rows(name: str, values: object, width: int, *, rows: int | None = None, dtype: object = None) -> NDArray[Any]:
    """Convert to a numeric array (n, width), copied only if needed. Raises `TypeError` or `ValueError`."""
    array = check_numeric(name, values)
    if array.ndim != 2 or array.shape[1] != width:
        if array.size or array.ndim > 2 or len(array):
            given = f"{list(array.shape)}{remedy_of_shape(array.shape, width)}"
            raise ValueError(f"{name}: expected shape [n, {width}], got {given}")
        array = array.reshape(0, width)
    if rows is not None and len(array) != rows:
        raise ValueError(
            f"{name}: expected shape [{rows}, {width}] as the cloud has {rows} points, got {list(array.shape)}"
        )
    return array if dtype is None else _cast(name, array, dtype)


def remedy_of_shape(shape: Sequence[int], width: int) -> str:
    """A hint how to reshape an array to rows of `width`, or ""."""
    if len(shape) == 2 and shape[0] == width:
        return "; pass its transpose: array.T"
    if len(shape) == 1 and shape[0] == width:
        return "; pass one row as [row]"
    if len(shape) == 1 and shape[0] % width == 0:
        return f"; array.reshape(-1, {width}) splits it into rows"
    if len(shape) == 2 and (shape[1], width) == (2, 3):
        return "; np.pad(array, ((0, 0), (0, 1))) adds z = 0"
    if len(shape) == 2 and shape[1] > width:
        return f"; array[:, :{width}] selects its first columns"
    return ""


def _cast(name: str, array: NDArray[Any], dtype: Any) -> NDArray[Any]:
    """Cast an array. Raises if a finite number becomes infinite."""
    with np.errstate(over="ignore", invalid="ignore"):  # infinity, and signaling NaN
        cast = array.astype(dtype, copy=False)
    if cast.dtype.itemsize < array.dtype.itemsize and array.dtype.kind == cast.dtype.kind == "f":
        lost = np.isinf(cast) & np.isfinite(array)
        if lost.any():
            raise ValueError(f"{name}: {array[lost][0]} is beyond the range of {cast.dtype}")
    return cast


def check_shape(name: str, values: object, shape: tuple[int, ...], *, dtype: Any = np.float64) -> NDArray[Any]:
    array = check_numeric(name, values)
    if array.shape != shape:
        remedy = "; append the row [0, 0, 0, 1]" if (shape, array.shape) == ((4, 4), (3, 4)) else ""
        raise ValueError(f"{name}: expected shape {list(shape)}, got {list(array.shape)}{remedy}")
    return array.astype(dtype, copy=False)


def check_finite(name: str, array: NDArray[Any]) -> NDArray[Any]:
    """Raise if a number is NaN, infinite or beyond 1e100."""
    if array.size <= FEW_NUMBERS and all(
        -LARGEST_NUMBER <= number <= LARGEST_NUMBER for number in array.ravel().tolist()
    ):
        return array
    if not np.isfinite(array).all():
        raise ValueError(f"{name}: expected finite numbers, got {shown(array.tolist())}")
    if not (np.abs(array) <= LARGEST_NUMBER).all():
        raise ValueError(f"{name}: expected numbers up to {LARGEST_NUMBER:g}, got {shown(array.tolist())}")
    return array


def check_direction(name: str, direction: object) -> NDArray[np.float64]:
    """A nonzero direction as a unit vector (3,)."""
    vector = check_finite(name, check_shape(name, direction, (3,)))
    if not vector.any():
        raise ValueError(f"{name}: expected a direction, got {vector.tolist()}")
    vector = vector / np.abs(vector).max()  # its square does not overflow
    return vector / norm(vector)


def check_color(name: str, color: object) -> NDArray[np.float64]:
    """Red, green and blue in 0..1."""
    has_four = len(color) == 4 if isinstance(color, list | tuple) else getattr(color, "shape", None) == (4,)
    if isinstance(color, str) or has_four:
        remedy = ", such as [1, 0, 0]" if isinstance(color, str) else ", without alpha"
        kind = TypeError if isinstance(color, str) else ValueError
        raise kind(f"{name}: expected red, green and blue in 0..1{remedy}, got {shown(color)}")
    rgb = check_shape(name, color, (3,))
    if not all(0 <= part <= 1 for part in rgb.tolist()):
        remedy = "; divide 8-bit colors by 255" if (rgb > 1).any() else ""
        raise ValueError(f"{name}: expected 0..1, got {rgb.tolist()}{remedy}")
    return rgb


def check_colors(name: str, colors: NDArray[Any]) -> NDArray[np.float32]:
    """Rows of RGB in 0..1. 8-bit colors are divided by 255."""
    if colors.dtype == np.uint8:
        return colors.astype(np.float32) / np.float32(255)
    if colors.size and not (colors.min() >= -1e-3 and colors.max() <= 1 + 1e-3):
        remedy = "; divide 8-bit colors by 255" if colors.max() > 1 else ""  # false for NaN
        raise ValueError(f"{name}: expected 0..1, got {colors.min()}..{colors.max()}{remedy}")
    return colors.astype(np.float32)


def check_numeric(name: str, values: object) -> NDArray[Any]:
    """Convert real numbers or booleans to a NumPy array. Masked floats become NaN.
    Raises `ValueError` for masked integers and `TypeError` for GPU memory, which is never copied to the host silently.
    """
    if type(values) is np.ndarray:
        array = values
    elif is_on_gpu(values):
        given = type(values).__name__
        raise TypeError(f"{name}: expected an array on the host, got a {given} on a GPU; download it first")
    else:
        plain = unmasked(name, values)
        try:
            array = np.asarray(plain)
        except (ValueError, TypeError, RuntimeError) as error:  # RuntimeError: a tensor that requires a gradient
            given = unreadable(values) or f"{type(values).__name__} ({error})"
            raise TypeError(f"{name}: expected numbers, got {given}") from error
    is_bfloat16 = array.dtype == np.uint16 and unreadable(values)  # Warp's, as its bits
    if array.dtype.kind not in "biuf" or array.dtype.isbuiltin == 2 or is_bfloat16:  # 2: float8 of jax
        kind = f"{type(values).__name__}{remedy_of_geometry(values)}"
        given = unreadable(values) or (kind if array.dtype == object else array.dtype)
        if names := array.dtype.names:
            given = f"fields {', '.join(names)}; pass numpy.lib.recfunctions.structured_to_unstructured({name}[[...]])"
        raise TypeError(f"{name}: expected real numbers, got {given}")
    return array


def remedy_of_geometry(values: object) -> str:
    """A hint which array of a mesh, or of another object with positions, to pass, or ""."""
    if hasattr(values, "sample_points_uniformly"):
        return "; pass mesh.vertices, or mesh.sample_points_uniformly(100_000).points"
    names = [name for name in ("points", "vertices") if hasattr(values, name)]
    return f"; pass its {names[0]}" if names else ""


def check_number(name: str, value: Any, *, allow_nan: bool = False, allow_infinite: bool = False) -> float:
    """A real number, finite by default. Booleans, strings and arrays raise `TypeError`."""
    if isinstance(value, bool | np.bool_ | str | bytes | bytearray) or getattr(value, "ndim", 0):
        raise TypeError(f"{name}: expected a number, got {shown(value)}")
    if getattr(getattr(value, "dtype", None), "kind", "") == "c":  # NumPy drops the imaginary part
        raise TypeError(f"{name}: expected a real number, got {shown(value)}")
    if getattr(value, "requires_grad", False) is True:  # torch warns, and drops the gradient
        raise TypeError(f"{name}: expected a number, got {unreadable(value) or shown(value)}")
    try:
        number = float(value)
    except (TypeError, ValueError, RuntimeError) as error:  # RuntimeError: a tensor on the device meta
        raise TypeError(f"{name}: expected a number, got {unreadable(value) or shown(value)}") from error
    except OverflowError as error:
        raise ValueError(f"{name}: expected a finite number in float64, got {shown(value)}") from error
    if (math.isnan(number) and not allow_nan) or (math.isinf(number) and not allow_infinite):
        raise ValueError(f"{name}: expected a finite number, got {shown(value)}")
    return number


def check_positive(
    name: str, value: object, *, allow_zero: bool = False, allow_infinite: bool = False, maximum: float = math.inf
) -> float:
    """A finite number > 0 and <= `maximum`. Zero or infinity if allowed."""
    if type(value) is float and 0 < value <= maximum and value < math.inf:
        return value
    number = check_number(name, value, allow_nan=True, allow_infinite=True)
    if not number >= 0 or (number == 0 and not allow_zero) or (math.isinf(number) and not allow_infinite):
        expected = f"{'a' if allow_infinite else 'a finite'} number {'>= 0' if allow_zero else '> 0'}"
        raise ValueError(f"{name}: expected {expected}, got {shown(value)}")
    if number > maximum:
        raise ValueError(f"{name}: expected a number up to {maximum:g}, got {shown(value)}")
    return number


def check_fraction(name: str, value: object) -> float:
    fraction = check_number(name, value, allow_nan=True, allow_infinite=True)
    if not 0 <= fraction <= 1:
        raise ValueError(f"{name}: expected a fraction from 0 to 1, got {shown(value)}")
    return fraction


def check_count(
    name: str, value: Any, *, minimum: int = 1, maximum: int = MAX_COUNT, because: str = "counts have 32 bits"
) -> int:
    """An integer from `minimum` to `maximum` (for the reason `because`). Booleans and 3.0 raise `TypeError`."""
    try:
        if isinstance(value, bool | np.bool_):
            raise TypeError
        number = operator.index(value)
    except (TypeError, RuntimeError) as error:  # RuntimeError: a tensor on the device meta
        is_integral = isinstance(value, float) and value.is_integer() and abs(value) <= maximum
        remedy = f"; pass {int(value)}" if is_integral else ""
        raise TypeError(f"{name}: expected an integer, got {unreadable(value) or shown(value)}{remedy}") from error
    if number < minimum:
        raise ValueError(f"{name}: expected an integer >= {minimum}, got {shown(value)}")
    if number > maximum:
        raise ValueError(f"{name}: expected an integer up to {maximum:,}, got {shown(value)}: {because}")
    return number


def check_indices(name: str, values: object, count: int, *, of: str, hint: str = "") -> NDArray[Any]:
    """Indices of `count` rows as a flat array (k,) from 0. Negative ones count from the end.
    `of` names the container and `hint` a remedy in the message of `TypeError` or `IndexError`."""
    rows = check_numeric(name, values).reshape(-1)
    if not rows.size:
        return rows.astype(np.int64)
    if rows.dtype.kind not in "iu":
        raise TypeError(f"{name}: expected integers, got {rows.dtype}{hint}")
    low, high = rows.min(), rows.max()
    if low < -count or high >= count:
        raise IndexError(f"{name}: {low}..{high} are out of range for a {of}")
    return rows if low >= 0 else np.where(rows < 0, rows.astype(np.int64) + count, rows)


def check_list(name: str, values: Any, of: str) -> list[Any]:
    if isinstance(values, str | bytes | dict):
        raise TypeError(f"{name}: expected a list of {of}, got {shown(values)}")
    try:
        return list(values)
    except TypeError as error:
        remedy = "; put it into a list" if hasattr(values, "points") or hasattr(values, "vertices") else ""
        raise TypeError(f"{name}: expected a list of {of}, got {type(values).__name__}{remedy}") from error


def check_textures(name: str, values: object) -> tuple[NDArray[np.uint8], ...]:
    """Texture images, uint8 (height, width, 3 or 4), read-only; copied unless immutable, duplicates are shared."""
    given = check_list(name, values, "images")
    taken: dict[int, NDArray[np.uint8]] = {}
    for number, value in enumerate(given):
        if id(value) in taken:
            continue
        image = check_numeric(f"{name}[{number}]", value)
        if image.dtype != np.uint8 or image.ndim != 3 or image.shape[2] not in (3, 4) or not image.size:
            raise ValueError(
                f"{name}[{number}]: expected uint8 [height, width, 3 or 4], got {image.dtype} {list(image.shape)}"
            )
        if type(image) is not np.ndarray or image.flags.writeable or not image.flags.owndata:
            image = np.array(image)
            image.flags.writeable = False
        taken[id(value)] = image
    return tuple(taken[id(value)] for value in given)


def check_name(name: str, value: object) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{name}: expected a string, got {type(value).__name__}")
    return value


def check_callback(name: str, value: object) -> Any:
    if value is not None and not callable(value):
        raise TypeError(f"{name}: expected a function or None, got {type(value).__name__}")
    return value


def check_progress(value: object) -> ReportProgress:
    """The progress callback. None gives one that logs long jobs."""
    return check_callback("progress", value) or LoggedProgress()


def check_search(radius: object, max_nn: object) -> tuple[float, int | None]:
    """Limits of a neighbor search: radius [m] (infinite if None) and count (None: all). Raises if both are None."""
    if radius is None and max_nn is None:
        raise ValueError("radius, max_nn: give at least one of them")
    search_radius = math.inf if radius is None else check_positive("radius", radius)
    return search_radius, None if max_nn is None else check_count("max_nn", max_nn)


def check_angle(name: str, value: object, *, allow_zero: bool = False) -> float:
    """An angle up to a full turn [rad]. Larger values are probably degrees and raise."""
    angle = check_positive(name, value, allow_zero=allow_zero)
    if angle > 2 * math.pi:
        raise ValueError(
            f"{name}: expected radians, up to 6.283, got {shown(value)}; convert degrees with np.radians({value:g})"
        )
    return angle


def check_seed(seed: object) -> int:
    """An integer from 0 to 2^31 - 1, for counter-based random numbers."""
    if isinstance(seed, int) and seed > MAX_SEED:
        raise ValueError(f"seed: expected an integer below 2^31, got {shown(seed)}")
    return check_count("seed", seed, minimum=0, maximum=MAX_SEED)


def check_rigid(name: str, matrix: object, *, tolerance: float = RIGID_TOLERANCE) -> NDArray[np.float64]:
    """A rigid 4x4 transformation in float64, its rotation within `tolerance` of orthonormal.
    The tolerance admits poses of real data sets, rounded to a few digits."""
    T = check_shape(name, matrix, (4, 4))
    if is_plainly_rigid(T.tolist(), tolerance):
        return T
    if not np.isfinite(T).all():
        raise ValueError(f"{name}: expected a rigid motion, got NaN or infinite entries")
    check_finite(name, T)
    if np.abs(T[3] - (0, 0, 0, 1)).max() > 1e-6:
        raise ValueError(f"{name}: expected a rigid motion with last row (0, 0, 0, 1), got {T[3].tolist()}")
    R = T[:3, :3]
    with np.errstate(over="ignore", invalid="ignore"):
        error, determinant = np.abs(matmul(R, R.T) - np.eye(3)).max(), det(R)
    if not error <= tolerance or determinant < 0:  # the comparison is false for NaN, the result of huge entries
        raise ValueError(
            f"{name}: expected a rigid motion, got a rotation part with R R^T - I up to {error:.3g} "
            f"and determinant {determinant:.3g}"
        )
    return T


def is_plainly_rigid(rows: list[list[float]], tolerance: float) -> bool:
    """True if a 4x4 matrix is clearly rigid, in a tenth of NumPy's time for so few numbers."""
    (a, b, c, x), (d, e, f, y), (g, h, i, z), last = rows
    lengths = max(abs(a * a + b * b + c * c - 1), abs(d * d + e * e + f * f - 1), abs(g * g + h * h + i * i - 1))
    products = max(abs(a * d + b * e + c * f), abs(a * g + b * h + c * i), abs(d * g + e * h + f * i))
    if not (lengths < tolerance / 2 and products < tolerance / 2 and last == [0, 0, 0, 1]):
        return False
    is_bounded = abs(x) <= LARGEST_NUMBER and abs(y) <= LARGEST_NUMBER and abs(z) <= LARGEST_NUMBER
    return is_bounded and a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g) > 0.5


def check_transformation(name: str, matrix: object) -> NDArray[np.float64]:
    if check_numeric(name, matrix).shape == (3, 3):
        raise ValueError(f"{name}: expected shape [4, 4], got [3, 3]; use rotate(R) for a rotation")
    T = check_shape(name, matrix, (4, 4))
    if _is_plainly_invertible(T.tolist()):
        return T
    if not np.isfinite(T).all() or np.abs(T[3] - (0, 0, 0, 1)).max() > 1e-9:
        is_transposed = np.abs(T[:, 3] - (0, 0, 0, 1)).max() <= 1e-9
        remedy = "; pass its transpose: T.T" if is_transposed else ""
        raise ValueError(
            f"{name}: expected a finite affine 4x4 matrix with last row (0, 0, 0, 1), got {T.tolist()}{remedy}"
        )
    check_finite(name, T)
    if np.linalg.matrix_rank(T[:3, :3]) < 3:
        raise ValueError(f"{name}: expected an invertible matrix, got {T.tolist()}")
    return T


def _is_plainly_invertible(rows: list[list[float]]) -> bool:
    """True if a 4x4 matrix is clearly finite, affine and invertible, in a tenth of NumPy's time."""
    (a, b, c, _), (d, e, f, _), (g, h, i, _), last = rows
    if last != [0, 0, 0, 1] or not all(abs(number) <= LARGEST_NUMBER for number in (*rows[0], *rows[1], *rows[2])):
        return False
    largest = max(map(abs, (a, b, c, d, e, f, g, h, i)))
    determinant = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    # The norm is at most three times the largest entry. Cubes of smaller entries would underflow.
    return largest > SMALLEST_ENTRY and abs(determinant) > CLEARLY_REGULAR * (3 * largest) ** 3
