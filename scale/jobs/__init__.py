"""Jobs of other tasks than tiles: volumes by cubes, queues of sequences, hundreds of scans."""
