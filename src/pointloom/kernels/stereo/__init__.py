"""Multi-view stereo with known poses: plane hypotheses, costs, consistency."""
