# python/sinew/_checks.py: arguments that must be of one of the module's own classes.
from ._error import Error


def expect(value, kind, place):
    """The value, if it is one of that class."""
    if isinstance(value, kind):
        return value
    name = type(value).__name__
    got = "None" if value is None else "%s %s" % ("an" if name[:1] in "aeiouAEIOU" else "a", name)
    raise Error("expected a sinew.%s, got %s" % (kind.__name__, got), place)
