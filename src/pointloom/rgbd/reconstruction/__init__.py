"""Reconstruction system: RGB-D frames without poses to one model, in resumable stages."""
