"""An interrupted depth search resumes at the next picture, with bitwise identical results."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.photogrammetry.mvs import plane_search

from .made_pictures import scene, three


def bytes_of(maps):
    return [part.tobytes() for each in maps for part in (each.depth, each.normals, each.confidence)]


def test_an_interrupted_search_resumes_at_the_next_picture(tmp_path, monkeypatch):
    cameras = three()
    pictures, sparse = scene(cameras)
    expected = bytes_of(loom.mvs.estimate_depth_maps(pictures, cameras, sparse))
    steps, matched, match = [], [], plane_search._PhaseRun.match
    monkeypatch.setattr(
        plane_search._PhaseRun, "match", lambda phase, i: matched.append((phase.number, i)) or match(phase, i)
    )

    def run(stop):
        matched.clear()

        def progress(name, done, total):
            steps.append(total)
            if done == stop:
                raise KeyboardInterrupt

        return loom.mvs.estimate_depth_maps(pictures, cameras, sparse, going=tmp_path / "going", progress=progress)

    for stop in (2, 4, 6, 9):
        with pytest.raises(KeyboardInterrupt):
            run(stop)
    phases = steps[0] // 3
    maps = run(None)
    assert bytes_of(maps) == expected
    assert matched == [(k // 3, k % 3) for k in range(9, 3 * phases)]  # finished pictures are not matched again


def test_truncated_files_are_matched_again(tmp_path):
    cameras = three()
    pictures, sparse = scene(cameras)
    expected = loom.mvs.estimate_depth_maps(pictures, cameras, sparse, going=tmp_path / "going")
    files = sorted((tmp_path / "going").iterdir())
    files[0].write_bytes(files[0].read_bytes()[:-7])
    files[1].write_bytes(b"")
    np.save(files[2], np.zeros((3, 4), np.float32))
    again = loom.mvs.estimate_depth_maps(pictures, cameras, sparse, going=tmp_path / "going")
    assert bytes_of(again) == bytes_of(expected)
