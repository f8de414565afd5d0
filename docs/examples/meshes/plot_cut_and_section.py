"""
Cut a mesh and compute sections
===============================

On this page you cut a mesh by a plane and close the cut, and compute cross sections: floor plans, profiles,
circumferences. ``clip_plane`` cuts, ``slice_plane`` computes sections of many planes at once, and ``section_loops``
returns ordered loops.
"""

import numpy as np

import pointloom as loom

# %%
# Cut and close
# -------------
#
# The part on the side of the normal remains. ``cap=True`` closes the cut (requires manifold3d, the extra "mesh"), so
# both halves are watertight. The sum of their volumes is that of the mesh.

mesh = loom.datasets.object_mesh()
low, high = mesh.get_axis_aligned_bounding_box()
middle = 0.5 * (low + high)
half = mesh.clip_plane(middle, [0, 0, -1], cap=True)
other = mesh.clip_plane(middle, [0, 0, 1], cap=True)
print(f"{mesh.get_volume() * 1e6:.2f} cm^3 = {half.get_volume() * 1e6:.2f} + {other.get_volume() * 1e6:.2f}")
assert half.is_watertight() and other.is_watertight()
assert np.isclose(half.get_volume() + other.get_volume(), mesh.get_volume(), rtol=1e-4)

# %%
# Loops
# -----
#
# ``section_loops`` connects the segments of a section to loops of shape ``(k, 3)`` [m]. The length of a loop is the
# circumference at that height.

loops = mesh.section_loops(middle, [0, 0, 1])
lengths = [float(np.linalg.norm(np.diff(np.vstack([loop, loop[:1]]), axis=0), axis=1).sum()) for loop in loops]
print(
    f"{len(loops)} loops at half the height, circumferences {', '.join(f'{length * 100:.1f} cm' for length in lengths)}"
)
assert all(np.allclose(loop[:, 2], middle[2], atol=1e-6) for loop in loops)

# %%
# Contours
# --------
#
# Twenty planes at once, at the given heights above the first point. The result is a ``LineSet``.

heights = np.linspace(low[2], high[2], 22)[1:-1]
contours = mesh.slice_plane([0, 0, 0], [0, 0, 1], contour_values=heights)
print(f"{len(contours.lines)} segments of {len(heights)} sections")
section_heights = np.unique(contours.points[:, 2].round(5))
assert len(section_heights) == len(heights) and np.allclose(section_heights, heights, atol=2e-5)

# %%
# The closed half, the sections of the other half, and the cut:

cut_lines = loom.LineSet(np.vstack(loops), np.vstack([
    np.column_stack([np.arange(len(loop)), np.roll(np.arange(len(loop)), -1)]) + sum(map(len, loops[:i]))
    for i, loop in enumerate(loops)
]))  # fmt: skip
is_above = contours.points[contours.lines].mean(axis=1)[:, 2] > middle[2]
upper_contours = loom.LineSet(contours.points, contours.lines[is_above])
view = loom.View.fit(mesh.vertices, direction=(-0.35, 1, -0.6), width=800, height=800)
scene = {
    "closed half": {"geometry": half, "color": (0.86, 0.65, 0.45)},
    "sections of the other half": {"geometry": upper_contours, "color": (0.2, 0.4, 0.7), "line_width": 2},
    "cut": {"geometry": cut_lines, "color": (0.75, 0.1, 0.1), "line_width": 5},
}
image = loom.render(scene, view, (800, 800), shading="flat", legend=True)

# %%
# What to change
# --------------
# - The point [m] and the normal of the plane.
# - ``contour_values`` [m]: more planes give denser contours.
# - ``cap``: ``False`` leaves the cut open.
#
# Next
# ----
# - :ref:`Create solids: extrusion, revolution, boolean operations
#   <sphx_glr_gallery_meshes_plot_extrude_revolve_join.py>`
# - :ref:`Ray casting: visibility, distance, occupancy <sphx_glr_gallery_meshes_plot_ray_casting.py>`
