"""
Meshes in files: GLB, PLY, OBJ, STL
===================================

Which format keeps what? A mesh with colors and values of its own goes out and comes back, and what a format cannot
hold is told by a warning, never dropped in silence.
"""

import tempfile
import warnings
from pathlib import Path

import numpy as np

import pointloom as loom

# %%
# A mesh with more than a shape
# -----------------------------
#
# Values at vertices and at triangles, of any type, by name.

mesh = loom.datasets.object_mesh().simplify_quadric_decimation(8000).compute_vertex_normals()
mesh.vertex_attributes["quality"] = np.float32(mesh.compute_vertex_curvature().mean)
mesh.triangle_attributes["label"] = np.uint8(mesh.vertices[mesh.triangles].mean(axis=1)[:, 2] > 0)
folder = Path(tempfile.mkdtemp())

# %%
# Out and back
# ------------
#
# The suffix chooses the format. Files appear whole or not at all.

for suffix in (".ply", ".glb", ".obj", ".off", ".stl"):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        loom.write_triangle_mesh(folder / f"owl{suffix}", mesh)
    back = loom.read_triangle_mesh(folder / f"owl{suffix}")
    stored = [name for name, there in {
        "normals": back.has_vertex_normals, "colors": back.has_vertex_colors,
        "quality": "quality" in back.vertex_attributes, "label": "label" in back.triangle_attributes,
    }.items() if there]  # fmt: skip
    size = (folder / f"owl{suffix}").stat().st_size
    print(f"{suffix} {size:8} bytes, {len(back.vertices):6} vertices, keeps {', '.join(stored) or 'the shape'}")
    for warning in caught:
        print("     ", str(warning.message)[:110])
    assert len(back.triangles) == len(mesh.triangles)
    assert np.isclose(back.get_volume(), mesh.get_volume(), rtol=1e-3) or suffix == ".stl"
    if suffix == ".ply":
        assert np.array_equal(back.triangle_attributes["label"], mesh.triangle_attributes["label"])

# %%
# An STL holds each triangle by itself; equal corners are made one vertex on reading, so the solid comes back whole.

assert loom.read_triangle_mesh(folder / "owl.stl").is_watertight() == mesh.is_watertight()

# %%
# A file that is damaged is an error that says where, never half a mesh.

(folder / "half.ply").write_bytes((folder / "owl.ply").read_bytes()[:20_000])
try:
    loom.read_triangle_mesh(folder / "half.ply")
except loom.FileError as error:
    print("refused:", str(error).replace(str(folder), "..."))
else:
    raise AssertionError("half a file was taken for a mesh")

# %%
# Which way is up
# ---------------
#
# glTF has y up, most scans z. ``up="z"`` turns on writing and back on reading; without it coordinates are taken as they
# are.

del mesh.triangle_attributes["label"]  # which glTF cannot hold
loom.write_triangle_mesh(folder / "up.glb", mesh, up="z")
assert np.allclose(loom.read_triangle_mesh(folder / "up.glb", up="z").vertices, mesh.vertices, atol=1e-6)
rotated = loom.read_triangle_mesh(folder / "up.glb")
assert np.allclose(rotated.vertices[:, 1], mesh.vertices[:, 2], atol=1e-6)

# %%
# Colors for programs that know textures alone
# ---------------------------------------------
#
# ``compute_uvatlas`` unwraps the mesh (xatlas, of the extra "mesh"), ``bake_vertex_colors`` draws its colors into a
# image. Where the atlas has a seam a GLB needs two vertices at one place; smoothing and subdivision here know that
# they are one.

baked = mesh.compute_uvatlas(1024, gutter=4).bake_vertex_colors(1024)
loom.write_triangle_mesh(folder / "baked.glb", baked)
textured = loom.read_triangle_mesh(folder / "baked.glb")
print(
    f"{len(mesh.vertices)} vertices became {len(textured.vertices)} "
    f"at the seams, a texture of {textured.textures[0].shape}"
)
assert textured.has_textures and len(textured.vertices) > len(mesh.vertices)

view = {"front": [0.3, -1, 0.25], "up": [0, 0, 1], "field_of_view": 25, "zoom": 0.72}
atlas = textured.textures[0][::2, ::2]
image = np.hstack([loom.render(textured, view, (512, 512), shading="smooth"), atlas])
