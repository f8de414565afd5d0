"""The sofa of the demo: points off its surface by the noise, normals that look out of it, a surface that is right."""

import numpy as np
import pytest

from pointloom.app.demos import demo_object
from pointloom.app.demos.demo_object import LARGEST_RMSE, SofaFigures, make_sofa, scan_sofa
from pointloom.core.devices import resolve_device
from pointloom.core.timing import Clock
from pointloom.data.scenes.furniture import furnished_room, sofa


@pytest.mark.slow
def test_points_lie_off_the_surface_by_the_noise_and_not_without(device, monkeypatch):
    monkeypatch.setattr(demo_object, "POINTS", 8000)
    where = resolve_device(device)
    solids = sofa().solids(where)
    noisy, exact = (demo_object._distances(scan_sofa(noise=n, device=where).points, solids) for n in (True, False))
    assert 0.9 * 0.003 < np.sqrt(np.mean(noisy**2)) < 1.05 * 0.003
    assert np.quantile(np.abs(exact), 0.95) < 3e-4  # but in the creases, which the grid rounds


@pytest.mark.slow
def test_normals_look_out_of_the_sofa(monkeypatch):
    cloud = scan_sofa(device=resolve_device("cpu"))
    solids = sofa().solids(resolve_device("cpu"))
    ahead, behind = (demo_object._distances(cloud.points + s * 0.03 * cloud.normals, solids) for s in (1, -1))
    assert (ahead > behind).mean() > 0.99
    assert cloud.normal_disagreement() < 0.02


@pytest.mark.slow
def test_the_surface_is_closed_and_near_the_true_one():
    clock = Clock()
    mesh, figures = make_sofa(seed=3, noise=True, device=resolve_device("cpu"), clock=clock)
    told = figures.to_json()
    assert told["watertight"] and len(mesh) == told["triangles"]
    assert figures.median < 0.0012 and figures.rmse < 0.002
    assert list(clock.seconds) == ["scan", "poisson"]
    assert "closed; off the true surface by" in str(figures)


@pytest.mark.slow
def test_a_seed_gives_the_same_bits_and_another_one_others(monkeypatch):
    monkeypatch.setattr(demo_object, "POINTS", 2000)
    first, again, other = (scan_sofa(seed=s, device=resolve_device("cpu")).points for s in (1, 1, 2))
    assert first.tobytes() == again.tobytes() != other.tobytes()


def test_a_surface_is_poor_beyond_the_limit_and_not_at_it():
    at, beyond = (SofaFigures({}, 9, 0.0, factor * LARGEST_RMSE, 0.0) for factor in (1, 1.02))
    assert at.why_poor() is None
    assert beyond.why_poor() == "the sofa's surface is off by 5.1 mm, more than 5"


def test_the_sofa_is_part_of_the_room():
    alone, room = sofa(), furnished_room()
    places = [tuple(center) for center in room.centers]
    assert len(alone.centers) == 12
    assert all(tuple(center) in places for center in alone.centers)
