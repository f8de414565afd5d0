"""Rendered images are bitwise identical to the stored ones, on every device.

After a change of how images look, `python -m tests.visualization.render.test_stored_pictures FOLDER` from the root of
the repository writes the images into a folder to be looked at, and their hashes beside this file.
"""

import hashlib
import json
import sys
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.visualization.render.canvas import Canvas
from pointloom.visualization.render.coloring import Coloring
from pointloom.visualization.render.legends import draw_color_bar, draw_labels, draw_legend
from pointloom.visualization.render.parts import Points
from pointloom.visualization.render.picture_files import write_image

STORED = Path(__file__).with_name("stored_pictures.json")
SIZE = (160, 120)
CAMERA = {"front": [0.5, -0.7, 0.45], "up": [0.0, 0.0, 1.0], "zoom": 1.0}


def hills(rows=90):
    """A hilly surface, shape [n, 3], by arithmetic alone: sines differ between machines in their last digits."""
    x, y = np.meshgrid(np.arange(rows) / (rows - 1), np.arange(rows) / (rows - 1))
    z = 0.5 * x * (1 - x) * (1 + 2 * y) + 0.3 * (y - 0.5) * (y - 0.5) - 0.4 * np.abs(x - 0.3) * np.abs(y - 0.6)
    return np.column_stack([2 * x.ravel(), 2 * y.ravel(), 2 * z.ravel()])


def mesh(rows=25, **extras):
    k = np.arange(rows - 1)
    a = (k[:, None] * rows + k).ravel()
    triangles = np.vstack([np.column_stack([a, a + 1, a + rows + 1]), np.column_stack([a, a + rows + 1, a + rows])])
    return loom.TriangleMesh(hills(rows), triangles, **extras)


def colors(rows=90):
    points = hills(rows)
    return np.clip(np.column_stack([points[:, 0] / 2, points[:, 1] / 2, 1 - points[:, 2]]), 0, 1)


def textured():
    surface = mesh()
    levels = np.mgrid[:32, :32].sum(axis=0) % 8
    texture = np.stack([32 * levels, 255 - 16 * levels, np.full((32, 32), 90)], axis=-1).astype(np.uint8)
    uvs = surface.vertices[surface.triangles.ravel(), :2] / 2
    return loom.TriangleMesh(surface.vertices, surface.triangles, triangle_uvs=uvs, textures=[texture])


def parabola_poses():
    poses = np.tile(np.eye(4), (12, 1, 1))
    poses[:, 0, 3] = np.arange(12) / 6
    poses[:, 1, 3] = (np.arange(12) / 6 - 1) ** 2
    return poses


def boxes():
    rotation = np.array([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1.0]])
    upright = loom.AxisAlignedBoundingBox([0, 0, 0], [2, 2, 0.5])
    lines = loom.LineSet([[0, 0, 0], [2, 2, 1], [2, 0, 1]], [[0, 1], [1, 2]], [[1, 0, 0], [0, 0.6, 0]])
    tilted = {"geometry": loom.OrientedBoundingBox([1, 1, 0.4], rotation, [1, 0.5, 0.7]), "line_width": 3}
    return [upright, tilted | {"color": (0.8, 0.3, 0)}, lines, mesh()]


def inside():
    """A view from between the hills, so that triangles extend behind the camera."""
    pose = np.eye(4)
    pose[:3, :3] = [[0.8, 0, 0.6], [-0.6, 0, 0.8], [0, -1, 0]]
    pose[:3, 3] = 0.7, 0.4, 0.55
    return loom.View(loom.PinholeCameraIntrinsic(*SIZE, 80.0, 80.0, 79.5, 59.5), pose)


def voxels():
    x, y, z = np.mgrid[:7, :7, :7].reshape(3, -1)
    cells = np.column_stack([x, y, z])[(x - 3) ** 2 + (y - 3) ** 2 + (z - 3) ** 2 <= 10]
    return loom.VoxelGrid(np.zeros(3), 0.25, (7, 7, 7), cells.astype(np.int32))


def cameras():
    intrinsic = loom.PinholeCameraIntrinsic(640, 480, 500.0, 500.0, 319.5, 239.5)
    frustums = [loom.CameraFrustum(intrinsic, T, scale=0.3) for T in parabola_poses()[::4]]
    return [loom.Trajectory(parabola_poses()), *frustums]


def normals(rows=90):
    cloud = loom.PointCloud(hills(rows), normals=np.cross([2.0, 0.3, 0], hills(rows) - [1, 1, 3]))
    return {"geometry": cloud, "color": Points.plain}


def beads():
    return {"geometry": hills(20), "point_size": 0.08, "metric": True, "color": Points.plain}


def room():
    """A box whose faces point inwards, and its content."""
    box = loom.TriangleMesh.create_box(2, 2, 1)
    return [loom.TriangleMesh(box.vertices, box.triangles[:, ::-1]), mesh()]


def titled():
    cloud = loom.PointCloud(hills())
    return {"geometry": cloud, "color_by": "height", "colormap": "turbo", "limits": (0, 0.8)}


def veils():
    """A transparent surface and a transparent cloud, with objects behind and between them."""
    ball = loom.TriangleMesh.create_sphere(0.4, 12).translate((1, 1, 0.3))
    moved = loom.PointCloud(hills() + np.array([0, 0, 0.5]))
    through = [{"geometry": mesh(), "opacity": 0.6}, {"geometry": moved, "opacity": 0.3, "color": (0, 0.3, 0.9)}]
    return [*through, {"geometry": ball, "opacity": 0.5, "color": (0.9, 0.2, 0.1)}, boxes()[0]]


FIGURE = (320, 240)
WAVE = [0, 5, 9, 10, 7, 3, -2, -6, -9, -10, -8, -4]  # no sine: another library may round it otherwise


def ground(device):
    rows, columns = np.mgrid[: FIGURE[1], : FIGURE[0]]
    image = np.stack([rows, columns % 256, (rows * columns) % 256], axis=-1).astype(np.uint8)
    return Canvas.of_image(image, device)


def text_figure(device):
    canvas = ground(device)
    for k, size in enumerate((12, 14, 16, 20, 24, 32)):
        canvas.text("Text 0123.5 °±·…µ×²³–− é", 5, 20 + 34 * k, size=size, halo=(1, 1, 1) if k % 2 else None)
    return canvas


def strokes_figure(device):
    canvas = ground(device)
    for k in range(12):
        canvas.line(20, 20, 20 + 12 * k, 160 - 9 * k, width=0.5 + 0.5 * k, color=(0.1 * (k % 5), 0.5, 0.2), opacity=0.8)
    path = np.column_stack([np.arange(12) * 12.5 + 160.25, 120 + 8.5 * np.array(WAVE)])
    canvas.polyline(path, width=4, color=(0.2, 0.5, 0.9), opacity=0.8)
    canvas.dots(path, radius=3.7, color=(1, 1, 0))
    canvas.rectangle(100.25, 190.5, 50.5, 30.25, fill=(0, 0, 1), outline=(1, 0, 0), line_width=3, opacity=0.6)
    return canvas


def legend_figure(device):
    canvas = ground(device)
    draw_legend(canvas, [("cloud", (1.0, 0.7, 0.0)), ("mesh", (0.0, 0.6, 0.9))], "lower right")
    draw_labels(canvas, [("A", 50, 50), ("hidden", 52, 52), ("B 12.5 m²", 315, 100)])
    return canvas


def color_bar_figure(device):
    canvas = ground(device)
    draw_color_bar(canvas, Coloring(None, "values", (-0.25, 3.5), "turbo", title="height [m]", has_missing=True))
    return canvas


PICTURES = {
    "cloud with colors": lambda: ([loom.PointCloud(hills(), colors=colors())], {}),
    "cloud with normals": lambda: (normals(), {}),
    "cloud with its normals drawn": lambda: (normals(15), {"point_show_normal": True, "point_size": 3}),
    "eye-dome cloud": lambda: ({"geometry": loom.PointCloud(hills()), "color": Points.plain}, {}),
    "cloud by height": lambda: (loom.PointCloud(hills()), {}),
    "points in meters": lambda: (
        {"geometry": hills(20), "point_size": 0.08, "metric": True, "color": Points.plain},
        {},
    ),
    "flat mesh": lambda: (mesh(), {}),
    "smooth mesh": lambda: (mesh(vertex_colors=colors(25)), {"shading": "smooth"}),
    "wireframe": lambda: (mesh(), {"mesh_show_wireframe": True}),
    "front faces": lambda: (room(), {"mesh_show_back_face": False, "background": (0.2, 0.3, 0.4)}),
    "textured mesh": lambda: (textured(), {}),
    "inside": lambda: ([mesh(), boxes()[0]], {"camera": inside()}),
    "lines and boxes": lambda: (boxes(), {}),
    "cameras and trajectory": lambda: (cameras(), {}),
    "voxel grid": lambda: ({"geometry": voxels(), "wireframe": True}, {}),
    "labels and legend": lambda: ({"hills": mesh()}, {"legend": True, "labels": [("top", [1, 2, 0.9])]}),
    "color bar": lambda: (titled(), {"color_bar": True}),
    "seen through": lambda: (veils(), {"background": "black", "scale_bar": True}),
    "without a background": lambda: (veils(), {"background": "transparent", "labels": [("top", [1, 2, 0.9])]}),
}

FIGURES = {"figure: text": text_figure, "figure: strokes": strokes_figure}
FIGURES |= {"figure: legend": legend_figure, "figure: color_bar": color_bar_figure}


def draw(name, device):
    if name in FIGURES:
        return FIGURES[name](device).to_numpy()
    geometries, options = PICTURES[name]()
    return loom.render(geometries, **{"camera": CAMERA, "size": SIZE, **options}, device=device)


def digest(image):
    return hashlib.sha256(image.tobytes()).hexdigest()


@pytest.mark.parametrize("name", [*PICTURES, *FIGURES])
def test_pictures_are_those_that_were_looked_at(name, device):
    expected = json.loads(STORED.read_text())[name]
    image = draw(name, device)
    assert image.std() > 8, "hardly anything is drawn"
    if digest(image) != expected:
        other = draw(name, "cpu")
        unlike = (image != other).any(axis=2).sum()
        by_default = "as stored" if digest(other) == expected else "not as stored either"
        pytest.fail(
            f"{name}: {unlike} of {image.shape[0] * image.shape[1]} pixels differ from those of the CPU's default, "
            f"which are {by_default}; see the head of {Path(__file__).name}"
        )


def test_no_two_pictures_are_the_same():
    stored = json.loads(STORED.read_text())
    assert sorted(stored) == sorted([*PICTURES, *FIGURES]) and len(set(stored.values())) == len(stored)


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    images = {name: draw(name, "cpu") for name in [*PICTURES, *FIGURES]}
    for name, image in images.items():
        write_image(folder / f"{name.replace(': ', ' ')}.png", image)
    STORED.write_text(json.dumps({name: digest(image) for name, image in images.items()}, indent=4) + "\n")
