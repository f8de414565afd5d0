"""An experiment: Gaussian splats trained on images with pointloom's kernels, forward and backward.

    python benchmarks/splat_training.py             the owl's photographs, some minutes
    python benchmarks/splat_training.py --check     compare gradients with float64 finite differences, a second

Splats are initialized at points of the surface, as from structure from motion or a depth camera, and optimized by Adam
with the mean absolute color difference; every fifth image is held out. Prints the PSNR of held-out images before and
after, the depth error of rendered splats, and the time of a step. There is no densification, splitting or pruning, so
areas without initial points stay empty. A complete trainer also has these, harmonics and structural similarity.
"""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
from splat_gradients import PARAMETERS, Adam, compare_pixels, find_gradients, light_pixels

import pointloom as loom
from pointloom.kernels.drawing.z_buffer import View
from pointloom.kernels.lang import float32, vec3
from pointloom.kernels.memory import download, upload
from pointloom.pcd.splat_images import columns_of, list_splats

NEAR = 0.01
# Step size of each parameter, as in common trainers; of positions relative to the scene's extent.
RATES = np.array([1.6e-4] * 3 + [0.05] + [0.005] * 3 + [0.001] * 4 + [0.0025 / 0.2820948] * 3)


def view_of(camera: Any, pose: Any, origin: Any) -> View:
    T = np.linalg.inv(pose)
    return View(camera, T[:3, :3], T[:3, :3] @ origin + T[:3, 3])


def step(columns: Any, view: View, target: Any, background: Any) -> tuple[Any, Any]:
    """Render the splats, and compute the gradients of the loss."""
    lists, projected = list_splats(columns, view, near=NEAR)
    light = light_pixels(lists, projected, background)
    compare_pixels(light, target)
    return light, find_gradients(columns, view, lists, projected, light, background)


def nearness(colors: Any, target: Any) -> float:
    """Peak signal-to-noise ratio [dB]."""
    return float(-10 * np.log10(np.mean((np.clip(colors, 0, 1) - target) ** 2)))


def beginnings(shots: Any, count: int, seed: int, device: Any) -> Any:
    """Splats at points of the surface, sized by the neighbor distance, with opacity 0.1."""
    rng = np.random.default_rng(seed)
    points, colors = [], []
    for pose, depth, image in zip(shots.poses, shots.depths, shots.images, strict=True):
        rows, columns = np.nonzero(depth)
        chosen = rng.choice(len(rows), count // len(shots.poses), replace=False)
        rows, columns, z = rows[chosen], columns[chosen], depth[rows[chosen], columns[chosen]]
        lens = shots.intrinsic
        camera_points = np.column_stack([(columns - lens.cx) / lens.fx * z, (rows - lens.cy) / lens.fy * z, z])
        points.append(camera_points @ pose[:3, :3].T + pose[:3, 3])
        colors.append(image[rows, columns] / 255.0)
    cloud = loom.PointCloud(np.vstack(points), device=device)
    sizes = np.clip(cloud.compute_nearest_neighbor_distance(), 1e-4, None)
    harmonics = ((np.vstack(colors) - 0.5) / 0.28209479)[:, None]
    quaternions = np.tile([1.0, 0, 0, 0], (len(cloud), 1))
    return loom.GaussianSplats(
        cloud.points, np.repeat(sizes[:, None], 3, 1), quaternions, np.full(len(cloud), 0.1), harmonics, device=device
    )


def train(arguments: argparse.Namespace) -> int:
    shots = small(loom.datasets.photographs(arguments.images), arguments.scale)
    is_held_out = np.arange(len(shots.images)) % 5 == 2
    splats = beginnings(shots, arguments.splats, arguments.seed, arguments.device)
    columns, camera = columns_of(splats), shots.intrinsic
    extent = float(np.linalg.norm(shots.poses[:, :3, 3] - shots.poses[:, :3, 3].mean(axis=0), axis=1).max()) * 1.1
    rates = RATES * ([extent] * 3 + [1] * (PARAMETERS - 3))
    views = [view_of(camera, pose, splats.cloud.origin) for pose in shots.poses]
    images = [image.reshape(-1, 3) / np.float32(255) for image in shots.images]
    targets = [upload(image, vec3, arguments.device) for image in images]
    background = vec3(0.80, 0.82, 0.85)
    adam = Adam(columns, upload(rates, float32, arguments.device))
    rng = np.random.default_rng(arguments.seed)
    report(0, columns, views, images, is_held_out, background, shots, splats)
    began, cpu = time.perf_counter(), time.process_time()
    for iteration in range(1, arguments.steps + 1):
        k = int(rng.choice(np.flatnonzero(~is_held_out)))
        light, gradients = step(columns, views[k], targets[k], background)
        adam.step(gradients)
        if iteration % arguments.every == 0 or iteration == arguments.steps:
            float(download(light.left)[0])
            wall, busy = (time.perf_counter() - began) / iteration, (time.process_time() - cpu) / iteration
            print(f"  {1000 * wall:.1f} ms per step, {1000 * busy:.1f} ms CPU")
            report(iteration, columns, views, images, is_held_out, background, shots, splats)
    if arguments.image:
        k = int(np.flatnonzero(is_held_out)[0])
        lists, projected = list_splats(columns, views[k], near=NEAR)
        rendered = download(light_pixels(lists, projected, background).colors).reshape(camera.height, camera.width, 3)
        pair = np.hstack([np.rint(255 * np.clip(rendered, 0, 1)).astype(np.uint8), shots.images[k]])
        loom.write_image(arguments.image, pair)
    return 0


def report(
    iteration: int, columns: Any, views: Any, images: Any, is_held_out: Any, background: Any, shots: Any, splats: Any
) -> None:
    values: list[list[float]] = [[], []]
    for k, view in enumerate(views):
        lists, projected = list_splats(columns, view, near=NEAR)
        colors = download(light_pixels(lists, projected, background).colors)
        values[int(is_held_out[k])].append(nearness(colors, images[k]))
    depth_errors = []
    for k in np.flatnonzero(is_held_out):
        rendered = splats.rasterize(shots.intrinsic, np.linalg.inv(shots.poses[k]))
        both = (shots.depths[k] > 0) & (rendered.median_depth > 0)
        depth_errors.append(np.median(np.abs(rendered.median_depth - shots.depths[k])[both]))
    print(f"step {iteration}: trained {np.mean(values[0]):.2f} dB, held out {np.mean(values[1]):.2f} dB, "
          f"depth error {1000 * np.mean(depth_errors):.2f} mm")  # fmt: skip


def small(shots: Any, scale: int) -> Any:
    """Images reduced by averaging squares of pixels."""
    lens = shots.intrinsic
    width, height = lens.width // scale, lens.height // scale
    camera = loom.PinholeCameraIntrinsic(
        width, height, lens.fx / scale, lens.fy / scale, (lens.cx + 0.5) / scale - 0.5, (lens.cy + 0.5) / scale - 0.5
    )
    images = [
        p.reshape(height, scale, width, scale, 3).mean(axis=(1, 3)).round().astype(np.uint8) for p in shots.images
    ]
    depths = [d[scale // 2 :: scale, scale // 2 :: scale] for d in shots.depths]
    return type(shots)(images, camera, shots.poses, depths)


def image_of(parameters: Any, camera: Any, background: Any, masks_of_splats: Any = None) -> Any:
    """Render splats with a camera at the origin in float64: [h, w, 3], and a mask of contributing pixels for each
    splat.
    """
    points, logits, scales = parameters[:, :3], parameters[:, 3], np.exp(parameters[:, 4:7])
    w, x, y, z = (parameters[:, 7:11] / np.linalg.norm(parameters[:, 7:11], axis=1, keepdims=True)).T
    rotations = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    ).transpose(2, 0, 1)
    rows, columns = np.mgrid[: camera.height, : camera.width]
    masks: list[Any] = []
    color, left = np.zeros((camera.height, camera.width, 3)), np.ones((camera.height, camera.width))
    for i in np.argsort(points[:, 2].astype(np.float32), kind="stable"):
        q, spread = points[i], (rotations[i] * scales[i]) @ (rotations[i] * scales[i]).T
        slope = np.array(
            [[camera.fx / q[2], 0, -camera.fx * q[0] / q[2] ** 2], [0, camera.fy / q[2], -camera.fy * q[1] / q[2] ** 2]]
        )
        inverse = np.linalg.inv(slope @ spread @ slope.T + 0.3 * np.eye(2))
        d = np.stack([columns - camera.fx * q[0] / q[2] - camera.cx, rows - camera.fy * q[1] / q[2] - camera.cy], -1)
        opacity = np.exp(-0.5 * np.einsum("hwi,ij,hwj->hw", d, inverse, d)) / (1 + np.exp(-logits[i]))
        masks.append(opacity >= 1 / 255 if masks_of_splats is None else masks_of_splats[len(masks)])
        opacity = opacity * masks[-1]
        own = np.maximum(0.5 + 0.28209479177387814 * parameters[i, 11:], 0)
        color += (left * opacity)[..., None] * own
        left = left * (1 - opacity)
    return color + left[..., None] * background, masks


def largest_differences(device: Any) -> Any:
    """Largest difference from finite differences of a float64 image, relative to the largest gradient of each
    parameter: [14].
    """
    rng = np.random.default_rng(0)
    camera = loom.PinholeCameraIntrinsic(32, 24, 40.0, 36.0, 15.5, 11.5)
    count = 6
    splats = loom.GaussianSplats(
        rng.normal(0, 0.2, (count, 3)) + np.array([0, 0, 2.0]),
        np.exp(rng.normal(-2.0, 0.3, (count, 3))),
        rng.normal(size=(count, 4)),
        rng.uniform(0.2, 0.7, count),
        rng.normal(0, 0.5, (count, 1, 3)),
        device=device,
    )
    columns = columns_of(splats)
    view = view_of(camera, np.eye(4), splats.cloud.origin)
    sky = np.array([0.2, 0.3, 0.4])
    rows, columns_of_pixels = np.mgrid[:24, :32]
    weights = np.stack([np.sin(rows / 6 + k) * np.cos(columns_of_pixels / 7 - k) for k in range(3)], axis=-1)
    lists, projected = list_splats(columns, view, near=NEAR)
    light = light_pixels(lists, projected, vec3(*sky))
    light.errors = upload(weights.reshape(-1, 3), vec3, device)
    gradients = download(find_gradients(columns, view, lists, projected, light, vec3(*sky)))
    arrays = [columns.points, columns.opacities, columns.scales, columns.quaternions, columns.first]
    parameters = np.column_stack([download(array) for array in arrays]).astype(np.float64)
    numeric, masks = np.zeros_like(parameters), image_of(parameters, camera, sky)[1]
    for index in np.ndindex(parameters.shape):
        losses = []
        for side in (1e-5, -1e-5):
            moved = parameters.copy()
            moved[index] += side
            losses.append(float((image_of(moved, camera, sky, masks)[0] * weights).sum()))
        numeric[index] = (losses[0] - losses[1]) / 2e-5
    return np.abs(numeric - gradients).max(axis=0) / np.abs(numeric).max(axis=0)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="compare gradients with finite differences")
    parser.add_argument("--pictures", type=int, default=36)
    parser.add_argument("--scale", type=int, default=4, help="reduction factor of the images of 640 x 480")
    parser.add_argument("--splats", type=int, default=12_000)
    parser.add_argument("--steps", type=int, default=1500)
    parser.add_argument("--every", type=int, default=500, help="steps between reports")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--device", default="cpu")
    parser.add_argument("--picture", type=Path, help="write the first held-out image, rendered and true")
    arguments = parser.parse_args()
    if not arguments.check:
        return train(arguments)
    worst = largest_differences(arguments.device)
    print(
        "largest difference of each parameter, relative to its largest gradient:", np.array2string(worst, precision=4)
    )
    return 0 if worst.max() < 1e-4 else 1


if __name__ == "__main__":
    sys.exit(main())
