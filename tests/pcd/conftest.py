"""Enable pytest's assertion messages in modules that tests share."""

import pytest

pytest.register_assert_rewrite("tests.pcd.full_clouds", "tests.pcd.nearest_oracle")
