"""PagedTSDFVolume beside TSDFVolume: processor time a frame and memory, and whether both have the same bits.

    python benchmarks/paged_volume.py [--frames 200] [--voxel-size 0.01] [--share 0.3]

A camera goes along a corrugated wall, 10 cm a frame, and comes back. The paged volume holds `share` of the blocks.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

import pointloom as loom

CAMERA = loom.PinholeCameraIntrinsic(320, 240, 262.5, 262.5, 159.5, 119.5)


def walk(count: int) -> Iterator[tuple[Any, Any]]:
    """Depth [m] and T_camera_world of each frame."""
    columns = (np.arange(320) - 159.5) / 262.5
    for k in range(count):
        x = 0.1 * min(k, count - k)
        depth = 1.5 + 0.1 * np.sin(3 * (x + 1.5 * columns))
        pose = np.eye(4)
        pose[0, 3] = -x
        yield np.tile(depth, (240, 1)).astype(np.float32), pose


def fused(volume: Any, count: int) -> float:
    """Seconds of all threads a frame."""
    spent = 0.0
    for depth, pose in walk(count):
        begin = time.process_time()
        volume.integrate(depth, CAMERA, pose)
        spent += time.process_time() - begin
    return spent / count


def main() -> None:
    """Print a line a volume."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--frames", type=int, default=200)
    parser.add_argument("--voxel-size", type=float, default=0.01)
    parser.add_argument("--share", type=float, default=0.3)
    given = parser.parse_args()
    sizes: dict[str, Any] = {"voxel_size": given.voxel_size, "color": False}
    fused(loom.TSDFVolume(**sizes), 2)  # compiles
    whole = loom.TSDFVolume(**sizes)
    seconds = fused(whole, given.frames)
    print(f"in memory: {seconds * 1e3:.2f} ms a frame, {whole.block_count:,} blocks, {whole.memory_bytes / 1e6:.0f} MB")
    most = int(given.share * whole.block_count)
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder) / "pages"
        with loom.PagedTSDFVolume(place, **sizes, max_blocks=most, page_blocks=8) as volume:
            paged = fused(volume, given.frames)
            mb, ratio = volume.memory_bytes / 1e6, paged / seconds
            pages = sum(1 for _ in place.glob("0*.npz"))
            print(
                f"paged: {paged * 1e3:.2f} ms a frame ({ratio:.2f} times), {most:,} blocks, {mb:.0f} MB, {pages} pages"
            )
            begin = time.process_time()
            volume.save()
            print(f"save: {time.process_time() - begin:.2f} s")
            begin = time.process_time()
            mesh = volume.extract_triangle_mesh(0)
            took = time.process_time() - begin
            begin = time.process_time()
            expected = whole.extract_triangle_mesh(0)
            same = (mesh.vertices == expected.vertices).all() and (mesh.triangles == expected.triangles).all()
            print(f"mesh: {took:.2f} s, in memory {time.process_time() - begin:.2f} s; the same bits: {bool(same)}")


if __name__ == "__main__":
    main()
