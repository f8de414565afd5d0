"""PagedTSDFVolume beside TSDFVolume: CPU time per frame and memory, and whether both are bitwise identical.

    python benchmarks/paged_volume.py [--frames 200] [--voxel-size 0.01] [--share 0.3]

A camera moves along a corrugated wall, 10 cm per frame, and back. The paged volume holds `fraction` of the blocks in
memory.
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


def rendered_frames(count: int) -> Iterator[tuple[Any, Any]]:
    """Depth [m] and T_camera_world of each frame."""
    columns = (np.arange(320) - 159.5) / 262.5
    for k in range(count):
        x = 0.1 * min(k, count - k)
        depth = 1.5 + 0.1 * np.sin(3 * (x + 1.5 * columns))
        pose = np.eye(4)
        pose[0, 3] = -x
        yield np.tile(depth, (240, 1)).astype(np.float32), pose


def fused(volume: Any, count: int) -> float:
    """CPU seconds of all threads per frame."""
    seconds = 0.0
    for depth, pose in rendered_frames(count):
        begin = time.process_time()
        volume.integrate(depth, CAMERA, pose)
        seconds += time.process_time() - begin
    return seconds / count


def main() -> None:
    """Print a line for each volume."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--frames", type=int, default=200)
    parser.add_argument("--voxel-size", type=float, default=0.01)
    parser.add_argument("--share", type=float, default=0.3)
    given = parser.parse_args()
    sizes: dict[str, Any] = {"voxel_size": given.voxel_size, "color": False}
    fused(loom.TSDFVolume(**sizes), 2)  # compiles
    in_memory = loom.TSDFVolume(**sizes)
    seconds = fused(in_memory, given.frames)
    print(
        f"in memory: {seconds * 1e3:.2f} ms per frame, {in_memory.block_count:,} blocks, "
        f"{in_memory.memory_bytes / 1e6:.0f} MB"
    )
    max_blocks = int(given.fraction * in_memory.block_count)
    with tempfile.TemporaryDirectory() as folder:
        pages_folder = Path(folder) / "pages"
        with loom.PagedTSDFVolume(pages_folder, **sizes, max_blocks=max_blocks, page_blocks=8) as volume:
            paged = fused(volume, given.frames)
            mb, ratio = volume.memory_bytes / 1e6, paged / seconds
            pages = sum(1 for _ in pages_folder.glob("0*.npz"))
            print(
                f"paged: {paged * 1e3:.2f} ms per frame ({ratio:.2f} times), {max_blocks:,} blocks, {mb:.0f} MB, "
                f"{pages} pages"
            )
            begin = time.process_time()
            volume.save()
            print(f"save: {time.process_time() - begin:.2f} s")
            begin = time.process_time()
            mesh = volume.extract_triangle_mesh(0)
            seconds_of_mesh = time.process_time() - begin
            begin = time.process_time()
            expected = in_memory.extract_triangle_mesh(0)
            same = (mesh.vertices == expected.vertices).all() and (mesh.triangles == expected.triangles).all()
            print(
                f"mesh: {seconds_of_mesh:.2f} s, in memory {time.process_time() - begin:.2f} s; "
                f"bitwise identical: {bool(same)}"
            )


if __name__ == "__main__":
    main()
