"""Nodes of a glTF scene: mesh transforms and skin joints at rest.

Khronos, "glTF 2.0 Specification", sections 3.5 and 3.7.3.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.coordinates import quiet
from ...core.quaternions import quaternions_to_rotations
from .gltf_arrays import GltfArrays
from .gltf_file import GltfFile


@dataclass
class Tree:
    """The scene's nodes: `T_world_node` by node index, the nodes `with_mesh` in scene order, and `joints` by skin."""

    T_world_node: dict[int, NDArray[np.float64]]
    with_mesh: list[int]
    joints: dict[int, NDArray[np.float64]] = field(default_factory=dict)


def list_scene_nodes(file: GltfFile) -> Tree:
    """The nodes of the displayed scene. Raises `FileError` on cycles or invalid transforms."""
    nodes, scenes = file.objects("nodes"), file.objects("scenes")
    if scenes:
        roots = file.node_indices(file.take("scenes", file.content.get("scene", 0), "scene"), "nodes", "a scene")
    else:
        below = {child for k, node in enumerate(nodes) for child in file.node_indices(node, "children", f"nodes {k}")}
        roots = [number for number in range(len(nodes)) if number not in below]
    waiting, tree = [(number, np.eye(4)) for number in reversed(roots)], Tree({}, [])
    while waiting:
        number, T_parent = waiting.pop()
        node = file.take("nodes", number, "a node or scene")
        if number in tree.T_world_node:
            raise file.error(f"nodes {number} is duplicated in the node tree")
        with quiet():
            T = T_parent @ _transform_of(file, node, f"nodes {number}")
        if not np.isfinite(T).all():
            raise file.error(f"nodes {number} has a transform beyond the range of numbers")
        tree.T_world_node[number] = T
        if "mesh" in node:
            tree.with_mesh.append(number)
        waiting += [(child, T) for child in reversed(file.node_indices(node, "children", f"nodes {number}"))]
    return tree


def _transform_of(file: GltfFile, node: dict[str, Any], what: str) -> NDArray[np.float64]:
    if "matrix" in node:
        return file.numbers(node, "matrix", what, [0.0] * 16).reshape(4, 4).T  # column-major
    T = np.eye(4)
    quaternion = file.numbers(node, "rotation", what, [0.0, 0.0, 0.0, 1.0])
    square = float((quaternion * quaternion).sum())
    if not 0.5 < square < 2:  # a rounded unit quaternion
        raise file.error(f"{what}: rotation is not a unit quaternion")
    R = quaternions_to_rotations((quaternion / math.sqrt(square))[None])[0]
    T[:3, :3] = R * file.numbers(node, "scale", what, [1.0, 1.0, 1.0])
    T[:3, 3] = file.numbers(node, "translation", what, [0.0, 0.0, 0.0])
    return T


def joint_transforms(arrays: GltfArrays, tree: Tree, number: int) -> NDArray[np.float64]:
    """Joint transforms of a skin from the bind pose to the world, shape (j, 4, 4)."""
    if number not in tree.joints:
        tree.joints[number] = _read_joints(arrays, tree, number)
    return tree.joints[number]


def _read_joints(arrays: GltfArrays, tree: Tree, number: int) -> NDArray[np.float64]:
    file, what = arrays.file, f"skins {number}"
    skin = file.take("skins", number, "a node")
    joints = file.node_indices(skin, "joints", what)
    for joint in joints:
        if joint not in tree.T_world_node:
            raise file.error(f"{what}: its joint nodes {joint} is not in the scene")
    if not joints:
        raise file.error(f"{what} has no joints")
    transforms = np.array([tree.T_world_node[joint] for joint in joints])
    if "inverseBindMatrices" not in skin:
        return transforms
    binds = arrays.accessor(skin["inverseBindMatrices"], f"inverseBindMatrices of {what}", ("MAT4",), "f4")
    if len(binds) < len(joints):
        raise file.error(f"{what} has {len(joints)} joints, but {len(binds)} inverse bind matrices")
    with quiet():
        transforms = transforms @ binds[: len(joints)].reshape(-1, 4, 4).transpose(0, 2, 1).astype(np.float64)
    if not np.isfinite(transforms).all():
        raise file.error(f"{what} has a joint transform beyond the range of numbers")
    return transforms


def blend_joints(
    file: GltfFile, transforms: NDArray[np.float64], joints: NDArray[Any], weights: NDArray[Any], what: str
) -> NDArray[np.float64]:
    """Transform of each vertex, shape (n, 4, 4): mean of its `joints` (n, k) with normalized `weights` (n, k)."""
    weights = weights.astype(np.float64)
    sums = weights.sum(axis=1)
    wrong = ~(np.isfinite(weights).all(axis=1) & (weights >= 0).all(axis=1) & (sums > 0))
    if wrong.any():
        raise file.error(f"{what}: invalid joint weights", where=f"vertex {int(np.argmax(wrong))}")
    joints = np.where(weights > 0, joints, 0)
    if joints.max() >= len(transforms):
        raise file.error(f"{what} refers to joint {joints.max()}, of {len(transforms)}")
    weights /= sums[:, None]
    blended = np.zeros((len(joints), 4, 4))
    for k in range(joints.shape[1]):
        blended += weights[:, k, None, None] * transforms[joints[:, k]]
    return blended


def move_points(points: NDArray[Any], transforms: NDArray[np.float64]) -> NDArray[np.float64]:
    with quiet():
        return (
            np.einsum("...ij,...j->...i", transforms[..., :3, :3], points.astype(np.float64)) + transforms[..., :3, 3]
        )


def transform_normals(normals: NDArray[Any], transforms: NDArray[np.float64]) -> NDArray[np.float64]:
    """Transform normals by cofactor matrices, which preserve the side under mirroring, and normalize them."""
    A = transforms[..., :3, :3]
    with quiet():
        cofactors = np.stack(
            [np.cross(A[..., k, :], A[..., (k + 1) % 3, :]) for k in (1, 2, 0)], axis=-2
        )  # rows 1 x 2, 2 x 0, 0 x 1
        transformed = np.einsum("...ij,...j->...i", cofactors, normals.astype(np.float64))
        transformed = transformed * np.sign(np.linalg.det(A))[..., None]
        lengths = np.linalg.norm(transformed, axis=-1, keepdims=True)
        return np.divide(transformed, lengths, out=np.zeros_like(transformed), where=lengths > 0)
