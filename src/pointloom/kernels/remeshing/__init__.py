"""The surface in another shape: smoothed, refined, thinned, bent."""
