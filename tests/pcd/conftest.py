"""Asserts of the modules that tests share tell what they compare, as those of tests do."""

import pytest

pytest.register_assert_rewrite("tests.pcd.full_clouds", "tests.pcd.nearest_oracle")
