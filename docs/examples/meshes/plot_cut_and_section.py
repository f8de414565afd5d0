"""
Cut a mesh, and take sections
=============================

Half of an object with a lid shows its inside and can be printed; the line in which a plane meets a mesh is a floor
plan, a profile, a girth. ``clip_plane`` cuts, ``slice_plane`` gives lines for any number of planes at once,
``section_loops`` ordered loops.
"""

import numpy as np

import pointloom as loom

# %%
# Half of it, closed again
# ------------------------
#
# What lies on the side to which the normal points stays. ``cap=True`` closes what it opens (by manifold3d, the extra
# "mesh"), so the half is watertight and has a volume. Both halves together have that of the whole.

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
# ``section_loops`` joins the lines of a section: [k, 3] places a loop, [m]. Their length is the girth at that height.

loops = mesh.section_loops(middle, [0, 0, 1])
lengths = [float(np.linalg.norm(np.diff(np.vstack([loop, loop[:1]]), axis=0), axis=1).sum()) for loop in loops]
print(f"{len(loops)} loops half way up, girths {', '.join(f'{length * 100:.1f} cm' for length in lengths)}")
assert all(np.allclose(loop[:, 2], middle[2], atol=1e-6) for loop in loops)

# %%
# Contours
# --------
#
# Twenty planes at once, each at a height above the first point. The lines come as a ``LineSet``.

heights = np.linspace(low[2], high[2], 22)[1:-1]
contours = mesh.slice_plane([0, 0, 0], [0, 0, 1], contour_values=heights)
print(f"{len(contours.lines)} segments of {len(heights)} sections")
section_heights = np.unique(contours.points[:, 2].round(5))
assert len(section_heights) == len(heights) and np.allclose(section_heights, heights, atol=2e-5)

# %%
# The image: the closed half, its sections, and where the other half was cut away.

lid = loom.LineSet(np.vstack(loops), np.vstack([
    np.column_stack([np.arange(len(loop)), np.roll(np.arange(len(loop)), -1)]) + sum(map(len, loops[:i]))
    for i, loop in enumerate(loops)
]))  # fmt: skip
above = contours.points[contours.lines].mean(axis=1)[:, 2] > middle[2]
rest = loom.LineSet(contours.points, contours.lines[above])
view = loom.View.fit(mesh.vertices, direction=(-0.35, 1, -0.6), width=800, height=800)
scene = {
    "half with its lid": {"geometry": half, "color": (0.86, 0.65, 0.45)},
    "sections of the other half": {"geometry": rest, "color": (0.2, 0.4, 0.7), "line_width": 2},
    "the cut": {"geometry": lid, "color": (0.75, 0.1, 0.1), "line_width": 5},
}
image = loom.render(scene, view, (800, 800), shading="flat", legend=True)
