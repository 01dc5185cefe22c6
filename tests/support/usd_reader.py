# tests/support/usd_reader.py: reads a .usda apart from the program, for the tests in Python.
"""One statement a line, as Sinew writes them; lists and tuples of USD are those of Python."""
import ast
import re

PRIM = re.compile(r'def (\w+) "([A-Za-z_]\w*)"(?: \((.*)\))?$')
ATTRIBUTE = re.compile(r"(?:uniform )?([\w\[\]]+) ([\w:.]+)(?: = (.*))?$")
METADATA = re.compile(r" \(([^()]*)\)$")


class Prim:
    def __init__(self, kind, name, path):
        self.kind, self.name, self.path = kind, name, path
        self.values, self.metadata, self.children = {}, {}, []

    def __getitem__(self, name):
        return self.values[name]

    def all(self, kind):
        return ([self] if self.kind == kind else []) + [each for child in self.children for each in child.all(kind)]


def value_of(text):
    if text.startswith("<") or text.startswith("@"):
        return text[1:-1]
    return ast.literal_eval(re.sub(r"^\( ?", "(", text))


def read(path):
    """(metadata of the layer, its one root prim)"""
    lines = path.read_text().split("\n")
    assert lines[0] == "#usda 1.0", lines[0]
    end = lines.index(")")
    layer = dict(line.strip().split(" = ", 1) for line in lines[2:end])
    layer = {name: value_of(text) for name, text in layer.items()}
    root, open_prims, samples = None, [], None
    for line in map(str.strip, lines[end + 1:]):
        prim = PRIM.match(line)
        if prim:
            above = open_prims[-1] if open_prims else None
            made = Prim(prim[1], prim[2], (above.path if above else "") + "/" + prim[2])
            if above:
                assert made.name not in [child.name for child in above.children], made.path
                above.children.append(made)
            else:
                assert root is None
                root = made
            open_prims.append(made)
        elif line == "}":
            if samples is not None:
                samples = None
            else:
                open_prims.pop()
        elif samples is not None:
            code, text = line.rstrip(",").split(": ", 1)
            samples[float(code)] = value_of(text)
        elif line not in ("", "{"):
            metadata = METADATA.search(line) if "interpolation" in line else None
            line = METADATA.sub("", line) if metadata else line
            found = ATTRIBUTE.match(line)
            assert found, line[:80]
            name = found[2]
            assert name not in open_prims[-1].values, name
            open_prims[-1].metadata[name] = metadata[1] if metadata else ""
            if name.endswith(".timeSamples"):
                samples = open_prims[-1].values[name] = {}
            else:
                open_prims[-1].values[name] = value_of(found[3]) if found[3] else None
    assert not open_prims
    return layer, root
