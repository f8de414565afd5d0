"""torch is not among the packages of the tests. `make test-torch` installs it beside them and runs this folder."""

import importlib.util

collect_ignore_glob = ["test_*.py"] if importlib.util.find_spec("torch") is None else []
