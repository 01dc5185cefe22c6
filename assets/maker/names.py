# assets/maker/names.py: the left's name for the right.


def mirror_name(name):
    return name[:-2] + ".R" if name and name.endswith(".L") else name


def with_twins(rows):
    """[(name, parent, origin)]: the rows, then the ".L" ones again for the right, across x = 0."""
    return list(rows) + [(mirror_name(name), mirror_name(parent), (-x, y, z))
                         for name, parent, (x, y, z) in rows if name.endswith(".L")]
