"""Frames, clouds, scans, pictures and meshes of made scenes, each with its truth, as `loom.data` hands them out."""
