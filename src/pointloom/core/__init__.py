"""Foundations: checks, errors, devices, other array libraries, progress, resumable stages."""
