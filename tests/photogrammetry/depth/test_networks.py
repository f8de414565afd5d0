"""Inputs and outputs of the networks of each preset, images of all kinds, and models that do not match."""

import math
import sys

import numpy as np
import onnx
import pytest
from onnx import TensorProto
from PIL import Image, ImageOps

import pointloom as loom
from pointloom.cli.shell import depth_command
from pointloom.photogrammetry import DepthModel
from pointloom.photogrammetry.depth import network
from pointloom.photogrammetry.depth.photos import camera_of, take_photo
from pointloom.photogrammetry.depth.presets import IMAGENET_MEAN, IMAGENET_STD, NETWORK_PRESETS, input_size

from .tiny_networks import FLOAT, busy, fixed_map, in_strides, linear, save, seen_by, with_mean

SIZES = {  # of an input for 640 x 480, 480 x 640, 1920 x 1080, 100 x 100: rows and columns, by the networks' own code
    "depth-anything-v2": [(518, 686), (686, 518), (518, 924), (518, 518)],
    "midas-v2.1": [(288, 384), (384, 288), (224, 384), (384, 384)],
    "midas-v2.1-small": [(192, 256), (256, 192), (128, 256), (256, 256)],
    "midas-v2.1-onnx": [(384, 384)] * 4,
    "midas-v2.1-small-onnx": [(256, 256)] * 4,
    "dpt": [(384, 512), (512, 384), (384, 672), (384, 384)],
    "depth-anything-v2-metric": [(518, 686), (686, 518), (518, 924), (518, 518)],
    "zoedepth": [(384, 512), (672, 512), (384, 672), (384, 384)],
    "depth-pro": [(1536, 1536)] * 4,
    "moge-2": [(727, 970), (970, 727), (630, 1120), (840, 840)],
    "unidepth-v2": [(462, 616), (616, 462), (406, 714), (546, 546)],
    "metric3d-v2": [(616, 1064)] * 4,
    "metric3d-convnext": [(544, 1216)] * 4,
    "depth-anything-3": [(378, 504), (504, 378), (280, 504), (504, 504)],
    "depth-anything-3-metric": [(378, 504), (504, 378), (280, 504), (504, 504)],
}


@pytest.mark.parametrize("name", NETWORK_PRESETS)
def test_the_input_has_the_size_of_the_network(name):
    sizes = [input_size(NETWORK_PRESETS[name], *size) for size in ((480, 640), (640, 480), (1080, 1920), (100, 100))]
    assert sizes == SIZES[name]


def test_the_command_offers_every_preset():
    assert tuple(NETWORK_PRESETS) == depth_command.PRESETS
    assert "Apache-2.0" in NETWORK_PRESETS[depth_command.PRESETS[0]].license


def image_of(size, seed=0):
    return np.random.default_rng(seed).integers(0, 256, (*size, 3), dtype=np.uint8)


@pytest.mark.parametrize("name", NETWORK_PRESETS)
def test_the_normalization_matches_the_code_of_the_network(name):
    preset, imagenet = NETWORK_PRESETS[name], ((0.485, 0.456, 0.406), (0.229, 0.224, 0.225))
    own = {"dpt": ((0.5,) * 3, (0.5,) * 3), "metric3d-v2": ((0.0,) * 3, (1.0,) * 3)}
    own |= {"zoedepth": own["dpt"], "depth-pro": own["dpt"], "metric3d-convnext": own["metric3d-v2"]}
    own["moge-2"] = own["metric3d-v2"]
    own |= {f"midas-v2.1{size}-onnx": ((0.0,) * 3, (1.0,) * 3) for size in ("", "-small")}
    assert (preset.mean, preset.std) == own.get(name, imagenet)
    assert preset.levels == (255 if name.startswith("metric3d") else 1)


def test_resized_inputs_stay_within_the_range_of_the_image(tmp_path):
    model = loom.photogrammetry.DepthModel(linear(tmp_path / "m.onnx", weights=(1, 0, 0)), "midas-v2.1-small-onnx")
    image = np.zeros((40, 40, 3), np.uint8)
    image[:, 20:] = 255  # bicubic kernels go beyond at such edges
    values = model.run(image)
    assert (values.min(), values.max()) == (0, 1)


@pytest.mark.parametrize("name", ["depth-anything-v2", "midas-v2.1-onnx", "dpt", "depth-anything-3"])
def test_inputs_are_normalized_by_the_preset(name, tmp_path):
    preset = NETWORK_PRESETS[name]
    size = (384, 512) if name == "dpt" else input_size(preset, 480, 640)
    model = loom.photogrammetry.DepthModel(
        linear(tmp_path / "m.onnx", size=size, squeeze=True, views=preset.takes_views), name
    )
    image = image_of(size)
    values, placement = model._run_with_placement(image)
    assert (placement.rows, placement.columns) == placement.used == size
    np.testing.assert_allclose(values, seen_by(preset, image), rtol=1e-5, atol=2e-5 * preset.levels)


@pytest.mark.parametrize("name", ["depth-anything-v2", "midas-v2.1-small", "dpt", "depth-anything-3"])
def test_a_model_of_any_size_gets_that_of_the_preset(name, tmp_path):
    preset = NETWORK_PRESETS[name]
    model = loom.photogrammetry.DepthModel(linear(tmp_path / "m.onnx"), name)
    u, v = np.meshgrid(np.arange(200), np.arange(150))
    image = np.stack([u, v, 255 - v], -1).astype(np.uint8)
    values, placement = model._run_with_placement(image)
    assert (placement.rows, placement.columns) == input_size(preset, 150, 200)
    assert values.shape == (150, 200)
    error = np.abs(values - seen_by(preset, image)) / preset.levels * preset.std[0]
    assert error.max() < 0.004  # a level of 255: ramps come back where they were, to the borders


def test_a_strided_map_covers_the_image_to_its_borders(tmp_path):
    model = loom.photogrammetry.DepthModel(in_strides(tmp_path / "m.onnx"), "depth-anything-v2")
    ramp = np.tile(np.linspace(0, 250, 500), (500, 1)).astype(np.uint8)
    values, placement = model._run_with_placement(np.repeat(ramp[..., None], 3, 2))
    assert (placement.rows, placement.columns) == (518, 518)
    assert values.shape == (500, 500)
    gray = np.mean([(ramp[250] / 255 - mean) / std for mean, std in zip(IMAGENET_MEAN, IMAGENET_STD, strict=True)], 0)
    cell = 14 * 500 / 518  # pixels per output value
    assert np.abs(values[250] - gray).max() < 0.6 * cell * (gray[499] - gray[0]) / 499


def test_inputs_of_fixed_sizes_and_of_half_precision_are_taken_as_they_are(tmp_path):
    image = image_of((28, 42))
    for kind, limit in ((FLOAT, 1e-5), (TensorProto.FLOAT16, 5e-3)):
        model = loom.photogrammetry.DepthModel(linear(tmp_path / "m.onnx", size=(28, 42), kind=kind))
        values = model._run_with_placement(image)[0]
        np.testing.assert_allclose(values, seen_by(NETWORK_PRESETS[model.preset], image), atol=limit)
    model = loom.photogrammetry.DepthModel(linear(tmp_path / "m.onnx", size=(28, 42)))
    assert model._run_with_placement(image_of((100, 70)))[0].shape == (100, 70)
    half = loom.photogrammetry.DepthModel(linear(tmp_path / "half.onnx", size=(28, "w")))
    assert (half._placement(100, 100).rows, half._placement(100, 100).columns) == (28, 518)


def test_borders_are_filled_with_the_mean_color(tmp_path):
    model = loom.photogrammetry.DepthModel(with_mean(tmp_path / "m.onnx", (616, 1064)), "metric3d-v2")
    image = np.full((300, 400, 3), 10, np.uint8)
    image[:, 200:] = 20
    placement = model._placement(300, 400)
    assert placement.used == (616, 821)
    assert (placement.top, placement.left) == (0, 121)
    fraction = 821 / 1064
    mean = 15 * fraction + 123.675 * (1 - fraction)
    values, _ = model._run_with_placement(image)
    assert values[150, 20] == pytest.approx(10 + mean, abs=0.02)
    assert values[150, 380] == pytest.approx(20 + mean, abs=0.02)


def test_square_exports_of_depth_anything_3_see_undistorted_images(tmp_path):
    model = loom.photogrammetry.DepthModel(with_mean(tmp_path / "m.onnx", (504, 504)), "depth-anything-3")
    assert model._placement(1080, 1920).used == (283, 504)
    image = np.full((100, 200, 3), 200, np.uint8)
    image[0, 0] = 0
    values, placement = model._run_with_placement(image)
    red = (200 / 255 - 0.485) / 0.229
    assert placement.used == (252, 504)
    assert values[50, 100] == pytest.approx(red + red / 2, abs=1e-3)  # the mean around it is 0 once normalized


def flat_estimate(tmp_path, name, image, focal, **options):
    """The estimate of a network that returns the red channel, 0..levels before normalization."""
    preset = NETWORK_PRESETS[name]
    weights = (preset.std[0] / preset.levels * 255, 0, 0)
    offset = preset.mean[0] / preset.levels * 255
    views = preset.takes_views
    path = linear(tmp_path / "red.onnx", weights=weights, offset=offset, views=views)
    height, width = image.shape[:2]
    fx, fy = 0.9 * focal, 1.1 * focal  # of mean focal
    camera = loom.PinholeCameraIntrinsic(width, height, fx, fy, (width - 1) / 2, (height - 1) / 2)
    return loom.photogrammetry.estimate_depth(image, DepthModel(path, name), intrinsic=camera, **options)


def two_reds(size, near, far):
    image = np.full((*size, 3), near, np.uint8)
    image[:, size[1] // 2 :] = far
    return image


def test_depth_anything_3_metric_divides_by_300(tmp_path):
    for factor in (1, 2):
        size = 504 // factor, 504 // factor
        result = flat_estimate(tmp_path, "depth-anything-3-metric", two_reds(size, 10, 20), 600.0 / factor)
        assert result.is_metric
        assert result.depth[5, 5] == pytest.approx(10 * 600 / 300, rel=1e-4)
        assert result.depth[5, -5] == pytest.approx(20 * 600 / 300, rel=1e-4)


def test_meters_require_a_known_focal_length(tmp_path):
    path = linear(tmp_path / "m.onnx", offset=1.0)
    result = loom.photogrammetry.estimate_depth(two_reds((300, 400), 10, 20), DepthModel(path, "metric3d-v2"))
    assert not result.is_metric
    assert (result.unit, result.intrinsic_source) == ("arbitrary", "assumed 60 degrees")
    assert result.intrinsic.fx == pytest.approx(200 / np.tan(np.radians(30)))


@pytest.mark.parametrize(
    ("name", "side", "reds", "depth"),
    [
        ("depth-anything-v2", 518, (200, 50), (1, 10)),  # inverse depth runs from 1 to 10
        ("dpt", 384, (200, 50), (1, 10)),
        ("depth-anything-3", 504, (50, 200), (1, 4)),  # relative depth keeps its ratios
    ],
)
def test_depth_without_references_has_an_arbitrary_unit(tmp_path, name, side, reds, depth):
    result = flat_estimate(tmp_path, name, two_reds((side, side), *reds), 300.0)
    assert (result.is_metric, result.unit) == (False, "arbitrary")
    assert (result.depth[5, 5], result.depth[5, -5]) == pytest.approx(depth, rel=1e-3)
    if name == "depth-anything-3":
        assert result.shift == 0
    else:
        np.testing.assert_allclose(1 / (result.scale * np.array(reds) + result.shift), depth, rtol=1e-3)


def of_nodes(path, nodes, shape, out, kind=FLOAT, inputs=("x",), outputs=("y",)):
    return save(path, nodes, [(name, kind, shape) for name in inputs], [(name, kind, out) for name in outputs])


HW = ["h", "w"]
MEANS = "ReduceMean x -> normal axes=[1] keepdims=1; ReduceMean x -> mask axes=[1] keepdims=1"
MODELS = {  # nodes, shapes of the input and of the output, the reason, and more options
    "two inputs": ("Add image mask -> y", [1, 3, *HW], [1, 3, *HW], "the image, got image, mask", ("image", "mask")),
    "colors last": ("ReduceMean x -> y axes=[3] keepdims=0", [1, *HW, 3], [1, *HW], "expected [1, 3, h, w]"),
    "one color": ("Relu x -> y", [1, 1, *HW], [1, 1, *HW], "expected [1, 3, h, w]"),
    "three dimensions": ("Relu x -> y", [3, *HW], [3, *HW], "expected [1, 3, h, w]"),
    "a batch of 4": ("Relu x -> y", [4, 3, *HW], [4, 3, *HW], "expected [1, 3, h, w]"),
    "two maps": (MEANS, [1, 3, *HW], [1, 1, *HW], "got normal, mask", ("x",), ("normal", "mask")),
    "a class": ("ReduceMean x -> y axes=[2,3] keepdims=0", [1, 3, *HW], [1, 3], "of floats for"),
}


@pytest.mark.parametrize("title", MODELS)
def test_a_model_of_another_preset_is_rejected_when_opened(title, tmp_path):
    nodes, shape, out, reason, *names = MODELS[title]
    with pytest.raises(loom.FileError, match=r"m\.onnx") as error:
        loom.photogrammetry.DepthModel(of_nodes(tmp_path / "m.onnx", nodes, shape, out, FLOAT, *names))
    assert reason in str(error.value)


def test_a_model_of_bytes_or_of_another_size_is_rejected_when_opened(tmp_path):
    nodes, kind = "ReduceMax x -> y axes=[1] keepdims=0", TensorProto.UINT8
    with pytest.raises(loom.FileError, match=r"m\.onnx.*expected floats"):
        loom.photogrammetry.DepthModel(of_nodes(tmp_path / "m.onnx", nodes, [1, 3, *HW], [1, *HW], kind))
    with pytest.raises(loom.FileError, match=r"m\.onnx.*is the default; another network: --preset"):
        loom.photogrammetry.DepthModel(linear(tmp_path / "m.onnx", size=(500, 518)))


def test_a_model_of_another_size_than_the_preset_s_is_refused(tmp_path):
    path = linear(tmp_path / "m.onnx", size=(384, 384))
    assert loom.photogrammetry.DepthModel(path, "midas-v2.1").preset == "midas-v2.1"
    with pytest.raises(loom.FileError, match=r"/m\.onnx \(input 'x'\):.*256.*256.*midas-v2\.1-small-onnx.*384.*384"):
        loom.photogrammetry.DepthModel(path, "midas-v2.1-small-onnx")
    with pytest.raises(loom.FileError, match=r"616 x 1064.* for metric3d-v2"):
        loom.photogrammetry.DepthModel(path, "metric3d-v2")
    with pytest.raises(loom.FileError, match="for dpt"):  # only Depth Anything 3 has views
        loom.photogrammetry.DepthModel(linear(tmp_path / "views.onnx", views=True), "dpt")


def test_a_map_of_another_size_than_its_input_is_an_error(tmp_path):
    model = loom.photogrammetry.DepthModel(in_strides(tmp_path / "m.onnx", 16))
    with pytest.raises(loom.FileError, match=r"/m\.onnx \(output 'depth'\):.*518.*518.*1.*1.*512.*512"):
        model._run_with_placement(image_of((100, 100)))


@pytest.mark.parametrize(
    ("value", "reason"), [(np.nan, "NaN or infinite"), (np.inf, "NaN or infinite"), (3.0, "3 for every pixel")]
)
def test_a_map_without_depth_is_an_error(tmp_path, value, reason):
    values = np.linspace(1, 2, 518 * 518).reshape(518, 518)
    values[::7] = value
    model = loom.photogrammetry.DepthModel(
        fixed_map(tmp_path / "m.onnx", np.full((518, 518), 3.0) if value == 3 else values)
    )
    with pytest.raises(loom.FileError, match=reason):
        model._run_with_placement(image_of((100, 100)))


def test_metric_depth_that_is_never_positive_is_an_error(tmp_path):
    path = linear(tmp_path / "m.onnx", offset=-1e4)
    with pytest.raises(loom.FileError, match=r"/m\.onnx:.*0"):
        loom.photogrammetry.estimate_depth(image_of((50, 50)), DepthModel(path, "depth-anything-3-metric"))


def test_files_that_are_no_models_are_rejected_with_advice(tmp_path):
    good = linear(tmp_path / "good.onnx").read_bytes()
    contents = {
        "random": np.random.default_rng(0).bytes(5000), "text": b"weights: none\n" * 20, "cut": good[: len(good) // 2],
        "empty": b"", "tail": good + b"\xff" * 7,
    }  # fmt: skip
    for name, content in contents.items():
        path = tmp_path / f"{name}.onnx"
        path.write_bytes(content)
        with pytest.raises(loom.FileError, match=f"{name}.onnx") as error:
            loom.photogrammetry.DepthModel(path)
        assert "onnxruntime_src" not in str(error.value)
    with pytest.raises(loom.FileError, match="is a folder"):
        loom.photogrammetry.DepthModel(tmp_path)
    with pytest.raises(loom.FileError, match=r"/none\.onnx:"):
        loom.photogrammetry.DepthModel(tmp_path / "none.onnx")


@pytest.mark.parametrize("name", [b"side", b"depth", b"Conv"])
def test_a_name_that_is_no_text_is_rejected_without_a_banner(tmp_path, capsys, name):
    data = linear(tmp_path / "good.onnx", size=("side", "w")).read_bytes()
    path = tmp_path / "bad.onnx"
    path.write_bytes(data.replace(name, b"\xff" + name[1:]))
    with pytest.raises(loom.FileError, match=r"bad\.onnx"):
        loom.photogrammetry.DepthModel(path)
    assert capsys.readouterr().out == ""


def test_a_model_of_a_newer_format_requires_an_update(tmp_path):
    model = onnx.load(linear(tmp_path / "m.onnx"))
    model.ir_version = 99
    (tmp_path / "later.onnx").write_bytes(model.SerializeToString())
    with pytest.raises(loom.FileError, match="Update onnxruntime"):
        loom.photogrammetry.DepthModel(tmp_path / "later.onnx")


def test_external_weights_are_read_from_the_folder_of_the_model(tmp_path):
    model = onnx.load(linear(tmp_path / "m.onnx", size=(28, 42)))
    onnx.save(model, tmp_path / "split.onnx", save_as_external_data=True, location="split.onnx_data", size_threshold=0)
    image = image_of((28, 42))
    expected = loom.photogrammetry.DepthModel(tmp_path / "m.onnx")._run_with_placement(image)[0]
    np.testing.assert_array_equal(
        loom.photogrammetry.DepthModel(tmp_path / "split.onnx")._run_with_placement(image)[0], expected
    )
    (tmp_path / "split.onnx_data").unlink()
    with pytest.raises(loom.FileError, match=r"/split\.onnx:"):
        loom.photogrammetry.DepthModel(tmp_path / "split.onnx")


@pytest.mark.parametrize("package", ["onnx", "onnxruntime"])
def test_without_the_extra_the_error_names_it(package, tmp_path, monkeypatch):
    path = linear(tmp_path / "m.onnx")
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(loom.FileError, match=r"/m\.onnx:"):
        loom.photogrammetry.DepthModel(path)


def test_missing_cuda_is_an_error_without_fallback_to_the_cpu(tmp_path, monkeypatch):
    import onnxruntime

    path = linear(tmp_path / "m.onnx")
    assert loom.photogrammetry.DepthModel(path).provider == "CPUExecutionProvider"
    assert loom.photogrammetry.DepthModel(path, device="auto").provider == "CPUExecutionProvider"
    with pytest.raises(loom.DeviceError, match=r"^device:"):
        loom.photogrammetry.DepthModel(path, device="cuda:0")
    with pytest.raises(loom.DeviceError, match="device:"):
        loom.photogrammetry.DepthModel(path, device="tpu")
    # CUDA by name, but its libraries are missing: onnxruntime goes on with the CPU
    both = ["CUDAExecutionProvider", "CPUExecutionProvider"]
    monkeypatch.setattr(onnxruntime, "get_available_providers", lambda: both)
    monkeypatch.setattr(network, "resolve_device", lambda _: _Cuda)
    with pytest.raises(loom.DeviceError, match=r"^device:"):
        loom.photogrammetry.DepthModel(path, device="cuda")
    assert loom.photogrammetry.DepthModel(path, device="auto").provider == "CPUExecutionProvider"


class _Cuda:
    is_cuda, ordinal = True, 0


@pytest.mark.slow
def test_results_are_bitwise_identical_for_any_number_of_threads(tmp_path):
    path, image = busy(tmp_path / "m.onnx"), image_of((200, 300))
    first = loom.photogrammetry.DepthModel(path, threads=1)._run_with_placement(image)[0]
    for threads in (1, 2, None):
        np.testing.assert_array_equal(
            loom.photogrammetry.DepthModel(path, threads=threads)._run_with_placement(image)[0], first
        )


UPRIGHT = np.random.default_rng(0).integers(0, 256, (24, 40), dtype=np.uint8).repeat(8, 0).repeat(8, 1)
RGB = np.stack([UPRIGHT, 255 - UPRIGHT, UPRIGHT // 2], -1)

# Stored pixels for each orientation that give this image upright.
STORED = {
    1: RGB, 2: RGB[:, ::-1], 3: RGB[::-1, ::-1], 4: RGB[::-1], 5: RGB.transpose(1, 0, 2),
    6: np.rot90(RGB, 1), 7: np.rot90(RGB, 2).transpose(1, 0, 2), 8: np.rot90(RGB, -1),
}  # fmt: skip


def exif(**tags):
    made = Image.Exif()
    if "orientation" in tags:
        made[0x0112] = tags.pop("orientation")
    inner = made.get_ifd(0x8769)
    for name, value in tags.items():
        inner[{"f35": 0xA405, "mm": 0x920A, "plane": 0xA20E, "unit": 0xA210, "width": 0xA002}[name]] = value
    return made


@pytest.mark.parametrize(("orientation", "suffix"), [*((each, "png") for each in STORED), (6, "jpg")])
def test_exif_rotates_images_upright(tmp_path, orientation, suffix):
    path = tmp_path / f"photo.{suffix}"
    options = {"quality": 100, "subsampling": 0} if suffix == "jpg" else {}
    stored = np.ascontiguousarray(STORED[orientation])
    Image.fromarray(stored).save(path, exif=exif(orientation=orientation), **options)
    photo = take_photo(path)
    np.testing.assert_allclose(photo.color.astype(int), RGB, atol=8 if suffix == "jpg" else 0)
    assert photo.is_rotated == (orientation > 4)
    with Image.open(path) as image:
        np.testing.assert_array_equal(photo.color, np.asarray(ImageOps.exif_transpose(image)))


def test_a_rotated_jpeg_requires_an_upright_camera(tmp_path):
    path = tmp_path / "photo.jpg"
    Image.fromarray(np.ascontiguousarray(STORED[6])).save(path, exif=exif(orientation=6))
    model = linear(tmp_path / "m.onnx", size=(28, 28))
    assert loom.photogrammetry.estimate_depth(path, model).depth.shape == RGB.shape[:2]
    stored = loom.PinholeCameraIntrinsic(192, 320, 300.0, 300.0, 95.5, 159.5)
    with pytest.raises(ValueError, match=r"^intrinsic:.*320.*192"):
        loom.photogrammetry.estimate_depth(path, model, intrinsic=stored)
    with pytest.raises(ValueError, match=r"^align:"):
        loom.photogrammetry.estimate_depth(path, model, align=np.ones((320, 192)))


def test_an_unknown_orientation_and_damaged_exif_leave_the_image_as_it_is(tmp_path):
    path = tmp_path / "photo.jpg"
    Image.fromarray(RGB).save(path, exif=exif(orientation=9))
    assert take_photo(path).color.shape == RGB.shape
    Image.fromarray(RGB).save(path, exif=b"Exif\0\0" + bytes(range(40)))
    assert take_photo(path).focal is None


def test_the_focal_length_comes_from_exif(tmp_path):
    def focal_of(**tags):
        Image.fromarray(RGB).save(tmp_path / "p.jpg", exif=exif(**tags))
        return take_photo(tmp_path / "p.jpg").focal

    diagonal = math.hypot(320, 192)
    assert focal_of(f35=26) == pytest.approx(26 / math.hypot(36, 24) * diagonal)
    assert focal_of(mm=4.25, plane=2000.0, unit=3, width=320) == pytest.approx(4.25 * 200)
    assert focal_of(mm=4.25, plane=2000.0, unit=3, width=4000) is None  # the image was scaled since
    assert focal_of(mm=4.25) is None
    assert focal_of(f35=0) is None
    Image.fromarray(RGB).save(tmp_path / "p.jpg", exif=exif(f35=26))
    camera, source = camera_of(take_photo(tmp_path / "p.jpg"))
    assert source == "EXIF"
    assert (camera.fx, camera.fy) == (pytest.approx(26 / math.hypot(36, 24) * diagonal),) * 2
    assert (camera.cx, camera.cy) == (159.5, 95.5)


def test_60_degrees_are_assumed_and_reported_without_a_focal_length():
    for size in ((192, 320), (320, 192)):
        camera, source = camera_of(take_photo(np.zeros(size, np.uint8)))
        assert source == "assumed 60 degrees"
        assert 2 * math.degrees(math.atan(160 / camera.fx)) == pytest.approx(60)


def test_gray_deep_and_transparent_images_are_taken(tmp_path):
    gray = np.repeat(UPRIGHT[..., None], 3, 2)
    deep = UPRIGHT.astype(np.uint16) * 257
    alpha = np.concatenate([RGB, np.full((*UPRIGHT.shape, 1), 7, np.uint8)], 2)
    files = {
        "gray.png": (Image.fromarray(UPRIGHT), gray), "deep.png": (Image.fromarray(deep), gray),
        "alpha.png": (Image.fromarray(alpha), RGB), "palette.png": (Image.fromarray(UPRIGHT).convert("P"), gray),
    }  # fmt: skip
    for name, (image, expected) in files.items():
        image.save(tmp_path / name)
        np.testing.assert_array_equal(take_photo(tmp_path / name).color, expected, err_msg=name)
    for array, expected in ((UPRIGHT, gray), (UPRIGHT[..., None], gray), (deep, gray), (alpha, RGB), (RGB, RGB)):
        np.testing.assert_array_equal(take_photo(array).color, expected)
    np.testing.assert_array_equal(take_photo(np.stack([deep] * 3, -1).astype(">u2")).color, gray)


def test_a_single_pixel_and_a_line_of_pixels_have_a_depth(tmp_path):
    model = loom.photogrammetry.DepthModel(linear(tmp_path / "m.onnx"), "midas-v2.1-small")
    line = np.linspace(0, 255, 30).astype(np.uint8)
    result = loom.photogrammetry.estimate_depth(line[None], model)
    assert result.depth.shape == (1, 30)
    assert len(result.to_point_cloud()) == 30
    with pytest.raises(loom.FileError, match=r"/m\.onnx \(output 'depth'\):"):  # one color shows no depth
        loom.photogrammetry.estimate_depth(np.full((1, 1), 9, np.uint8), model)


def test_a_huge_image_is_downscaled_first(tmp_path):
    model = loom.photogrammetry.DepthModel(linear(tmp_path / "m.onnx"), "midas-v2.1-small")
    image = np.tile(np.linspace(0, 255, 1500).astype(np.uint8), (1000, 1))
    result = loom.photogrammetry.estimate_depth(image, model)
    assert result.depth.shape == (1000, 1500)
    assert result.enlargement == 1000 / 160  # 171 rows of 256 columns, in multiples of 32
    with pytest.raises(ValueError, match=r"^image:.*depth-anything-v2"):
        loom.photogrammetry.estimate_depth(np.zeros((4, 6000), np.uint8), linear(tmp_path / "d.onnx"))


@pytest.mark.parametrize(
    "content", [b"", b"hello", b"\x89PNG\r\n\x1a\n" + b"\0" * 50, b"\xff\xd8\xff\xe0" + b"\1" * 50]
)
def test_files_that_are_no_images_are_rejected(tmp_path, content):
    path = tmp_path / "photo.jpg"
    path.write_bytes(content)
    with pytest.raises(loom.FileError, match=r"photo\.jpg"):
        loom.photogrammetry.estimate_depth(path, linear(tmp_path / "m.onnx"))


@pytest.mark.parametrize(
    ("array", "error"),
    [
        (np.zeros((4, 4), np.float32), TypeError), (np.zeros((4, 4), bool), TypeError), (np.zeros(4, "u1"), ValueError),
        (np.zeros((0, 4), np.uint8), ValueError), (np.zeros((4, 4, 2), np.uint8), ValueError),
        (np.zeros((2, 4, 4, 3), np.uint8), ValueError), (None, TypeError), ({}, TypeError),
    ],
)  # fmt: skip
def test_other_arrays_are_refused_by_name(array, error):
    with pytest.raises(error, match="image:"):
        take_photo(array)


def test_a_network_of_an_input_beyond_all_published_ones_is_rejected(tmp_path, monkeypatch):
    path = linear(tmp_path / "a.onnx", size=(100_002, 100_002))
    with pytest.raises(loom.FileError, match=r"a\.onnx.*100002 x 100002 pixels, which is more than 16,777,216"):
        DepthModel(path)
    model = DepthModel(linear(tmp_path / "b.onnx", size=(28, 28)))
    monkeypatch.setattr(network, "prepare", lambda *_: np.empty(1 << 58))
    with pytest.raises(loom.FileError, match=r"b\.onnx: needs more memory than is available for an input of 28 x 28"):
        model.run(image_of((28, 28)))
