"""Depth networks: is a file that is not the preset's refused, and is one that is taken?

Files in the shape of published exports (tests/photogrammetry/depth/published_networks.py), unchanged and as other
programs rewrite them: onnxruntime's optimizer (basic and extended, which fuses operations), half precision, 8 bits.
Each is opened under every preset, as a user might who has the file and not the preset's name. Right or wrong is
measured on a picture whose depth is known, with the checks of names and heads switched off: meters that are off by more
than 5 % (median) are wrong, and maps without a unit whose order is not that of the depth (rank correlation below 0.9):
how well a network bears another normalization is its weights' affair, which are not here. A preset whose sizes, inputs
or outputs do not fit gives no answer to judge, and is left out. Under a preset that is not its own a file may be right
by luck, as a metric network is under one of depth up to a scale; such cases stand in rows of their own.

Not shown: real weights. Heads are those of the networks' code; the constants of the check (20 and 80 m) are theirs.
"""

from __future__ import annotations

import logging
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from unittest import mock

import numpy as np
from judged import Judged
from numpy.typing import NDArray
from scipy.stats import spearmanr

from pointloom.photogrammetry.depth.estimation import DepthEstimate

ROOT = Path(__file__).resolve().parents[2]
if str(ROOT) not in sys.path:
    sys.path.append(str(ROOT))

import pointloom as loom  # noqa: E402
from pointloom.photogrammetry.depth import network  # noqa: E402
from pointloom.photogrammetry.depth.heads import RECIPROCAL, UNKNOWN, Head  # noqa: E402
from pointloom.photogrammetry.depth.presets import PRESETS  # noqa: E402
from tests.photogrammetry.depth.published_networks import FILES, FOCAL, depth_of, picture_of, published  # noqa: E402

AREA, LUCK = "depth network", "depth network, a preset that fits by luck"
MAX_ERROR = 0.05  # median, relative
MIN_ORDER = 0.9  # rank correlation
ROWS, COLUMNS = 120, 160


def judge() -> Iterator[Judged]:
    """Each file, in each form that it is found in, under every preset."""
    with tempfile.TemporaryDirectory() as folder:
        for name in FILES:
            path = published(Path(folder) / f"{name.replace(' ', '_')}.onnx", name)
            for form, changed in _forms(path):
                yield from _judge_file(f"{name}, {form}", FILES[name][0], changed)


def _forms(path: Path) -> Iterator[tuple[str, Path]]:
    """The file as it is, and rewritten."""
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
    logging.getLogger().setLevel(logging.ERROR)  # it would have the file prepared first
    quantize_dynamic(str(path), str(small), weight_type=QuantType.QUInt8)
    yield "weights of 8 bits", small


def _judge_file(case: str, own: str, path: Path) -> Iterator[Judged]:
    """Its own preset and those that would be wrong; and those that would be right all the same."""
    answers = {preset: found for preset in PRESETS if (found := _answer(path, preset)) is not None}
    truth = depth_of(picture_of(ROWS, COLUMNS))
    if own in answers and PRESETS[own].focal is not None:  # a picture in whose gray depth lies knows no focal length
        truth = truth * float(np.median((answers[own].depth / truth)[answers[own].depth > 0]))
    errors = {preset: _error(found, truth) for preset, found in answers.items()}
    figure = f"{100 * errors[own]:.2g} % under its own preset" if np.isfinite(errors.get(own, np.inf)) else ""
    wrong = {preset for preset, error in errors.items() if not error <= MAX_ERROR}
    said = {preset: _refusal(path, preset) for preset in answers}
    yield _count(AREA, case, {own, *wrong} & set(answers), wrong, said, figure)
    if luck := set(answers) - wrong - {own}:
        yield _count(LUCK, case, luck, wrong, said, figure)


def _count(area: str, case: str, chosen: set[str], wrong: set[str], said: dict[str, str | None], figure: str) -> Judged:
    believed = sorted(preset for preset in chosen & wrong if said[preset] is None)
    refused = sorted(preset for preset in chosen - wrong if said[preset] is not None)
    words = [f"accepted under {preset}" for preset in believed] + [f"rejected under {preset}" for preset in refused]
    counts = len(chosen), len(chosen & wrong), len(believed), len(refused)
    return Judged(area, case, *counts, "; ".join(words), figure)


def _refusal(path: Path, preset: str) -> str | None:
    """What is said where the file is refused under a preset."""
    try:
        loom.estimate_depth(picture_of(ROWS, COLUMNS), path, preset=preset, intrinsic=_camera())
    except (loom.FileError, ValueError) as error:
        return str(error)
    return None


def _answer(path: Path, preset: str) -> DepthEstimate | None:
    """What would be answered, were nothing asked of names and heads; None where the file cannot run."""

    def believed(*given: object) -> Head:
        return Head(RECIPROCAL) if "focal" in given[2].outputs else UNKNOWN  # type: ignore[attr-defined]

    with (
        mock.patch.object(network, "check_head", believed),
        mock.patch.object(network, "_check_names", lambda *_: None),
    ):
        try:
            return loom.estimate_depth(picture_of(ROWS, COLUMNS), path, preset=preset, intrinsic=_camera())
        except (loom.FileError, ValueError):
            return None


def _error(found: DepthEstimate, truth: NDArray[np.float64]) -> float:
    """Median relative error of meters; without a unit 0 where the order is right, infinity where not."""
    seen = found.depth > 0
    if seen.mean() < 0.5:
        return np.inf
    if found.unit == "m":
        return float(np.median(abs(found.depth[seen] / truth[seen] - 1)))
    order = float(spearmanr(found.depth[seen], truth[seen])[0])
    return 0.0 if order >= MIN_ORDER else np.inf


def _camera() -> loom.PinholeCameraIntrinsic:
    focal = FOCAL * COLUMNS
    return loom.PinholeCameraIntrinsic(COLUMNS, ROWS, focal, focal, (COLUMNS - 1) / 2, (ROWS - 1) / 2)


if __name__ == "__main__":
    from judged import rates, table

    cases = list(judge())
    print("\n".join([*rates(cases), "", *table(cases)]))
