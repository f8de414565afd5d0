"""Every argument of every public function rejects invalid values quickly, with an error that names it.

The checks run on the host, so only the CPU is tested. Switches (`invert`, `write_ascii`, ...) are excluded, since every
value is valid for them. Records returned by operations are excluded, too.
"""

import contextlib
import sys
from functools import cache, partial
from typing import Any

import numpy as np
import pytest

import pointloom as loom
from pointloom.cameras.panoramas import Panorama
from pointloom.cameras.undistortion import Undistortion
from pointloom.io.frames.recordings import FrameRecorder

from ..hostile import (
    call_of,
    calls_of_clouds,
    faults_of,
    faults_of_clouds,
    faults_of_exchange,
    missing_from,
    public_arguments,
    read_table,
    temporary_folder,
)
from ..io.camera_stubs import KinectStub, RealSenseStub
from ..recorded_calls import faults_of_recorded, has_record, valid_call

# One line per call that no record of an operation contains: the function and a valid value of each argument, as
# expressions over `things()`.
CALLS = """
loom.PointCloud(points=points, normals=normals, colors=colors, device="cpu", origin=three, unit="foot", crs=25832, label=row, arrays="numpy")
loom.from_any(geometry=points, device="cpu", arrays="numpy")
loom.PointCloud.concatenate(clouds=[cloud, cloud])
loom.PointCloud.create_from_depth_image(depth=depth, intrinsic=camera, extrinsic=pose, depth_scale=1.0, depth_trunc=5.0, stride=1, device="cpu", arrays="numpy")
loom.PointCloud.from_dlpack(points=points32, normals=points32, colors=points32, origin=three)
loom.PointCloud.create_from_rgbd_image(image=rgbd, intrinsic=camera, extrinsic=pose, stride=1)
cloud.array(name="points")
cloud.rotate(R=turn, center=three)
cloud.scale(scale=2.0, center=three)
cloud.segment_shape(kind="torus", distance_threshold=0.2, normal_threshold_deg=80.0, num_iterations=2000, probability=0.99, min_radius=0.0, max_radius=2.0, seed=0)
cloud.to(device="cpu", arrays="numpy")
cloud.to_unit(unit="foot")
survey.reproject(epsg=25833)
cloud.translate(translation=three)
loom.NearestNeighborSearch(cloud=cloud, device="cpu")
loom.KDTree(data=points, device="cpu")
tree.query(x=points, k=3, distance_upper_bound=0.3)
search.knn_search(queries=points, knn=3)
search.hybrid_search(queries=points, radius=0.3, max_nn=3)
search.radius_search(queries=points, radius=0.3)
loom.detect_shapes(cloud=cloud, distance_threshold=0.05, normal_threshold_deg=30.0, kinds=("plane", "sphere"), min_support=10, cluster_epsilon=0.3, num_iterations=10, probability=0.9, min_radius=0.0, max_radius=2.0, max_shapes=2, seed=0, progress=None)
loom.fit_shape(cloud=cloud, kind="plane", start=None, weights=[1.0] * len(points), seed=0)
loom.asnumpy(array=points)
loom.free_memory(device="cpu")
loom.LengthUnit(name="ell", symbol="ell", meters=1.143)
loom.AxisAlignedBoundingBox(min_bound=three, max_bound=three)
loom.AxisAlignedBoundingBox.create_from_points(points=points)
box.get_point_indices_within_bounding_box(points=points)
box.rotate(R=turn, center=three)
box.scale(scale=2.0, center=three)
box.translate(translation=three)
loom.OrientedBoundingBox(center=three, R=turn, extent=three)
loom.OrientedBoundingBox.create_from_axis_aligned_bounding_box(aabox=box)
loom.OrientedBoundingBox.create_from_points(points=points)
loom.OrientedBoundingBox.create_from_points_minimal(points=points)
turned.get_point_indices_within_bounding_box(points=points)
turned.rotate(R=turn, center=three)
turned.scale(scale=2.0, center=three)
turned.translate(translation=three)
loom.LineSet(points=points, lines=line_ends, colors=line_colors)
loom.LineSet.create_camera_visualization(intrinsic=camera, extrinsic=pose, scale=0.2)
loom.LineSet.create_from_axis_aligned_bounding_box(box=box)
loom.LineSet.create_from_oriented_bounding_box(box=turned)
loom.LineSet.create_from_point_cloud_correspondences(cloud0=cloud, cloud1=other, correspondences=line_ends)
loom.LineSet.create_from_triangle_mesh(mesh=mesh)
segments.get_line_coordinate(line_index=0)
segments.paint_uniform_color(color=three)
segments.rotate(R=turn, center=three)
segments.scale(scale=2.0, center=three)
segments.transform(transformation=pose)
segments.translate(translation=three)
loom.PinholeCameraIntrinsic(width=16, height=12, fx=10.0, fy=10.0, cx=8.0, cy=6.0)
loom.PinholeCameraIntrinsic.from_matrix(K=turn, width=16, height=12)
camera.scaled(factor=2.0)
camera.set_intrinsics(width=16, height=12, fx=10.0, fy=10.0, cx=8.0, cy=6.0)
loom.CameraModel(model="PINHOLE", width=16, height=12, params=[10.0, 10.0, 8.5, 6.5])
loom.CameraModel.from_intrinsic(intrinsic=camera)
lens.project(points=points)
lens.unproject(pixels=points[:, :2])
lens.undistorted(blank_fraction=0.5, max_size=10, size=None)
loom.Undistortion(camera=lens, blank_fraction=0.5, max_size=10, size=None, device="cpu")
straightened.apply(image=color)
loom.undistort_image(image=color, camera=lens, blank_fraction=0.5, max_size=10, size=None, device="cpu")
loom.SfmModel(names=["a", "b", "c"], cameras=[lens] * 3, T_camera_world=poses, points=points, colors=bytes3, errors=points[:, 0], observations=line_ends, pixels=points[:2, :2], left_out=["d"])
model.index_of(name="a")
model.point_cloud(device="cpu", arrays="numpy")
model.scaled(factor=2.0)
model.select(names=["a", "b"])
model.trajectory(timestamps=times)
model.transform(transformation=pose)
loom.RGBDImage(color=color, depth=depth, depth_scale=1.0, depth_trunc=3.0, device="cpu")
loom.RGBDImage.create_from_color_and_depth(color=color, depth=depth, depth_scale=1.0, depth_trunc=3.0, device="cpu")
loom.RGBDImage.create_from_nyu_format(color=color, depth=whole_depth, device="cpu")
loom.RGBDImage.create_from_redwood_format(color=color, depth=whole_depth, device="cpu")
loom.RGBDImage.create_from_sun_format(color=color, depth=whole_depth, device="cpu")
loom.RGBDImage.create_from_tum_format(color=color, depth=whole_depth, device="cpu")
loom.SelectionPolygonVolume(bounding_polygon=points, orthogonal_axis="Z", axis_min=0.0, axis_max=1.0)
volume.crop_in_polygon(points=points)
volume.crop_point_cloud(cloud=cloud)
loom.OccupancyGrid(voxel_size=0.1, hit=0.7, miss=0.4, min=0.1192, max=0.971, device="cpu")
occupancy().insert_scan(points=points, origin=[0.5, 0.5, 0.5], max_range=3.0)
occupancy_filled.cast_rays(origins=points, directions=points, max_range=3.0)
occupancy_filled.log_odds(points=points)
occupancy_filled.occupied(points=points)
occupancy_filled.probabilities(points=points)
occupancy_filled.states(points=points)
occupancy_filled.to_array(bounds=[[0.0, 0.0, 0.0], [1.0, 1.0, 1.0]])
loom.TSDFVolume(voxel_size=0.1, truncation=0.4, device="cpu")
loom.meshing.fuse_volumes(volumes=[tsdf_filled], poses=[pose], voxel_size=0.1, truncation=0.4, color=True)
tsdf().integrate_points(points=points, origin=[0.0, 0.0, 1.0], carve=True, min_range=0.0, max_range=50.0)
tsdf().integrate(depth=depth, intrinsic=camera, extrinsic=pose, color=color, depth_scale=1.0, depth_max=3.0)
tsdf().integrate_frames(depth=[depth, depth], intrinsic=camera, extrinsic=[pose, pose], color=[color, color], depth_scale=1.0, depth_max=3.0)
tsdf_filled.extract_point_cloud(weight_threshold=0.5)
tsdf_filled.extract_triangle_mesh(weight_threshold=0.5)
tsdf_filled.ray_cast(intrinsic=camera, extrinsic=pose, depth_min=0.1, depth_max=3.0, weight_threshold=0.5)
loom.DistanceField.from_point_cloud(cloud=cloud, voxel_size=0.1, max_distance=0.4, origin=three)
loom.DistanceField.from_array(occupied=cells, voxel_size=0.1, origin=three, max_distance=0.4, device="cpu")
loom.DistanceField.from_occupancy_grid(grid=occupancy_filled, max_distance=0.5)
loom.DistanceField.from_voxel_grid(grid=voxels, max_distance=0.4, device="cpu")
loom.DistanceField.from_voxels(coordinates=triangles, voxel_size=0.1, max_distance=0.4, origin=three, device="cpu")
loom.DistanceField.load(path="nowhere.npz", device="cpu")
distance_field.collides(centers=points, radii=0.1)
distance_field.collides_bodies(spheres=[[0.0, 0.0, 0.0, 0.1]], poses=poses)
distance_field.distances(points=points)
distance_field.gradients(points=points)
distance_field.is_known(points=points)
distance_field.nearest_obstacles(points=points)
distance_field.save(path="field.npz")
distance_field.slice(axis="z", position=0.5, bounds=points[:2].copy() * 0 + [[0.0], [1.0]])
distance_field.to_array(bounds=points[:2].copy() * 0 + [[0.0], [1.0]], values="squared")
loom.ImuReadings(times=times, angular_velocity=vectors, linear_acceleration=vectors, orientation=None, T_sensor_imu=pose)
loom.Trajectory(poses=poses, timestamps=times, ids=ids, crs=25832)
loom.TriangleMesh.create_from_point_cloud_poisson(cloud=cloud, depth=3, width=0.0, scale=1.1, point_weight=2.0, samples_per_node=1.5, envelope=shell)
loom.TriangleMesh(vertices=points, triangles=triangles, vertex_normals=normals, vertex_colors=colors, triangle_uvs=corner_uvs, triangle_material_ids=material_ids, textures=[image], vertex_attributes={"a": row}, triangle_attributes={"b": material_ids}, device="cpu", origin=three, arrays="numpy")
loom.TriangleMesh.create_arrow(cylinder_radius=1.0, cone_radius=1.5, cylinder_height=5.0, cone_height=4.0, resolution=20, cylinder_split=4, cone_split=1, device="cpu")
loom.TriangleMesh.create_box(width=1.0, height=1.0, depth=1.0, device="cpu")
loom.TriangleMesh.create_cone(radius=1.0, height=2.0, resolution=20, split=1, device="cpu")
loom.TriangleMesh.create_coordinate_frame(size=1.0, origin=three, device="cpu")
loom.TriangleMesh.create_cylinder(radius=1.0, height=2.0, resolution=20, split=4, device="cpu")
loom.TriangleMesh.create_ellipsoid(radius_x=1.0, radius_y=1.0, radius_z=1.0, resolution=20, device="cpu")
loom.TriangleMesh.create_icosahedron(radius=1.0, device="cpu")
loom.TriangleMesh.create_mobius(length_split=70, width_split=15, twists=1, radius=1.0, flatness=1.0, width=1.0, scale=1.0, device="cpu")
loom.TriangleMesh.create_octahedron(radius=1.0, device="cpu")
loom.TriangleMesh.create_plane(width=1.0, height=1.0, device="cpu")
loom.TriangleMesh.create_sphere(radius=1.0, resolution=20, device="cpu")
loom.TriangleMesh.create_tetrahedron(radius=1.0, device="cpu")
loom.TriangleMesh.create_torus(torus_radius=1.0, tube_radius=0.5, radial_resolution=30, tubular_resolution=20, device="cpu")
loom.TriangleMesh.create_from_point_cloud_alpha_shape(cloud=cloud, alpha=[0.5, 0.3])
loom.TriangleMesh.create_from_point_cloud_ball_pivoting(cloud=cloud, radii=[0.1, 0.2])
mesh.array(name="triangles")
shell.boolean_difference(mesh=shell)
shell.boolean_intersection(mesh=shell)
shell.boolean_union(mesh=shell)
mesh.crop(bounding_box=box)
mesh.clip_plane(point=three, normal=three)
shell.slice_plane(point=three, normal=three, contour_values=[0.0], cap=False)
mesh.section_loops(point=three, normal=three)
mesh.select_faces_by_mask(mask=material_ids > 5)
mesh.extrude_linear(vector=three, scale=1.0)
mesh.extrude_rotation(angle=90.0, axis=three, resolution=4, translation=0.0)
mesh.remesh_isotropic(edge_length=0.5, iterations=1, feature_angle=30.0)
loom.TriangleMesh.concatenate(meshes=[mesh])
loom.TriangleMesh.create_isosurfaces(volume=field, contour_values=[0.0], device="cpu", arrays="numpy")
loom.TriangleMesh.from_polygon(outline=outline, holes=[], device="cpu")
loom.TriangleMesh.revolve(profile=outline, angle=360.0, resolution=8, device="cpu")
mesh.fill_holes(hole_size=0.1)
mesh.merge_close_vertices(eps=0.1)
mesh.remove_triangles_by_index(triangle_indices=[0])
mesh.remove_vertices_by_index(vertex_indices=[0])
mesh.repair(merge_distance=0.01, hole_size=0.1)
mesh.select_by_index(indices=[0, 1, 2])
painted.bake_vertex_colors(size=8, gutter=1)
mesh.compute_uvatlas(size=64, gutter=1.0)
mesh.remove_small_components(min_triangles=1, min_area=0.1)
mesh.remove_triangles_by_mask(mask=[True, False])
mesh.remove_vertices_by_mask(mask=mask)
mesh.sample_points_poisson_disk(number_of_points=10, init_factor=5, pcl=cloud, seed=1)
mesh.sample_points_uniformly(number_of_points=50, seed=1)
mesh.simplify_quadric_decimation(target_number_of_triangles=1, maximum_error=1.0, boundary_weight=1.0)
mesh.simplify_vertex_clustering(voxel_size=0.5, contraction="quadric")
mesh.to(device="cpu", arrays="numpy")
mesh.paint_uniform_color(color=three)
mesh.rotate(R=turn, center=three)
mesh.scale(scale=2.0, center=three)
mesh.to_unit(unit="foot")
surveyed.reproject(epsg=25833)
mesh.transform(transformation=pose)
mesh.translate(translation=three)
mesh.compute_geodesic_distances(sources=[0, 1])
mesh.deform_as_rigid_as_possible(constraint_vertex_indices=[0, 1, 2], constraint_vertex_positions=points[:3], max_iter=2, energy="spokes", smoothed_alpha=0.01)
mesh.filter_sharpen(number_of_iterations=1, strength=1.0, filter_scope="all")
mesh.filter_smooth_laplacian(number_of_iterations=1, lambda_filter=0.5, filter_scope="all")
mesh.filter_smooth_simple(number_of_iterations=1, filter_scope="all")
mesh.filter_smooth_taubin(number_of_iterations=1, lambda_filter=0.5, mu=-0.53, filter_scope="all")
mesh.subdivide_loop(number_of_iterations=1)
mesh.subdivide_midpoint(number_of_iterations=1)
mapped.project_images_to_albedo(images=[color], intrinsic_matrices=[camera], extrinsic_matrices=[pose], tex_size=8)
mesh.voxelize(voxel_size=0.5, min_bound=[-1.0, -1.0, -1.0], max_bound=[1.0, 1.0, 1.0])
mesh.trim(vertex_values=points[:, 0], level=0.5, island_ratio=0.001)
loom.RaycastingScene(device="cpu")
scene.add_triangles(mesh=points, triangles=triangles, pose=pose)
scene.add_instance(geometry_id=0, pose=pose)
scene.set_pose(geometry_id=0, pose=pose)
scene.cast_rays(rays=rays)
scene.test_occlusions(rays=rays, tnear=0.0, tfar=9.0)
scene.count_intersections(rays=rays)
scene.list_intersections(rays=rays)
scene.compute_closest_points(query_points=points, nthreads=0)
scene.compute_distance(query_points=points, nthreads=0)
scene.compute_signed_distance(query_points=points, nthreads=0, nsamples=1)
scene.compute_occupancy(query_points=points, nthreads=0, nsamples=1)
mesh.compute_metrics(mesh2=shell, fscore_radius=[0.1], n_sampled_points=50, seed=1)
mesh.compute_error_map(mesh2=shell, max_distance=0.5)
mesh.is_intersecting(other=shell)
loom.meshing.clean_mesh(mesh=mesh, merge_distance=0.01, hole_size=0.1, min_triangles=1, min_area=0.0, progress=None)
loom.meshing.compare_meshes(first=mesh, second=shell, thresholds=[0.1], samples=50, limit=0.5, seed=1)
loom.meshing.simplify_mesh(mesh=mesh, triangles=1, ratio=None, voxel_size=None, max_error=1.0, boundary_weight=1.0, progress=None)
loom.meshing.smooth_mesh(mesh=mesh, method="taubin", iterations=1, lambda_filter=0.5, mu=-0.53, strength=None)
loom.meshing.create_surface(cloud=cloud, method="poisson", depth=2, density_quantile=0.1, radii=None, alpha=None, progress=None)
loom.create_depth_pyramid(depth=depth, levels=2, diff_threshold=0.1, depth_scale=1.0, device="cpu")
loom.create_normal_map(depth=depth, intrinsic=camera, invalid_fill=0.0, depth_scale=1.0, device="cpu")
loom.fill_depth_holes(depth=depth, max_pixels=9, depth_threshold=0.1, depth_scale=1.0, device="cpu")
loom.erode_depth_edges(depth=depth, radius=1, depth_threshold=0.1, depth_scale=1.0, device="cpu")
loom.meshing.compare_cloud_to_mesh(cloud=cloud, mesh=mesh, radius=0.5, registration_error=0.01, max_distance=9.0)
loom.paint_change(cloud=cloud, change=cloud.points[:, 0], limit=0.5)
loom.filter_depth_bilateral(depth=depth, kernel_size=3, value_sigma=0.03, dist_sigma=2.0, depth_scale=1.0, device="cpu")
loom.meshing.marching_cubes(field=field, level=0.0, spacing=three, origin=three, device="cpu", arrays="numpy")
loom.open_dataset(folder="nowhere", layout="auto", intrinsic=camera, every=1, skip_missing=True)
loom.open_frames(folder="nowhere", layout="auto", intrinsic=camera, every=1, depth_scale=1000.0, poses=True, skip_missing=True, resize_color=True)
loom.frames_from(frames=images, intrinsic=camera, depth_scale=1000.0, resize_color=True)
loom.LatestFrames(source=stream)
latest.close(timeout=1.0)
loom.FrameRecorder(folder="recorded", intrinsic=camera, depth_scale=1000.0)
recorder().write(frame=frame)
loom.RealSenseCamera(serial="0123", file="nowhere.bag", width=640, height=480, rate=30, color=True, timeout=5.0)
loom.AzureKinectCamera(number=0, file="nowhere.mkv", timeout=5.0)
loom.write_colmap_model(folder="model", model=model, format="bin")
loom.write_transforms(path="transforms.json", model=model, images="images")
loom.record_frames(source=stream, folder="recording", progress=None)
loom.open_recording(path="nowhere.mcap")
loom.read_copc(path="nowhere.copc.laz", within=box, spacing=0.5, device="cpu", arrays="numpy")
loom.read_e57_chunks(path="nowhere.e57", chunk_size=10, scan=0, device="cpu", arrays="numpy")
loom.read_raster(path="nowhere.tif")
raster.contour_lines(interval=0.1, levels=None)
raster.fill_gaps(max_distance=1.0, neighbors=8, device="cpu")
raster.write(path="raster.tif")
raster.write_contours(path="contours.gpkg", interval=0.1, levels=None)
loom.profile(surface=cloud, line=points[:2, :2], width=0.5, spacing=None)
loom.volume_change(before=cloud, after=other, cell=0.5, registration_error=0.01, classes=None, max_gap=0.5, corner=[0.0, 0.0])
loom.read_las_chunks(path="nowhere.las", chunk_size=10, device="cpu", arrays="numpy")
loom.read_point_cloud(path="nowhere.ply", device="cpu", scan=None, columns=None, arrays="numpy")
loom.GaussianSplats(centers=points[:2], scales=[[1.0, 1.0, 1.0]] * 2, rotations=[[1.0, 0.0, 0.0, 0.0]] * 2, opacities=[0.5, 0.6], harmonics=points[:2], device="cpu", arrays="numpy")
loom.GaussianSplats.from_cloud(cloud=splats.cloud)
loom.GaussianSplats.concatenate(splats=[splats, splats])
splats.rasterize(intrinsic=camera, extrinsic=pose, background=three, near=0.01)
loom.meshing.fuse_splats(splats=splats, intrinsic=camera, extrinsics=[pose, pose, pose, pose], voxel_size=0.2, truncation=0.6, depth_max=9.0, weight_threshold=1.0, progress=print)
splats.select_by_index(indices=[0, 1])
splats.select_by_mask(mask=[True, False])
splats.crop(bounding_box=box)
splats.clean(min_opacity=0.1, min_scale=0.01, max_scale=9.0)
splats.to(device="cpu", arrays="numpy")
splats.transform(transformation=pose)
splats.rotate(R=turn, center=three)
splats.scale(scale=2.0, center=three)
splats.translate(translation=three)
loom.read_splats(path="nowhere.ply", device="cpu", arrays="numpy")
loom.write_splats(path="splats.ply", splats=splats)
loom.read_stations(path="nowhere.e57", device="cpu", arrays="numpy")
loom.write_stations(path="stations.e57", clouds=[cloud.select_by_index([0])], poses=[pose], names=["A"], crs=25832)
loom.read_triangle_mesh(path="mesh.ply", device="cpu", up="y", arrays="numpy")
camera.write(path="camera.json")
loom.write_point_cloud(path="cloud.las", cloud=cloud, scale=0.001, like=None, crs=25832)
loom.project_to_utm(cloud=lonlat, epsg=32632)
loom.write_trajectory(path="trajectory.tum", trajectory=trajectory, format="tum", intrinsic=camera)
loom.write_triangle_mesh(path="mesh.ply", mesh=mesh, up="y")
loom.WorldFrame(latitude=47.5, longitude=8.25, altitude=430.0)
world.to_enu(points=[[47.5, 8.25, 430.0]])
world.to_geodetic(points=[[1.0, 2.0, 3.0]])
world.to_utm(points=[[1.0, 2.0, 3.0]], epsg=32632)
loom.meshing.orthophoto(mesh=mesh, cell=0.1, frame=world, epsg=32632, corner=[0.0, 0.5], bounds=None, crs=None)
photo.write(path="ortho.tif")
loom.read_color(path="nowhere.png")
loom.read_depth(path="nowhere.png")
loom.PinholeCameraIntrinsic.read(path="nowhere.json")
loom.read_trajectory(path="nowhere.log", skip_missing=True)
loom.Panorama(width=32, height=16, side=8, device="cpu")
panorama.apply(image=sphere)
loom.SelectionPolygonVolume.from_json(path="nowhere.json")
volume.to_json(path="volume.json")
loom.OccupancyGrid.load(path="nowhere.npz", device="cpu")
occupancy_filled.save(path="grid.npz")
loom.TSDFVolume.load(path="nowhere.npz", device="cpu")
tsdf_filled.save(path="volume.npz")
loom.PagedTSDFVolume(folder="pages", voxel_size=0.1, truncation=0.4, max_blocks=50, page_blocks=4, device="cpu", overwrite=True)
loom.PagedTSDFVolume.load(folder="nowhere", max_blocks=50, device="cpu")
paged().integrate(depth=depth, intrinsic=camera, extrinsic=pose, color=color, depth_scale=1.0, depth_max=3.0)
paged().integrate_frames(depth=[depth, depth], intrinsic=camera, extrinsic=[pose, pose], color=[color, color], depth_scale=1.0, depth_max=3.0)
paged().integrate_points(points=points, origin=[0.0, 0.0, 1.0], carve=True, min_range=0.0, max_range=50.0)
paged_filled.extract_parts(weight_threshold=0.5)
paged_filled.extract_point_cloud(weight_threshold=0.5)
paged_filled.extract_triangle_mesh(weight_threshold=0.5)
paged_filled.ray_cast(intrinsic=camera, extrinsic=pose, depth_min=0.1, depth_max=3.0, weight_threshold=0.5)
"""  # noqa: E501


@cache
def things() -> dict[str, Any]:
    rng = np.random.default_rng(0)
    points, row = rng.random((60, 3)), np.arange(60)
    colors, depth = rng.random((60, 3)), 1 + rng.random((12, 16))
    cloud = loom.PointCloud(points, colors=colors, label=row.astype(np.int32), unit="metre").estimate_normals(max_nn=10)
    camera = loom.PinholeCameraIntrinsic(16, 12, 10.0, 10.0, 8.0, 6.0)
    color = rng.integers(0, 255, (12, 16, 3)).astype(np.uint8)
    triangles = np.array([[0, 1, 2], [2, 3, 4]])
    corner = np.array([412300.0, 5651200.0, 120.0])
    survey, surveyed = loom.PointCloud(points + corner, crs=25832), loom.TriangleMesh(points + corner, triangles)
    surveyed.crs = 25832
    mesh = loom.TriangleMesh(points, triangles)
    mesh.unit = "metre"

    splats = loom.GaussianSplats(points[:2], [[1.0] * 3] * 2, [[1, 0, 0, 0]] * 2, [0.5, 0.6], points[:2])
    tsdf, occupancy = (partial(kind, voxel_size=0.1) for kind in (loom.TSDFVolume, loom.OccupancyGrid))
    paged = lambda: loom.PagedTSDFVolume(temporary_folder(), voxel_size=0.1)  # noqa: E731
    seen = occupancy()
    seen.insert_scan(points, [0.5, 0.5, 0.5])
    filled = tsdf()
    filled.integrate(depth, camera, np.eye(4), color)
    paged_filled = paged()
    paged_filled.integrate(depth, camera, np.eye(4), color)
    corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    mapped = loom.TriangleMesh(points, triangles, triangle_uvs=[[0, 0], [1, 0], [0, 1]] * 2)
    painted = loom.TriangleMesh.create_plane(create_uv_map=True)
    painted.vertex_colors = np.eye(4, 3)
    poses = np.tile(np.eye(4), (3, 1, 1))
    scene = loom.RaycastingScene()
    scene.add_triangles(points, triangles)
    images = [(color, depth.astype(np.float32))]
    stream = loom.frames_from(images, camera)
    lens = loom.CameraModel("SIMPLE_RADIAL", 16, 12, [10.0, 8.5, 6.5, -0.1])
    return dict(
        sphere=np.zeros((16, 32, 3), np.uint8), panorama=Panorama(32, 16),
        splats=splats, lens=lens, straightened=Undistortion(lens),
        model=loom.SfmModel(["a", "b", "c"], [lens] * 3, poses, points, observations=[[0, 1]], pixels=[[1, 2]]),
        bytes3=(255 * colors).astype(np.uint8),
        images=images, stream=stream, frame=next(iter(stream)), latest=loom.LatestFrames(stream),
        recorder=lambda: FrameRecorder(temporary_folder(), camera),
        scene=scene, rays=rng.random((5, 6)),
        loom=loom, points=points, points32=points.astype(np.float32), row=row, colors=colors, depth=depth, cloud=cloud,
        normals=cloud.normals, other=loom.PointCloud(points + 0.1), camera=camera, color=color,
        whole_depth=(1000 * depth).astype(np.uint16), three=np.array([0.5, 0.5, 0.5]), pose=np.eye(4), turn=np.eye(3),
        mask=row < 20, box=loom.AxisAlignedBoundingBox([0.1] * 3, [0.9] * 3),
        turned=loom.OrientedBoundingBox([0.5] * 3, np.eye(3), [1.0] * 3), search=loom.NearestNeighborSearch(cloud),
        tree=loom.KDTree(cloud),
        rgbd=loom.RGBDImage(color, depth), volume=loom.SelectionPolygonVolume(corners, "Z", 0.0, 1.0), tsdf=tsdf,
        occupancy=occupancy, occupancy_filled=seen, tsdf_filled=filled, paged=paged, paged_filled=paged_filled,
        mapped=mapped, mesh=mesh, triangles=triangles, survey=survey, surveyed=surveyed,
        corner_uvs=np.zeros((3 * len(triangles), 2)), material_ids=np.zeros(len(triangles), int),
        image=np.zeros((4, 4, 3), np.uint8), painted=painted, outline=[[1, 0], [2, 0], [2, 1], [1, 1]],
        shell=loom.TriangleMesh(np.vstack([40 * np.eye(3), [[-40] * 3]]), [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]),
        world=loom.WorldFrame(47.5, 8.25), photo=loom.meshing.orthophoto(painted, 0.5),
        raster=loom.rasterize(cloud, 0.25, "dsm"),
        line_ends=np.array([[0, 1], [1, 2]]), line_colors=np.eye(2, 3),
        segments=loom.LineSet(points, [[0, 1], [1, 2]]),
        field=rng.normal(size=(4, 4, 4)), poses=poses, times=np.arange(3.0),
        vectors=np.eye(3), ids=np.arange(3)[:, None],
        trajectory=loom.Trajectory(poses), lonlat=loom.PointCloud(points * [1, 1, 9] + [8, 48, 0]),
        distance_field=loom.DistanceField.from_point_cloud(cloud, 0.1, 0.5), cells=points.reshape(3, 6, 10) < 0.2,
        voxels=mesh.voxelize(0.2),
    )  # fmt: skip


HOMES = {
    "world": "WorldFrame", "raster": "Raster",
    "photo": "Orthophoto", "cloud": "PointCloud", "survey": "PointCloud", "surveyed": "TriangleMesh",
    "search": "NearestNeighborSearch", "tree": "KDTree", "box": "AxisAlignedBoundingBox",
    "turned": "OrientedBoundingBox", "camera": "PinholeCameraIntrinsic", "volume": "SelectionPolygonVolume",
    "occupancy()": "OccupancyGrid", "occupancy_filled": "OccupancyGrid",
    "paged()": "PagedTSDFVolume", "paged_filled": "PagedTSDFVolume",
    "tsdf()": "TSDFVolume", "tsdf_filled": "TSDFVolume", "mesh": "TriangleMesh", "mapped": "TriangleMesh",
    "painted": "TriangleMesh", "shell": "TriangleMesh", "scene": "RaycastingScene", "latest": "LatestFrames",
    "recorder()": "FrameRecorder", "segments": "LineSet", "lens": "CameraModel", "model": "SfmModel",
    "straightened": "Undistortion", "panorama": "Panorama",
    "splats": "GaussianSplats", "distance_field": "DistanceField",
}  # fmt: skip
# Results; errors; functions of device arrays, which are not public; and functions tested in other folders.
LEFT_OUT = {
    "DatasetError", "FileError", "DeviceError", "PointloomError", "CameraError", "NonFiniteWarning",
    "GeographicWarning", "RecordingWarning", "evaluate_depth",
    "DroppedResultWarning", "UnitWarning", "VoxelGrid",
    "DistanceField",
    "AxisAlignedBoundingBox.mask_points", "OrientedBoundingBox.mask_points",
    "PointCloud.from_open3d", "TriangleMesh.from_open3d", "find_boxes", "rasterize",
    # tests/drawing: viewer, recording, render
    "draw", "Viewer", "DetailTree", "record", "render", "write_image", "View",
    "read_view", "write_view", "CameraFrustum",
    # tests/core, tests/photogrammetry/depth, tests/rgbd
    "DepthModel", "estimate_depth",
    "fuse", "track", "check_focal", "reconstruct",
    # tests/files, tests/meshing, tests/kernels
    "read_cameras", "draw_slice", "set_num_threads", "draw_change", "paint_change",
    # tests/meshing
    "ColorMapOption", "ImageTextureOption", "optimize_color_map",
    "texture_from_images", "texture_mesh",
}  # fmt: skip
LEFT_OUT |= {
    f"Recording.{name}"
    for name in ("choose_topic", "messages", "scans", "frames", "imu", "trajectory", "transforms", "header_at")
} | {f"Recording.{name}_{how}" for name, how in (("rows", "of"), ("bytes", "at"), ("content", "at"))}
LEFT_OUT |= {  # aliases of table entries
    f"{kind.__name__}.{name}"
    for kind in (loom.PointCloud, loom.RGBDImage, loom.TriangleMesh)
    for name in dir(kind)
    if name.startswith("create_from_") and hasattr(kind, name.removeprefix("create_"))
}
CLOUDS_ONLY = {"target", "source", "other", "cloud"}
TAKES_ARRAYS = {
    "KDTree", "KDTree.query", "NearestNeighborSearch", "TriangleMesh.is_intersecting", "LatestFrames", "record_frames",
}  # or a mesh, or frames  # fmt: skip
MAY_BE_INFINITE = {"invalid_fill", "distance_upper_bound"}
# Text that a message uses instead of the argument's name.
ALSO = {
    "KDTree": "points",
    "NearestNeighborSearch": "points",
    "from_any": "points",
    "PointCloud.array": "the cloud has no",
    "TriangleMesh": "one row per triangle",
    "TriangleMesh.array": "expected one of the mesh's arrays",
    "RaycastingScene.add_triangles": "points",
}
TABLE = read_table(CALLS, HOMES)
PUBLIC = public_arguments(loom, LEFT_OUT) | public_arguments(loom.meshing, LEFT_OUT)
RECORDED = [name for name in sorted(PUBLIC) if name not in TABLE and has_record(name)]


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    """Working folder of files with hostile names; camera drivers are replaced by stubs."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(sys.modules, "pyrealsense2", RealSenseStub([1]))
    monkeypatch.setitem(sys.modules, "pyk4a", KinectStub([1] * 1000))


def test_every_argument_of_every_public_call_is_in_the_table_or_a_record():
    missing = missing_from(TABLE, {name: PUBLIC[name] for name in PUBLIC if name not in RECORDED})
    assert missing == {}, "add a record in benchmarks/operations_on_clouds.py or operations_on_scenes.py"


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::pointloom.DroppedResultWarning", "ignore::pointloom.NormalsWarning")
@pytest.mark.filterwarnings("ignore:edge_length. expected most edges")  # two triangles have no equal edges
@pytest.mark.parametrize("call", TABLE)
def test_valid_arguments_are_accepted(call):
    function, expressions = TABLE[call]
    values = dict(things())
    good = {name: eval(expression, values) for name, expression in expressions.items()}
    with contextlib.suppress(loom.FileError):  # of missing files
        eval(function, values)(**good)


EXPENSIVE = [  # they accept 2^24 points
    ("TriangleMesh.compute_metrics", "n_sampled_points"), ("TriangleMesh.sample_points_uniformly", "number_of_points"),
    ("compare_meshes", "samples"),
]  # fmt: skip


@pytest.mark.parametrize("call", RECORDED)
def test_a_hostile_value_in_a_recorded_call_is_refused_by_name(call):
    faults = faults_of_recorded(call, PUBLIC[call], CLOUDS_ONLY)
    assert not faults, "\n".join(faults)


@pytest.mark.parametrize("call", TABLE)
def test_a_hostile_value_is_refused_by_name(call):
    check_arguments(call, cheap_arguments(call), every=False)


@pytest.mark.slow
@pytest.mark.parametrize("call", TABLE)
def test_all_hostile_values_are_refused_by_name(call):
    check_arguments(call, cheap_arguments(call))


def cheap_arguments(call):
    return [name for name, good in TABLE[call][1].items() if good != "True" and (call, name) not in EXPENSIVE]


@pytest.mark.nightly
@pytest.mark.parametrize(("call", "argument"), EXPENSIVE)
def test_a_hostile_count_is_refused_by_name(call, argument):
    check_arguments(call, [argument])


def check_arguments(call, arguments, every=True):
    function, expressions = TABLE[call]
    values, faults = things(), []
    for argument in arguments:
        good = {name: eval(expression, dict(values)) for name, expression in expressions.items()}
        of_clouds = argument in CLOUDS_ONLY and call not in TAKES_ARRAYS
        more = {"clouds": of_clouds, "finite": argument not in MAY_BE_INFINITE, "also": ALSO.get(call, "")}
        faults += faults_of(call_of(function, values), good, argument, **more, every=every)
    assert not faults, "\n".join(faults)


EITHER = {  # arguments that accept clouds and meshes
    "LineSet.create_from_triangle_mesh": ["mesh"], "RaycastingScene.add_triangles": ["triangles"],
    "from_any": ["geometry"], "volume_change": ["before", "after"],
}  # fmt: skip


@pytest.mark.filterwarnings("ignore::pointloom.NormalsWarning")
@pytest.mark.slow_on_emulated_cuda("checks of the host alone")
@pytest.mark.parametrize("call", [*TABLE, *RECORDED])
def test_a_mesh_as_a_cloud_and_a_cloud_as_a_mesh_name_the_conversion(call):
    if call in TABLE:
        function, values = TABLE[call][0], dict(things())
        called, arguments = call_of(function, values), {n: eval(good, values) for n, good in TABLE[call][1].items()}
    else:
        called, arguments = valid_call(call)
    faults = faults_of_exchange(called, arguments, EITHER.get(call, ()))
    assert not faults, "\n".join(faults)


CLOUDS = ("cloud", "other")


@pytest.mark.parametrize("call", calls_of_clouds(TABLE, CLOUDS))
def test_hostile_cloud_issues_no_warning(call):
    faults = faults_of_clouds(TABLE[call], CLOUDS, things())
    assert not faults, "\n".join(faults)
