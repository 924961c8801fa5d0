import os

import pytest


@pytest.fixture
def program() -> str:
    """The command-line program of the same build."""
    path = os.environ.get("RBPA_PROGRAM", "")
    if not os.path.exists(path):
        pytest.skip("there is no rbpa program in this build")
    return path
