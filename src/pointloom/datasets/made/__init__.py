"""Synthetic frames, clouds, scans, images and meshes with ground truth for `loom.datasets`."""
