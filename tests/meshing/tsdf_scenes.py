"""Planes and spheres seen by cameras, fused volumes, and their contents."""

import numpy as np

import pointloom as loom
from pointloom.kernels.memory import upload
from pointloom.kernels.volumes.tsdf_blocks import BLOCK_SIDE, block_box

from ..interruptions import run_lines

VOXEL, TRUNCATION = 0.02, 0.08
RADIUS = 0.4
CAMERA = loom.PinholeCameraIntrinsic(160, 120, 131.0, 133.0, 79.2, 59.9)
FINE = loom.PinholeCameraIntrinsic(640, 480, 524.0, 532.0, 317.3, 239.9)  # where nearest-pixel steps would be visible
SMALL = loom.PinholeCameraIntrinsic(32, 24, 31.0, 29.0, 15.3, 11.7)


def look_at(eye, target=(0, 0, 0), up=(0.1, 0.2, 1.0)):
    forward = np.subtract(target, eye) / np.linalg.norm(np.subtract(target, eye))
    right = np.cross(forward, up)
    right /= np.linalg.norm(right)
    T = np.eye(4)
    T[:3, 0], T[:3, 1], T[:3, 2], T[:3, 3] = right, np.cross(forward, right), forward, eye
    return T


def rays_of(camera, T):
    """Directions [h, w, 3] in the world, with depth along z as parameter."""
    v, u = np.mgrid[: camera.height, : camera.width]
    local = np.stack([(u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, np.ones(u.shape)], axis=-1)
    return local @ T[:3, :3].T


def plane_depth(camera, T, normal, offset):
    """Depth of the plane normal . x = offset; 0 where it is behind the camera."""
    with np.errstate(divide="ignore"):
        d = (offset - T[:3, 3] @ normal) / (rays_of(camera, T) @ normal)
    return np.where((d > 0) & np.isfinite(d), d, 0)


def sphere_depth(camera, T, radius=RADIUS, center=(0, 0, 0)):
    rays, eye = rays_of(camera, T), T[:3, 3] - center
    a, b, c = (rays**2).sum(-1), rays @ eye, eye @ eye - radius**2
    root = b * b - a * c
    return np.where(root >= 0, (-b - np.sqrt(np.maximum(root, 0))) / a, 0)


def sphere_frames(camera=CAMERA, distance=1.3, scale=1.0, center=(0, 0, 0)):
    faces = [s * e for e in np.eye(3) for s in (-1.0, 1.0)]
    corners = [np.array([x, y, z]) / 3**0.5 for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    for direction in (*faces, *corners):
        T = look_at(np.add(direction * (distance * scale), center), center)
        yield sphere_depth(camera, T, RADIUS * scale, center), T


def fuse(frames, device, *, camera=CAMERA, voxel_size=VOXEL, truncation=TRUNCATION, depth_max=3.0):
    volume = loom.TSDFVolume(voxel_size=voxel_size, truncation=truncation, color=False, device=device)
    for depth, T in frames:
        volume.integrate(depth, camera, np.linalg.inv(T), depth_max=depth_max)
    return volume


def fused_sphere(device, **options):
    return fuse(sphere_frames(), device, **options)


def voxels_of(volume):
    """(blocks [m, 3], distances, weights, colors or None), all of shape [m, 8, 8, 8, ...], sorted by block."""
    keys = volume.blocks.keys.numpy()[: volume.block_count]
    order, used = np.argsort(keys), volume.block_count * BLOCK_SIDE**3
    shape = (-1, BLOCK_SIDE, BLOCK_SIDE, BLOCK_SIDE)
    arrays = volume.blocks.distances, volume.blocks.weights
    distances, weights = (values.numpy()[:used].reshape(shape)[order] for values in arrays)
    colors = volume.blocks.colors.numpy()[:used].reshape(*shape, 3)[order] if volume.has_color else None
    return block_box(keys[order]), distances, weights, colors


def set_voxels(volume, name, values):
    setattr(volume.blocks, name, upload(values, getattr(volume.blocks, name).dtype, volume.device))


def fingerprint(volume):
    return b"".join(a.tobytes() for a in voxels_of(volume) if a is not None)


def small_frames(rng, count):
    """Rough depth with holes, seen from random positions."""
    for _ in range(count):
        T = look_at(rng.uniform(-0.3, 0.3, 3), rng.uniform((-0.4, -0.4, 1.5), (0.4, 0.4, 2)))
        depth = 1.2 + 0.3 * rng.random((SMALL.height, SMALL.width)) * (rng.random() < 0.5)
        depth[rng.random(depth.shape) < 0.1] = 0
        yield depth, T, rng.integers(0, 256, (*depth.shape, 3), dtype=np.uint8)


def triangle_normals(mesh):
    a, b, c = mesh.vertices[mesh.triangles].transpose(1, 0, 2)
    n = np.cross(b - a, c - a)
    return n / np.linalg.norm(n, axis=1, keepdims=True), (a + b + c) / 3


def view_from(volume, T, camera=CAMERA, **options):
    options.setdefault("weight_threshold", 0)
    return volume.ray_cast(camera, np.linalg.inv(T), **options)


def assert_complete_or_absent(begin, add, files, every=1):
    """Interrupt `add` before each (or some) line of files: what it adds is either in the volume or not.

    Returns:
        The states without and with it, and the complete volume.
    """
    volume = begin()
    states, outcomes, stop = [state_of(volume)], set(), 0
    total = run_lines(lambda: add(volume), files)
    states.append(state_of(volume))
    while stop < total:
        stop += every
        volume = begin()
        run_lines(lambda: add(volume), files, stop)  # noqa: B023  runs at once
        added = volume.frame_count - 1
        outcomes.add(added)
        assert state_of(volume) == states[added], stop
        if not added:
            add(volume)
        assert (volume.frame_count, state_of(volume)) == (2, states[1]), stop
    assert outcomes == {0, 1}
    return states, volume


def state_of(volume):
    return volume.block_count, fingerprint(volume)
