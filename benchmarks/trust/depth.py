"""Depth networks: rejection of files that do not match the preset, and acceptance of those that do.

Files have the structure of published exports (tests/photogrammetry/depth/published_networks.py), unchanged and as
rewritten by other programs: onnxruntime's optimizer (basic and extended, which fuses operations), half precision, 8
bits.
Each is opened under every preset, as by a user who does not know the preset's name. Correctness is measured on an image
with known depth, with the checks of names and heads disabled: metric depth with a median error above 5 % is wrong, and
so are maps without a unit whose rank correlation with the depth is below 0.9. The effect of another normalization
depends
on the weights, which are not included. A preset with incompatible sizes, inputs or outputs returns no result and is
skipped. Under another preset a file may be correct by chance, as a metric network under a preset for depth up to scale;
such cases are not counted, since to reject them is right too.

Not tested: real weights. Heads are those of the networks' code, as are the constants of the check (20 and 80 m).
"""

from __future__ import annotations

import logging
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from unittest import mock

import numpy as np
from judged import Case, Judged
from numpy.typing import NDArray
from scipy.stats import spearmanr

from pointloom.photogrammetry.depth.estimation import DepthEstimate

ROOT = Path(__file__).resolve().parents[2]
if str(ROOT) not in sys.path:
    sys.path.append(str(ROOT))

import pointloom as loom  # noqa: E402
from pointloom.photogrammetry.depth import network  # noqa: E402
from pointloom.photogrammetry.depth.heads import RECIPROCAL, UNKNOWN, Head  # noqa: E402
from pointloom.photogrammetry.depth.network import DepthModel  # noqa: E402
from pointloom.photogrammetry.depth.presets import NETWORK_PRESETS  # noqa: E402
from tests.photogrammetry.depth.published_networks import FILES, FOCAL, depth_of, image_of, published  # noqa: E402

AREA = "depth network"
MAX_ERROR = 0.05  # median, relative
MIN_ORDER = 0.9  # rank correlation
ROWS, COLUMNS = 120, 160


def cases() -> Iterator[Case]:
    """Each file, in each of its forms, under every preset."""
    for name in FILES:
        yield Case(name, lambda name=name: _judge_network(name))


def _judge_network(name: str) -> Iterator[Judged]:
    with tempfile.TemporaryDirectory() as folder:
        path = published(Path(folder) / f"{name.replace(' ', '_')}.onnx", name)
        for form, changed in _forms(path):
            yield from _judge_file(f"{name}, {form}", FILES[name][0], changed)


def _forms(path: Path) -> Iterator[tuple[str, Path]]:
    """The file unchanged, and rewritten."""
    import onnx
    import onnxruntime as ort
    from onnxruntime.quantization import QuantType, quantize_dynamic
    from onnxruntime.transformers.float16 import convert_float_to_float16

    yield "as exported", path
    for level in ("BASIC", "EXTENDED"):
        options = ort.SessionOptions()
        options.graph_optimization_level = getattr(ort.GraphOptimizationLevel, f"ORT_ENABLE_{level}")
        options.optimized_model_filepath = str(path.with_suffix(f".{level}.onnx"))
        options.log_severity_level = 4
        ort.InferenceSession(str(path), options, providers=["CPUExecutionProvider"])
        yield f"optimized, {level.lower()}", Path(options.optimized_model_filepath)
    half = convert_float_to_float16(onnx.load(str(path)), disable_shape_infer=True)
    onnx.save(half, str(path.with_suffix(".half.onnx")))
    yield "half precision", path.with_suffix(".half.onnx")
    small = path.with_suffix(".int8.onnx")
    logging.getLogger().setLevel(logging.ERROR)  # avoids a warning that asks for preprocessing
    quantize_dynamic(str(path), str(small), weight_type=QuantType.QUInt8)
    yield "weights of 8 bits", small


def _judge_file(case: str, own: str, path: Path) -> Iterator[Judged]:
    """Its preset and wrong ones."""
    estimates = {preset: estimate for preset in NETWORK_PRESETS if (estimate := _answer(path, preset)) is not None}
    truth = depth_of(image_of(ROWS, COLUMNS))
    if own in estimates and NETWORK_PRESETS[own].focal is not None:  # gray images contain no focal length
        truth = truth * float(np.median((estimates[own].depth / truth)[estimates[own].depth > 0]))
    errors = {preset: _error(estimate, truth) for preset, estimate in estimates.items()}
    figure = f"{100 * errors[own]:.2g} % under its own preset" if np.isfinite(errors.get(own, np.inf)) else ""
    wrong = {preset for preset, error in errors.items() if not error <= MAX_ERROR}
    refusals = {preset: _refusal(path, preset) for preset in estimates}
    yield _count(case, {own, *wrong} & set(estimates), wrong, refusals, figure)


def _count(case: str, chosen: set[str], wrong: set[str], refusals: dict[str, str | None], figure: str) -> Judged:
    accepted = sorted(preset for preset in chosen & wrong if refusals[preset] is None)
    refused = sorted(preset for preset in chosen - wrong if refusals[preset] is not None)
    words = [f"accepted under {preset}" for preset in accepted] + [f"rejected under {preset}" for preset in refused]
    counts = len(chosen), len(chosen & wrong), len(accepted), len(refused)
    return Judged(AREA, case, *counts, "; ".join(words), figure)


def _refusal(path: Path, preset: str) -> str | None:
    """The error message if the file is rejected under a preset."""
    try:
        loom.photogrammetry.estimate_depth(image_of(ROWS, COLUMNS), DepthModel(path, preset), intrinsic=_camera())
    except (loom.FileError, ValueError) as error:
        return str(error)
    return None


def _answer(path: Path, preset: str) -> DepthEstimate | None:
    """The result without the checks of names and heads; None if the file cannot run."""

    def accept(*given: object) -> Head:
        return Head(RECIPROCAL) if "focal" in given[2].outputs else UNKNOWN  # type: ignore[attr-defined]

    with mock.patch.object(network, "check_head", accept), mock.patch.object(network, "_check_names", lambda *_: None):
        try:
            return loom.photogrammetry.estimate_depth(
                image_of(ROWS, COLUMNS), DepthModel(path, preset), intrinsic=_camera()
            )
        except (loom.FileError, ValueError):
            return None


def _error(estimate: DepthEstimate, truth: NDArray[np.float64]) -> float:
    """Median relative error for metric depth; without a unit 0 if the order is correct, else infinity."""
    valid = estimate.depth > 0
    if valid.mean() < 0.5:
        return np.inf
    if estimate.unit == "m":
        return float(np.median(abs(estimate.depth[valid] / truth[valid] - 1)))
    order = float(spearmanr(estimate.depth[valid], truth[valid])[0])
    return 0.0 if order >= MIN_ORDER else np.inf


def _camera() -> loom.PinholeCameraIntrinsic:
    focal = FOCAL * COLUMNS
    return loom.PinholeCameraIntrinsic(COLUMNS, ROWS, focal, focal, (COLUMNS - 1) / 2, (ROWS - 1) / 2)


if __name__ == "__main__":
    from judged import rates, table

    judged = [each for case in cases() for each in case.judge()]
    print("\n".join([*rates(judged), "", *table(judged)]))
