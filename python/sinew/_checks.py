# python/sinew/_checks.py: arguments that must be of one of the module's own classes.
from ._error import Error


def expect(value, kind, place):
    """The value, if it is one of that class."""
    if isinstance(value, kind):
        return value
    got = type(value)
    raise Error("expected a sinew.%s, got %s %s" % (kind.__name__, "an" if got.__name__[:1] in "aeiouAEIOU" else "a",
                                                    got.__name__), place)
