# packaging/man_page.py: the text of sinew.1.

HEAD = r'''.\" Made by packaging/make_pages.py from the program's help.
.TH SINEW 1 "" "Sinew" "User Commands"
.SH NAME
sinew \- add muscles to animated glTF characters
.SH SYNOPSIS
'''

DESCRIPTION = r'''.SH DESCRIPTION
.B sinew
opens a skinned glTF character, lets the user place ellipsoids on its bones and blend them, and turns the coarse mesh
plus the ellipsoids into one smooth, textured, closed mesh while the character plays its animation.
.PP
Without a verb the editor opens, with the file that is named or with a sample character.
Only the editor needs a display.
Results go to standard output, messages to standard error.
'''

TAIL = r'''.SH FILES
.TP
.I *.rig.json
A rig: muscles, groups and links, and the name of the character they belong to. JSON text.
.TP
.IR *.glb ", " *.gltf ", " *.vrm
A character: a skinned mesh with its animations, as glTF 2.0.
.TP
.I $XDG_CONFIG_HOME/sinew/preferences.json
Preferences of the editor: keymap and changed keys, size of the interface, layout, recent files.
Without the variable,
.IR ~/.config/sinew/preferences.json .
.TP
.I $XDG_STATE_HOME/sinew/recovery/
Unsaved work of running editors, which is offered after a crash.
.TP
.I /usr/share/sinew
Shaders and sample characters of the installed program.
.SH ENVIRONMENT
.TP
.B SINEW_DATA_DIR
The folder to look for shaders and sample characters in first.
.TP
.BR DISPLAY ", " WAYLAND_DISPLAY
Where the editor opens its window.
.SH EXIT STATUS
.TP
.B 0
Done.
.TP
.B 1
The input is bad: one line on standard error names the file, the place in it and the reason.
.TP
.B 2
The command line is wrong.
.SH EXAMPLES
.TP
.B sinew fox.glb
Open a character in the editor.
.TP
.B sinew inspect fox.glb \-\-json
Describe it, as JSON.
.TP
.B sinew muscle fox.glb \-o fox.rig.json
Give it a set of muscles that fits its body.
.TP
.B sinew smooth fox.rig.json \-\-clip Walk \-\-time 0.4 \-\-depth 6 \-o fox.obj
Write the surface of one moment of a clip.
.TP
.B sinew render fox.rig.json \-\-clip Walk \-\-frames 0:23 \-o fox_%04d.png
Render a clip to numbered pictures.
.SH SEE ALSO
The editor lists its keys under Help, Keys and mouse; they are changed in its preferences.
'''


def escaped(text):
    text = text.replace("\\", r"\e").replace("-", r"\-").replace("'", r"\(aq")
    return r"\&" + text if text.startswith(".") else text


def option_lines(option):
    names = ", ".join(r"\fB%s\fR" % escaped(name) for name in option.names) or r"\fI%s\fR" % escaped(option.value)
    if option.names and option.value:
        names += r" \fI%s\fR" % escaped(option.value)
    notes = []
    if option.range:
        notes.append(option.range.replace("in [", "From ").replace(" - ", " to ").replace("]", ""))
    if option.names and option.required:
        notes.append("Required")
    text = option.description + "".join(". " + note for note in notes)
    return ".TP\n%s\n%s.\n" % (names, escaped(text.rstrip(".")))


def leaves(verb):
    """What runs: verbs without verbs of their own, and those that read files without one."""
    own = [verb] if verb.path and (verb.positionals or not verb.verbs) else []
    return own + [leaf for one in verb.verbs for leaf in leaves(one)]


def synopsis(verb):
    words = [r"\fBsinew\fR"] + [r"\fB%s\fR" % word for word in verb.path] + [r"[\fIOPTIONS\fR]"]
    for one in verb.positionals:
        words.append((r"\fI%s\fR" if one.required else r"[\fI%s\fR]") % (one.value + ("..." if one.repeated else "")))
    return " ".join(words)


def page(root):
    lines = [synopsis(verb) for verb in leaves(root)]
    lines[0] = lines[0].replace(r"\fBedit\fR", r"[\fBedit\fR]")
    lines.append(r"\fBsinew\fR {%s}" % "|".join(r"\fB%s\fR" % escaped(n) for o in root.options for n in o.names))
    text = HEAD + "\n.br\n".join(lines) + "\n" + DESCRIPTION + ".SH OPTIONS\n"
    text += "".join(option_lines(option) for option in root.options)
    for verb in leaves(root):
        text += ".SS sinew %s\n%s.\n" % (" ".join(verb.path), escaped(verb.summary))
        shown = [o for o in verb.positionals + verb.options if "--help" not in o.names]
        text += "".join(option_lines(option) for option in shown)
    return text + TAIL
