"""What the mesh itself hides from a picture's camera, by rays: of points, or as a depth picture of the mesh.

A ray to a point ends a thousandth of its length before it, so the point's own triangles are not met, and what is hidden
by less than that counts as seen. 24 B written and read a ray beside the walk through the tree (rays/).
"""

import numpy as np

from ..array_types import Mask, Points, Scalars, Triangles
from ..lang import array, float32, float64, isfinite, kernel, launch, tid, uint8, vec3
from ..memory import empty
from ..rays.ray_casting import cast_rays, test_occlusions
from ..rays.scene_trees import SceneTrees
from ..rays.triangle_tree import TriangleTree
from .posed_pictures import PosedPictures, camera_place

SHORT = 0.999  # share of the way to the point that must be free


@kernel
def aim_pixels_kernel(image: int, pictures: PosedPictures, rays: array(dtype=float32)):
    """The ray through each pixel's centre; its parameter is the depth."""
    i = tid()
    eye = camera_place(image, pictures)
    T = pictures.poses[image]
    lens = pictures.lenses[image]
    width = pictures.sizes[image][0]
    x = (float64(i % width) - lens[2]) / lens[0]
    y = (float64(i // width) - lens[3]) / lens[1]
    n = int(3)
    for k in range(n):
        rays[6 * i + k] = float(eye[k])
        rays[6 * i + 3 + k] = float(T[0, k] * x + T[1, k] * y + T[2, k])


@kernel
def drop_infinite_kernel(depth: array(dtype=float32)):
    """0 in place of infinity."""
    i = tid()
    if not isfinite(depth[i]):
        depth[i] = 0.0


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
    if seen[i] != 0:
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
    if occluded[i] != 0:
        seen[i] = 0


def plant_trees(vertices: Points, triangles: Triangles) -> SceneTrees:
    """What rays are cast against: SceneTrees of one mesh in its own coordinates."""
    return SceneTrees([TriangleTree(vertices, triangles)], [0], np.eye(4)[None])


def render_depth(image: int, pictures: PosedPictures, trees: SceneTrees) -> Scalars:
    """The mesh's depth in a picture, float32 [pixels]; 0 where it is not."""
    width, height, _ = pictures.layout[image].tolist()
    rays = empty(6 * width * height, float32, pictures.device)
    launch(aim_pixels_kernel, width * height, [image, pictures, rays])
    depth = cast_rays(trees, rays)[0].t_hit
    launch(drop_infinite_kernel, depth.size, [depth])
    return depth


def drop_hidden(vertices: Points, image: int, pictures: PosedPictures, trees: SceneTrees, seen: Mask) -> Mask:
    """Clear the mask `seen` (uint8 [m]) where the mesh hides the vertex from a picture's camera; the mask itself."""
    rays = empty(6 * vertices.size, float32, vertices.device)
    launch(aim_rays_kernel, vertices.size, [vertices, image, pictures, seen, rays])
    launch(keep_free_kernel, vertices.size, [test_occlusions(trees, rays, 0.0, SHORT), seen])
    return seen
