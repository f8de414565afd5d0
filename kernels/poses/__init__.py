"""Poses from pairs of points: hypotheses, fits, scores, evidence."""
