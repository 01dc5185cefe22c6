# tests/install/pages_test.py: man page and completions say what the program's help says.
"""Usage: pages_test.py PROGRAM SOURCE. The shells complete; what they offer is compared with the help and tried
on the program."""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

FILES = ("fox.glb", "fox.gltf", "fox.rig.json", "fox.json", "fox.png", "fox.obj", "fox.ply", "fox.txt")
READ = {"fox.glb", "fox.gltf", "fox.rig.json"}
BASH = r'''
source "$1"; shift
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMP_LINE="$*"; COMP_POINT=${#COMP_LINE}
_sinew; printf '%s\n' "${COMPREPLY[@]}"
'''
# zsh completes only at a terminal: one of its own, in which Tab is pressed and what is added to the matches is printed.
ZSH = r'''
zmodload zsh/zpty
zpty z zsh -f -i
zpty -w z "PS1=; stty -echo; unset zle_bracketed_paste; fpath=(${(q)1} \$fpath); autoload -Uz compinit; compinit -u -D
compadd() {
  if [[ \${@[1,(i)(-|--)]} == *-(O|A|D)\ * ]]; then builtin compadd \"\$@\"; return \$?; fi
  local -a hits; builtin compadd -A hits \"\$@\"
  local h; for h in \$hits; do print -r -- \"HIT:\$h:TIH\"; done
  builtin compadd \"\$@\"
}
tab() { zle complete-word; print -r -- DO''NE }; zle -N tab; bindkey '^I' tab; print REA''DY"
while zpty -r z line; do [[ $line == *READY* ]] && break; done
zpty -w -n z "$2"$'\t'
while zpty -r z line; do print -r -- "$line"; [[ $line == *DONE* ]] && break; done
'''


class Program:
    def __init__(self, path):
        self.path = path

    def help(self, *verb):
        return subprocess.run([self.path, *verb, "--help"], check=True, capture_output=True, text=True).stdout

    def accepts(self, *arguments):
        """The command line is not what is wrong."""
        return subprocess.run([self.path, *arguments], capture_output=True, cwd="/").returncode != 2

    def subcommands(self, *verb):
        found = re.search(r"Subcommands:\n((?:  .*\n)+)", self.help(*verb))
        return [line.split()[0] for line in found[1].splitlines() if re.match(r"  \w", line)] if found else []

    def leaves(self):
        for verb in self.subcommands():
            if not self.subcommands(verb) or "\nPositionals:" in self.help(verb):
                yield [verb]
            yield from ([verb, sub] for sub in self.subcommands(verb))

    def flags(self, *verb):
        lines = [line for line in self.help(*verb).splitlines() if re.match(r"  -", line)]
        return {flag for line in lines for flag in re.findall(r"(?<![\w.])--?[a-z][a-z-]*", line.split("  ")[1])}


def check(what, seen, wanted):
    if seen != wanted:
        raise SystemExit("FAILED: %s\nseen    %s\nwanted  %s" % (what, seen, wanted))
    print("ok: " + what, flush=True)


def pages_are_made_from_this_program(program, packaging, work):
    subprocess.run([sys.executable, "-B", packaging / "make_pages.py", program.path, work], check=True)
    for name in ("sinew.1", "completions/sinew.bash", "completions/_sinew", "completions/sinew.fish"):
        same = (work / name).read_text() == (packaging / name).read_text()
        check("packaging/%s is what `packaging/make_pages.py PROGRAM` makes" % name, same, True)
    page = (packaging / "sinew.1").read_text().replace("\\-", "-").replace("\\fR", " ")
    for verb in program.leaves():
        section = page.split(".SS sinew %s\n" % " ".join(verb))[1].split("\n.S")[0]
        for flag in program.flags(*verb) - {"-h", "--help"}:
            if not re.search(r"\\fB%s\W" % re.escape(flag), section):
                raise SystemExit("FAILED: sinew.1 lacks %s of %s" % (flag, verb))


def completes(name, offer, program):
    """`offer(words)`: what the shell offers in place of the last word."""
    verbs = program.subcommands()
    check(name + ": verbs and files first", offer([""]), set(verbs) | READ | {"folder"})
    check(name + ": options without a verb", offer(["-"]) & {"--version", "--help"}, {"--version", "--help"})
    for verb in program.leaves():
        check("%s: options of %s" % (name, verb), {o for o in offer([*verb, "--"])},
              {f for f in program.flags(*verb) if f.startswith("--")})
    for verb in (["inspect"], ["smooth", "--clip", "Walk"], ["render"], ["bench", "--json", "fox.json"], ["edit"]):
        check("%s: files to read after %s" % (name, verb), offer([*verb, "fo"]), READ | {"folder"})
    for option, wanted in ((["smooth", "-o"], {"fox.obj", "fox.ply", "fox.glb"}),
                           (["render", "--output"], {"fox.png"}),
                           (["smooth", "--report"], {"fox.json", "fox.rig.json"}),
                           (["edit", "--log-state"], set(FILES))):
        check("%s: files after %s" % (name, option), offer([*option, "fo"]), wanted | {"folder"})
    for verb, ending, option in (("smooth", ".obj", "--mode"), ("smooth", ".obj", "--patch"),
                                 ("smooth", ".obj", "--projection"), ("render", ".png", "--view"),
                                 ("render", ".png", "--shading"), ("render", ".png", "--show")):
        words = offer([verb, option, ""])
        for word in words:
            if not program.accepts(verb, "/nowhere.glb", "-o", "/nowhere" + ending, option, word):
                raise SystemExit("FAILED: %s offers %s %s, which the program refuses" % (name, option, word))
        listed = re.search(option + r" \w+:\{(.*?)\}", program.help(verb))
        check("%s: words of %s" % (name, option), words, set(listed[1].split(",")) if listed else words)
        check("... more than one", len(words) > 1, True)
    check(name + ": no number is made up", offer(["smooth", "--depth", ""]), set())


def in_bash(packaging, folder):
    def offer(words):
        script = packaging / "completions/sinew.bash"
        done = subprocess.run(["bash", "--norc", "-c", BASH, "bash", script, "sinew", *words], capture_output=True,
                              text=True, cwd=folder)
        if done.stderr:
            raise SystemExit("FAILED: bash: " + done.stderr)
        return {word for word in done.stdout.splitlines() if word}
    return offer


def in_fish(packaging, folder):
    def offer(words):
        line = " ".join(["sinew", *words])
        done = subprocess.run(["fish", "--no-config", "-c", "source %s; complete -C '%s'" % (
            packaging / "completions/sinew.fish", line)], capture_output=True, text=True, cwd=folder)
        if done.stderr:
            raise SystemExit("FAILED: fish: " + done.stderr)
        return {row.split("\t")[0].rstrip("/") for row in done.stdout.splitlines()}
    return offer


def in_zsh(packaging, folder):
    def offer(words):
        done = subprocess.run(["zsh", "-f", "-c", ZSH, "zsh", packaging / "completions", " ".join(["sinew", *words])],
                              stdin=subprocess.DEVNULL, capture_output=True, cwd=folder, timeout=60)
        return set(re.findall(r"HIT:(.*?):TIH", done.stdout.decode(errors="replace")))
    return offer


def main():
    program, packaging = Program(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve() / "packaging"
    with tempfile.TemporaryDirectory(prefix="sinew-pages-") as name:
        work = pathlib.Path(name)
        pages_are_made_from_this_program(program, packaging, work / "made")
        folder = work / "files"
        (folder / "folder").mkdir(parents=True)
        for file in FILES:
            (folder / file).touch()
        completes("bash", in_bash(packaging, folder), program)
        check("bash: a word after =", in_bash(packaging, folder)(["smooth", "--mode", "=", "s"]), {"swell"})
        for shell, offer in (("fish", in_fish), ("zsh", in_zsh)):
            if shutil.which(shell):
                completes(shell, offer(packaging, folder), program)
            else:
                print("left out: completion in %s, which is not installed" % shell)


if __name__ == "__main__":
    main()
