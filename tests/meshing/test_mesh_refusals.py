"""Invalid arguments are rejected by an error that names them: one table for all operations on meshes and volumes.

Values that are not numbers are tested in tests/pcd/test_hostile_arguments.py.
"""

import re
from functools import partial

import numpy as np
import pytest

import pointloom as loom

from .color_scenes import make_scene
from .image_scenes import CAMERA, wall_scene
from .test_mesh_attributes import IMAGE, textured
from .tsdf_scenes import SMALL

CORNERS = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [np.nan] * 3]
SPHERE = loom.TriangleMesh.create_sphere(1.0, 6)
BALL = loom.PointCloud(SPHERE.vertices, normals=SPHERE.vertices)
SPLATS = loom.GaussianSplats(
    SPHERE.vertices, np.full((62, 3), 0.1), np.eye(4)[[0] * 62], np.full(62, 0.5), np.zeros((62, 3))
)
SCENE, WALL = make_scene(rows=5, width=32, height=24), wall_scene()
VOLUME = loom.TSDFVolume(voxel_size=0.05, truncation=0.1, color=False)
VOLUME.integrate(np.full((24, 32), 1.0), SMALL, np.eye(4))
BOXES = loom.RaycastingScene()
BOXES.add_triangles(loom.TriangleMesh.create_box())
SHIFTED = np.eye(4)
SHIFTED[0, 3] = 1e8


def poisson(points, normals=None, **options):
    cloud = loom.PointCloud(points, normals=points if normals is None else normals)
    return loom.TriangleMesh.create_from_point_cloud_poisson(cloud, **options)


def bake(size=8, *, factor=1, missing="", **options):
    mesh = loom.TriangleMesh.create_plane(create_uv_map=missing != "uvs")
    if missing != "uvs":
        mesh.triangle_uvs = mesh.triangle_uvs * factor
    if missing != "colors":
        mesh.vertex_colors = np.zeros((4, 3))
    return mesh.bake_vertex_colors(size, **options)


CUBE = loom.PointCloud(np.indices([2, 2, 2]).reshape(3, -1).T)
FINE = loom.TriangleMesh(np.zeros((3, 3)), np.zeros((10_001, 3), int))
bend = partial(
    loom.TriangleMesh(CORNERS, [[0, 1, 2]]).deform_as_rigid_as_possible,
    constraint_vertex_indices=[0, 1], constraint_vertex_positions=np.eye(3)[:2], max_iter=3,
)  # fmt: skip
color_map = partial(
    loom.meshing.optimize_color_map,
    mesh=SCENE.mesh, images_rgbd=SCENE.frames, camera_trajectory=SCENE.path(), intrinsic=SCENE.camera,
)  # fmt: skip
texture = partial(
    loom.meshing.texture_from_images,
    mesh=WALL.mesh, images=WALL.images, cameras=CAMERA, extrinsics=WALL.extrinsics,
)  # fmt: skip
NAMES = {
    "loom": loom, "np": np, "nan": np.nan, "inf": np.inf, "eye": np.eye(4), "make": loom.TriangleMesh,
    "box": loom.TriangleMesh.create_box(), "corners": loom.TriangleMesh(CORNERS, [[0, 1, 2]]), "ball": BALL,
    "none": loom.TriangleMesh(), "sphere": SPHERE.vertices, "textured": textured(), "IMAGE": IMAGE,
    "splats": SPLATS, "volume": VOLUME, "shifted": SHIFTED, "camera": SMALL, "s": SCENE, "poses": SCENE.poses,
    "boxes": BOXES, "frame": loom.WorldFrame(48.75, 9.0), "poisson": poisson, "color_map": color_map,
    "rigid": loom.meshing.ColorMapOption(), "texture": texture, "wall": WALL, "scene": loom.RaycastingScene(),
    "pivot": partial(loom.TriangleMesh.create_from_point_cloud_ball_pivoting, BALL),
    "alpha_shape": partial(loom.TriangleMesh.create_from_point_cloud_alpha_shape, CUBE),
    "bend": bend, "bake": bake, "fine": FINE, "obj": object(),
    "field": loom.DistanceField.from_voxels([[0, 0, 0]], 1.0, 4.0),
    "gray": loom.RGBDImage.create_from_color_and_depth(SCENE.frames[0].color, SCENE.frames[0].depth),
}  # fmt: skip
VALUES = """
box.extrude_rotation(0, [0, 0, 1]) | angle: expected a nonzero
box.remove_vertices_by_mask([True, False]) | mask: expected shape [8]
box.remove_triangles_by_mask([True, False]) | mask: expected shape [12]
make.from_polygon([[0, 0], [1, 0], [1, 1]], holes=[[[0, 0, 0], [1, 0, 0], [1, 1, 0]]]) | holes: expected the same number
make.from_polygon([[0, 0], [1, 1], [2, 2]]) | outline, holes: expected polygons
make.revolve(X) | [[1, 0]]; [[-1, 0], [1, 0]] | profile: expected at least two points
make.create_isosurfaces(np.zeros((3, 3, 3)), X) | 1e60; [0, -1e60] | contour_values: expected numbers within float32
make.create_coordinate_frame(origin=[1e300, 0, 0]) | origin:
box.slice_plane([0, 0, 0], [0, 0, 1], [[0.0]]) | contour_values: expected shape [k]
box.slice_plane([0, 0, 0], [0, 0, 1], [[0.0]], cap=True) | contour_values: expected shape [k]
field.collides([[0, 0, 0]] * 3, X) | [0.1, 0.2]; [[0.1]] * 3 | radii: expected one, or 3, one per center
field.collides_bodies([], [eye]) | spheres: expected at least one row
field.to_array(X) | [[0, 0, 0], [0, 1, 1]]; [[1, 1, 1], [0, 0, 0]] | bounds: expected a low corner below a high one
loom.write_triangle_mesh("a.glb", box, write_ascii=True) | write_ascii:
box.voxelize(0.5, [1e300, 0, 0], [2e300, 1, 1]) | min_bound:
loom.PagedTSDFVolume("pages", voxel_size=0.1, page_blocks=10**6) | page_blocks: expected at most
texture(cameras=loom.SfmModel([], [], np.zeros((0, 4, 4)))) | extrinsics: expected None, because the model
texture(cameras=loom.SfmModel([], [], np.zeros((0, 4, 4))), extrinsics=None) | cameras: expected a model with images
loom.volume_change(ball, ball, 0.5, classes=[2]) | classes: expected None, because
loom.meshing.fuse_splats(splats, camera, [shifted], voxel_size=1e-6) | voxel_size:
make(X, [[0, 1, 2]]) | np.zeros((2, 4)) | vertices:
make(np.eye(3), [[0, 1, X]]) | 3; -1 | triangles:
make(np.eye(3), [[0, 1, 2]], X=np.zeros((2, 3))) | vertex_normals | vertex_normals:
make(np.eye(3), [[0, 1, 2]], origin=[0, 0]) | origin:
bend(constraint_vertex_indices=X) | []; [0, 0]; [0, 4]; [-1, 1]; [0, 3] | constraint_vertex_indices:
bend(constraint_vertex_positions=X) | [[0, 0, 0]]; [[0, 0, inf]] * 2 | constraint_vertex_positions:
bend(max_iter=X) | -1; 10_001 | max_iter:
bend(energy="springs") | energy:
bend(smoothed_alpha=-0.1) | smoothed_alpha:
pivot(X) | []; 0.0; [0.1, -1.0]; nan; [inf]; 1e9 | radii:
alpha_shape(X) | 0; -1; nan; -inf; []; [1.0, -1.0]; "wide"; "0.1" | alpha:
setattr(box, "up", X) | "w"; (0, 0, 0); (1, 2) | up:
bake(missing=X) | "colors"; "uvs" | bake_vertex_colors:
bake(X) | 0; 2**15 | size
bake(gutter=X) | -1; 9 | gutter
bake(factor=X) | 2; nan | triangle_uvs:
scene.add_instance(0, eye) | geometry_id: expected a geometry id below 0, got 0
scene.cast_rays(np.zeros((3, 5))) | rays:
scene.test_occlusions(np.zeros((3, 6)), -1) | tnear
scene.create_rays_pinhole(180, [0, 0, 0], [0, 0, 1], [0, 1, 0], 2, 2) | fov_deg
scene.create_rays_pinhole(60, [0, 0, 1], [0, 0, 1], [0, 1, 0], 2, 2) | center, eye: the camera is at the point
scene.create_rays_pinhole(60, [0, 0, 0], [0, 0, 1], [0, 0, 1], 2, 2) | up
scene.create_rays_pinhole(np.zeros((3, 3)), eye, 2, 2) | intrinsic_matrix
scene.create_rays_pinhole(np.eye(3), eye, 2**15, 2**15) | width_px, height_px:
boxes.set_pose(0, 2 * eye) | pose:
loom.meshing.compare_cloud_to_mesh(ball, box, radius=-1) | radius:
loom.meshing.compare_cloud_to_mesh(ball, box, max_distance=0) | max_distance:
loom.meshing.create_surface(ball, radii=[0.1]) | radii:
loom.meshing.create_surface(ball, "ball", depth=7) | depth:
loom.meshing.create_surface(ball, "alpha", density_quantile=0.1) | density_quantile:
loom.meshing.create_surface(ball, alpha=0.1) | alpha:
loom.meshing.create_surface(ball, "voronoi") | method:
loom.meshing.create_surface(ball, density_quantile=1) | density_quantile:
poisson(X) | np.zeros((0, 3)); np.ones((1, 3)); np.ones((40, 3)) | cloud:
poisson(sphere, np.zeros((62, 3))) | cloud:
poisson(np.full((9, 3), nan)) | cloud:
poisson(3e38 * sphere, sphere, scale=1.3) | cloud, scale:
make.create_from_point_cloud_poisson(loom.PointCloud(sphere)) | the cloud has no normals:
poisson(sphere, depth=X) | 1; 21 | depth:
poisson(sphere, depth=4, envelope=X) | make(box.vertices * 9 - 4, box.triangles[1:]); fine | envelope:
poisson(sphere, width=X) | -1; 1e-9 | width:
poisson(sphere, scale=X) | 0.99; 17.0, depth=5 | scale:
poisson(sphere, point_weight=X) | -1; 1001 | point_weight:
poisson(sphere, samples_per_node=1e-4) | samples_per_node:
loom.meshing.marching_cubes(np.zeros((3, X)), 0) | 3; 1, 3 | field:
loom.meshing.marching_cubes(np.zeros((2, 2, 2)), 1e39) | level:
loom.meshing.marching_cubes(np.zeros((2, 2, 2)), 0, spacing=X) | 1.0; (1, 0, 1); (1, 1e-60, 1) | spacing:
loom.meshing.marching_cubes(np.zeros((2, 2, 2)), 0, spacing=(1, 1e39, 1)) | origin, spacing:
loom.meshing.marching_cubes(np.zeros((2, 2, 2)), 0, origin=(nan, 0, 0)) | origin, spacing:
box.scale(1e60) | scale, center:
box.paint_uniform_color([255, 0, 0]) | color:
box.vertex_attributes.__setitem__("a", X) | [1, 2]; np.zeros((8, 2, 2)) | a:
make([[1e6, 0, 0]], [], origin=[0, 0, 0]).merge_close_vertices(1e-20) | eps:
box.merge_close_vertices(0) | eps:
box.remove_small_components(min_triangles=0) | min_triangles:
box.remove_small_components(min_area=-1) | min_area:
box.clip_plane(X, [0, 0, 1]) | [0, 0]; [0, 0, inf] | point:
box.clip_plane([0, 0, 0], [0, 0, 0]) | normal:
box.slice_plane(X, [0, 0, 1]) | [0, 0]; [0, 0, inf] | point:
box.slice_plane([0, 0, 0], [0, 0, 0]) | normal:
corners.compute_geodesic_distances(X) | []; [4]; [-1]; [3]; 0 | sources:
make.from_polygon(X) | [[0, 0], [1, 1], [1, 0], [0, 1]]; [[0, 0], [1, 0], [2, 0]] | outline, holes:
make.from_polygon([[0, 0], [1, 0]]) | outline:
make.from_polygon([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.1]]) | outline, holes:
make.from_polygon([[0, 0], [nan, 0], [1, 1]]) | outline:
box.compute_metrics(box, [0.0]) | fscore_radius:
box.compute_metrics(none) | mesh2:
none.compute_metrics(box) | compute_metrics:
box.compute_error_map(box, max_distance=-1) | max_distance:
box.remesh_isotropic(X) | 0; 1e-9 | edge_length:
box.remesh_isotropic(0.1, -1) | iterations:
box.remesh_isotropic(0.1, feature_angle=200) | feature_angle:
box.repair(hole_size=X) | 0; inf | hole_size:
box.repair(merge_distance=X) | 0; inf | merge_distance:
loom.meshing.simplify_mesh(X) | box; box, triangles=9, ratio=0.5 | pass one of triangles, ratio and voxel_size
loom.meshing.simplify_mesh(box, ratio=0) | ratio:
loom.meshing.simplify_mesh(box, voxel_size=1, max_error=1) | max_error, boundary_weight:
loom.meshing.smooth_mesh(box, "simple", mu=-1) | mu:
loom.meshing.smooth_mesh(box, strength=1) | strength:
loom.meshing.smooth_mesh(box, "bilateral") | method:
loom.meshing.clean_mesh(box, min_triangles=0) | min_triangles:
loom.meshing.compare_meshes(box, box, limit=0) | limit:
box.sample_points_uniformly(X) | 0; 2**31 | number_of_points:
box.sample_points_poisson_disk(X) | 0; 2**31 | number_of_points:
box.sample_points_poisson_disk(X) | 4_000_000; 10, init_factor=2**30 | number_of_points, init_factor:
make.concatenate([]) | meshes:
make(box.vertices, box.triangles[1:]).get_volume() | get_volume: expected a watertight mesh
make(box.vertices, np.vstack([box.triangles[1:], box.triangles[:1, ::-1]])).get_volume() | get_volume:
make(box.vertices, box.triangles[1:]).center_of_mass | center_of_mass: expected a watertight mesh
make(box.vertices, box.triangles[1:]).moment_of_inertia | moment_of_inertia: expected a watertight mesh
make(box.vertices, np.vstack([box.triangles[1:], box.triangles[:1, ::-1]])).center_of_mass | center_of_mass:
make(box.vertices * [1, 1, 0], box.triangles).center_of_mass | center_of_mass: expected a mesh that encloses a volume
none.moment_of_inertia | moment_of_inertia: expected triangles that enclose a volume, got none
make.create_box(width=0) | width:
make.create_sphere(resolution=X) | 1; 10**6 | resolution:
make.create_cylinder(resolution=2) | resolution:
make.create_cylinder(split=0) | split:
make.create_cone(radius=-1) | radius:
make.create_torus(tubular_resolution=2) | tubular_resolution:
make.create_arrow(cone_split=0) | cone_split:
make.create_mobius(flatness=0) | flatness:
make.create_mobius(twists=-1) | twists:
make.create_mobius(width_split=1) | width_split:
make.create_coordinate_frame(origin=[0, 0]) | origin:
make.create_coordinate_frame(origin=[0, inf, 0]) | origin:
box.filter_smooth_laplacian(X) | -1; 10_001 | number_of_iterations:
box.filter_smooth_laplacian(filter_scope=X) | "vertices"; "normal" | filter_scope:
box.subdivide_midpoint(X) | -1; 15 | number_of_iterations:
box.subdivide_loop(X) | -1; 2**31 - 1 | number_of_iterations:
setattr(textured, "triangle_uvs", np.zeros((40, 2))) | triangle_uvs:
setattr(textured, "triangle_material_ids", X) | [0]; np.full(40, -1) | triangle_material_ids:
setattr(textured, "textures", [IMAGE.astype(float)]) | textures[0]:
box.trim(X, 0) | [1, 2]; np.zeros((8, 1)); np.full(8, nan) | vertex_values:
box.trim(np.zeros(8), inf) | level:
box.trim(np.zeros(8), 0, island_ratio=X) | -0.1; 2 | island_ratio:
X.voxelize(0.1, solid=True) | none; make.create_mobius(); box.remove_triangles_by_mask(np.arange(12) == 3) | voxelize:
box.voxelize(0.5).check_if_included([[0, 0]]) | queries:
box.voxelize(0) | voxel_size:
box.voxelize(1e-12) | voxel_size, min_bound, max_bound:
box.voxelize(X) | 3e-9; 1e-6 | voxel_size:
box.voxelize(0.1, [0, 0]) | min_bound:
box.voxelize(0.1, [0, 0, nan]) | min_bound:
box.voxelize(0.1, [0, 0, 0], [1, 1, -1]) | min_bound, max_bound:
loom.meshing.orthophoto(box, 0) | cell:
loom.meshing.orthophoto(box, 1.0, epsg=32632) | epsg:
loom.meshing.orthophoto(box, 1.0, frame=frame, crs="EPSG:4326") | crs:
loom.meshing.orthophoto(box, 1.0, frame=frame, epsg=4326) | epsg:
loom.meshing.orthophoto(box, 1.0, bounds=(0, 0, 0, 1)) | bounds:
loom.meshing.orthophoto(box, 1.0, corner=(1e300, 0)) | corner:
box.simplify_quadric_decimation(-1) | target_number_of_triangles:
box.simplify_quadric_decimation(2, maximum_error=-1) | maximum_error:
box.simplify_quadric_decimation(2, boundary_weight=X) | -1; inf | boundary_weight:
box.simplify_vertex_clustering(X) | 0; 1e-30 | voxel_size:
box.simplify_vertex_clustering(1, "median") | contraction:
scene.compute_distance([[0, 0]]) | query_points:
scene.compute_signed_distance([[0, 0, 0]], nsamples=2) | nsamples:
loom.meshing.fuse_splats(splats, X, voxel_size=0.1) | camera; extrinsics=[eye] | extrinsics:
loom.meshing.fuse_splats(splats, voxel_size=0) | voxel_size:
loom.meshing.fuse_splats(splats, voxel_size=0.1, depth_max=-1) | depth_max:
loom.meshing.fuse_splats(splats, voxel_size=0.1, depth_max=1e-3) | extrinsics:
loom.meshing.fuse_splats(splats.select_by_index([]), voxel_size=0.1) | splats:
volume.ray_cast(camera, eye, depth_min=X) | 0; 2, depth_max=1 | depth_min:
volume.ray_cast(camera, eye, weight_threshold=-1) | weight_threshold:
volume.ray_cast(camera, np.diag([2.0, 2, 2, 1])) | extrinsic:
volume.ray_cast(camera, shifted) | extrinsic:
volume.extract_triangle_mesh(-1) | weight_threshold:
volume.extract_point_cloud(-1) | weight_threshold:
field.collides([[9, 9, 9]], 3.0) | radii:
field.collides_bodies([[0, 0, 0, 1]], np.stack([eye, 2 * eye])) | poses[1]
loom.DistanceField.from_voxels([[0, 0, 0]], 0.001, 50.0) | max_distance:
loom.DistanceField.from_array(np.zeros((40_000, 1, 1), bool)) | occupied:
loom.meshing.fuse_volumes([], []) | volumes:
loom.meshing.fuse_volumes([volume], [eye, eye]) | poses:
loom.meshing.fuse_volumes([volume], [2 * eye]) | poses[0]:
loom.meshing.fuse_volumes([volume, volume], [eye, shifted]) | poses:
loom.meshing.fuse_volumes([volume], [eye], voxel_size=0.0) | voxel_size:
loom.meshing.fuse_volumes([volume], [eye], truncation=X) | 0.2; 0.01 | truncation:
loom.meshing.fuse_volumes([volume], [eye], color=True) | color:
color_map(camera_trajectory=loom.Trajectory(poses[:4])) | camera_trajectory.poses:
color_map(intrinsic=[s.camera] * 2) | intrinsic:
color_map(intrinsic=loom.PinholeCameraIntrinsic(16, 12, 15.0, 15.0, 7.5, 5.5)) | images_rgbd[0]:
color_map(images_rgbd=[], camera_trajectory=loom.Trajectory(poses[:0])) | images_rgbd:
color_map(camera_trajectory=loom.Trajectory([*poses[:3], nan * eye, poses[4]])) | camera_trajectory.poses[3]:
color_map(occlusion="no") | occlusion:
loom.meshing.ColorMapOption(maximum_allowable_depth=0) | maximum_allowable_depth:
loom.meshing.ColorMapOption(depth_threshold_for_visibility_check=0) | depth_threshold_for_visibility_check:
loom.meshing.ColorMapOption(number_of_vertical_anchors=0) | number_of_vertical_anchors:
color_map(images_rgbd=[f.color for f in s.frames], occlusion="depth") | occlusion:
color_map(images_rgbd=[gray] * 5) | images_rgbd[0]:
texture(mesh=box.remove_triangles_by_mask(np.ones(12, bool))) | mesh:
texture(cameras=loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)) | images[0]:
texture(extrinsics=[*wall.extrinsics[:2], np.full((4, 4), nan)]) | extrinsics[2]:
texture(extrinsics=X) | wall.extrinsics[:2]; None | extrinsics:
texture(images=[], extrinsics=[]) | images:
"""
TYPES = """
color_map(option=obj) | option: expected a ColorMapOption, got object
color_map(mesh=obj) | mesh: expected a TriangleMesh, got object
volume.integrate_points(sphere, [0, 0, 0], carve=X) | 1; "yes"; None | carve: expected True or False
make.from_open3d(obj) | mesh: expected an open3d
box.slice_plane([0, 0, 0], [0, 0, 1], cap=X) | 1; "yes" | cap: expected True, False or None
make(np.eye(3), [[0, 1, 2]], textures=X) | "a.png"; {}; 5 | textures: expected a list of images
make(np.eye(3), [[0.0, 1.0, 2.0]]) | triangles:
make(np.eye(3), [[0, 1, 2]], vertex_colors=[["red"] * 3] * 3) | vertex_colors:
bend(constraint_vertex_indices=[0.0, 1.0]) | constraint_vertex_indices:
bend(energy=1) | energy:
pivot(X) | "0.1"; ["0.1"]; True; obj | radii:
setattr(box, "up", obj) | up:
poisson(sphere, depth=4, envelope="box") | envelope:
loom.meshing.compare_cloud_to_mesh(ball, ball) | mesh:
loom.meshing.create_surface(ball, "alpha", alpha=[0.1, 0.2]) | alpha:
poisson(sphere, depth=5.0) | depth:
loom.meshing.marching_cubes(np.zeros((2, 2, 2), complex), 0) | field:
box.vertex_attributes.__setitem__("a", X) | ["x"] * 8; np.zeros(8, np.longdouble) | a:
box.remove_small_components(min_triangles=1.5) | min_triangles:
corners.compute_geodesic_distances([0.5]) | sources:
box.compute_metrics([[0, 0, 0]]) | mesh2:
make.create_sphere(resolution=2.5) | resolution:
box.filter_smooth_laplacian(1.0) | number_of_iterations:
box.filter_smooth_laplacian(filter_scope=3) | filter_scope:
box.subdivide_loop(1.5) | number_of_iterations:
setattr(textured, "triangle_material_ids", np.zeros(40)) | triangle_material_ids:
setattr(textured, "textures", "picture.png") | textures:
box.trim(["a"] * 8, 0) | vertex_values:
box.simplify_quadric_decimation(10.0) | target_number_of_triangles:
box.simplify_vertex_clustering(1, 1) | contraction:
box.voxelize(0.5).check_if_included(None) | queries
box.is_intersecting("cube") | other:
loom.DistanceField() | DistanceField: create one with from_point_cloud
scene.compute_closest_points("abc") | query_points:
scene.add_triangles([[0, 0, 0]]) | mesh: expected a TriangleMesh
scene.add_triangles(box, [[0, 1, 2]]) | triangles: expected None with a mesh
scene.create_rays_pinhole(60, [0, 0, 0]) | create_rays_pinhole: expected
loom.meshing.fuse_splats(ball, voxel_size=0.1) | splats:
volume.ray_cast("prime sense", eye) | intrinsic:
loom.meshing.fuse_volumes([volume, None], [eye, eye]) | volumes[1]:
color_map(camera_trajectory=poses) | camera_trajectory:
color_map(images_rgbd=[np.zeros((24, 32, 3))] * 5) | images_rgbd[0]:
"""
KEYS = "box.vertex_attributes.__setitem__('vertex_colors', np.zeros((8, 3))) | 'vertex_colors:"
KINDS = {ValueError: VALUES, TypeError: TYPES, KeyError: KEYS}


def rows_of(line):
    """(call, argument) for each value that replaces X in the call."""
    call, *values, name = line.split(" | ")
    return [(re.sub(r"\bX\b", value, call), name) for value in (values[0].split("; ") if values else [""])]


@pytest.mark.parametrize(
    ("call", "name", "error"),
    [(*row, error) for error, lines in KINDS.items() for line in lines.strip().splitlines() for row in rows_of(line)],
)
def test_invalid_arguments_are_rejected_by_name(call, name, error):
    with pytest.raises(error, match=f"^{re.escape(name)}"):
        eval(call, dict(NAMES))
