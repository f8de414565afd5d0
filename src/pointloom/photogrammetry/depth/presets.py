"""Presets of depth networks: input size, normalization, layout, meaning of the output.

From DepthAnything/Depth-Anything-V2 (metric_depth/), isl-org/MiDaS, YvanYin/Metric3D (onnx/),
ByteDance-Seed/Depth-Anything-3, apple/ml-depth-pro (Bochkovskii et al. 2024), isl-org/ZoeDepth and transformers'
zoedepth (Bhat et al. 2023), microsoft/MoGe's docs/onnx.md (Wang et al. 2025), lpiccinelli-eth/UniDepth's
models/unidepthv2/export.py. Values from their PyTorch code and assumptions are marked.
"""

from __future__ import annotations

import dataclasses

from ...core.checks import check_name
from .heads import BINS, CLAMPED, EXP, INVERSE, RECIPROCAL, SIGMOID

IMAGENET_MEAN, IMAGENET_STD = (0.485, 0.456, 0.406), (0.229, 0.224, 0.225)
ZERO_RGB, ONE_RGB, HALF_RGB = (0.0, 0.0, 0.0), (1.0, 1.0, 1.0), (0.5, 0.5, 0.5)

MAX_INPUT = 2**23  # maximum input pixels: 30 times the usual size. Attention over more needs 100 GB


@dataclasses.dataclass(frozen=True)
class Preset:
    """Interface of a family of networks.

    Args:
        name: Name of the preset.
        license: License of the weights.
        sizing: Input size for dynamic models. "lower": both sides at least `size`; "upper": at most; "minimal": the
            side with the least change becomes `size`. Then rounded to `multiple`. "area": same number of pixels,
            keeping the aspect. "exact": `fixed`, stretched. "pad": `fixed`, letterboxed with the mean.
        size: Rows and columns for `sizing` [px].
        multiple: Sides are multiples of this [px].
        fixed: Allowed sizes (rows, columns) of fixed inputs; empty: any multiple.
        fixed_pads: Fixed inputs are padded with the mean instead of stretched.
        levels: White level before normalization: 1 or 255.
        mean, std: Normalization, red, green, blue.
        output: "inverse": affine in 1 / z; "depth": proportional to z; "metric": meters, up to the focal length.
        focal: Focal length of a metric network [px]: z = output * f / focal, f of its input; None: output in meters.
        outputs: Names of the depth output if there are several.
        takes_views: The input may have five dimensions [1, views, 3, h, w].
        heads: Allowed ends of the graph (heads.py); empty: not checked.
        reading: Conversion of the outputs (network_outputs.py): "map", "canonical", "points" or "camera".
        others: Names of further outputs, by content.
        needed: Required ones among them.
        numbers: Integer inputs besides the image, by name.
        reflects: Dynamic inputs are padded by reflection.
    """

    name: str
    license: str
    sizing: str
    size: tuple[int, int]
    multiple: int
    fixed: tuple[tuple[int, int], ...] = ()
    fixed_pads: bool = False
    levels: float = 1.0
    mean: tuple[float, float, float] = IMAGENET_MEAN
    std: tuple[float, float, float] = IMAGENET_STD
    output: str = "inverse"
    focal: float | None = None
    outputs: tuple[str, ...] = ("predicted_depth", "depth")
    takes_views: bool = False
    heads: tuple[str, ...] = (INVERSE,)
    reading: str = "map"
    others: dict[str, tuple[str, ...]] = dataclasses.field(default_factory=dict)
    needed: tuple[str, ...] = ()
    numbers: dict[str, int] = dataclasses.field(default_factory=dict)
    reflects: bool = False

    @property
    def gives_scale(self) -> bool:
        """True if the output lacks a scale but no shift."""
        return self.output != "inverse"


def _midas(name: str, side: int, *, inside: bool) -> Preset:
    """MiDaS v2.1; `inside` for the ONNX files of its release, which normalize internally and have a fixed size."""
    license = "MIT"
    if inside:
        return Preset(name, license, "exact", (side, side), 32, fixed=((side, side),), mean=ZERO_RGB, std=ONE_RGB)
    return Preset(name, license, "upper", (side, side), 32)


_DA3_APACHE = "Apache-2.0 (Large, Giant and Nested: CC-BY-NC-4.0)"

# Depth Anything 3: sizes of its `upper_bound_resize` at 504. Fixed inputs are padded by the mean as in its ONNX page.
# Assumed: sides rounded to the nearest multiple, confidence and sky not needed, relative depth without shift, focal
# length of the metric model as of the input.
_DEPTH_ANYTHING_3 = {
    "sizing": "upper", "size": (504, 504), "multiple": 14, "fixed_pads": True, "takes_views": True, "heads": (EXP,),
}  # fmt: skip

# Metric3D: 0..255, as its ONNX export normalizes inside. Portrait canvases are from third-party exports.
_METRIC3D_OPTIONS = {
    "sizing": "pad", "fixed_pads": True, "levels": 255.0, "mean": ZERO_RGB, "std": ONE_RGB, "output": "metric",
    "focal": 1000.0, "outputs": ("predicted_depth", "pred_depth", "depth"),
}  # fmt: skip

# Depth Pro: 1536 x 1536, stretched; canonical inverse depth c with z = (f / w) / c, f and w along x of the image. Some
# exports output meters by the network's own focal length.
_DEPTH_PRO = {"focal": ("focallength_px",), "view": ("field_of_view", "fov_deg")}

# MoGe-2 normalizes inside. 3600 tokens of 14 x 14 pixels are the maximum of its `infer`.
MOGE_TOKENS = 3600

NETWORK_PRESETS = {
    preset.name: preset
    for preset in (
        Preset(
            "depth-anything-v2", "Apache-2.0 (Small; Base, Large and Giant: CC-BY-NC-4.0)", "lower", (518, 518), 14
        ),
        _midas("midas-v2.1", 384, inside=False),
        _midas("midas-v2.1-small", 256, inside=False),
        _midas("midas-v2.1-onnx", 384, inside=True),
        _midas("midas-v2.1-small-onnx", 256, inside=True),
        Preset("dpt", "MIT", "minimal", (384, 384), 32, mean=HALF_RGB, std=HALF_RGB),
        Preset(
            "depth-anything-v2-metric", "Apache-2.0 (Small; Base and Large: CC-BY-NC-4.0)", "lower", (518, 518), 14,
            output="metric", heads=(SIGMOID,),
        ),
        Preset(
            "zoedepth", "MIT", "minimal", (384, 512), 32, mean=HALF_RGB, std=HALF_RGB, output="metric", heads=(BINS,),
            outputs=("predicted_depth", "metric_depth", "depth"), reflects=True,
        ),
        Preset(
            "depth-pro", "apple-amlr (research only)", "exact", (1536, 1536), 1536, fixed=((1536, 1536),),
            mean=HALF_RGB, std=HALF_RGB, output="metric", focal=1536.0, heads=(INVERSE, RECIPROCAL),
            reading="canonical", outputs=("predicted_depth", "canonical_inverse_depth", "depth"), others=_DEPTH_PRO,
        ),
        Preset(
            "moge-2", "MIT", "area", (840, 840), 1, fixed_pads=True, mean=ZERO_RGB, std=ONE_RGB, output="metric",
            heads=(), reading="points", outputs=("points",), others={"scale": ("metric_scale",), "mask": ("mask",)},
            needed=("scale",), numbers={"num_tokens": MOGE_TOKENS},
        ),
        Preset(
            "unidepth-v2", "CC-BY-NC-4.0", "area", (462, 630), 14, fixed_pads=True, output="metric", heads=(),
            reading="camera", outputs=("pts_3d", "depth"), others={"camera": ("intrinsics", "out_K", "K")},
            needed=("camera",),
        ),
        Preset(
            "metric3d-v2", "BSD-2-Clause", size=(616, 1064), multiple=14, fixed=((616, 1064), (1064, 616)),
            heads=(CLAMPED,), **_METRIC3D_OPTIONS,
        ),
        Preset(
            "metric3d-convnext", "BSD-2-Clause", size=(544, 1216), multiple=32, fixed=((544, 1216), (1216, 544)),
            heads=(BINS, CLAMPED), **_METRIC3D_OPTIONS,
        ),
        Preset("depth-anything-3", _DA3_APACHE, **_DEPTH_ANYTHING_3, output="depth"),
        Preset("depth-anything-3-metric", "Apache-2.0", **_DEPTH_ANYTHING_3, output="metric", focal=300.0),
    )
}  # fmt: skip

DEFAULT = "depth-anything-v2"


def find_preset(name: str) -> Preset:
    """The preset of this name. TypeError or ValueError (with the known names) otherwise."""
    if check_name("preset", name) not in NETWORK_PRESETS:
        raise ValueError(f"preset: expected one of {', '.join(NETWORK_PRESETS)}, got {name!r}")
    return NETWORK_PRESETS[name]


def input_size(preset: Preset, height: int, width: int) -> tuple[int, int]:
    """Input rows and columns for an image and a dynamic model. ValueError if the input would be huge."""
    rows, columns, step = *preset.size, preset.multiple
    if preset.sizing in ("exact", "pad"):
        return rows, columns
    across, down = columns / width, rows / height
    if preset.sizing == "area":
        across = down = (across * down) ** 0.5
    if preset.sizing == "lower":
        across = down = max(across, down)
    elif preset.sizing == "upper":
        across = down = min(across, down)
    elif preset.sizing == "minimal":
        across = down = across if abs(1 - across) < abs(1 - down) else down
    sides = []
    for wanted, limit in ((down * height, rows), (across * width, columns)):
        side = max(round(wanted / step), 1) * step
        if preset.sizing == "lower" and side < limit:
            side = -(-limit // step) * step
        if preset.sizing == "upper" and side > limit:
            side = limit // step * step
        sides.append(side)
    if sides[0] * sides[1] > MAX_INPUT:
        raise ValueError(
            f"image: {width} x {height} pixels are too narrow: {preset.name} would resize it to {sides[1]} x "
            f"{sides[0]}; crop it"
        )
    return sides[0], sides[1]
