"""Terrestrial scans: stations brought into one frame by pairs, targets, levels and control."""
