"""
Curvature and geodesic distances
================================

On this page you compute the curvature of a mesh, which distinguishes ridges, valleys and flat regions, and geodesic
distances, which are measured along the surface. Both are verified on a sphere, where the exact values are known.
"""

import numpy as np

import pointloom as loom

# %%
# Curvature of a sphere
# ---------------------
#
# ``mean`` is the mean of the two principal curvatures [1/m], positive for convex surfaces. ``gaussian`` is their
# product [1/m^2]. On a sphere, the principal curvatures are the inverse of the radius.

sphere = loom.TriangleMesh.create_icosahedron(0.05).subdivide_midpoint(5)
sphere.vertices = 0.05 * sphere.vertices / np.linalg.norm(sphere.vertices, axis=1, keepdims=True)
sphere_curvature = sphere.compute_vertex_curvature()
print(
    f"sphere of 5 cm: mean curvature {np.median(sphere_curvature.mean):.2f} 1/m, "
    f"Gaussian {np.median(sphere_curvature.gaussian):.0f} 1/m^2"
)
assert np.isclose(np.median(sphere_curvature.mean), 20, rtol=0.01) and np.isclose(
    np.median(sphere_curvature.gaussian), 400, rtol=0.02
)

# %%
# The distance from pole to pole is pi times the radius. ``sources`` are vertex indices.

geodesic = sphere.compute_geodesic_distances([int(sphere.vertices[:, 2].argmax())])
print(
    f"from pole to pole {geodesic.max() * 100:.2f} cm along the surface, exact {np.pi * 5:.2f}; straight line {10:.0f}"
)
assert abs(geodesic.max() / (np.pi * 0.05) - 1) < 0.02

# %%
# A scanned object
# ----------------
#
# Noise and narrow triangles affect the curvature. Remesh to uniform edges (3 mm) and smooth first. Vertex attributes
# are preserved by cropping and simplification, stored in .ply and .glb files, and displayed by ``color_by``.

mesh = loom.datasets.object_mesh().remesh_isotropic(0.003, 5).filter_smooth_taubin(10).compute_vertex_normals()
mesh.vertex_attributes["mean curvature [1/m]"] = mesh.compute_vertex_curvature().mean
top = int(mesh.vertices[:, 2].argmax())
mesh.vertex_attributes["distance from the top [m]"] = mesh.compute_geodesic_distances([top])
geodesic_from_top = mesh.vertex_attributes["distance from the top [m]"]
straight = np.linalg.norm(mesh.vertices - mesh.vertices[top], axis=1)
assert geodesic_from_top[top] == 0 and (geodesic_from_top >= straight - 1e-3).all(), (
    "a geodesic distance is at least the straight distance"
)
print(
    f"farthest from the top: {np.nanmax(geodesic_from_top) * 100:.1f} cm along the surface, "
    f"{straight.max() * 100:.1f} cm straight"
)

# %%
# Ridges are red, valleys blue.

view = {"front": [0.25, -1, 0.3], "up": [0, 0, 1], "field_of_view": 25, "zoom": 0.72}
high = float(np.nanquantile(np.abs(mesh.vertex_attributes["mean curvature [1/m]"]), 0.95))
bent = {"geometry": mesh, "color_by": "mean curvature [1/m]", "colormap": "coolwarm", "limits": (-high, high)}
curvature = loom.render(bent, view, (800, 800), color_bar=True)

# %%
# Geodesic distances from the top, in bands of 4 cm.

mesh.vertex_attributes["from the top, in bands [m]"] = 0.04 * np.floor(geodesic_from_top / 0.04)
distances = loom.render(
    {"geometry": mesh, "color_by": "from the top, in bands [m]", "colormap": "turbo"}, view, (800, 800), color_bar=True
)

# %%
# What to change
# --------------
# - The edge length of ``remesh_isotropic`` [m]: 0.006 gives the curvature at a larger scale.
# - The iterations of ``filter_smooth_taubin``: without smoothing, noise dominates.
# - ``sources``: several vertices give the distance from the nearest one.
#
# Next
# ----
# - :ref:`Mesh smoothing without shrinkage <sphx_glr_gallery_meshes_plot_smooth.py>`
# - :ref:`Isotropic remeshing and subdivision <sphx_glr_gallery_meshes_plot_remesh_and_subdivide.py>`
