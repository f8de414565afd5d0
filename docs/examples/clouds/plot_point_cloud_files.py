"""
File formats of point clouds
============================

On this page you write a cloud with normals, colors and attributes to each format, read it again, and compare file size
and content. The readers are strict: a damaged file raises an error with its position, and is never read partially.
"""

import importlib.util
import tempfile
import warnings
from pathlib import Path

import numpy as np

import pointloom as loom

# %%
# A cloud with attributes
# -----------------------
room = loom.datasets.room_cloud().voxel_down_sample(0.04)
room["intensity"] = (1000 * room.colors.mean(axis=1)).astype(np.float32)
room["label"] = np.arange(len(room), dtype=np.int32) % 7
folder = Path(tempfile.mkdtemp())
print(room)

# %%
# Write and read
# --------------
# The suffix selects the format. Attributes that a format cannot store raise an error. ``without`` removes them
# explicitly. NPZ and PLY store everything. PCD is the format of PCL. LAS and LAZ round to millimeters. E57 requires an
# optional package. XYZ is plain text.
formats = {
    ".ply": (),
    ".pcd": (),
    ".npz": (),
    ".xyz": ("normals", "colors", "intensity", "label"),
    ".las": ("normals", "label"),
    ".laz": ("normals", "label"),
    ".e57": ("normals", "label"),
}
for needed, endings in {"laspy": (".las", ".laz"), "pye57": (".e57",)}.items():
    if importlib.util.find_spec(needed) is None:
        print(f"{needed} is not installed: {', '.join(endings)} are skipped")
        formats = {ending: dropped_names for ending, dropped_names in formats.items() if ending not in endings}
for ending, dropped in formats.items():
    path = folder / f"room{ending}"
    prepared = room.without(*dropped)
    if ending in (".las", ".laz"):
        prepared["intensity"] = room["intensity"].astype(np.uint16)  # LAS stores intensity as an integer
    loom.write_point_cloud(path, prepared)
    read_back = loom.read_point_cloud(path)
    error = 1000 * np.abs(read_back.points - room.points).max()
    stored = [name for name in ("normals", "colors") if getattr(read_back, f"has_{name}")] + sorted(
        set(read_back.attributes) & {"intensity", "label"}
    )
    print(
        f"{ending:5}{path.stat().st_size / 1024:8.0f} KiB, position error {error:.4f} mm, stores "
        f"{', '.join(stored) or 'positions'}"
    )
    assert len(read_back) == len(room) and error < 0.6
    if not dropped:
        assert np.array_equal(read_back["label"], room["label"]) and np.array_equal(
            read_back["intensity"], room["intensity"]
        )

# %%
# Unsupported attributes
# ----------------------
# They are rejected before the file is created.
try:
    loom.write_point_cloud(folder / "labels.xyz", room)
except loom.FileError as error:
    print("rejected:", error)
else:
    raise AssertionError("expected an error, since XYZ has no labels")
assert not (folder / "labels.xyz").exists()

# %%
# Damaged and missing files
# -------------------------
# A truncated file raises an error, and so does a misspelled path.
content = (folder / "room.ply").read_bytes()
(folder / "cut.ply").write_bytes(content[: len(content) // 2])
for name in ("cut.ply", "rom.ply"):
    try:
        loom.read_point_cloud(folder / name)
    except loom.FileError as error:
        print(f"{name}:", str(error).replace(str(folder), "..."))
    else:
        raise AssertionError(name)

# %%
# Text files without a header
# ---------------------------
# The names of the columns must be given.
table = folder / "table.txt"
np.savetxt(table, np.column_stack([room.points[:5], room["intensity"][:5]]), fmt="%.4f")
cloud = loom.read_point_cloud(table, columns=["x", "y", "z", "intensity"])
print(cloud)
assert np.allclose(cloud["intensity"], room["intensity"][:5], atol=1e-3)

# %%
# The cloud read from the PLY file is bitwise identical to the original.
with warnings.catch_warnings():
    warnings.simplefilter("error")
    read_back = loom.read_point_cloud(folder / "room.ply")
assert np.array_equal(read_back.points, room.points) and np.array_equal(read_back.normals, room.normals)
low, high = room.get_min_bound(), room.get_max_bound()
without_ceiling = read_back.crop(
    loom.AxisAlignedBoundingBox([low[0], low[1] + 0.1, low[2]], [high[0] - 0.1, high[1], low[2] + 2.2])
)
image = loom.render(
    without_ceiling, loom.View.fit(without_ceiling.points, direction=(-0.5, 0.62, -0.8), width=960, height=640)
)

# %%
# What to change
# --------------
# - ``formats``: add ``.csv``. Which attributes does it store?
# - The voxel size [m]: compare file sizes for 0.02 and 0.04.
# - ``columns``: the order of the columns in your own text file.
#
# Next
# ----
# - :doc:`File formats, ROS recordings and units </files>`
# - :ref:`File formats of meshes: GLB, PLY, OBJ, STL <sphx_glr_gallery_meshes_plot_mesh_files.py>`
