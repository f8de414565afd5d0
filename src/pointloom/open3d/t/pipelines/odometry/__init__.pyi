"""The names of `open3d.t.pipelines.odometry`."""
