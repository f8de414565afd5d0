"""Poses from correspondences: hypotheses, fits, scores, evidence."""
