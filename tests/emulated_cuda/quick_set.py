"""The tests that CI runs on the emulated device, in order 3: shuffled, and interleaved at memory accesses.

The device's own tests are included too; test_orders.py compares every operation in order 0 and in order 3.
"""

from __future__ import annotations

CHOSEN = {
    "tests/kernels/": "every subpackage of kernels against NumPy and SciPy, on small arrays",
    "tests/pcd/test_cloud.py": "uploads, downloads, moves between devices",
    "tests/pcd/test_interop.py": "arrays of other libraries, streams, pickles",
    "tests/registration/test_icp_input.py": "graphs over clouds that are empty, few, not finite or far apart",
    "tests/registration/test_icp_freedom.py::test_the_pose_matches": "steps of jobs that may move in some ways only",
    "tests/registration/test_icp_freedom.py::test_a_batch_has": "pivots and priors of each job, a job without pairs",
    "tests/registration/test_icp_freedom.py::test_empty_clouds": "one point, no scale to estimate",
    "tests/registration/test_icp_prior.py::test_residuals_far": "logarithms of all rotations",
    "tests/registration/test_icp_prior.py::test_a_prior_without": "motions that a prior alone determines",
    "tests/registration/test_nonrigid.py::test_fewer_nodes": "a graph of one node",
    "tests/registration/test_nonrigid.py::test_the_far_side": "pairs that their normals exclude",
    "tests/meshing/test_tsdf_integration.py": "blocks that frames touch, volumes that grow",
    "tests/meshing/test_splat_fusion.py::test_given_views": "the surface and colors of splats",
    "tests/meshing/test_mesh_cutting.py": "clips and slices of meshes",
    "tests/pcd/test_visibility.py": "hidden points",
    "tests/pcd/test_splat_pictures.py": "splats of pixels, before and behind what is solid",
    "tests/photogrammetry/mvs/test_plane_priors.py": "planes of image regions without texture",
    "tests/cameras/test_depth_filters.py": "filters of depth images",
    "tests/cameras/test_undistortion.py": "images of distorted lenses",
    "tests/visualization/viewer/test_tools_polygon.py": "points inside a polygon that is drawn on the screen",
    "tests/meshing/test_mesh_cleaning.py": "duplicate and degenerate triangles, close vertices",
    "tests/meshing/test_mesh_smoothing.py": "filters of meshes",
    "tests/meshing/test_mesh_subdivision.py": "subdivision of meshes",
    "tests/meshing/test_mesh_topology.py": "boundaries, orientation, manifold tests",
    "tests/meshing/test_shift_scores.py": "points shifted along the surface of a TSDF volume",
    "tests/meshing/test_orthophoto.py": "textured surfaces from above",
    "tests/pcd/test_geographic.py": "degrees to meters",
    "tests/pcd/test_splats.py": "splats that are cleaned and moved",
    "tests/photogrammetry/sfm/test_known_poses.py": "matches along epipolar lines",
    "tests/registration/test_deskewing.py": "scans of a moving sensor",
    "tests/rgbd/odometry/test_odometry_input.py": "tiny and invalid frames",
}

# Inexpensive tests that reach branches of kernels that no test above reaches, by file. A name selects all tests that
# begin with it.
CHOSEN_TESTS = {
    "tests/datasets/test_room.py": ("test_a_room_of_coarse_light_has_the_exact_depth",),
    "tests/visualization/render/test_render.py": (
        "test_the_point_size_closes_nearly_all_gaps",
        "test_points_behind_their_neighbors_are_darker_and_those_with_normals_are_lit",
        "test_lines_are_visible_over_the_faces_that_contain_them",
    ),
    "tests/visualization/viewer/test_tools_picking.py": (
        "test_points_outside_a_box_or_not_finite_are_hidden",
        "test_points_hidden_by_clip_planes_are_not_picked",
        "test_non_finite_points_and_those_behind_the_camera_are_not_picked",
        "test_a_click_on_a_point_picks_that_point",
    ),
    "tests/meshing/test_ball_pivoting.py": (
        "test_open3ds_triangles_are_included_except_at_shared_edges",
        "test_points_without_finite_position_or_normal_are_ignored",
    ),
    "tests/meshing/test_cloud_change.py": ("test_undefined_distances_are_nan",),
    "tests/meshing/test_color_map.py": (
        "test_initial_poses_are_never_replaced_by_worse_ones",
        "test_non_finite_vertices_are_not_seen_and_stay_black",
    ),
    "tests/meshing/test_distance_fields.py": (
        "test_invalid_queries_and_those_beyond_max_distance",
        "test_interpolated_distances_are_linear_and_gradients_are_their_differences",
        "test_a_cloud_at_utm_has_the_distances_of_brute_force",
        "test_signed_distances_are_scipys_two_transforms",
        "test_no_touching_sphere_is_reported_free",
        "test_a_box_has_scipys_distances_and_the_first_of_the_nearest[cuda:0-long]",
    ),
    "tests/meshing/test_isosurface.py": (
        "test_only_cells_around_non_finite_values_are_excluded",
        "test_vertices_are_the_edge_crossings_in_field_order",
    ),
    "tests/meshing/test_mesh.py": ("test_vertices_without_area_point_up_and_non_finite_ones_have_no_normal",),
    "tests/meshing/test_mesh_albedo.py": (
        "test_back_facing_triangles_are_not_painted",
        "test_texels_beside_a_triangle_repeat_it",
        "test_unseen_texels_take_the_vertex_colors",
    ),
    "tests/meshing/test_mesh_attributes.py": ("test_new_vertices_have_interpolated_values",),
    "tests/meshing/test_mesh_curvature.py": (
        "test_only_consistently_oriented_rings_have_a_curvature",
        "test_degenerate_and_non_finite_triangles_have_no_curvature",
    ),
    "tests/meshing/test_mesh_deformation.py": (
        "test_degenerate_triangles_and_non_finite_vertices_have_no_weight",
        "test_zero_iterations_and_no_triangles_change_nothing",
    ),
    "tests/meshing/test_mesh_geodesics.py": (
        "test_coincident_vertices_have_zero_distance",
        "test_paths_avoid_non_finite_vertices",
        "test_unreachable_vertices_are_infinitely_far",
    ),
    "tests/meshing/test_mesh_intersections.py": (
        "test_degenerate_triangles_intersect_where_their_segments_do",
        "test_meshes_intersect_at_their_surfaces_and_not_by_containment",
        "test_impossible_pairs_do_not_intersect",
    ),
    "tests/meshing/test_mesh_metrics.py": (
        "test_an_error_map_colors_each_vertex_by_its_distance",
        "test_bounds_are_valid_and_tight_on_random_surfaces",
    ),
    "tests/meshing/test_mesh_remeshing.py": (
        "test_corners_and_edges_of_a_box_are_preserved",
        "test_edges_between_a_crease_and_a_corner",
        "test_attributes_are_interpolated",
    ),
    "tests/meshing/test_mesh_repair.py": (
        "test_holes_that_would_share_one_chord_are_filled_separately",
        "test_only_holes_up_to_the_size_are_filled_and_no_single_triangles",
        "test_holes_of_a_ball_are_closed_at_any_scale_and_position",
    ),
    "tests/meshing/test_mesh_repair_harm.py": (
        "test_an_edge_of_many_triangles_is_split_into_sheets",
        "test_folded_triangles_go_with_the_first_fan_at_their_vertex",
        "test_damaged_meshes_are_restored",
    ),
    "tests/meshing/test_mesh_results.py": (
        "test_a_mesh_in_memory_gives_the_result_and_report_of_its_file[cuda:0-clean]",
        "test_comparison_in_memory_matches_that_of_files",
        "test_a_mesh_in_memory_gives_the_result_and_report_of_its_file[cuda:0-sharpen]",
    ),
    "tests/meshing/test_mesh_trim.py": ("test_one_triangle_is_clipped_as_a_polygon",),
    "tests/meshing/test_mesh_voxels.py": (
        "test_a_triangle_with_a_non_finite_corner_touches_no",
        "test_touched_voxels_match_open3d",
    ),
    "tests/meshing/test_occupancy.py": (
        "test_each_ray_can_have_its_own_origin",
        "test_rays_hit_the_first_voxel_that_is_not_free",
        "test_invalid_scans_are_rejected_and_change_nothing",
        "test_a_grid_without_scans_is_unknown",
    ),
    "tests/meshing/test_paged_volume.py": (
        "test_an_error_names_a_page_without_colors",
        "test_scan_rays_carve_voxels_on_disk",
    ),
    "tests/meshing/test_picture_texturing.py": (
        "test_an_image_with_other_content_is_excluded",
        "test_triangles_without_an_image_take_vertex_colors_or_are_plain",
        "test_occluded_images_are_not_used",
        "test_back_facing_triangles_are_not_visible",
    ),
    "tests/meshing/test_poisson_input.py": (
        "test_an_inverted_envelope_gives_the_same_result",
        "test_a_few_points_give_a_surface[cuda:0-10]",
    ),
    "tests/meshing/test_quadric_decimation.py": (
        "test_seams_are_simplified_before_the_target_is_missed",
        "test_isolated_triangles_are_removed_last_and_small_ones_first",
        "test_a_closed_component_remains_and_is_reported",
        "test_triangles_without_area_collapse",
        "test_the_maximum_error_is_respected",
    ),
    "tests/meshing/test_raycasting_scene.py": (
        "test_a_triangle_with_a_non_finite_corner_is_never",
        "test_invalid_rays_hit_nothing",
        "test_instances_of_a_mesh_are_transformed_copies",
    ),
    "tests/meshing/test_scene_distances.py": (
        "test_a_non_finite_query_has_no_distance_and_affects_no_other",
        "test_a_scene_without_triangles_is_infinitely_far",
    ),
    "tests/meshing/test_tsdf_device_frames.py": ("test_a_volume_without_color_renders_no_brightness",),
    "tests/meshing/test_tsdf_scans.py": (
        "test_outlier_points_create_no_blocks",
        "test_scans_with_invalid_poses_are_rejected",
    ),
    "tests/meshing/test_vertex_clustering.py": (
        "test_normals_and_colors_are_means",
        "test_meshes_with_at_most_one_triangle",
    ),
    "tests/meshing/test_volume_fusion.py": ("test_colors_are_weighted_means",),
    "tests/meshing/test_wild_measurements.py": ("test_outlier_points_create_no_block_beyond_max_range",),
    "tests/pcd/test_boxes.py": ("test_the_smallest_box_of_a_shape_is_no_larger_than_open3ds",),
    "tests/pcd/test_change.py": ("test_empty_clouds",),
    "tests/pcd/test_depth_clouds.py": (
        "test_images_of_a_data_set_are_open3ds",
        "test_clouds_of_no_points_give_empty_images",
    ),
    "tests/pcd/test_eigen_features.py": ("test_degenerate_neighborhoods_have_no_features",),
    "tests/pcd/test_features.py": ("test_fpfh_is_its_formula",),
    "tests/pcd/test_hulls.py": ("test_the_hull_of_a_made_cloud_is_open3ds",),
    "tests/pcd/test_normals.py": (
        "test_normals_of_a_depth_frame_have_open3ds_side",
        "test_normals_of_walls_and_lines_depend_on_no_order[cuda:0-{'radius': 0.6, 'max_nn': 12}",
    ),
    "tests/pcd/test_orientation.py": (
        "test_clouds_of_a_few_points_are_oriented",
        "test_steep_and_outlying_neighbors_are_left_out[cuda:0-(0.0, 0.6)",
    ),
    "tests/pcd/test_planes.py": ("test_points_on_a_line_have_no_plane",),
    "tests/pcd/test_search.py": ("test_a_point_too_far_for_a_squared_distance_is_nobodys_neighbor_and_an_outlier",),
    "tests/pcd/test_shape_boxes.py": ("test_invalid_detections_are_rejected",),
    "tests/pcd/test_shape_detection.py": ("test_clutter_alone_has_no_shape",),
    "tests/pcd/test_shape_fitting.py": (
        "test_a_fit_is_scipy_s_and_so_is_its_covariance[cuda:0-sphere]",
        "test_a_fit_is_scipy_s_and_so_is_its_covariance[cuda:0-torus]",
        "test_points_of_no_weight_and_those_that_are_not_finite_are_left_out",
    ),
    "tests/pcd/test_shape_checks.py": (
        "test_points_beside_a_plane_are_counted_within_its_box_by_distance_and_by_normal",
    ),
    "tests/pcd/test_smoothing.py": (
        "test_small_degenerate_and_non_finite_clouds_are_smoothed",
        "test_attributes_are_preserved_and_the_cloud_is_unchanged",
        "test_a_point_without_a_side_is_left_by_the_bilateral_filter",
    ),
    "tests/pcd/test_terrain.py": (
        "test_an_intensity_that_is_not_finite_is_left_out_of_the_mean",
        "test_heights_above_ground_follow_the_definition",
        "test_points_in_a_cell_are_counted_once",
        "test_bare_earth_on_triangles_is_scipys",
        "test_points_beyond_the_radius_have_no_height",
    ),
    "tests/registration/test_coherent_drift.py": (
        "test_steps_match_the_paper[cuda:0-deformable]",
        "test_all_points_are_weighted_for_any_count",
    ),
    "tests/registration/test_estimation.py": (
        "test_steps_match_open3d[cuda:0-ForGeneralizedICP-(0.001, 'TukeyLoss')-1]",
        "test_point_to_point_weights_depend_on_distance",
    ),
    "tests/registration/test_lidar_odometry.py": (
        "test_scans_are_downsampled_to_the_first_point_of_each_voxel",
        "test_a_scan_pose_matches_the_explicit_loop[shipped-cuda:0-0.0]",
    ),
    "tests/registration/test_matching.py": (
        "test_few_or_no_rows_are_matched",
        "test_matches_in_any_dimension_equal_brute_force[cuda:0-16]",
        "test_the_ratio_test_follows_the_mutual_filter_and_its_fallback",
        "test_of_equal_rows_the_first_is_matched",
    ),
    "tests/registration/test_multiway.py": ("test_the_information_of_a_pair",),
    "tests/registration/test_rating.py": (
        "test_batched_poses_have_the_evidence_of_each",
        "test_points_without_a_surface_are_excluded",
    ),
    "tests/rgbd/odometry/test_open3d_weights.py": (
        "test_the_odometries_of_made_pictures",
        "test_a_blank_pair_fails_where_open3d_reports_success",
    ),
    "tests/rgbd/odometry/test_verdict.py": (
        "test_views_of_other_locations_are_no_success[cuda:0-1.6",
        "test_a_wall_without_texture_is_no_success[cuda:0-0.6-Method.Intensity",
    ),
    "tests/rgbd/slam/test_stream_check.py": ("test_reported_frames_are_uncertain_and_make_the_path_unreliable",),
    "tests/tiling/test_clusters.py": ("test_border_points_take_the_lowest_label_of_renamed_cores",),
}

PREFIXES = (*CHOSEN, *(f"{file}::{name}" for file, names in CHOSEN_TESTS.items() for name in names))


def is_in_quick_set(node: str) -> bool:
    """True if a test is in the set: a run on the device, of a file, folder or test that is named."""
    return "cuda:0" in node and node.startswith(PREFIXES)
