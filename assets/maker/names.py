# assets/maker/names.py: the left's name for the right.


def mirror_name(name):
    return name[:-2] + ".R" if name and name.endswith(".L") else name
