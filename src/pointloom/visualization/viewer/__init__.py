"""The viewer in the browser and the notebook."""
