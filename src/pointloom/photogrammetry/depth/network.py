"""Depth networks from ONNX files: session, checks against the preset, and inference.

A model whose names, sizes or last operations belong to another network is rejected with the preset to use. A graph that
cannot be classified (heads.py) is accepted with a note, since quantized exports end in arbitrary operations.
"""

from __future__ import annotations

import dataclasses
import sys
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.checks import check_count, shown
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import DeviceError, FileError, FilePath
from ...core.interrupts import signal_exception
from ...core.paths import path_of
from ...io.optional_imports import import_for
from ...io.source import content_errors, open_source
from .graph import NO_MODEL, WEIGHTS_REMEDY, Graph, load_graph
from .heads import BINS, BROKEN, CLAMPED, EXP, INVERSE, RECIPROCAL, SIGMOID, Head, find_head
from .inputs import Map, Placement, placement_of, prepare
from .network_outputs import Reading, ReadingError, read_outputs
from .photos import Photo, camera_of, take_photo
from .presets import DEFAULT, NETWORK_PRESETS, Preset, find_preset

TYPES = {"tensor(float)": np.float32, "tensor(float16)": np.float16}
INTEGER_TYPES = ("tensor(int64)",)
NOT_THE_MODEL = "Check that the preset matches the model"

# Names of inputs and outputs that one network's exports alone have.
_FAMILY_BY_NAME = {
    "num_tokens": "moge-2", "metric_scale": "moge-2",
    "focallength_px": "depth-pro", "field_of_view": "depth-pro", "fov_deg": "depth-pro",
    "canonical_inverse_depth": "depth-pro",
    "pts_3d": "unidepth-v2", "out_K": "unidepth-v2", "depth_ssi": "unidepth-v2",
    "normal_confidence": "metric3d-v2", "predicted_normal": "metric3d-v2",
    "domain_logits": "zoedepth",
}  # fmt: skip

_HEADS = {
    INVERSE: ("a ReLU, typical of relative inverse depth", ("depth-anything-v2", "dpt", "midas-v2.1")),
    SIGMOID: ("a sigmoid times {factor:g}, typical of depth up to {factor:g} m", ("depth-anything-v2-metric",)),
    BINS: ("a sum over depth bins, typical of metric depth", ("zoedepth", "metric3d-convnext")),
    RECIPROCAL: ("the reciprocal of an inverse depth, so its output is depth", ("depth-pro",)),
    EXP: ("an exponential, typical of depth", ("depth-anything-3", "depth-anything-3-metric")),
    CLAMPED: ("depth clamped to a range", ("metric3d-v2", "metric3d-convnext")),
}

_MEANINGS = {
    "inverse": "inverse depth, larger for nearer points",
    "depth": "depth, larger for farther points",
    "metric": "depth in meters, larger for farther points",
}


@dataclasses.dataclass(frozen=True)
class Signature:
    """Names, types and shapes of a model's inputs and outputs; `fixed` rows and columns are None if dynamic."""

    input: str
    type: str
    has_views: bool
    fixed: tuple[int | None, int | None]
    numbers: tuple[tuple[str, int, tuple[int, ...]], ...]
    outputs: dict[str, str]


def check_signature(path: str, session: Any, preset: Preset) -> Signature:
    _check_names(path, session, preset)
    the_input, views, fixed, numbers = _check_input(path, session, preset)
    return Signature(the_input.name, the_input.type, views, fixed, numbers, _check_outputs(path, session, preset))


def check_head(path: str, graph: Graph, signature: Signature, preset: Preset) -> Head:
    """Classify the end of the model's graph. FileError if it is another network's."""
    head = find_head(graph, signature.outputs["depth"])
    if head.kind == BROKEN:
        reason = (
            f"ends in a ReLU times {head.factor:g}: a metric network that was exported with the output function of the "
            "relative network, so its depth is 0 or far too large"
        )
        raise FileError(path, reason, remedy="Use an export made since October 2024, which ends in a sigmoid")
    if head.kind is None:
        _check_canvas(path, signature, preset)
        return _by_outputs(path, signature) if preset.reading == "canonical" else head
    if preset.heads and head.kind not in preset.heads:
        words, presets = _HEADS[head.kind]
        is_contrary = (preset.output == "inverse") != (head.kind == INVERSE)
        own = f"outputs {_MEANINGS[preset.output]}" if is_contrary else "does not"
        reason = f"ends in {words.format(factor=head.factor)}; {preset.name} {own}"
        raise FileError(path, reason, remedy=f"Use the preset {' or '.join(presets)}")
    if preset.reading == "canonical" and head.kind == INVERSE and not _is_canonical(signature, preset):
        words, presets = _HEADS[INVERSE]
        reason = f"ends in {words}, but its size and its outputs do not match {preset.name}"
        raise FileError(path, reason, remedy=f"Use the preset {' or '.join(presets)}")
    return head


def _is_canonical(signature: Signature, preset: Preset) -> bool:
    """True if inverse depth is Depth Pro's canonical one, not relative: its encoder has one size."""
    names = signature.outputs
    return (
        signature.fixed in preset.fixed
        or names["depth"] == "canonical_inverse_depth"
        or not {"focal", "view"}.isdisjoint(names)
    )


def _check_canvas(path: str, signature: Signature, preset: Preset) -> None:
    """Reject a model of Metric3D's input size for another network, which has the same inputs and outputs."""
    canvas = next(
        (each for each in NETWORK_PRESETS.values() if each.levels > 1 and signature.fixed in each.fixed), None
    )
    if canvas is not None and preset.levels == 1:
        rows, columns = signature.fixed
        reason = f"has an input of {rows} x {columns} pixels, the size of {canvas.name}, not of {preset.name}"
        raise FileError(path, reason, remedy=f"Use the preset {canvas.name}")


def _by_outputs(path: str, signature: Signature) -> Head:
    """The head of a Depth Pro by its outputs: exports with a focal length output meters."""
    if "focal" in signature.outputs:
        return Head(RECIPROCAL)
    if "view" in signature.outputs or signature.outputs["depth"] == "canonical_inverse_depth":
        return Head(INVERSE)
    reason = "does not specify whether its output is depth in meters or canonical inverse depth"
    raise FileError(path, reason, remedy="Export it with the focal length or field of view as an output")


def note_on(head: Head, preset: Preset) -> str | None:
    if head.kind is None and preset.heads:
        return (
            f"the file does not specify that its map is {_MEANINGS[preset.output]}, as {preset.name} assumes: check "
            "that near points are near, or align, which rejects an inverted map"
        )
    if preset.output == "metric" and preset.reading == "map":
        twins = (each for each in NETWORK_PRESETS.values() if each.output != "metric" and head.kind in each.heads)
        if (twin := next(twins, None)) is not None:
            return (
                f"the file does not specify that its depth is in meters, as {preset.name} assumes: "
                f"{twin.name} has the same head"
            )
    return None


def _check_names(path: str, session: Any, preset: Preset) -> None:
    names = [each.name for each in (*session.get_inputs(), *session.get_outputs())]
    families = {_FAMILY_BY_NAME[name]: name for name in names if name in _FAMILY_BY_NAME}
    family = "metric3d-v2" if preset.name == "metric3d-convnext" else preset.name
    if families and family not in families:
        other, name = next(iter(families.items()))
        reason = f"contains {name!r}, which {other} has and {preset.name} does not"
        raise FileError(path, reason, remedy=f"Use the preset {other}")


def _check_input(path: str, session: Any, preset: Preset) -> tuple[Any, bool, tuple[int | None, int | None], Any]:
    numbers = [each for each in session.get_inputs() if each.name in preset.numbers]
    inputs = [each for each in session.get_inputs() if each.name not in preset.numbers]
    for each in numbers:
        if each.type not in INTEGER_TYPES or any(side != 1 for side in each.shape or []):
            reason = f"expected one integer for {preset.name}, got {each.type} {each.shape}"
            raise FileError(path, reason, where=f"input {each.name!r}", remedy=NOT_THE_MODEL)
    if len(inputs) != 1:
        names = ", ".join(each.name for each in inputs) or "none"
        reason = f"expected one input for {preset.name}, the image, got {names}"
        raise FileError(path, reason, remedy="Export it without the other inputs, or give another preset")
    wanted = "[1, 3, h, w]" + (" or [1, 1, 3, h, w]" if preset.takes_views else "")
    the_input = inputs[0]
    shape, where = list(the_input.shape or []), f"input {the_input.name!r}"
    views = len(shape) == 5 and preset.takes_views
    heads = [1, 1, 3] if views else [1, 3]
    is_image = len(shape) == len(heads) + 2 and shape[-1] != 3  # otherwise the colors are last
    if not is_image or any(isinstance(a, int) and a != b for a, b in zip(shape, heads, strict=False)):
        reason = f"expected {wanted} for {preset.name}, got {the_input.type} {shape}"
        raise FileError(path, reason, where=where, remedy=NOT_THE_MODEL)
    if the_input.type not in TYPES:
        raise FileError(
            path, f"expected floats for {preset.name}, got {the_input.type}", where=where, remedy=NOT_THE_MODEL
        )
    rows, columns = (side if isinstance(side, int) and side > 0 else None for side in shape[-2:])
    _check_fixed(path, where, preset, rows, columns)
    given = tuple((each.name, preset.numbers[each.name], tuple(each.shape or ())) for each in numbers)
    return the_input, views, (rows, columns), given


def _check_fixed(path: str, where: str, preset: Preset, rows: int | None, columns: int | None) -> None:
    if preset.fixed and not any(rows in (None, size[0]) and columns in (None, size[1]) for size in preset.fixed):
        sizes = " or ".join(f"{height} x {width}" for height, width in preset.fixed)
        reason = f"expected {sizes} for {preset.name}, got {rows or 'any'} rows and {columns or 'any'} columns"
        other = next((each.name for each in NETWORK_PRESETS.values() if (rows, columns) in each.fixed), None)
        remedy = NOT_THE_MODEL if other is None else f"{NOT_THE_MODEL}; {other} has this size"
        raise FileError(path, reason, where=where, remedy=remedy)
    if (rows or 1) * (columns or 1) > MAX_FIXED:
        reason = f"has an input of {rows or 'any'} x {columns or 'any'} pixels, which is more than {MAX_FIXED:,}"
        raise FileError(path, reason, where=where, remedy=NOT_THE_MODEL)
    for side in (rows, columns):
        if side is not None and side % preset.multiple:
            reason = f"expected sides that are multiples of {preset.multiple} for {preset.name}, got {side}"
            remedy = "Export it with such sides; otherwise its map lacks rows or columns"
            remedy += f" ({preset.name} is the default; another network: --preset)" if preset.name == DEFAULT else ""
            raise FileError(path, reason, where=where, remedy=remedy)


def _check_outputs(path: str, session: Any, preset: Preset) -> dict[str, str]:
    outputs = session.get_outputs()
    names = [each.name for each in outputs]
    is_alone = len(names) == 1 and not preset.needed
    name = next((name for name in preset.outputs if name in names), names[0] if is_alone else None)
    if name is None:
        reason = f"expected the output {' or '.join(preset.outputs)} for {preset.name}, got {', '.join(names)}"
        raise FileError(path, reason, remedy=NOT_THE_MODEL)
    output = outputs[names.index(name)]
    shape = output.shape
    if output.type not in TYPES or (shape and not 3 <= len(shape) <= 5):
        reason = f"expected [1, h, w] or [1, 1, h, w] of floats for {preset.name}, got {output.type} {shape}"
        raise FileError(path, reason, where=f"output {name!r}", remedy=NOT_THE_MODEL)
    selected = {"depth": name}
    for kind, known in preset.others.items():
        for each in names:
            if each in known and each != name:
                selected[kind] = each
    for kind in preset.needed:
        if kind not in selected:
            reason = f"expected the output {preset.others[kind][0]} for {preset.name}, got {', '.join(names)}"
            raise FileError(path, reason, remedy=NOT_THE_MODEL)
    return selected


MAX_FIXED = 1 << 24  # [px] 100 times the inputs of the largest published networks take gigabytes for a small file
CUDA, CPU = "CUDAExecutionProvider", "CPUExecutionProvider"
MAX_THREADS = 1024
FATAL_LOG_LEVEL = 4  # minimum severity of onnxruntime's stderr log. Errors are raised as exceptions too

_REMEDIES = (
    ("External data", WEIGHTS_REMEDY),
    ("IR version", "Update onnxruntime, or export the model with an older version of ONNX"),
    ("opset", "Update onnxruntime, or export the model with an older opset"),
    ("No Op registered", "The model uses operations that this onnxruntime does not support; update it"),
)


class DepthModel:
    """A depth network from an ONNX file, for many images.

    Args:
        path: The .onnx file. External weights must be in its folder.
        preset: Type of network, see docs/depth.md.
        device: "cpu" or None; "cuda", "cuda:N": requires onnxruntime with CUDA; "auto": a GPU if usable, see
            `provider`.
        threads: CPU threads; None: all cores.

    Raises:
        FileError: Not an ONNX model of the preset, weights outside its folder, or onnx or onnxruntime is missing.
        DeviceError: The device is missing or not usable by onnxruntime.
        ValueError: An unknown preset, or threads out of range.

    Notes:
        Memory: weights, and about 1 GB for attention. Uses deterministic algorithms, see docs/depth.md.

    Example:
        >>> import pointloom as loom
        >>> loom.photogrammetry.DepthModel("missing.onnx")
        Traceback (most recent call last):
        ...
        pointloom.core.errors.FileError: missing.onnx: does not exist
    """

    def __init__(self, path: FilePath, preset: str = DEFAULT, *, device: DeviceLike = None, threads: int | None = None):
        self._preset = find_preset(preset)
        self.path = str(path_of(path))
        count = 0 if threads is None else check_count("threads", threads, maximum=MAX_THREADS, because="of one CPU")
        open_source(self.path)
        with content_errors(self.path):
            graph = load_graph(self.path)
        self._session = _open_session(self.path, device, count)
        self.provider: str = self._session.get_providers()[0]
        with content_errors(self.path):  # onnxruntime returns names that may not be UTF-8
            self._signature = check_signature(self.path, self._session, self._preset)
            self._head = check_head(self.path, graph, self._signature, self._preset)

    @property
    def preset(self) -> str:
        """Name of the preset."""
        return self._preset.name

    @property
    def notes(self) -> tuple[str, ...]:
        """What could not be verified in the file."""
        note = note_on(self._head, self._preset)
        return () if note is None else (note,)

    def __repr__(self) -> str:
        return f"DepthModel({self.path!r}, {self.preset!r}, {self.provider})"

    def run(self, image: Any) -> Map:
        """Run the network on an image. Returns its map, float32 [h, w], at the image size in the network's unit.

        Args:
            image: As of `estimate_depth`.

        Raises:
            FileError: The network fails, or outputs a wrong size, NaN, infinity or a constant.
            TypeError, ValueError: Not an image, or one that is too narrow for the network.
        """
        return self._run_with_placement(take_photo(image).color)[0]

    def _placement(self, height: int, width: int) -> Placement:
        return placement_of(self._preset, height, width, self._signature.fixed)

    def _run_with_placement(self, image: NDArray[np.uint8]) -> tuple[Map, Placement]:
        camera, _ = camera_of(Photo(image))
        reading = self._read(image, camera, is_known=False)
        return reading.values, reading.placement

    def _read(self, image: NDArray[np.uint8], camera: PinholeCameraIntrinsic, *, is_known: bool) -> Reading:
        placement = self._placement(*image.shape[:2])
        try:
            values = prepare(self._preset, image, placement)
        except MemoryError as error:
            reason = (
                f"needs more memory than is available for an input of {placement.rows} x {placement.columns} pixels"
            )
            raise FileError(self.path, reason, remedy="Give a smaller image, or another network") from error
        signature = self._signature
        batch = values[(None,) * (2 if signature.has_views else 1)].astype(TYPES[signature.type])
        numbers = {name: np.array(number, np.int64).reshape(shape) for name, number, shape in signature.numbers}
        roles, names = zip(*signature.outputs.items(), strict=True)
        handled = sys.exception()
        try:
            given = self._session.run(list(names), {signature.input: batch, **numbers})
        except Exception as error:  # onnxruntime has its own exception classes
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


def _open_session(path: str, device: DeviceLike, threads: int) -> Any:
    ort = import_for(path, "onnxruntime", "depth")
    providers = _providers(ort, device)
    options = ort.SessionOptions()
    options.add_session_config_entry("session.load_model_format", "ONNX")  # as load_graph, for any file extension
    options.use_deterministic_compute = True
    options.log_severity_level = FATAL_LOG_LEVEL
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
        remedy = next((remedy for part, remedy in _REMEDIES if part in text), "Download or export the file again")
        raise FileError(path, f"{NO_MODEL}: {_first_line(error)}", remedy=remedy) from error
    if wants_cuda(device) and session.get_providers()[0] != CUDA:
        raise DeviceError(
            f"device: {shown(str(device))} was requested, but onnxruntime could not start CUDA and fell back to the "
            'CPU; install the CUDA libraries that onnxruntime-gpu requires, or use "cpu"'
        )
    return session


def _start(ort: ModuleType, path: str, options: Any, providers: list[Any]) -> Any:
    """Open a session with fallback to the CPU as in onnxruntime, without its banner on stdout."""
    try:
        return ort.InferenceSession(path, options, providers=providers, enable_fallback=0)
    except (ValueError, RuntimeError, Warning):  # a warning if the program turns them into errors
        if providers == [CPU]:
            raise
        return ort.InferenceSession(path, options, providers=[CPU], enable_fallback=0)


def wants_cuda(device: DeviceLike) -> bool:
    return device is not None and str(device).startswith("cuda")


def _providers(ort: ModuleType, device: DeviceLike) -> list[Any]:
    has_cuda = CUDA in ort.get_available_providers()
    if wants_cuda(device) and not has_cuda:
        raise DeviceError(
            f"device: {shown(str(device))} was requested, but this onnxruntime has no CUDA; install onnxruntime-gpu "
            'instead, or use "cpu"'
        )
    where = resolve_device(device)
    if where.is_cuda and has_cuda:
        return [(CUDA, {"device_id": str(where.ordinal)}), CPU]
    return [CPU]


def _first_line(error: Exception) -> str:
    """onnxruntime's message without error code, source location and path."""
    line = (str(error).split("\n")[0] or type(error).__name__).split("failed:", 1)[-1]
    return line.replace("[ONNXRuntimeError] : ", "").strip()[:200].rstrip(".")
