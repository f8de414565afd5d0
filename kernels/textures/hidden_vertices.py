"""Which vertices of those that project into a picture the mesh itself hides: one ray a vertex, from the camera to it.

A ray ends a thousandth of its length before the vertex, so the vertex's own triangles are not met, and what is hidden
by less than that counts as seen. 24 B written and read a vertex beside the walk through the tree (rays/).
"""

import numpy as np

from ..lang import array, float32, float64, kernel, launch, tid, uint8, vec3
from ..memory import empty
from ..rays.ray_casting import test_occlusions
from ..rays.scene_trees import SceneTrees
from ..rays.triangle_tree import TriangleTree
from .posed_pictures import PosedPictures, camera_place

SHORT = 0.999  # share of the way to the vertex that must be free


@kernel
def aim_rays_kernel(
    vertices: array(dtype=vec3),
    image: int,
    pictures: PosedPictures,
    seen: array(dtype=uint8),
    rays: array(dtype=float32),
):
    """The ray from a picture's camera to each vertex; one of no length, which meets nothing, where it is not asked."""
    i = tid()
    eye = camera_place(image, pictures)
    way = vec3(0.0, 0.0, 0.0)
    if seen[i] != uint8(0):
        p = vertices[i]
        way = vec3(float(float64(p[0]) - eye[0]), float(float64(p[1]) - eye[1]), float(float64(p[2]) - eye[2]))
    n = int(3)
    for k in range(n):
        rays[6 * i + k] = float(eye[k])
        rays[6 * i + 3 + k] = way[k]


@kernel
def keep_free_kernel(occluded: array(dtype=uint8), seen: array(dtype=uint8)):
    """Drop what is occluded."""
    i = tid()
    if occluded[i] != uint8(0):
        seen[i] = uint8(0)


def plant_trees(vertices, triangles):
    """What rays are cast against: SceneTrees of one mesh in its own coordinates."""
    return SceneTrees([TriangleTree(vertices, triangles)], [0], np.eye(4)[None])


def drop_hidden(vertices, image, pictures, trees, seen):
    """Clear the mask `seen` (uint8 [m]) where the mesh hides the vertex from a picture's camera; the mask itself."""
    rays = empty(6 * vertices.size, float32, vertices.device)
    launch(aim_rays_kernel, vertices.size, [vertices, image, pictures, seen, rays])
    launch(keep_free_kernel, vertices.size, [test_occlusions(trees, rays, 0.0, SHORT), seen])
    return seen
