"""The names of `open3d.t.io`."""
