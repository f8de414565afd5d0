"""What each depth network expects and gives: size of its input, normalisation, layout, the meaning of its output.

Held against the networks' own repositories where they say it; what was taken over from their PyTorch code or is
assumed is said at the preset. Sizes are chosen as there; resizing itself is this package's (inputs.py). Repositories:
DepthAnything/Depth-Anything-V2 (metric_depth/), isl-org/MiDaS, YvanYin/Metric3D (onnx/),
ByteDance-Seed/Depth-Anything-3, apple/ml-depth-pro (Bochkovskii et al. 2024), isl-org/ZoeDepth and
transformers' zoedepth (Bhat et al. 2023), microsoft/MoGe (docs/onnx.md; Wang et al. 2025),
lpiccinelli-eth/UniDepth (models/unidepthv2/export.py).
"""

from __future__ import annotations

import dataclasses

from ...core.checks import check_name
from .heads import BINS, CLAMPED, EXP, INVERSE, RECIPROCAL, SIGMOID

IMAGENET_MEAN, IMAGENET_STD = (0.485, 0.456, 0.406), (0.229, 0.224, 0.225)
ZERO, ONE, HALF = (0.0, 0.0, 0.0), (1.0, 1.0, 1.0), (0.5, 0.5, 0.5)

MOST_INPUT = 2**23  # pixels of a network's input: 30 times its usual size; attention over more wants 100 GB


@dataclasses.dataclass(frozen=True)
class Preset:
    """How to speak to one family of networks.

    Args:
        name: What users call it.
        licence: Of the weights, and which of them.
        sizing: How a picture's size becomes that of the input, where the model leaves it open. "lower": both sides at
            least `size`; "upper": at most; "minimal": the side that needs the least change becomes `size`; each then a
            multiple of `multiple`. "area": as many pixels, the picture's shape kept. "exact": the one size of `fixed`,
            the picture stretched. "pad": the same, the picture as large as fits in, and the mean around it.
        size: Rows and columns that `sizing` speaks of [px].
        multiple: Sides are multiples of this [px].
        fixed: Sizes (rows, columns) that a model with a fixed input may have; none for any multiple.
        fixed_pads: A model with a fixed input gets the picture with the mean around it, and not stretched.
        levels: What white is before the normalisation: 1 or 255.
        mean, std: Of the normalisation, red, green, blue.
        output: "inverse": grows with 1 / z, up to a scale and a shift; "depth": grows with z, up to a scale;
            "metric": metres, up to the focal length.
        focal: Of the camera that a metric network was made for [px]: z = output * f / focal, f as of its input. None
            of those that give metres by themselves.
        outputs: Names of the output that holds depth, where a model has several.
        takes_views: The input may have five dimensions [1, views, 3, h, w].
        heads: What the graph may end in (heads.py); none where it is not looked at.
        reading: How outputs become a map (readings.py): "map", "canonical", "points" or "camera".
        others: Names of outputs beside the depth, by what they hold.
        needed: Which of those a model must have.
        numbers: Inputs beside the picture, whole numbers by their names.
        reflects: The picture goes in with its own reflection around it, where the input's size is open.
    """

    name: str
    licence: str
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
        """Whether only a scale lacks, and no shift, between what it gives and depth."""
        return self.output != "inverse"


def _midas(name: str, side: int, *, inside: bool) -> Preset:
    """MiDaS v2.1; `inside` for the ONNX files of its release, which normalise by themselves and have one size."""
    licence = "MIT"
    if inside:
        return Preset(name, licence, "exact", (side, side), 32, fixed=((side, side),), mean=ZERO, std=ONE)
    return Preset(name, licence, "upper", (side, side), 32)


_DA3_APACHE = "Apache-2.0 (Large, Giant and Nested: CC-BY-NC-4.0)"

# Depth Anything 3: the sizes are those of its `upper_bound_resize` at 504; fixed inputs are padded by the mean as its
# ONNX page says. Assumed: sides are rounded to the nearest multiple, the confidence and the sky beside the depth are
# not needed, relative depth lacks no shift, and the metric model's focal length is that of the picture as it goes in.
_DA3 = {
    "sizing": "upper", "size": (504, 504), "multiple": 14, "fixed_pads": True, "takes_views": True, "heads": (EXP,),
}  # fmt: skip

# Metric3D: 0..255 in, as its ONNX export normalises inside. Portrait canvases are those of others' exports.
_METRIC3D = {
    "sizing": "pad", "fixed_pads": True, "levels": 255.0, "mean": ZERO, "std": ONE, "output": "metric", "focal": 1000.0,
    "outputs": ("predicted_depth", "pred_depth", "depth"),
}  # fmt: skip

# Depth Pro: 1536 x 1536, stretched. It gives canonical inverse depth c, and z = (f / w) / c with f and w of the picture
# along x; some exports go on to metres by the network's own focal length.
_DEPTH_PRO = {"focal": ("focallength_px",), "view": ("field_of_view", "fov_deg")}

# MoGe-2: normalises inside. 3600 tokens are the most that its `infer` asks for, of 14 x 14 pixels each: a larger
# picture would be made smaller inside.
MOGE_TOKENS = 3600

PRESETS = {
    preset.name: preset
    for preset in (
        Preset(
            "depth-anything-v2", "Apache-2.0 (Small; Base, Large and Giant: CC-BY-NC-4.0)", "lower", (518, 518), 14
        ),
        _midas("midas-v2.1", 384, inside=False),
        _midas("midas-v2.1-small", 256, inside=False),
        _midas("midas-v2.1-onnx", 384, inside=True),
        _midas("midas-v2.1-small-onnx", 256, inside=True),
        Preset("dpt", "MIT", "minimal", (384, 384), 32, mean=HALF, std=HALF),
        Preset(
            "depth-anything-v2-metric", "Apache-2.0 (Small; Base and Large: CC-BY-NC-4.0)", "lower", (518, 518), 14,
            output="metric", heads=(SIGMOID,),
        ),
        Preset(
            "zoedepth", "MIT", "minimal", (384, 512), 32, mean=HALF, std=HALF, output="metric", heads=(BINS,),
            outputs=("predicted_depth", "metric_depth", "depth"), reflects=True,
        ),
        Preset(
            "depth-pro", "apple-amlr (research only)", "exact", (1536, 1536), 1536, fixed=((1536, 1536),), mean=HALF,
            std=HALF, output="metric", focal=1536.0, heads=(INVERSE, RECIPROCAL), reading="canonical",
            outputs=("predicted_depth", "canonical_inverse_depth", "depth"), others=_DEPTH_PRO,
        ),
        Preset(
            "moge-2", "MIT", "area", (840, 840), 1, fixed_pads=True, mean=ZERO, std=ONE, output="metric", heads=(),
            reading="points", outputs=("points",), others={"scale": ("metric_scale",), "mask": ("mask",)},
            needed=("scale",), numbers={"num_tokens": MOGE_TOKENS},
        ),
        Preset(
            "unidepth-v2", "CC-BY-NC-4.0", "area", (462, 630), 14, fixed_pads=True, output="metric", heads=(),
            reading="camera", outputs=("pts_3d", "depth"), others={"camera": ("intrinsics", "out_K", "K")},
            needed=("camera",),
        ),
        Preset(
            "metric3d-v2", "BSD-2-Clause", size=(616, 1064), multiple=14, fixed=((616, 1064), (1064, 616)),
            heads=(CLAMPED,), **_METRIC3D,
        ),
        Preset(
            "metric3d-convnext", "BSD-2-Clause", size=(544, 1216), multiple=32, fixed=((544, 1216), (1216, 544)),
            heads=(BINS, CLAMPED), **_METRIC3D,
        ),
        Preset("depth-anything-3", _DA3_APACHE, **_DA3, output="depth"),
        Preset("depth-anything-3-metric", "Apache-2.0", **_DA3, output="metric", focal=300.0),
    )
}  # fmt: skip

DEFAULT = "depth-anything-v2"


def find_preset(name: str) -> Preset:
    """The preset of this name.

    Raises:
        TypeError: No string.
        ValueError: None is called so; lists those that there are.
    """
    if check_name("preset", name) not in PRESETS:
        raise ValueError(f"preset: expected one of {', '.join(PRESETS)}, got {name!r}")
    return PRESETS[name]


def input_size(preset: Preset, height: int, width: int) -> tuple[int, int]:
    """Rows and columns of the input for a picture, where the model leaves them open.

    Raises:
        ValueError: The picture is so narrow that the input would be huge.
    """
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
    if sides[0] * sides[1] > MOST_INPUT:
        raise ValueError(
            f"picture: {width} x {height} pixels are so narrow that {preset.name} would work on {sides[1]} x "
            f"{sides[0]}; crop it"
        )
    return sides[0], sides[1]
