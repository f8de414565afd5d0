"""
Feet, meters and UTM coordinates
================================

Survey files may be in feet, in degrees, or far from the origin: at an easting of 630,087 m, 32-bit coordinates have no
millimeters. On this page you read and convert units, and keep full precision for large coordinates. Use it if lengths
are too large by a factor of 3.28, or if distant clouds look distorted.
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
# Large coordinates
# -----------------
# The example is a wall of 8 x 3 m in UTM coordinates with a point per centimeter. Stored as float32, these coordinates
# would have errors of up to 0.5 m. A cloud stores float32 positions relative to an origin in float64, so the error is a
# fraction of a millimeter.
along, up = np.meshgrid(np.arange(0, 8, 0.01), np.arange(0, 3, 0.01))
wall = np.column_stack([630_087.0 + along.ravel(), 4_833_442.0 + 0.2 * along.ravel(), 553.0 + up.ravel()])
cloud = loom.PointCloud(wall)
rounded = wall.astype(np.float32).astype(np.float64)
print(
    f"error {1000 * np.abs(cloud.points - wall).max():.4f} mm; as float32 {1000 * np.abs(rounded - wall).max():.0f} mm"
)
print("origin:", cloud.origin)
assert np.abs(cloud.points - wall).max() < 1e-6 * 10
assert np.abs(rounded - wall).max() > 0.1

# %%
# Normals are accurate, too: all normals of the wall are parallel.
normals = cloud.estimate_normals(max_nn=12).normals
true_normal = np.array([0.2, -1.0, 0.0]) / np.hypot(0.2, 1.0)
print(
    f"error of the normals at most {np.degrees(np.arccos(np.abs(normals @ true_normal).min().clip(0, 1))):.3f} degrees"
)
assert np.abs(normals @ true_normal).min() > np.cos(np.radians(1.0))

# %%
# Units of length
# ---------------
# The unit is a property of the cloud. Formats with a field for it store it. ``to_unit`` converts the coordinates.
# Setting ``unit`` only declares the unit of existing coordinates.
feet = loom.PointCloud(rng.uniform(0, 100, (2000, 3)), unit="US survey foot")
loom.write_point_cloud(folder / "feet.las", feet)
read_back = loom.read_point_cloud(folder / "feet.las")
meters = read_back.to_unit("metre")
print(
    f"read as {read_back.unit.name} ({read_back.unit.symbol}, {read_back.unit.meters:.7f} m): "
    f"{np.ptp(read_back.points[:, 0]):.2f} {read_back.unit.symbol} wide,",
    f"{np.ptp(meters.points[:, 0]):.3f} m",
)
assert read_back.unit == "US survey foot" and meters.unit == "metre"
assert np.allclose(meters.points, feet.points * 1200 / 3937, atol=2e-3)

# %%
# A call with two clouds of different units emits a warning. Turned into an error, it stops the pipeline.
with warnings.catch_warnings():
    warnings.simplefilter("error", loom.UnitWarning)
    try:
        feet.compute_point_cloud_distance(meters)
    except loom.UnitWarning as error:
        print("UnitWarning:", error)
    else:
        raise AssertionError("expected a UnitWarning")
assert np.median(feet.to_unit("metre").compute_point_cloud_distance(meters)) < 1e-3

# %%
# A unit without a predefined name is defined by its length in meters.
link = LengthUnit("Gunter's link", "li", 0.201168)
field = loom.PointCloud([[0, 0, 0], [100, 0, 0]], unit=link).to_unit("metre")
print(f"a chain of 100 links is {field.points[1, 0]:.4f} m")
assert abs(field.points[1, 0] - 20.1168) < 1e-4

# %%
# Degrees
# -------
# Degrees are not lengths: at this latitude, 0.001 degrees are 111 m north and 80 m east. ``project_to_utm`` converts
# them to meters. ``epsg`` is the zone, or a cloud whose zone is used, so that several clouds have the same zone.
longitude = -79.3871 + rng.uniform(0, 0.002, 5000)
latitude = 43.6426 + rng.uniform(0, 0.002, 5000)
hill = 100 + 20 * np.exp(-(((longitude + 79.3861) / 5e-4) ** 2) - ((latitude - 43.6436) / 5e-4) ** 2)
degrees = loom.PointCloud(np.column_stack([longitude, latitude, hill]), unit="degree")
utm = loom.project_to_utm(degrees)
same_zone = loom.project_to_utm(degrees.select_by_index(range(9)), epsg=degrees)
size = np.ptp(utm.points, axis=0)
print(f"{size[0]:.1f} by {size[1]:.1f} m")
assert np.allclose(same_zone.points, utm.points[:9]) and abs(size[0] - 161) < 6 and abs(size[1] - 222) < 6
assert utm.unit == "metre"

# %%
# Color bar
# ---------
# The color bar of a height uses the unit of the cloud.
image = loom.render(
    {"geometry": utm, "color_by": "height", "colormap": "viridis", "point_size": 6},
    loom.View.fit(utm.points, direction=(-0.3, 0.7, -0.55), width=960, height=640),
    color_bar=True,
)

# %%
# What to change
# --------------
# - ``unit``: "foot", "US survey foot", "millimetre" or a ``LengthUnit``.
# - The easting of the wall [m]: 6,300,000 instead of 630,087. How large is the float32 error?
# - ``epsg``: the code of a neighboring UTM zone.
#
# Next
# ----
# - :doc:`File formats and units </files>`: which formats store a unit.
# - :ref:`Ground, buildings and trees in an airborne scan <sphx_glr_gallery_clouds_plot_ground_and_buildings.py>`
