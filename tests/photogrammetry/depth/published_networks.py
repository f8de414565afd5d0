"""Tiny ONNX networks with the names, sizes, normalization and last operations of published exports.

Instead of weights they decode the image: gray g of 0..255 is depth 1 + 9 g / 255 meters. Each network encodes this
depth as its family does, after the families' own code (src/pointloom/photogrammetry/depth/heads.py).
"""

from pathlib import Path
from typing import Any

import numpy as np
from onnx import TensorProto

from .tiny_networks import FLOAT, nodes_of, save

IMAGENET = np.array([0.485, 0.456, 0.406]), np.array([0.229, 0.224, 0.225])
HALF = np.full(3, 0.5), np.full(3, 0.5)
UNIT = np.zeros(3), np.ones(3)
BYTES = np.zeros(3), np.full(3, 1 / 255)

FOCAL = 0.9  # of the images: the focal length over their width
MOGE_SHIFT, MOGE_SCALE = 0.75, 1.6  # the missing depth of MoGe's points, before the scale to meters


def image_of(height: int = 60, width: int = 80) -> np.ndarray:
    """An image whose gray encodes the depth of a sloping floor with a box in front."""
    v, u = np.mgrid[:height, :width]
    gray = 220 - 150 * v / height + 20 * np.sin(5 * u / width)
    box = (abs(u / width - 0.6) < 0.15) & (abs(v / height - 0.5) < 0.2)
    return np.repeat(np.where(box, 60, gray).round().astype(np.uint8)[..., None], 3, 2)


def depth_of(image: np.ndarray) -> np.ndarray:
    return 1 + 9 * image[..., 0].astype(np.float64) / 255


# Nodes of heads from depth z [1, 1, h, w] to `out`, and their constants.
LOGIT = "Sub one p -> rest; Div p rest -> odds; Log odds -> l"  # log(p / (1 - p)), whose sigmoid is p
RAYS = (  # x and y of the points at depth z, for a camera of FOCAL at any size
    "Mul z zero -> nothing; Add nothing one -> ones; CumSum ones three -> u; CumSum ones two -> v;"
    "ReduceMax u -> w keepdims=1; Mul w focal -> f;"
    + ";".join(
        f"ReduceMean {axis} -> {axis}.mid keepdims=1; Sub {axis} {axis}.mid -> {axis}0; Mul {axis}0 z -> {axis}z;"
        f"Div {axis}z f -> {axis}p"
        for axis in "uv"
    )
)
OF_RAYS = {"zero": 0, "one": 1, "focal": FOCAL, "two": np.int64(2), "three": np.int64(3)}
# Depth Anything V2, relative: the head's ReLU, and that of `forward`
RELATIVE = "Reciprocal z -> raw; Relu raw -> once; Relu once -> twice; Squeeze twice axis -> out", {}
# Depth Anything V2, metric
SCALED = f"Div z range -> p; {LOGIT}; Sigmoid l -> s; Mul s range -> m; Squeeze m axis -> out"
INDOOR, OUTDOOR = ((SCALED, {"range": farthest, "one": 1}) for farthest in (20, 80))
# a metric network exported with the last function of the relative one: a logit below 0 gives 0
CLIPPED = (
    f"Div z far -> p; {LOGIT}; Relu l -> s; Mul s range -> m; Squeeze m axis -> out",
    {"far": 10.5, "range": 20, "one": 1},
)
# ZoeDepth: depths of two bins, 1 and 10 m, weighted by a softmax
TWO_BINS = (
    f"Sub z one -> above; Div above nine -> share; Clip share low high -> p; {LOGIT}; Mul l zero -> o;"
    "Concat o l -> logits axis=1; Softmax logits -> shares axis=1; Mul shares centers -> parts;"
    "ReduceSum parts axis -> m keepdims=1; Squeeze m axis -> out",
    {"one": 1, "nine": 9, "zero": 0, "low": 1e-4, "high": 0.9999, "centers": np.reshape([1.0, 10.0], (1, 2, 1, 1))},
)
# Metric3D: max - ReLU(max - (ReLU(x - min) + min)), in one dimension more than the others
CLAMPED_RANGE = (
    "Sub z least -> a; Relu a -> b; Add b least -> c; Sub most c -> d; Relu d -> e; Sub most e -> out",
    {"least": 0.1, "most": 200},
)
EXPONENTIAL = "Log z -> l; Exp l -> e; Squeeze e axis -> out", {}  # Depth Anything 3
# Depth Pro's forward pass: c = (f / w) / z, and the field of view [degrees]
CANONICAL = (
    "Div focal z -> raw; Relu raw -> out; ReduceMean z -> mean keepdims=1; Mul mean zero -> nothing;"
    "Add nothing view -> fov_deg",
    {"focal": FOCAL, "zero": 0, "view": 2 * np.degrees(np.arctan(0.5 / FOCAL))},
)
# Depth Pro's `infer` at its own size: meters by the estimated focal length [px of 1536]
METERS = (
    "Div focal z -> raw; Relu raw -> c; ReduceMean z -> mean; Mul mean zero -> nothing;"
    "Add nothing pixels -> focallength_px; Div width focallength_px -> w_f; Mul c w_f -> inverse;"
    "Clip inverse low high -> kept; Reciprocal kept -> depth; Squeeze depth axis -> out",
    {"focal": FOCAL, "zero": 0, "pixels": FOCAL * 1536, "width": 1536, "low": 1e-4, "high": 1e4},
)
# MoGe-2: points without their shift and scale, a mask that excludes white pixels, the scale
POINTS = (
    f"{RAYS}; Sub z shift -> zs; Concat up vp zs -> all axis=1; Div all size -> small;"
    "Transpose small -> out perm=[0,2,3,1]; Sub white z -> dark; Mul dark hundred -> sure; Sigmoid sure -> m;"
    "Squeeze m axis -> mask; ReduceMax nothing -> n keepdims=0; Add n sizes -> metric_scale",
    OF_RAYS | {"shift": MOGE_SHIFT, "size": MOGE_SCALE, "white": 9.8, "hundred": 100, "sizes": [MOGE_SCALE]},
)
# UniDepth V2: points, and the camera matrix of the input with pixel centers at half-integers
WITH_CAMERA = (
    f"{RAYS}; Concat up vp z -> out axis=1; ReduceMax v -> h keepdims=1; Mul w half -> cx; Mul h half -> cy;"
    "Mul w zero -> o; Add o one -> i; Concat f o cx o f cy o o i -> row axis=3; Reshape row matrix -> intrinsics",
    OF_RAYS | {"half": 0.5, "matrix": np.array([1, 3, 3], np.int64)},
)


OPEN = ("h", "w")
PAIR = ("predicted_depth", "focallength_px")
# By name: the preset, mean and deviation, size, head, names of the input and of the outputs.
FILES: dict[str, tuple[str, Any, tuple[Any, Any], Any, str, tuple[str, ...]]] = {
    "dav2": ("depth-anything-v2", IMAGENET, OPEN, RELATIVE, "pixel_values", ("predicted_depth",)),
    "dav2 indoor": ("depth-anything-v2-metric", IMAGENET, OPEN, INDOOR, "pixel_values", ("predicted_depth",)),
    "dav2 outdoor": ("depth-anything-v2-metric", IMAGENET, (518, 518), OUTDOOR, "image", ("depth",)),
    "dpt": ("dpt", HALF, OPEN, RELATIVE, "pixel_values", ("predicted_depth",)),
    "midas": ("midas-v2.1-onnx", UNIT, (384, 384), RELATIVE, "0", ("797",)),
    "zoedepth": ("zoedepth", HALF, OPEN, TWO_BINS, "pixel_values", ("predicted_depth",)),
    "zoedepth fixed": ("zoedepth", HALF, (384, 512), TWO_BINS, "pixel_values", ("predicted_depth",)),
    "depth pro": ("depth-pro", HALF, (1536, 1536), CANONICAL, "image", ("canonical_inverse_depth", "fov_deg")),
    "depth pro meters": ("depth-pro", HALF, (1536, 1536), METERS, "pixel_values", PAIR),
    "moge-2": ("moge-2", UNIT, OPEN, POINTS, "image", ("points", "mask", "metric_scale")),
    "unidepth": ("unidepth-v2", IMAGENET, (462, 616), WITH_CAMERA, "rgbs", ("pts_3d", "intrinsics")),
    "metric3d": ("metric3d-v2", BYTES, (616, 1064), CLAMPED_RANGE, "image", ("pred_depth",)),
    "metric3d portrait": ("metric3d-v2", BYTES, (1064, 616), CLAMPED_RANGE, "pixel_values", ("predicted_depth",)),
    "metric3d convnext": ("metric3d-convnext", BYTES, (544, 1216), CLAMPED_RANGE, "image", ("pred_depth",)),
    "da3": ("depth-anything-3", IMAGENET, OPEN, EXPONENTIAL, "pixel_values", ("predicted_depth",)),
    "dav2 broken": ("depth-anything-v2-metric", IMAGENET, OPEN, CLIPPED, "image", ("depth",)),
}  # fmt: skip


def published(path: Path, name: str) -> Path:
    _, (mean, std), size, (head, constants), source, outputs = FILES[name]
    nodes = f"Identity {source} -> x; Conv x kernel bias -> z; {head}; Identity out -> {outputs[0]}"
    inputs = [(source, FLOAT, [1, 3, *size])]
    if name == "moge-2":
        inputs.append(("num_tokens", TensorProto.INT64, []))
        nodes += f"; Cast num_tokens -> tokens to={int(FLOAT)}"
    constants = {"kernel": (9 * std / 3).reshape(1, 3, 1, 1), "bias": [1 + 9 * mean.mean()], **constants}
    for key, value in constants.items():
        constants[key] = value if getattr(value, "dtype", None) == np.int64 else np.asarray(value, np.float32)
    used = {value for node in nodes_of(nodes) for value in node.input}
    constants = {key: value for key, value in {**constants, "axis": np.array([1], np.int64)}.items() if key in used}
    return save(path, nodes, inputs, [(output, FLOAT, None) for output in outputs], **constants)
