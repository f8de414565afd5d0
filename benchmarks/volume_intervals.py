"""Coverage of the intervals of `loom.volume_change` in repeated surveys, the table of docs/change.md.

Each case is 20 x 20 m with a noise of 3 cm, surveyed twice at new positions. The seeds are 20,000 and the following.
Nothing was chosen by the held-out cases. Run `python benchmarks/volume_intervals.py 200`.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

import pointloom as loom

Array = NDArray[np.float64]
SIDE, NOISE, FIRST_SEED = 20.0, 0.03, 20_000
CONE = np.pi * 6**2 * 1.5 / 3  # volume of the cone [m^3]


def even(rng: np.random.Generator, density: float) -> Array:
    return rng.random((2, round(density * SIDE**2))) * SIDE


def lines(spacing: float) -> Callable[..., Array]:
    """Scan lines along y."""

    def positions(rng: np.random.Generator, density: float) -> Array:
        x = np.repeat(np.arange(0, SIDE, spacing) + rng.uniform(0, spacing), round(density * SIDE * spacing)) % SIDE
        return np.stack([x, rng.random(len(x)) * SIDE])

    return positions


def viewed(x0: float) -> Callable[..., Array]:
    """Seen from (x0, 10), 2 m above the ground, with a density of 1 / r^2."""

    def positions(rng: np.random.Generator, density: float) -> Array:
        count, found = round(density * SIDE**2), np.empty((2, 0))
        while found.shape[1] < count:
            x, y = rng.random((2, 4 * count)) * SIDE
            seen = rng.random(4 * count) < 29 / ((x - x0) ** 2 + (y - SIDE / 2) ** 2 + 4)
            found = np.concatenate([found, np.stack([x, y])[:, seen]], axis=1)
        return found[:, :count]

    return positions


def flank(x: Array, y: Array) -> NDArray[np.bool_]:
    return (np.abs(y - 10) < 3) & (x > 11) & (x < 14.5)


def north_east(x: Array, y: Array) -> NDArray[np.bool_]:
    return (np.abs(x - y) < 4.2) & (x + y > 21.5) & (x + y < 26.5)


def summit(x: Array, y: Array) -> NDArray[np.bool_]:
    return (np.abs(y - 10) < 1.75) & (x > 8) & (x < 12)


def on_flat_ground(x: Array, y: Array) -> NDArray[np.bool_]:
    return (np.abs(y - 4) < 1.75) & (x > 2) & (x < 8)


@dataclass(frozen=True)
class Case:
    """Two surveys: slope, waves of 0.3 m, patterns, points per m^2, cell [m], and errors of the second survey."""

    slope: float = 0.0
    waves: float = 0.0
    patterns: tuple[Callable[..., Array], Callable[..., Array]] = (even, even)
    density: tuple[float, float] = (10, 10)
    cell: float = 1.0
    pile: bool = False
    shadow: Callable[..., NDArray[np.bool_]] | None = None
    outliers: float = 0.0
    drift: float = 0.0
    given: float = 0.0
    offset: float = 0.0
    scale: float = 1.0
    origin: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def survey(self, rng: np.random.Generator, epoch: int) -> loom.PointCloud:
        x, y = self.patterns[epoch](rng, self.density[epoch])
        z = self.slope * x + self.waves * np.sin(x / 3) * np.cos(y / 4) + NOISE * rng.normal(size=len(x))
        z += (rng.random(len(x)) < self.outliers) * rng.uniform(0.2, 2.0, len(x))
        keep = np.ones(len(x), bool)
        if epoch:
            z += self.pile * 1.5 * np.maximum(0, 1 - np.hypot(x - 10, y - 10) / 6) + self.offset
            z += self.drift * rng.normal()
            keep = keep if self.shadow is None else ~self.shadow(x, y)
        return loom.PointCloud(np.column_stack([x, y, z])[keep] * self.scale + np.array(self.origin))

    def measure(self, seed: int) -> tuple[float, float, bool]:
        """Error of the net volume and half width [m^3], and whether the result is reliable."""
        rng = np.random.default_rng(seed)
        surveys = self.survey(rng, 0), self.survey(rng, 1)
        error = self.given * self.scale
        found = loom.volume_change(*surveys, self.cell * self.scale, registration_error=error)
        volumes = np.array([found.net, found.net_uncertainty]) / self.scale**3
        return float(volumes[0] - self.pile * CONE), float(volumes[1]), found.reliable


TWO_SIDES = viewed(-5), viewed(25)
CASES: dict[str, Any] = {
    "even, 10 points": Case(),
    "even, slope 0.3, 1.25 points": Case(0.3, density=(1.25, 1.25)),
    "even, slope 0.8, 4 points": Case(0.8, density=(4, 4)),
    "even, cone on slope 0.5": Case(0.5, pile=True),
    "lines 0.9 m, slope 0.5 with waves": Case(0.5, 0.3, (lines(0.9),) * 2),
    "lines 0.9 m, slope 0.5 with waves, 4 points": Case(0.5, 0.3, (lines(0.9),) * 2, (4, 4)),
    "two sides, slope 0.3": Case(0.3, patterns=TWO_SIDES),
    "two sides, slope 0.8": Case(0.8, patterns=TWO_SIDES),
    "cone, shadow on the flank": Case(pile=True, shadow=flank),
    "cone, shadow on the summit": Case(pile=True, shadow=summit),
    "flat, shadow": Case(shadow=on_flat_ground),
    "5% of points 0.2 to 2 m high": Case(0.3, outliers=0.05),
    "registration 2 cm, given": Case(drift=0.02, given=0.02),
    "registration 2 cm, not given": Case(drift=0.02),
    "cone, heights differ by 20 cm": Case(pile=True, offset=0.2),
}
HELD_OUT: dict[str, Any] = {
    "even, slope 1.5, 20 points": Case(1.5, density=(20, 20)),
    "even, slope 0.8 with waves, 1.25 points": Case(0.8, 0.3, density=(1.25, 1.25)),
    "even, slope 0.8, 4 then 20 points": Case(0.8, density=(4, 20)),
    "lines 0.3 m, slope 0.8 with waves": Case(0.8, 0.3, (lines(0.3),) * 2),
    "lines 0.6 m, slope 1.5 with waves, 4 points": Case(1.5, 0.3, (lines(0.6),) * 2, (4, 4)),
    "lines 0.8 m then even, slope 0.8 with waves": Case(0.8, 0.3, (lines(0.8), even)),
    "lines 0.9 m, slope 0.5 with waves, UTM": Case(0.5, 0.3, (lines(0.9),) * 2, origin=(412_300, 5_651_200, 300)),
    "two sides, slope 1.5, 20 points": Case(1.5, patterns=TWO_SIDES, density=(20, 20)),
    "two sides, slope 0.3 with waves, cells 0.5 m": Case(0.3, 0.3, TWO_SIDES, cell=0.5),
    "two sides, slope 0.3 with waves, cells 2 m": Case(0.3, 0.3, TWO_SIDES, cell=2.0),
    "cone, shadow in the north-east": Case(pile=True, shadow=north_east),
    "cone on slope 0.5, shadow, cells 0.5 m": Case(0.5, pile=True, shadow=flank, cell=0.5),
    "slope 0.3 with waves, shadow, mm": Case(0.3, 0.3, shadow=on_flat_ground, scale=1000.0),
    "5% of points high, 4 points, cells 2 m": Case(0.3, 0.3, density=(4, 4), outliers=0.05, cell=2.0),
    "cone on slope 0.5, registration 2 cm, given": Case(0.5, pile=True, drift=0.02, given=0.02),
    "lines 0.5 m, slope 0.8, registration 2 cm, not given": Case(0.8, patterns=(lines(0.5),) * 2, drift=0.02),
    "cone, heights differ by 47 m": Case(pile=True, offset=47.0),
}


def main() -> None:
    count = int(sys.argv[1])
    print("| case | bias | sd | half width | holds | holds or warning | warning | half width / 1.96 rms error |")
    print("|---|---|---|---|---|---|---|---|")
    for title, cases in (("", CASES), (" *", HELD_OUT)):
        for name, case in cases.items():
            found = [case.measure(FIRST_SEED + number) for number in range(count)]
            errors, halves, reliable = (np.array(each) for each in zip(*found, strict=True))
            holds = np.abs(errors) <= halves
            ratio = halves.mean() / (1.96 * np.sqrt((errors**2).mean()))
            shares = " | ".join(f"{100 * part.mean():.0f}%" for part in (holds, holds | ~reliable, ~reliable))
            row = f"{errors.mean():.2f} | {errors.std():.2f} | {halves.mean():.2f} | {shares} | {ratio:.2f} |"
            print(f"| {name}{title} | {row}", flush=True)


if __name__ == "__main__":
    main()
