"""Checks that calls are refused."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

import rbpa


def refuses(message: str, call: Callable[..., Any], *arguments: Any, **options: Any) -> None:
    """Checks that the call with these arguments raises InvalidInput with this message, a regular expression."""
    with pytest.raises(rbpa.InvalidInput, match=message):
        call(*arguments, **options)
