# python/sinew/_sinew.pyi: the part that is C++ has no types of its own: what is public of it is in __init__.pyi.
from typing import Any

def __getattr__(name: str) -> Any: ...
