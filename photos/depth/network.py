"""A depth network from an ONNX file: opened once, held to what its preset says, run on one picture after another."""

from __future__ import annotations

import os
import sys
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.checks import check_count, shown
from ...core.devices import resolve_device
from ...core.errors import DeviceError, FileError
from ...core.interrupts import signal_exception
from ...core.paths import path_of
from ...files.foreign import import_for
from ...files.source import content_errors, open_source
from .graph import NO_MODEL, WEIGHTS_REMEDY, load_graph
from .inputs import Map, Placement, place, prepare
from .photos import Photo, camera_of, take_photo
from .presets import DEFAULT, find_preset
from .readings import Reading, ReadingError, read_outputs
from .signature import NOT_THE_MODEL, TYPES, check_head, check_signature, note_on

CUDA, CPU = "CUDAExecutionProvider", "CPUExecutionProvider"
MOST_THREADS = 1024
SILENT = 4  # severity from which onnxruntime's own log goes to stderr: its errors come as exceptions as well

# What onnxruntime's messages are about, and what to do.
_REMEDIES = (
    ("External data", WEIGHTS_REMEDY),
    ("IR version", "Update onnxruntime, or export the model with an older version of ONNX"),
    ("opset", "Update onnxruntime, or export the model with an older opset"),
    ("No Op registered", "The model uses operations that this onnxruntime lacks; update it"),
)


class DepthModel:
    """A depth network from an ONNX file, for many pictures.

    Args:
        path: The .onnx file; weights that it keeps in other files must be in its folder.
        preset: Which network it is: what its input and output mean. docs/depth.md lists them.
        device: "cpu" or None; "cuda", "cuda:N": an error where onnxruntime has no CUDA; "auto": a GPU where
            onnxruntime can use one, and `provider` says whether it did.
        threads: CPU threads; None for all cores.

    Raises:
        FileError: No ONNX model, one with other inputs or outputs than the preset's, one with weights outside its
            folder, or onnx or onnxruntime is missing.
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
        self.path = str(path_of(path))
        count = 0 if threads is None else check_count("threads", threads, maximum=MOST_THREADS, because="of one CPU")
        open_source(self.path)
        with content_errors(self.path):
            graph = load_graph(self.path)
        self._session = _open_session(self.path, device, count)
        self.provider: str = self._session.get_providers()[0]
        with content_errors(self.path):  # names that are no UTF-8 show where onnxruntime hands them out
            self._signature = check_signature(self.path, self._session, self._preset)
            self._head = check_head(self.path, graph, self._signature, self._preset)

    @property
    def preset(self) -> str:
        """The name of its preset."""
        return self._preset.name

    @property
    def note(self) -> str | None:
        """What could not be checked in the file, so that the preset was trusted; or None."""
        return note_on(self._head, self._preset)

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
        return place(self._preset, height, width, self._signature.fixed)

    def _run_placed(self, picture: NDArray[np.uint8]) -> tuple[Map, Placement]:
        """The same of an array [h, w, 3], and where it lay in the input."""
        camera, _ = camera_of(Photo(picture))
        reading = self._read(picture, camera, is_known=False)
        return reading.values, reading.placement

    def _read(self, picture: NDArray[np.uint8], camera: PinholeCameraIntrinsic, *, is_known: bool) -> Reading:
        """What the network says of an array [h, w, 3] that this camera took, which may be assumed."""
        placement = self._placement(*picture.shape[:2])
        values = prepare(self._preset, picture, placement)
        signature = self._signature
        batch = values[(None,) * (2 if signature.has_views else 1)].astype(TYPES[signature.type])
        numbers = {name: np.array(number, np.int64).reshape(shape) for name, number, shape in signature.numbers}
        roles, names = zip(*signature.outputs.items(), strict=True)
        handled = sys.exception()
        try:
            given = self._session.run(list(names), {signature.input: batch, **numbers})
        except Exception as error:  # onnxruntime's own classes, one a kind of failure
            if (stopped := signal_exception(error, handled)) is not None:
                raise stopped from None
            reason = f"fails on an input of {list(batch.shape)}: {_first_line(error)}"
            raise FileError(self.path, reason, remedy=NOT_THE_MODEL) from error
        outputs = dict(zip(roles, given, strict=True))
        focal = camera.fx, camera.fy
        try:
            return read_outputs(self._preset, self._head.kind, outputs, placement, focal, is_known=is_known)
        except ReadingError as error:
            where = f"output {signature.outputs['depth']!r}"
            raise FileError(self.path, str(error), where=where, remedy=error.remedy or NOT_THE_MODEL) from error


def _open_session(path: str, device: Any, threads: int) -> Any:
    """A session where the device asks for it."""
    ort = import_for(path, "onnxruntime", "depth")
    providers = _providers(ort, device)
    options = ort.SessionOptions()
    options.add_session_config_entry("session.load_model_format", "ONNX")  # as load_graph, whatever the name ends in
    options.use_deterministic_compute = True
    options.log_severity_level = SILENT
    options.intra_op_num_threads = threads
    handled = sys.exception()
    try:
        session = _start(ort, path, options, providers)
    except MemoryError:
        raise
    except Exception as error:
        if (stopped := signal_exception(error, handled)) is not None:
            raise stopped from None
        text = str(error)
        remedy = next((remedy for part, remedy in _REMEDIES if part in text), "Fetch or export the file again")
        raise FileError(path, f"{NO_MODEL}: {_first_line(error)}", remedy=remedy) from error
    if wants_cuda(device) and session.get_providers()[0] != CUDA:
        raise DeviceError(
            f"device: {shown(str(device))} was asked for, but onnxruntime could not start CUDA and fell back to the "
            'CPU; install the CUDA libraries that onnxruntime-gpu names, or take "cpu"'
        )
    return session


def _start(ort: Any, path: str, options: Any, providers: list[Any]) -> Any:
    """A session; on the CPU where the first provider fails, as onnxruntime has it, but without its banner on stdout."""
    try:
        return ort.InferenceSession(path, options, providers=providers, enable_fallback=0)
    except (ValueError, RuntimeError, Warning):  # a warning where the program makes errors of them
        if providers == [CPU]:
            raise
        return ort.InferenceSession(path, options, providers=[CPU], enable_fallback=0)


def wants_cuda(device: Any) -> bool:
    """Whether a GPU is asked for by name."""
    return device is not None and str(device).startswith("cuda")


def _providers(ort: Any, device: Any) -> list[Any]:
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


def _first_line(error: Exception) -> str:
    """What onnxruntime says, without its code, its place in the source and the path that the user knows."""
    line = (str(error).split("\n")[0] or type(error).__name__).split("failed:", 1)[-1]
    return line.replace("[ONNXRuntimeError] : ", "").strip()[:200].rstrip(".")
