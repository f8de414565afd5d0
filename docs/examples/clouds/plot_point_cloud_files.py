"""
Files of clouds, in and out
===========================

Which format keeps what, how large does it get, and what happens with a file that is broken? One cloud with normals,
colors and two attributes goes through all of them here. The readers are strict: a damaged file is an error that
names the byte, never a cloud with holes that nobody notices.
"""

import importlib.util
import tempfile
import warnings
from pathlib import Path

import numpy as np

import pointloom as loom

# %%
# A colored piece of a room with two attributes of our own.
room = loom.datasets.room_cloud().voxel_down_sample(0.04)
room["intensity"] = (1000 * room.colors.mean(axis=1)).astype(np.float32)
room["label"] = np.arange(len(room), dtype=np.int32) % 7
folder = Path(tempfile.mkdtemp())
print(room)

# %%
# Through each format and back. The extension says which one; what a format cannot hold is an error when it is
# written, so nothing is lost in silence: ``without`` drops it on purpose. NPZ and PLY keep all; PCD is what PCL
# reads; LAS and LAZ round to millimeters; E57 wants an extra package; .xyz is for the eye.
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
        print(f"{needed} is not installed: {', '.join(endings)} are left out")
        formats = {ending: drop for ending, drop in formats.items() if ending not in endings}
for ending, dropped in formats.items():
    path = folder / f"room{ending}"
    given = room.without(*dropped)
    if ending in (".las", ".laz"):
        given["intensity"] = room["intensity"].astype(np.uint16)  # LAS holds whole numbers there
    loom.write_point_cloud(path, given)
    back = loom.read_point_cloud(path)
    error = 1000 * np.abs(back.points - room.points).max()
    stored = [name for name in ("normals", "colors") if getattr(back, f"has_{name}")] + sorted(
        set(back.attributes) & {"intensity", "label"}
    )
    print(
        f"{ending:5}{path.stat().st_size / 1024:8.0f} KiB, positions to {error:.4f} mm, keeps "
        f"{', '.join(stored) or 'positions'}"
    )
    assert len(back) == len(room) and error < 0.6
    if not dropped:
        assert np.array_equal(back["label"], room["label"]) and np.array_equal(back["intensity"], room["intensity"])

# %%
# What a format cannot hold is refused before a byte is written.
try:
    loom.write_point_cloud(folder / "labels.xyz", room)
except loom.FileError as error:
    print("refused:", error)
else:
    raise AssertionError("xyz holds no labels")
assert not (folder / "labels.xyz").exists()

# %%
# A file that was cut short, as by a full disk, is an error too; and so is a name with a typo.
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
# Text without names of its columns says nothing of what they are: name them.
table = folder / "table.txt"
np.savetxt(table, np.column_stack([room.points[:5], room["intensity"][:5]]), fmt="%.4f")
cloud = loom.read_point_cloud(table, columns=["x", "y", "z", "intensity"])
print(cloud)
assert np.allclose(cloud["intensity"], room["intensity"][:5], atol=1e-3)

# %%
# What came back from the PLY, bit for bit what was written.
with warnings.catch_warnings():
    warnings.simplefilter("error")
    back = loom.read_point_cloud(folder / "room.ply")
assert np.array_equal(back.points, room.points) and np.array_equal(back.normals, room.normals)
low, high = room.get_min_bound(), room.get_max_bound()
shown = back.crop(loom.AxisAlignedBoundingBox([low[0], low[1] + 0.1, low[2]], [high[0] - 0.1, high[1], low[2] + 2.2]))
image = loom.render(shown, loom.View.fit(shown.points, direction=(-0.5, 0.62, -0.8), width=960, height=640))
