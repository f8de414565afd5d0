"""
File formats of meshes: GLB, PLY, OBJ, STL
==========================================

On this page you write a mesh with colors and attributes to each format, read it again, and compare the content. A
warning lists attributes that a format cannot store.
"""

import tempfile
import warnings
from pathlib import Path

import numpy as np

import pointloom as loom

# %%
# A mesh with attributes
# ----------------------
#
# Vertices and triangles can have attributes of any type.

mesh = loom.datasets.object_mesh().simplify_quadric_decimation(8000).compute_vertex_normals()
mesh.vertex_attributes["quality"] = np.float32(mesh.compute_vertex_curvature().mean)
mesh.triangle_attributes["label"] = np.uint8(mesh.vertices[mesh.triangles].mean(axis=1)[:, 2] > 0)
folder = Path(tempfile.mkdtemp())

# %%
# Write and read
# --------------
#
# The suffix selects the format. Files are written atomically.

for suffix in (".ply", ".glb", ".obj", ".off", ".stl"):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        loom.write_triangle_mesh(folder / f"owl{suffix}", mesh)
    read_back = loom.read_triangle_mesh(folder / f"owl{suffix}")
    stored = [name for name, is_present in {
        "normals": read_back.has_vertex_normals, "colors": read_back.has_vertex_colors,
        "quality": "quality" in read_back.vertex_attributes, "label": "label" in read_back.triangle_attributes,
    }.items() if is_present]  # fmt: skip
    size = (folder / f"owl{suffix}").stat().st_size
    print(f"{suffix} {size:8} bytes, {len(read_back.vertices):6} vertices, stores {', '.join(stored) or 'the shape'}")
    for warning in caught:
        print("     ", str(warning.message)[:110])
    assert len(read_back.triangles) == len(mesh.triangles)
    assert np.isclose(read_back.get_volume(), mesh.get_volume(), rtol=1e-3) or suffix == ".stl"
    if suffix == ".ply":
        assert np.array_equal(read_back.triangle_attributes["label"], mesh.triangle_attributes["label"])

# %%
# An STL file contains separate triangles. Equal corners are merged on reading, so the result is watertight.

assert loom.read_triangle_mesh(folder / "owl.stl").is_watertight() == mesh.is_watertight()

# %%
# A damaged file raises an error with its position.

(folder / "half.ply").write_bytes((folder / "owl.ply").read_bytes()[:20_000])
try:
    loom.read_triangle_mesh(folder / "half.ply")
except loom.FileError as error:
    print("rejected:", str(error).replace(str(folder), "..."))
else:
    raise AssertionError("expected an error for a truncated file")

# %%
# The up axis
# -----------
#
# glTF has y up, most scans have z up. ``up="z"`` rotates on writing and back on reading. Without it, coordinates do not
# change.

del mesh.triangle_attributes["label"]  # not supported by glTF
loom.write_triangle_mesh(folder / "up.glb", mesh, up="z")
assert np.allclose(loom.read_triangle_mesh(folder / "up.glb", up="z").vertices, mesh.vertices, atol=1e-6)
rotated = loom.read_triangle_mesh(folder / "up.glb")
assert np.allclose(rotated.vertices[:, 1], mesh.vertices[:, 2], atol=1e-6)

# %%
# Vertex colors as a texture
# --------------------------
#
# ``compute_uvatlas`` unwraps the mesh (requires xatlas, the extra "mesh"). ``bake_vertex_colors`` creates the texture.
# At seams of the atlas, a GLB file has two vertices at the same position. Smoothing and subdivision treat them as one.

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

# %%
# What to change
# --------------
# - The suffix: which attributes does your own format store?
# - ``up``: ``"z"`` for viewers with y up.
# - The size of the atlas [texels]: 2048 instead of 1024 is sharper and four times as large.
#
# Next
# ----
# - :ref:`File formats of point clouds <sphx_glr_gallery_clouds_plot_point_cloud_files.py>`
# - :doc:`Triangle meshes </meshes>`: textures and materials.
