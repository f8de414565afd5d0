"""Files that other packages decode: HEIC, DNG, videos and ONNX networks.

The packages are optional. Without one of them, each file must be rejected with the command that installs it.
"""

from __future__ import annotations

import shutil
import struct
import subprocess
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import mutations
import numpy as np
from job_cases import anything

import pointloom as loom
from pointloom.io.images.photo_files import read_alpha
from pointloom.photogrammetry.sfm.image_folder import read_header, read_image, read_lens

_ROOT = Path(__file__).resolve().parents[2]
_FORMS = {1: "B", 2: "B", 3: "H", 4: "I", 5: "II", 10: "ii"}  # of the types of TIFF
_RNG = 17


def heics() -> list[bytes]:
    """A photograph of a telephone. No package here encodes HEIC, so it is the file of the tests."""
    return [(_ROOT / "tests" / "photogrammetry" / "sfm" / "telephone.heic").read_bytes()]


def dngs() -> list[bytes]:
    """A mosaic of 16 bits with the tags that a raw decoder requires."""
    height, width = 24, 32
    pixels = np.random.default_rng(_RNG).integers(0, 65536, (height, width)).astype("<u2").tobytes()
    one, zero = (1, 1), (0, 1)
    tags: dict[int, tuple[int, list[Any]]] = {
        254: (4, [0]), 256: (4, [width]), 257: (4, [height]), 258: (3, [16]), 259: (3, [1]), 262: (3, [32803]),
        271: (2, [*b"Maker\0"]), 272: (2, [*b"Telephone 1\0"]), 273: (4, [0]), 274: (3, [6]), 277: (3, [1]),
        278: (4, [height]), 279: (4, [len(pixels)]), 33421: (3, [2, 2]), 33422: (1, [0, 1, 1, 2]),
        50706: (1, [1, 4, 0, 0]), 50708: (2, [*b"Maker Telephone 1\0"]), 50714: (4, [0]), 50717: (4, [65535]),
        50721: (10, [one, zero, zero, zero, one, zero, zero, zero, one]), 50728: (5, [one] * 3), 50778: (3, [21]),
    }  # fmt: skip
    bodies = {tag: _packed(kind, values) for tag, (kind, values) in tags.items()}
    begin = 8 + 2 + 12 * len(tags) + 4
    bodies[273] = struct.pack("<I", begin + sum(len(body) + len(body) % 2 for body in bodies.values() if len(body) > 4))
    entries, more = b"", b""
    for tag, (kind, values) in tags.items():
        body = bodies[tag]
        if len(body) > 4:
            body, more = struct.pack("<I", begin + len(more)), more + body + bytes(len(body) % 2)
        entries += struct.pack("<HHI", tag, kind, len(values)) + body.ljust(4, b"\0")
    return [b"II*\0" + struct.pack("<IH", 8, len(tags)) + entries + bytes(4) + more + pixels]


def _packed(kind: int, values: list[Any]) -> bytes:
    return b"".join(struct.pack(f"<{_FORMS[kind]}", *(v if isinstance(v, tuple) else (v,))) for v in values)


def read_photograph(path: Path) -> Any:
    """Header, pixels and lens, as read from a folder of images."""
    header = read_header(path)
    return header, read_image(path, header), read_lens(path), read_alpha(path)


def films(suffix: str, *options: str) -> Callable[[], list[bytes]]:
    """A video of moving noise by ffmpeg."""

    def seeds() -> list[bytes]:
        wide = np.random.default_rng(_RNG).integers(0, 256, (48, 120), np.uint8).repeat(2, axis=1)
        frames = b"".join(wide[:, 4 * k : 4 * k + 64].tobytes() for k in range(12))
        given = ["-f", "rawvideo", "-pix_fmt", "gray", "-s", "64x48", "-r", "10", "-i", "-"]
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / f"x{suffix}"
            command = ["ffmpeg", "-v", "error", *given, "-c:v", "mpeg4", "-bitexact", *options, str(path)]
            subprocess.run(command, input=frames, check=True, timeout=60)
            return [path.read_bytes()]

    return seeds


def read_film(path: Path) -> Any:
    folder = path.with_name("chosen")
    shutil.rmtree(folder, ignore_errors=True)
    return loom.photogrammetry.choose_frames(path, folder, max_frames=4).to_dict()


def networks() -> list[bytes]:
    """Networks of few weights: a convolution as inverse depth, and depth with a constant."""
    from onnx import TensorProto, helper, numpy_helper

    kernel = numpy_helper.from_array(np.array([0.25, 0.5, 0.125], np.float32).reshape(1, 3, 1, 1), "kernel")
    one = numpy_helper.from_array(np.array([1], np.int64), "one")
    image = helper.make_tensor_value_info("x", TensorProto.FLOAT, [1, 3, "h", "w"])
    result = helper.make_tensor_value_info("depth", TensorProto.FLOAT, [1, "h", "w"])
    nodes = [
        helper.make_node("Conv", ["x", "kernel"], ["map"], kernel_shape=[1, 1]),
        helper.make_node("Relu", ["map"], ["positive"]),
        helper.make_node("Squeeze", ["positive", "one"], ["depth"]),
    ]
    graph = helper.make_graph(nodes, "tiny", [image], [result], [kernel, one])
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 17)], ir_version=8)
    return [model.SerializeToString()]


def read_network(path: Path) -> Any:
    image = np.random.default_rng(_RNG).integers(0, 256, (28, 42, 3), np.uint8)
    return loom.photogrammetry.DepthModel(path, threads=1).run(image)


# name, suffix, seeds, mutate, read, oracle: as in cases.Case
MEDIA = [
    ("photo .heic", ".heic", heics, mutations.binary, read_photograph, anything),
    ("photo .dng", ".dng", dngs, mutations.binary, read_photograph, anything),
    *((f"video {end}", end, films(end, *options), mutations.binary, read_film, anything)
      for end, *options in ((".mp4",), (".mkv",), (".avi",), (".ts",), (".mov", "-movflags", "faststart"))),
    ("network", ".onnx", networks, mutations.binary, read_network, anything),
]  # fmt: skip
