# packaging/help_text.py: the command line as `sinew --help` describes it.
"""Used by make_pages.py: man page and completions are made from what the program says of itself."""
import re
import subprocess

COLUMN = 30  # Where descriptions begin.
CHARACTER = ("glb", "gltf", "vrm", "rig.json")
# Words that the description names in a sentence: the parser cannot tell them from prose, so they stand here and are
# looked for there.
NAMED_WORDS = {
    "--view": ("front", "back", "left", "right", "top", "bottom", "three-quarter"),
    "--shading": ("textured", "clay", "classes", "heat"),
    "--show": ("muscles", "skeleton", "primitives", "influence", "wire", "control", "anchors", "classes",
               "relief"),
}


class Option:
    """An option, or a positional argument (no names)."""

    def __init__(self, left, description):
        self.description = description
        words = left.split(" ", 1)
        self.names = [re.sub(r"\{.*\}", "", name) for name in words[0].split(",")] if left.startswith("-") else []
        kind = words[1].strip() if len(words) > 1 else ""
        self.required = "REQUIRED" in kind
        kind = re.sub(r"\s*(REQUIRED|Needs: \S+)", "", kind)
        self.value = re.split(r":(?=\{|INT|FLOAT|TEXT|UINT)| ", kind)[0] if self.names else words[0]  # "" for a flag
        self.range = (re.search(r"in \[.*?\]", kind) or [""])[0]
        choices = re.search(r"\{(.*)\}", kind)
        self.words = tuple(choices[1].split(",")) if choices and self.value else ()
        for name in self.names:
            if name in NAMED_WORDS:
                self.words = NAMED_WORDS[name]
                missing = [word for word in self.words if word not in description]
                if missing:
                    raise SystemExit("%s: the help no longer names %s" % (name, ", ".join(missing)))
        self.repeated = left.rstrip().endswith("...")
        self.list = self.value.endswith(",...")

    def endings(self):
        """Of the files that it takes; () for any file; None: it takes no file."""
        if not self.names:
            return CHARACTER
        text = self.value + " " + self.description
        if re.match(r"(FILE|OUT)\b", self.value):
            return tuple(dict.fromkeys(re.findall(r"\.(glb|gltf|usda|obj|ply|png|webp|gif|mp4|json|pc2|mdd|sinew)\b", text)))
        return None


class Verb:
    def __init__(self, program, path):
        self.path = path
        text = subprocess.run([program, *path, "--help"], check=True, capture_output=True, text=True).stdout
        self.summary = text.split("\nUsage:")[0].strip()
        self.usage = re.search(r"Usage: (.*)", text)[1]
        self.positionals = [Option(*entry) for entry in section(text, "Positionals")]
        self.options = [Option(*entry) for entry in section(text, "Options")]
        self.subcommands = section(text, "Subcommands")
        self.verbs = [Verb(program, [*path, name]) for name, _ in self.subcommands]


def section(text, title):
    """(left, description) of each entry under a title."""
    found = re.search(r"^%s:\n((?:  .*\n)+)" % title, text, re.MULTILINE)
    entries = []
    for line in found[1].splitlines() if found else ():
        left, right = line[:COLUMN], line[COLUMN:]
        if not left.strip():
            entries[-1][1] += (" " if entries[-1][1] else "") + right.strip()
        elif len(line) > COLUMN and not line[COLUMN - 1].isspace():
            # The left part is longer than its column: two lines, or "NAME  text" with what follows one space.
            entries.append([line.strip(), ""])
        else:
            entries.append([left.strip(), right.strip()])
    return [tuple(entry) for entry in entries]


def read(program):
    return Verb(program, [])
