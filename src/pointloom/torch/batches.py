"""Batches of clouds in one layout for the kernels, from the layouts that torch's libraries use.

- Dense: points (B, N, D), with `lengths` (B) if clouds have fewer than N points, as in PyTorch3D.
- Ragged: points (M, D) with `batch` (M), the cloud of each row in ascending order, as in torch_geometric, or with
  `offsets` (B + 1), the first row of each cloud and M, as in the jagged tensors of fVDB.
- A single cloud: points (N, D).
"""

from typing import NamedTuple, TypeAlias

import torch

from ..core.checks import MAX_COUNT, check_count
from .operators import check_device, check_floats, check_integers, check_tensor, checks_values, computed

Pair: TypeAlias = torch.Tensor | tuple[torch.Tensor | None, torch.Tensor | None] | None  # one tensor for both, or two


class Batch(NamedTuple):
    """Clouds as rows.

    Attributes:
        points: float32 or float64 (M, D), contiguous.
        labels: The cloud of each row, int64 (M), `count` for rows of no cloud. None if each has `width` rows.
        count: Number of clouds.
        width: Rows of each cloud in a dense batch and of a single cloud. 0 if ragged.
        shape: Leading axes of the argument: (B, N), (M,) or (N,).
    """

    points: torch.Tensor
    labels: torch.Tensor | None
    count: int  # pyright: ignore[reportIncompatibleMethodOverride]
    width: int
    shape: tuple[int, ...]

    def row_labels(self) -> torch.Tensor:
        """The cloud of each row, int64 (M)."""
        if self.labels is not None:
            return self.labels
        rows = torch.arange(self.points.shape[0], device=self.points.device)
        return torch.div(rows, max(self.width, 1), rounding_mode="floor")

    def is_point(self) -> torch.Tensor:
        """False at padding rows, in the shape of the leading axes."""
        if self.labels is None:
            return torch.ones(self.shape, dtype=torch.bool, device=self.points.device)
        return (self.labels < self.count).reshape(self.shape)

    def starts(self) -> torch.Tensor:
        """First row of each cloud, int32 (count)."""
        clouds = torch.arange(self.count, device=self.points.device, dtype=torch.int32)
        if self.width or self.labels is None:
            return clouds * self.width
        return torch.searchsorted(self.labels, clouds.long(), out_int32=True)

    def sizes(self) -> torch.Tensor:
        """Points of each cloud, int32 (count)."""
        device = self.points.device
        if self.labels is None:
            return torch.full((self.count,), self.width, device=device, dtype=torch.int32)
        if self.width:
            return (self.labels.reshape(self.count, self.width) < self.count).sum(1, dtype=torch.int32)
        clouds = torch.arange(self.count, device=device)
        return torch.searchsorted(self.labels, clouds, right=True, out_int32=True) - self.starts()

    def is_same_layout(self, other: "Batch") -> bool:
        """True if the clouds of another batch are known to have the same rows."""
        is_dense = self.labels is None and other.labels is None
        return (is_dense and self.shape == other.shape) or (self.labels is not None and self.labels is other.labels)


def take_batch(
    name: str,
    points: torch.Tensor,
    *,
    lengths: torch.Tensor | None = None,
    batch: torch.Tensor | None = None,
    offsets: torch.Tensor | None = None,
    batch_size: int | None = None,
    width: int | None = 3,
) -> Batch:
    """Points in one of the layouts as rows. `width`: the expected D. If None, any.

    Raises:
        TypeError: Points that are not floating point, or other arguments of a wrong type.
        ValueError: Wrong shapes, two layouts at once, or lengths, clouds or offsets out of range (checked on the CPU).
    """
    check_floats(name, points)
    check_device(name, points)
    given = [key for key, value in (("lengths", lengths), ("batch", batch), ("offsets", offsets)) if value is not None]
    if len(given) > 1:
        raise ValueError(f"{name}: expected one of lengths, batch and offsets, got {' and '.join(given)}")
    is_ragged = batch is not None or offsets is not None
    form = "[M, {}]" if is_ragged else "[B, N, {}]" if lengths is not None else "[B, N, {0}] or [N, {0}]"
    expected = form.format(width or "D")
    axes = (2,) if is_ragged else (3,) if lengths is not None else (2, 3)
    if points.ndim not in axes or (width is not None and points.shape[-1] != width):
        raise ValueError(f"{name}: expected shape {expected}, got {list(points.shape)}")
    rows = computed(points).reshape(-1, points.shape[-1]).contiguous()
    shape = tuple(points.shape[:-1])
    if lengths is not None:
        return Batch(rows, _labels_of_lengths(name, lengths, points), shape[0], shape[1], shape)
    if offsets is not None:
        labels, count = _labels_of_offsets(name, offsets, points)
        return Batch(rows, labels, count, 0, shape)
    if batch is not None:
        labels, count = _labels_of_batch(name, batch, points, batch_size)
        return Batch(rows, labels, count, 0, shape)
    return Batch(rows, None, shape[0] if len(shape) == 2 else 1, shape[-1], shape)


def take_pair(
    query: torch.Tensor,
    points: torch.Tensor,
    names: tuple[str, str] = ("query", "points"),
    *,
    lengths: Pair = None,
    batch: Pair = None,
    offsets: Pair = None,
    batch_size: int | None = None,
    width: int | None = 3,
) -> tuple[Batch, Batch]:
    """Two batches of the same clouds, in one type. `lengths`, `batch` and `offsets` are pairs, one for each of the two,
    or one tensor for both. A None in a pair of lengths: all rows are points.
    """
    check_tensor(names[0], query)
    check_tensor(names[1], points)
    check_device(names[0], query)
    check_device(names[1], points, query)
    layouts = zip(_pair("lengths", lengths), _pair("batch", batch), _pair("offsets", offsets), strict=True)
    first, second = (dict(zip(("lengths", "batch", "offsets"), layout, strict=True)) for layout in layouts)
    if (
        batch is not None
        and batch_size is None
        and not any(value is None for value in (first["batch"], second["batch"]))
    ):
        batch_size = max(count_clouds(first["batch"]), count_clouds(second["batch"]))
    a = take_batch(names[0], query, **first, batch_size=batch_size, width=width)
    is_same = all(one is two for one, two in zip((query, *first.values()), (points, *second.values()), strict=True))
    b = a if is_same else take_batch(names[1], points, **second, batch_size=batch_size, width=width)
    is_one_ragged = len(a.shape) == 1 and (a.labels is None) != (b.labels is None)
    if a.count != b.count or len(a.shape) != len(b.shape) or is_one_ragged:
        counts = f"{list(query.shape)} ({a.count} clouds) and {list(points.shape)} ({b.count} clouds)"
        raise ValueError(f"{names[0]} and {names[1]}: expected the same number of clouds and layout, got {counts}")
    if a.points.shape[1] != b.points.shape[1]:
        given = f"{list(query.shape)} and {list(points.shape)}"
        raise ValueError(f"{names[0]} and {names[1]}: expected the same number of coordinates, got {given}")
    dtype = torch.promote_types(a.points.dtype, b.points.dtype)
    if a is b:
        return a, a
    return a._replace(points=a.points.to(dtype)), b._replace(points=b.points.to(dtype))


def count_clouds(batch: torch.Tensor) -> int:
    """Number of clouds of a batch vector: the largest label and 1. The host waits for a GPU."""
    check_integers("batch", batch)  # type: ignore[arg-type]
    largest = int(batch.max()) if batch.numel() else -1  # type: ignore[attr-defined]
    if largest >= MAX_COUNT:
        raise ValueError(f"batch: expected clouds below {MAX_COUNT:,}, got {largest:,}: counts have 32 bits")
    return largest + 1


def _pair(name: str, value: Pair) -> tuple[torch.Tensor | None, torch.Tensor | None]:
    if isinstance(value, (tuple, list)):
        if len(value) != 2:
            raise ValueError(f"{name}: expected a tensor for both arguments or a pair of tensors, got {len(value)}")
        return value[0], value[1]
    return value, value


def _labels_of_lengths(name: str, lengths: torch.Tensor, points: torch.Tensor) -> torch.Tensor:
    check_integers("lengths", lengths)
    check_device("lengths", lengths, points)
    count, width = points.shape[0], points.shape[1]
    if tuple(lengths.shape) != (count,):
        given = f"{list(lengths.shape)} for {name} of shape {list(points.shape)}"
        raise ValueError(f"lengths: expected shape [{count}], got {given}")
    if checks_values(lengths) and count and (int(lengths.min()) < 0 or int(lengths.max()) > width):
        given = f"{int(lengths.min())}..{int(lengths.max())}"
        raise ValueError(f"lengths: expected 0..{width}, as {name} has shape {list(points.shape)}, got {given}")
    rows = torch.arange(width, device=points.device)
    clouds = torch.arange(count, device=points.device)
    return torch.where(rows[None, :] < lengths[:, None], clouds[:, None], count).reshape(-1)


def _labels_of_offsets(name: str, offsets: torch.Tensor, points: torch.Tensor) -> tuple[torch.Tensor, int]:
    check_integers("offsets", offsets)
    check_device("offsets", offsets, points)
    if offsets.ndim != 1 or not offsets.shape[0]:
        raise ValueError(f"offsets: expected shape [B + 1], got {list(offsets.shape)}")
    rows = points.shape[0]
    if checks_values(offsets):
        steps = offsets[1:] - offsets[:-1]
        if int(offsets[0]) != 0 or int(offsets[-1]) != rows or (steps < 0).any():
            given = f"{int(offsets[0])} .. {int(offsets[-1])}" + (", descending" if (steps < 0).any() else "")
            expected = f"0 .. {rows} in ascending order, as {name} has shape {list(points.shape)}"
            raise ValueError(f"offsets: expected {expected}, got {given}")
    positions = torch.arange(rows, device=points.device)
    return torch.searchsorted(offsets[1:].long().contiguous(), positions, right=True), offsets.shape[0] - 1


def _labels_of_batch(
    name: str, batch: torch.Tensor, points: torch.Tensor, batch_size: int | None
) -> tuple[torch.Tensor, int]:
    check_integers("batch", batch)
    check_device("batch", batch, points)
    if tuple(batch.shape) != (points.shape[0],):
        given = f"{list(batch.shape)} for {name} of shape {list(points.shape)}"
        raise ValueError(f"batch: expected shape [{points.shape[0]}], got {given}")
    count = count_clouds(batch) if batch_size is None else check_count("batch_size", batch_size, minimum=0)
    if checks_values(batch) and batch.numel():
        if int(batch.min()) < 0 or int(batch.max()) >= count:
            given = f"{int(batch.min())}..{int(batch.max())}"
            raise ValueError(f"batch: expected clouds 0..{count - 1}, got {given}")
        if (batch[1:] < batch[:-1]).any():
            raise ValueError("batch: expected ascending clouds. Sort the points by batch first")
    return batch.long(), count
