# python/sinew/_rig.py: a rig: muscles, lines, groups, shapes and settings of a character.
import collections.abc

from . import _sinew
from ._character import Character
from ._checks import expect
from ._muscle import Line, Muscle


def _setting(name, doc):
    return property(lambda self: self._setting(name), lambda self, value: self._set_setting(name, value), doc=doc)


class Shapes(collections.abc.Mapping):
    """What a rig adds to the weights of the character's shapes (morph targets), by name, -10 to 10."""

    __slots__ = ("_rig",)

    def __init__(self, rig):
        self._rig = rig

    def __getitem__(self, name):
        return self._rig._shapes()[name]

    def __setitem__(self, name, weight):
        self._rig._set_shape(name, weight)

    def __iter__(self):
        return iter(self._rig._shapes())

    def __len__(self):
        return len(self._rig._shapes())

    def __repr__(self):
        return repr(self._rig._shapes())


class Rig(_sinew.Rig):
    """The muscles of a character. An edit that cannot be is refused with sinew.Error, and the rig stays as it was.

    Iterating gives the muscles, rig[name] one of them, name in rig tells whether there is one.
    """

    __slots__ = ("_character",)  # What is misspelled is refused.

    def __init__(self, character, *, path=None, text=None):
        """Without muscles, as a rig file, or as the text of one says. load_rig opens a file with its character."""
        super().__init__(expect(character, Character, "character"), path, text)
        self._character = character

    @property
    def character(self):
        """The character it is for."""
        return self._character

    mode = _setting("mode", "swell (the skin rises over the muscles) or replace (the paper's method).")
    iso = _setting("iso", "Value of the field on the surface, 0.001 to 0.999.")
    skin_blend = _setting("skin_blend", "How softly muscles begin, fraction of the height; above 0, at most 10.")
    grooves = _setting("grooves", "Width of the soft grooves between muscles that are not linked, fraction of the height, 0 to 1; 0: crisp.")
    detail = _setting("detail", "adaptive (as fine as the tolerance asks for) or uniform (the depth everywhere).")
    depth = _setting("depth", "Of uniform detail: every triangle becomes depth x depth, 1 to 16.")
    tolerance = _setting("tolerance", "Of adaptive detail, fraction of the height, 0.0001 to 0.01.")
    patch = _setting("patch", "Curved patch over each triangle: pn, phong, spherigon or flat.")
    projection = _setting("projection", "newton; analytic: in the mode replace, lines along the normals. bisection reads as newton.")
    crease_angle = _setting("crease_angle", "Degrees: faces that meet at more are shaded apart; 180: smooth everywhere.")

    @property
    def muscles(self):
        """All muscles, in the order of the rig."""
        return tuple(Muscle(self, identity) for identity in self._muscles())

    @property
    def leaders(self):
        """One muscle of each linked pair, and those without a twin: whoever makes every muscle larger by a tenth goes through
        these. Through all of them, a pair would grow twice, since each follows the other.
        """
        names, chosen = set(), []
        for muscle in self.muscles:
            if muscle.mirror not in names:
                names.add(muscle.name)
                chosen.append(muscle)
        return tuple(chosen)

    @property
    def lines(self):
        """All muscle lines."""
        return tuple(Line(self, identity) for identity in self._lines())

    @property
    def shapes(self):
        """What is added to the weights of shapes, by name; shapes[name] = weight sets one."""
        return Shapes(self)

    def add_clips(self, path):
        """Names a file whose clips the character plays too; they are there at once, and wherever the rig is opened.

        Returns what did not match, a line each. clip_files are those that are named, missing_clips why some are left out.
        """
        return self._add_clips(path)

    def muscle(self, name):
        """The muscle of that name."""
        return Muscle(self, self._muscle(name))

    def line(self, name):
        """The muscle line of that name."""
        return Line(self, self._line(name))

    def add_muscle(self, name, *, bone, center=(0.0, 0.0, 0.0), radii=(1.0, 1.0, 1.0), rotation=(0.0, 0.0, 0.0, 1.0),
                   group=None, line=None, reach=None, amount=None, sign=None, core=None, belly=None, bend=None,
                   territory=None):
        """Adds a muscle at the end. Its fields are those of Muscle; without a group it goes into the first."""
        fields = dict(bone=bone, center=center, radii=radii, rotation=rotation, reach=reach, amount=amount, sign=sign,
                      core=core, belly=belly, bend=bend, territory=territory)
        return Muscle(self, self._add_muscle(name, group, line, fields))

    def add_line(self, name, *, origin, insertion, via=None, rest=None, tendons=None, volume=None, limits=None,
                 pivot=None, twist=None, flex=None, base=None, gain=None, full=None):
        """Adds a muscle line. Its fields are those of Line; muscles ride it once their line is set to its name."""
        fields = dict(origin=origin, insertion=insertion, via=via, rest=rest, tendons=tendons, volume=volume,
                      limits=limits, pivot=pivot, twist=twist, flex=flex, base=base, gain=gain, full=full)
        return Line(self, self._add_line(name, fields))

    def mirror(self, muscle):
        """Gives a muscle, by name, its image on the other side, linked: what happens to one happens to both.

        Has it a twin already, that becomes its image. Returns the twin.
        """
        return Muscle(self, self._mirror(_name(muscle)))

    def remove(self, muscle):
        """Removes a muscle, and its line if that carries no other. A twin stays, single."""
        self._remove(_name(muscle))

    def link(self, group, other, amount=1.0):
        """Lets the muscles of two groups blend: 1 adds them up, less blends in part, 0 parts them. Groups that there
        are not yet are made."""
        self._set_link(group, other, amount)

    def link_amount(self, group, other):
        """How much two groups blend, 0 to 1; 0: they are not linked."""
        return self._link_amount(group, other)

    def unlink(self, group, other):
        """Parts two groups."""
        self._set_link(group, other, 0.0)

    def rename_group(self, group, name):
        """Gives a group another name."""
        self._rename_group(group, name)

    def remove_group(self, group):
        """Removes a group in which no muscle is."""
        self._remove_group(group)

    def save(self, path):
        """Writes the rig file, whole or not at all; the character's path in it is relative to it."""
        self._save(path)

    def to_json(self):
        """The text of its rig file."""
        return self._json()

    def copy(self):
        """Another one with the same contents."""
        made = Rig(self._character)
        made._copy_from(self)
        return made

    def __getitem__(self, name):
        return self.muscle(name)

    def __contains__(self, name):
        return self._has(name)

    def __iter__(self):
        return iter(self.muscles)

    def __len__(self):
        return len(self._muscles())

    def __eq__(self, other):
        return isinstance(other, Rig) and self._equals(other)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self):
        return "<sinew.Rig of %r: %d muscles, %d lines, %d groups>" % (
            self._character.name, len(self), len(self._lines()), len(self.groups))


def _name(muscle):
    return muscle.name if isinstance(muscle, Muscle) else muscle


def load_rig(path, character=None):
    """Opens a rig file and its character, or for a character that is open already, with the clips that the rig names."""
    if character is None:
        character = Character(_sinew.character_file_of(path))
    return Rig(character, path=path)
