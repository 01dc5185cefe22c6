# python/sinew/_muscle.py: muscles and muscle lines of a rig, as things whose fields are read and set.


def _field(name, doc):
    """Read and set in the rig: a setting that cannot be is refused, and nothing is changed."""
    return property(lambda self: self._get(name), lambda self, value: self._set(name, value), doc=doc)


class Part:
    """Something of a rig, whatever it is called. Two are equal if they are the same of the same rig."""

    __slots__ = ("_rig", "_id")
    _kind = "part"

    def __init__(self, rig, identity):
        self._rig = rig
        self._id = identity

    @property
    def rig(self):
        """The rig it is of."""
        return self._rig

    @property
    def mirror(self):
        """Name of the linked twin, or None. Rig.mirror makes one."""
        return self._get("mirror")

    def __eq__(self, other):
        return type(self) is type(other) and self._rig is other._rig and self._id == other._id

    def __hash__(self):
        return hash((self._kind, id(self._rig), self._id))

    def __repr__(self):
        try:
            return "<sinew.%s %r>" % (type(self).__name__, self.name)
        except ValueError:
            return "<sinew.%s, removed>" % type(self).__name__


class Muscle(Part):
    """One ellipsoid on one bone. What is set here, its linked twin follows."""

    __slots__ = ()
    _kind = "muscle"

    def _get(self, name):
        return self._rig._muscle_field(self._id, name)

    def _set(self, name, value):
        self._rig._set_muscle_field(self._id, name, value)

    name = _field("name", "Unique in its rig.")
    bone = _field("bone", "Name of the bone it rides.")
    group = _field("group", "Name of its group; one that there is not yet is made.")
    line = _field("line", "Name of the muscle line that carries it, or None.")
    center = _field("center", "x, y, z in the bone's space.")
    radii = _field("radii", "Semi-axes x, y, z, each above 0, in units of the character.")
    rotation = _field("rotation", "Of its axes in the bone's: x, y, z, w of a unit quaternion.")
    core = _field("core", "Straight part: half its length over the radius y, 0 to 0.95.")
    belly = _field("belly", "Where along y its thickest place is.")
    bend = _field("bend", "By how much the middle of its axis is moved, in radii x and z.")
    reach = _field("reach", "How far it acts: radii times this, above 1.")
    amount = _field("amount", "Factor on its strength, 0 to 2.")
    sign = _field("sign", "1 adds, -1 carves.")
    territory = _field("territory", "Bones whose skin it may move; None: those next to its own.")


class Line(Part):
    """A muscle line, from a point on one bone to a point on another: docs/muscles.md. Points are (bone, (x, y, z))."""

    __slots__ = ()
    _kind = "line"

    def _get(self, name):
        return self._rig._line_field(self._id, name)

    def _set(self, name, value):
        self._rig._set_line_field(self._id, name, value)

    name = _field("name", "Unique among the lines of its rig.")
    origin = _field("origin", "Where it begins.")
    insertion = _field("insertion", "Where it ends.")
    via = _field("via", "The point that it bends round, or None.")
    rest = _field("rest", "Rest length over that in the bind pose, 0.25 to 4.")
    tendons = _field("tendons", "At both ends, of the rest length.")
    volume = _field("volume", "0: girth stays; 1: volume stays; to 4.")
    limits = _field("limits", "Belly stretch towards which girth levels off.")
    pivot = _field("pivot", "Girth grows from 0: the line, 1: the bone under it.")
    twist = _field("twist", "The belly turns with 0: the origin's bone, 1: the insertion's.")
    flex = _field("flex", "Height and width added at full activation.")
    base = _field("base", "Activation by hand, 0 to 1.")
    gain = _field("gain", "Activation from shortening, 0 to 4.")
    full = _field("full", "Stretch at which shortening activates fully, 0.1 to 0.99.")
