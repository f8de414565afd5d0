"""Occlusion of points by the mesh, by rays that end 0.1 % before the point, and depth images of the mesh."""

import numpy as np

from ..array_types import Mask, Points, Scalars, Triangles
from ..lang import array, float32, float64, isfinite, kernel, launch, tid, uint8, vec3
from ..memory import empty
from ..rays.ray_casting import cast_rays, test_occlusions
from ..rays.scene_trees import SceneTrees
from ..rays.triangle_tree import TriangleTree
from .stacked_images import StackedImages, camera_center

FREE_RAY_FRACTION = 0.999  # fraction of the ray that must be free


@kernel
def aim_pixels_kernel(image: int, stack: StackedImages, rays: array(dtype=float32)):
    """Ray through each pixel's center. Its parameter is the depth."""
    i = tid()
    eye = camera_center(image, stack)
    T = stack.poses[image]
    lens = stack.lenses[image]
    width = stack.sizes[image][0]
    x = (float64(i % width) - lens[2]) / lens[0]
    y = (float64(i // width) - lens[3]) / lens[1]
    n = int(3)
    for k in range(n):
        rays[6 * i + k] = float(eye[k])
        rays[6 * i + 3 + k] = float(T[0, k] * x + T[1, k] * y + T[2, k])


@kernel
def drop_infinite_kernel(depth: array(dtype=float32)):
    i = tid()
    if not isfinite(depth[i]):
        depth[i] = 0.0


@kernel
def aim_rays_kernel(
    vertices: array(dtype=vec3), image: int, stack: StackedImages, mask: array(dtype=uint8), rays: array(dtype=float32)
):
    """Ray from the camera to each vertex. Zero-length where not needed."""
    i = tid()
    eye = camera_center(image, stack)
    way = vec3(0.0, 0.0, 0.0)
    if mask[i] != 0:
        p = vertices[i]
        way = vec3(float(float64(p[0]) - eye[0]), float(float64(p[1]) - eye[1]), float(float64(p[2]) - eye[2]))
    n = int(3)
    for k in range(n):
        rays[6 * i + k] = float(eye[k])
        rays[6 * i + 3 + k] = way[k]


@kernel
def keep_free_kernel(occluded: array(dtype=uint8), mask: array(dtype=uint8)):
    i = tid()
    if occluded[i] != 0:
        mask[i] = 0


def plant_trees(vertices: Points, triangles: Triangles) -> SceneTrees:
    """SceneTrees of one mesh in its own coordinates."""
    return SceneTrees([TriangleTree(vertices, triangles)], [0], np.eye(4)[None])


def render_depth(image: int, stack: StackedImages, trees: SceneTrees) -> Scalars:
    """Depth of the mesh in an image, float32 (pixels). 0 if empty."""
    width, height, _ = stack.layout[image].tolist()
    rays = empty(6 * width * height, float32, stack.device)
    launch(aim_pixels_kernel, width * height, [image, stack, rays])
    depth = cast_rays(trees, rays)[0].t_hit
    launch(drop_infinite_kernel, depth.size, [depth])
    return depth


def drop_hidden(vertices: Points, image: int, stack: StackedImages, trees: SceneTrees, mask: Mask) -> Mask:
    """Clear `mask` (uint8 (m), in place, returned) for vertices that the mesh hides from a camera."""
    rays = empty(6 * vertices.size, float32, vertices.device)
    launch(aim_rays_kernel, vertices.size, [vertices, image, stack, mask, rays])
    launch(keep_free_kernel, vertices.size, [test_occlusions(trees, rays, 0.0, FREE_RAY_FRACTION), mask])
    return mask
