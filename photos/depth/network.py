"""A depth network from an ONNX file: opened once, held to what its preset says, run on one picture after another."""

from __future__ import annotations

import os
import warnings
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_count, shown
from ...core.devices import resolve_device
from ...core.errors import DeviceError, FileError
from ...files.foreign import import_for
from ...files.source import open_source
from .inputs import Map, Placement, bring_back, place, prepare
from .photos import take_photo
from .presets import DEFAULT, Preset, find_preset

CUDA, CPU = "CUDAExecutionProvider", "CPUExecutionProvider"
MOST_THREADS = 1024
TYPES = {"tensor(float)": np.float32, "tensor(float16)": np.float16}
NOT_THE_MODEL = "Check that the file is the model that the preset names"
SILENT = 4  # severity from which onnxruntime's own log goes to stderr: its errors come as exceptions as well

# What onnxruntime's messages are about, and what to do.
_REMEDIES = (
    ("External data", "Put the file of its weights (often NAME.onnx_data) beside it, under its old name"),
    ("IR version", "Update onnxruntime, or export the model with an older version of ONNX"),
    ("opset", "Update onnxruntime, or export the model with an older opset"),
    ("No Op registered", "The model uses operations that this onnxruntime lacks; update it"),
)


class DepthModel:
    """A depth network from an ONNX file, for many pictures.

    Args:
        path: The .onnx file; weights that it keeps in other files are looked for beside it.
        preset: Which network it is: what its input and output mean. docs/depth.md lists them.
        device: "cpu" or None; "cuda", "cuda:N": an error where onnxruntime has no CUDA; "auto": a GPU where
            onnxruntime can use one, and `provider` says whether it did.
        threads: CPU threads; None for all cores.

    Raises:
        FileError: No ONNX model, one with other inputs or outputs than the preset's, or onnxruntime is missing.
        DeviceError: The device is not there, or onnxruntime cannot use it.
        ValueError: No such preset, or a number of threads out of range.

    Notes:
        Memory is onnxruntime's: the weights, and for attention some 1 GB at the usual sizes. Its deterministic
        algorithms are asked for; docs/depth.md says what that gives.

    Example:
        >>> import pointloom as loom
        >>> loom.DepthModel("missing.onnx")
        Traceback (most recent call last):
        ...
        pointloom.core.errors.FileError: missing.onnx: does not exist
    """

    def __init__(
        self, path: str | os.PathLike[str], preset: str = DEFAULT, *, device: Any = None, threads: int | None = None
    ):
        self._preset = find_preset(preset)
        if not isinstance(path, str | os.PathLike):
            raise TypeError(f"path: expected the path of an .onnx file, got {shown(path)}")
        self.path = os.fspath(path)
        count = 0 if threads is None else check_count("threads", threads, maximum=MOST_THREADS, because="of one CPU")
        open_source(self.path)
        self._session = _open_session(self.path, device, count)
        self.provider: str = self._session.get_providers()[0]
        self._input, self._views, self._fixed = _check_input(self.path, self._session, self._preset)
        self._output = _check_output(self.path, self._session, self._preset)

    @property
    def preset(self) -> str:
        """The name of its preset."""
        return self._preset.name

    def __repr__(self) -> str:
        return f"DepthModel({self.path!r}, {self.preset!r}, {self.provider})"

    def run(self, picture: Any) -> Map:
        """What the network gives for a picture, at the picture's size and in the network's own unit.

        Args:
            picture: As `estimate_depth` takes it.

        Returns:
            float32 [h, w].

        Raises:
            FileError: The network fails, or gives another size, NaN, infinity or one value everywhere.
            TypeError, ValueError: No picture, or one that is too narrow for the network.
        """
        return self._run_placed(take_photo(picture).color)[0]

    def _placement(self, height: int, width: int) -> Placement:
        """Where a picture of this size lies in the input."""
        return place(self._preset, height, width, self._fixed)

    def _run_placed(self, picture: NDArray[np.uint8]) -> tuple[Map, Placement]:
        """The same of an array [h, w, 3], and where it lay in the input."""
        placement = self._placement(*picture.shape[:2])
        values = prepare(self._preset, picture, placement)
        batch = values[(None,) * (2 if self._views else 1)].astype(TYPES[self._input.type])
        try:
            given = self._session.run([self._output], {self._input.name: batch})[0]
        except Exception as error:  # onnxruntime's own classes, one a kind of failure
            reason = f"fails on an input of {list(batch.shape)}: {_first_line(error)}"
            raise FileError(self.path, reason, remedy=NOT_THE_MODEL) from error
        return bring_back(self._check_values(given, placement), placement), placement

    def _check_values(self, given: Any, placement: Placement) -> Map:
        """The output as a map of the input's size, once it is one."""
        size = (placement.rows, placement.columns)
        found = list(np.shape(given))
        if len(found) < 3 or tuple(found[-2:]) != size or any(extent != 1 for extent in found[:-2]):
            reason = f"gave {found} for an input of {size[0]} x {size[1]}, expected [1, {size[0]}, {size[1]}]"
            raise FileError(self.path, reason, where=f"output {self._output!r}", remedy=NOT_THE_MODEL)
        values = np.asarray(given, np.float32).reshape(size)
        if not np.isfinite(values).all():
            share = 1 - np.isfinite(values).mean()
            reason = f"{share:.1%} of what it gave is NaN or infinite"
            raise FileError(self.path, reason, where=f"output {self._output!r}", remedy="Take a float32 export of it")
        if values.size > 1 and values.max() == values.min():
            reason = f"gave {values.flat[0]:g} for every pixel, so no depth was seen"
            raise FileError(self.path, reason, where=f"output {self._output!r}", remedy=NOT_THE_MODEL)
        return values


def _open_session(path: str, device: Any, threads: int) -> Any:
    """A session where the device asks for it."""
    ort = import_for(path, "onnxruntime", "depth")
    providers = _providers(ort, device)
    options = ort.SessionOptions()
    options.use_deterministic_compute = True
    options.log_severity_level = SILENT
    options.intra_op_num_threads = threads
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of providers that fell away: looked at below
            session = ort.InferenceSession(path, options, providers=providers)
    except MemoryError:
        raise
    except Exception as error:
        text = str(error)
        remedy = next((remedy for part, remedy in _REMEDIES if part in text), "Fetch or export the file again")
        raise FileError(path, f"no ONNX model that can be used: {_first_line(error)}", remedy=remedy) from error
    if wants_cuda(device) and session.get_providers()[0] != CUDA:
        raise DeviceError(
            f"device: {shown(str(device))} was asked for, but onnxruntime could not start CUDA and fell back to the "
            'CPU; install the CUDA libraries that onnxruntime-gpu names, or take "cpu"'
        )
    return session


def wants_cuda(device: Any) -> bool:
    """Whether a GPU is asked for by name."""
    return device is not None and str(device).startswith("cuda")


def _providers(ort: Any, device: Any) -> list[Any]:
    """What onnxruntime may run on, the first one foremost."""
    has_cuda = CUDA in ort.get_available_providers()
    if wants_cuda(device) and not has_cuda:
        raise DeviceError(
            f"device: {shown(str(device))} was asked for, but this onnxruntime has no CUDA: install onnxruntime-gpu in "
            'its place, or take "cpu"'
        )
    where = resolve_device(device)
    if where.is_cuda and has_cuda:
        return [(CUDA, {"device_id": str(where.ordinal)}), CPU]
    return [CPU]


def _check_input(path: str, session: Any, preset: Preset) -> tuple[Any, bool, tuple[int | None, int | None]]:
    """The one input, whether it has views, and its fixed rows and columns."""
    inputs = session.get_inputs()
    if len(inputs) != 1:
        names = ", ".join(each.name for each in inputs) or "none"
        reason = f"has the inputs {names}; {preset.name} has one, the picture"
        raise FileError(path, reason, remedy="Export it without the others, or give another preset")
    wanted = "[1, 3, h, w]" + (" or [1, 1, 3, h, w]" if preset.takes_views else "")
    the_input = inputs[0]
    shape, where = list(the_input.shape or []), f"input {the_input.name!r}"
    views = len(shape) == 5 and preset.takes_views
    heads = [1, 1, 3] if views else [1, 3]
    is_picture = len(shape) == len(heads) + 2 and shape[-1] != 3  # else the colours come last
    if not is_picture or any(isinstance(a, int) and a != b for a, b in zip(shape, heads, strict=False)):
        reason = f"is {the_input.type} {shape}; {preset.name} takes {wanted}"
        raise FileError(path, reason, where=where, remedy=NOT_THE_MODEL)
    if the_input.type not in TYPES:
        raise FileError(path, f"is {the_input.type}; {preset.name} takes floats", where=where, remedy=NOT_THE_MODEL)
    rows, columns = (side if isinstance(side, int) and side > 0 else None for side in shape[-2:])
    _check_fixed(path, where, preset, rows, columns)
    return the_input, views, (rows, columns)


def _check_fixed(path: str, where: str, preset: Preset, rows: int | None, columns: int | None) -> None:
    if preset.fixed and any(
        side is not None and all(side != size[axis] for size in preset.fixed)
        for axis, side in enumerate((rows, columns))
    ):
        sizes = " or ".join(f"{height} x {width}" for height, width in preset.fixed)
        reason = f"has {rows or 'any'} rows and {columns or 'any'} columns; {preset.name} has {sizes}"
        raise FileError(path, reason, where=where, remedy=NOT_THE_MODEL)
    for side in (rows, columns):
        if side is not None and side % preset.multiple:
            reason = f"has a side of {side}, which is no multiple of {preset.multiple} as {preset.name} needs"
            remedy = f"Export it with sides of a multiple of {preset.multiple}; its map would lack rows or columns"
            raise FileError(path, reason, where=where, remedy=remedy)


def _check_output(path: str, session: Any, preset: Preset) -> str:
    """The name of the output that holds depth."""
    outputs = session.get_outputs()
    names = [each.name for each in outputs]
    name = next((name for name in preset.outputs if name in names), names[0] if len(names) == 1 else None)
    if name is None:
        reason = f"has the outputs {', '.join(names)}; {preset.name} has {' or '.join(preset.outputs)}"
        raise FileError(path, reason, remedy=NOT_THE_MODEL)
    output = outputs[names.index(name)]
    shape = output.shape
    if output.type not in TYPES or (shape and not 3 <= len(shape) <= 5):
        reason = f"is {output.type} {shape}; {preset.name} gives a map, [1, h, w] or [1, 1, h, w] of floats"
        raise FileError(path, reason, where=f"output {name!r}", remedy=NOT_THE_MODEL)
    return name


def _first_line(error: Exception) -> str:
    """What onnxruntime says, without its code, its place in the source and the path that the user knows."""
    line = (str(error).split("\n")[0] or type(error).__name__).split("failed:", 1)[-1]
    return line.replace("[ONNXRuntimeError] : ", "").strip()[:200].rstrip(".")
