"""
Feet, meters and UTM without losing a millimetre
================================================

Survey files are in feet as often as in meters, and far from the origin: an easting of 630,087 m has no millimeters
left in 32 bits. Units are read from the file and never guessed, and coordinates are kept about an origin. Take this
page when lengths come out 3.28 times too long, or when points tremble.
"""

import tempfile
import warnings
from pathlib import Path

import numpy as np

import pointloom as loom
from pointloom.core.units import LengthUnit

folder = Path(tempfile.mkdtemp())
rng = np.random.default_rng(1)

# %%
# **Far from the origin.** A wall of 8 by 3 m at UTM coordinates, a point every centimetre. As float32 the coordinates
# would jump by 3 to 50 cm; here each keeps its place to a fraction of a millimetre, since positions are float32 about
# an origin in float64.
along, up = np.meshgrid(np.arange(0, 8, 0.01), np.arange(0, 3, 0.01))
wall = np.column_stack([630_087.0 + along.ravel(), 4_833_442.0 + 0.2 * along.ravel(), 553.0 + up.ravel()])
cloud = loom.PointCloud(wall)
rounded = wall.astype(np.float32).astype(np.float64)
print(
    f"stored to {1000 * np.abs(cloud.points - wall).max():.4f} mm; as float32 "
    f"{1000 * np.abs(rounded - wall).max():.0f} mm"
)
print("origin:", cloud.origin)
assert np.abs(cloud.points - wall).max() < 1e-6 * 10
assert np.abs(rounded - wall).max() > 0.1

# %%
# So normals are right too: all of the wall look one way.
normals = cloud.estimate_normals(max_nn=12).normals
across = np.array([0.2, -1.0, 0.0]) / np.hypot(0.2, 1.0)
print(f"normals off by at most {np.degrees(np.arccos(np.abs(normals @ across).min().clip(0, 1))):.3f} degrees")
assert np.abs(normals @ across).min() > np.cos(np.radians(1.0))

# %%
# **Feet.** The unit is a property of the cloud, is written to formats that have a place for it, and comes back.
# ``to_unit`` converts; setting ``unit`` only says what the numbers are.
feet = loom.PointCloud(rng.uniform(0, 100, (2000, 3)), unit="US survey foot")
loom.write_point_cloud(folder / "feet.las", feet)
back = loom.read_point_cloud(folder / "feet.las")
meters = back.to_unit("metre")
print(
    f"read as {back.unit.name} ({back.unit.symbol}, {back.unit.meters:.7f} m): "
    f"{np.ptp(back.points[:, 0]):.2f} {back.unit.symbol} wide,",
    f"{np.ptp(meters.points[:, 0]):.3f} m",
)
assert back.unit == "US survey foot" and meters.unit == "metre"
assert np.allclose(meters.points, feet.points * 1200 / 3937, atol=2e-3)

# %%
# Two units that meet are a warning, as mixing them has lost spacecraft. Made an error, it stops a pipeline there.
with warnings.catch_warnings():
    warnings.simplefilter("error", loom.UnitWarning)
    try:
        feet.compute_point_cloud_distance(meters)
    except loom.UnitWarning as error:
        print("UnitWarning:", error)
    else:
        raise AssertionError("feet and meters met in silence")
assert np.median(feet.to_unit("metre").compute_point_cloud_distance(meters)) < 1e-3

# %%
# A unit that has no name here is made: the length of one, in meters.
link = LengthUnit("Gunter's link", "li", 0.201168)
field = loom.PointCloud([[0, 0, 0], [100, 0, 0]], unit=link).to_unit("metre")
print(f"a chain of 100 links is {field.points[1, 0]:.4f} m")
assert abs(field.points[1, 0] - 20.1168) < 1e-4

# %%
# **Degrees** are no lengths: a radius of 0.001 degrees is 111 m one way and 80 m the other. ``project_to_utm`` makes
# meters of them. ``epsg=`` is the zone, or a cloud, to give several clouds of one site the same zone.
longitude = -79.3871 + rng.uniform(0, 0.002, 5000)
latitude = 43.6426 + rng.uniform(0, 0.002, 5000)
hill = 100 + 20 * np.exp(-(((longitude + 79.3861) / 5e-4) ** 2) - ((latitude - 43.6436) / 5e-4) ** 2)
degrees = loom.PointCloud(np.column_stack([longitude, latitude, hill]), unit="degree")
utm = loom.project_to_utm(degrees)
other = loom.project_to_utm(degrees.select_by_index(range(9)), epsg=degrees)
size = np.ptp(utm.points, axis=0)
print(f"{size[0]:.1f} by {size[1]:.1f} m")
assert np.allclose(other.points, utm.points[:9]) and abs(size[0] - 161) < 6 and abs(size[1] - 222) < 6
assert utm.unit == "metre"

# %%
# The color bar of a height is in the unit that the cloud has.
image = loom.render(
    {"geometry": utm, "color_by": "height", "colormap": "viridis", "point_size": 6},
    loom.View.fit(utm.points, direction=(-0.3, 0.7, -0.55), width=960, height=640),
    color_bar=True,
)
