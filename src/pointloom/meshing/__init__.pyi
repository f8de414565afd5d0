"""The public names of pointloom.meshing: the one list of them, for type checkers and for `public_names`."""

from .color_map.image_texturing import texture_from_images as texture_from_images
from .color_map.optimizers import optimize_color_map as optimize_color_map
from .color_map.options import ColorMapOption as ColorMapOption
from .color_map.options import ImageTextureOption as ImageTextureOption
from .color_map.texturing import texture_mesh as texture_mesh
from .mesh.cleaned_mesh import clean_mesh as clean_mesh
from .mesh.cloud_surface import create_surface as create_surface
from .mesh.isosurface import marching_cubes as marching_cubes
from .mesh.mesh_comparison import compare_meshes as compare_meshes
from .mesh.simplified_mesh import simplify_mesh as simplify_mesh
from .mesh.smoothed_mesh import smooth_mesh as smooth_mesh
from .scene.cloud_change import compare_cloud_to_mesh as compare_cloud_to_mesh
from .scene.orthophoto import orthophoto as orthophoto
from .volume.splat_fusion import fuse_splats as fuse_splats
from .volume.volume_fusion import fuse_volumes as fuse_volumes

# Results of functions, for annotations.
# isort: split
from .color_map.image_texture_result import ImageTextureResult as ImageTextureResult
from .color_map.results import ColorMapResult as ColorMapResult
from .color_map.textured_mesh import TexturedMesh as TexturedMesh
from .mesh.cleaned_mesh import CleanedMesh as CleanedMesh
from .mesh.measures import MeshCurvature as MeshCurvature
from .mesh.mesh_comparison import MeshComparison as MeshComparison
from .mesh.metrics import SurfaceMetrics as SurfaceMetrics
from .mesh.repair import MeshRepairReport as MeshRepairReport
from .mesh.simplified_mesh import SimplifiedMesh as SimplifiedMesh
from .mesh.smoothed_mesh import SmoothedMesh as SmoothedMesh
from .mesh.surface_result import SurfaceResult as SurfaceResult
from .scene.cloud_change import CloudToMeshResult as CloudToMeshResult
from .scene.orthophoto import Orthophoto as Orthophoto
from .volume.distance_field_queries import BodyCollisions as BodyCollisions
from .volume.distance_field_queries import NearestObstacles as NearestObstacles
from .volume.distance_field_views import FieldSlice as FieldSlice
from .volume.occupancy_queries import RayHits as RayHits
from .volume.tsdf_views import RayCast as RayCast
