"""Helpers of orientation tests: a call, random signs, and a surface with known normals."""

import numpy as np

import pointloom as loom


def orient(points, normals, k, device, **options):
    cloud = loom.PointCloud(points, normals=normals, device=device)
    return cloud.orient_normals_consistent_tangent_plane(k, **options).normals


def random_signs(rng, normals):
    return (normals * rng.choice([-1, 1], (len(normals), 1))).astype(np.float32)


def agreement(actual, expected):
    return float(((actual * expected).sum(axis=1) > 0).mean())


def sphere(rng, count, radius=1.0):
    outward = rng.normal(size=(count, 3))
    outward /= np.linalg.norm(outward, axis=1, keepdims=True)
    return radius * outward, outward
