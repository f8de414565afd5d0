"""A video, or a folder of pictures, to a mesh: the stages one after the other, each whole or not at all."""
