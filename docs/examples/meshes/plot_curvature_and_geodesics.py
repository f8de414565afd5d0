"""
Curvature and distances along a surface
=======================================

How a surface bends tells ridges from valleys and flat places from round ones; how far two places lie apart along the
surface is what a seam, a cable or a walker measures. Both are held against a ball, of which they are known.
"""

import numpy as np

import pointloom as loom

# %%
# A ball has one over its radius
# ------------------------------
#
# ``mean`` is half the sum of the two principal curvatures [1/m], above zero where the surface bulges outwards;
# ``gaussian`` is their product [1/m^2].

ball = loom.TriangleMesh.create_icosahedron(0.05).subdivide_midpoint(5)
ball.vertices = 0.05 * ball.vertices / np.linalg.norm(ball.vertices, axis=1, keepdims=True)
bend = ball.compute_vertex_curvature()
print(f"a ball of 5 cm: mean curvature {np.median(bend.mean):.2f} 1/m, Gaussian {np.median(bend.gaussian):.0f} 1/m^2")
assert np.isclose(np.median(bend.mean), 20, rtol=0.01) and np.isclose(np.median(bend.gaussian), 400, rtol=0.02)

# %%
# From the north pole to the south pole it is half a girth, pi times the radius. ``sources`` are numbers of vertices.

way = ball.compute_geodesic_distances([int(ball.vertices[:, 2].argmax())])
print(f"from pole to pole {way.max() * 100:.2f} cm along the surface, true {np.pi * 5:.2f}; straight through {10:.0f}")
assert abs(way.max() / (np.pi * 0.05) - 1) < 0.02

# %%
# A figure
# --------
#
# Noise of the vertices is blown up in curvatures, and slivers tell nothing: remesh to even edges (3 mm) and smooth
# first. Results that belong to vertices become attributes: they go along when the mesh is cut or simplified, into .ply
# and .glb files, and ``color_by`` draws them.

mesh = loom.datasets.object_mesh().remesh_isotropic(0.003, 5).filter_smooth_taubin(10).compute_vertex_normals()
mesh.vertex_attributes["mean curvature [1/m]"] = mesh.compute_vertex_curvature().mean
top = int(mesh.vertices[:, 2].argmax())
mesh.vertex_attributes["distance from the top [m]"] = mesh.compute_geodesic_distances([top])
away = mesh.vertex_attributes["distance from the top [m]"]
straight = np.linalg.norm(mesh.vertices - mesh.vertices[top], axis=1)
assert away[top] == 0 and (away >= straight - 1e-3).all(), "no way along the surface is shorter than the straight line"
print(
    f"farthest from the top: {np.nanmax(away) * 100:.1f} cm along the surface, {straight.max() * 100:.1f} cm straight"
)

# %%
# Ridges are red, valleys blue.

view = {"front": [0.25, -1, 0.3], "up": [0, 0, 1], "field_of_view": 25, "zoom": 0.72}
high = float(np.nanquantile(np.abs(mesh.vertex_attributes["mean curvature [1/m]"]), 0.95))
bent = {"geometry": mesh, "color_by": "mean curvature [1/m]", "colormap": "coolwarm", "limits": (-high, high)}
curvature = loom.render(bent, view, (800, 800), color_bar=True)

# %%
# Rings of equal distance from the top, a band every 4 cm.

mesh.vertex_attributes["from the top, in bands [m]"] = 0.04 * np.floor(away / 0.04)
distances = loom.render(
    {"geometry": mesh, "color_by": "from the top, in bands [m]", "colormap": "turbo"}, view, (800, 800), color_bar=True
)
