"""Depth from pictures whose poses are known: plane hypotheses, their costs, what views agree on."""
