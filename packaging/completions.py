# packaging/completions.py: what the three shells complete after `sinew`.


def all_verbs(root):
    """Verbs and verbs of verbs, outermost first."""
    return [v for one in root.verbs for v in [one, *all_verbs(one)]]


def names_of(verb):
    return [name for option in verb.options for name in option.names]


def pattern(endings):
    """"glb gltf" -> the words the shells' functions take; "-" for any file."""
    return " ".join(endings) or "-"


BASH_HEAD = r'''# packaging/completions/sinew.bash: completion for bash. Made by packaging/make_pages.py from the program's help.

# Folders, and files with one of the endings; "-": any file.
_sinew_files() {
    local name ending
    compopt -o filenames 2>/dev/null
    while IFS= read -r name; do COMPREPLY+=("$name"); done < <(compgen -d -- "$cur")
    while IFS= read -r name; do
        [[ -d $name ]] && continue
        for ending in "$@"; do
            [[ $ending == - || $name == *."$ending" ]] && COMPREPLY+=("$name") && break
        done
    done < <(compgen -f -- "$cur")
}

_sinew_words() {
    local word
    while IFS= read -r word; do COMPREPLY+=("$word"); done < <(compgen -W "$*" -- "$cur")
}

_sinew() {
    local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} verb="" word i
    COMPREPLY=()
    # "--mode=swell" comes as three words.
    if [[ $cur == = ]]; then
        cur=""
    elif [[ $prev == = ]] && ((COMP_CWORD >= 2)); then
        prev=${COMP_WORDS[COMP_CWORD-2]}
    fi
'''


def bash(root):
    out = [BASH_HEAD]
    verbs = all_verbs(root)
    out.append("    for ((i = 1; i < COMP_CWORD; ++i)); do\n        word=${COMP_WORDS[i]}\n"
               "        case \"$verb:$word\" in\n")
    for verb in verbs:
        out.append("            %s:%s) verb=%s ;;\n" % ("-".join(verb.path[:-1]), verb.path[-1], "-".join(verb.path)))
    out.append("        esac\n    done\n")
    out.append("    # Without a verb the file is the editor's.\n")
    out.append("    [[ -z $verb ]] && ((COMP_CWORD > 1)) && verb=edit\n")
    out.append('    case "$verb:$prev" in\n')
    for verb in verbs:
        for option in verb.options:
            if not option.value:
                continue
            if option.words:
                action = "_sinew_words " + " ".join(option.words)
            elif option.endings() is not None:
                action = "_sinew_files " + pattern(option.endings())
            else:
                action = ":"
            keys = "|".join("-".join(verb.path) + ":" + name for name in option.names)
            out.append("        %s) %s; return ;;\n" % (keys, action))
    out.append('    esac\n    case "$verb:$cur" in\n')
    out.append("        :-*) _sinew_words %s ;;\n" % " ".join(names_of(root)))
    out.append("        :*) _sinew_words %s; _sinew_files %s ;;\n" % (
        " ".join(v.path[-1] for v in root.verbs), pattern(root.verbs[0].positionals[0].endings())))
    for verb in verbs:
        path = "-".join(verb.path)
        out.append("        %s:-*) _sinew_words %s ;;\n" % (path, " ".join(names_of(verb))))
        actions = ["_sinew_words " + " ".join(v.path[-1] for v in verb.verbs)] if verb.verbs else []
        actions += ["_sinew_files " + pattern(one.endings()) for one in verb.positionals[:1]]
        if actions:
            out.append("        %s:*) %s ;;\n" % (path, "; ".join(actions)))
    out.append("    esac\n}\ncomplete -F _sinew sinew\n")
    return "".join(out)


def zsh_text(text):
    for sign in "\\:[]":
        text = text.replace(sign, "\\" + sign)
    return text.replace("'", r"'\''")


def zsh_files(endings):
    return '_files -g "*.(%s)(-.)"' % "|".join(endings) if endings else "_files"


def zsh_option(option):
    value = ""
    if option.value:
        action = "(%s)" % " ".join(option.words) if option.words else " "
        if option.list:
            action = "_values -s , word " + " ".join(option.words)
        elif option.endings() is not None:
            action = zsh_files(option.endings())
        value = ":%s:%s" % (zsh_text(option.value.lower().replace(",...", "")), action)
    text = "[%s]%s" % (zsh_text(option.description), value)
    if len(option.names) == 1:
        return "'%s%s'" % (option.names[0], text)
    return "'(%s)'{%s}'%s'" % (" ".join(option.names), ",".join(option.names), text)


def zsh_case(verb):
    lines = [zsh_option(option) for option in verb.options]
    for place, one in enumerate(verb.positionals, 1):
        lines.append("'%s:file:%s'" % ("*" if one.repeated else place, zsh_files(one.endings())))
    return "_arguments -S " + " \\\n        ".join(lines)


def zsh_described(verbs):
    return " ".join("'%s:%s'" % (v.path[-1], zsh_text(v.summary)) for v in verbs)


def zsh(root):
    out = ["#compdef sinew\n# packaging/completions/_sinew: completion for zsh. Made by packaging/make_pages.py from "
           "the program's help.\n"]
    for verb in [v for v in all_verbs(root) if v.verbs]:
        name = "_sinew_" + "_".join(verb.path)
        out.append("\n%s() {\n  local -a verbs=(%s)\n  if ((CURRENT == 2)) && [[ $words[2] != -* ]]; then\n"
                   "    _describe verb verbs\n%s    return\n  fi\n  case $words[2] in\n" % (
                       name, zsh_described(verb.verbs),
                       "".join("    %s\n" % zsh_files(one.endings()) for one in verb.positionals[:1])))
        for one in verb.verbs:
            out.append("    %s) shift words; ((CURRENT--)); %s ;;\n" % (one.path[-1], zsh_case(one)))
        out.append("    *) %s ;;\n  esac\n}\n" % zsh_case(verb))
    out.append("\n_sinew() {\n  local -a verbs=(%s)\n" % zsh_described(root.verbs))
    out.append("  if ((CURRENT == 2)) && [[ $words[2] != -* ]]; then\n    _describe verb verbs\n    %s\n    return\n"
               "  fi\n" % zsh_files(root.verbs[0].positionals[0].endings()))
    out.append("  if ((CURRENT == 2)); then\n    _arguments -S %s\n    return\n  fi\n" %
               " ".join(zsh_option(option) for option in root.options))
    out.append("  local verb=$words[2]\n  shift words\n  ((CURRENT--))\n  case $verb in\n")
    for verb in root.verbs:
        out.append("    %s) %s ;;\n" % (verb.path[0], "_sinew_" + verb.path[0] if verb.verbs else zsh_case(verb)))
    out.append("    *) %s ;;\n  esac\n}\n\n_sinew \"$@\"\n" % zsh_case(root.verbs[0]))
    return "".join(out)


FISH_HEAD = r'''# packaging/completions/sinew.fish: completion for fish. Made by packaging/make_pages.py from the program's help.

# The verbs of the command line so far, "bench drag" as "bench-drag"; "" for none.
function __sinew_verb
    set -l verb ""
    for word in (commandline -opc)[2..-1]
        switch "$verb:$word"
%s        end
    end
    echo $verb
end

function __sinew_in
    test (__sinew_verb) = "$argv[1]"
end

# Folders, and files with one of the endings; without endings, any file.
function __sinew_files
    set -l token (string replace -r '^-[^=]*=' '' -- (commandline -ct))
    for name in $token*
        if test -d $name
            echo $name/
        else if test (count $argv) -eq 0
            echo $name
        else
            for ending in $argv
                string match -q -- "*.$ending" $name; and echo $name; and break
            end
        end
    end
end

complete -c sinew -f
'''


def fish_text(text):
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


def fish_option(path, option):
    flags = " ".join(("-l " if name.startswith("--") else "-s ") + name.lstrip("-") for name in option.names)
    value = ""
    if option.words:
        value = " -x -a %s" % fish_text(" ".join(option.words))
    elif option.value and option.endings() is not None:
        value = " -x -a %s" % fish_text("(__sinew_files %s)" % " ".join(option.endings()))
    elif option.value:
        value = " -x"
    return "complete -c sinew -n '__sinew_in \"%s\"' %s%s -d %s\n" % (path, flags, value, fish_text(option.description))


def fish(root):
    verbs = all_verbs(root)
    out = [FISH_HEAD % "".join("            case %s:%s\n                set verb %s\n" % (
        "-".join(v.path[:-1]), v.path[-1], "-".join(v.path)) for v in verbs)]
    for verb in [root, *verbs]:
        path = "-".join(verb.path)
        for one in verb.verbs:
            out.append("complete -c sinew -n '__sinew_in \"%s\"' -a %s -d %s\n" % (
                path, one.path[-1], fish_text(one.summary)))
        takes = verb.positionals or (root.verbs[0].positionals if verb is root else [])
        if takes:
            out.append("complete -c sinew -n '__sinew_in \"%s\"' -a '(__sinew_files %s)'\n" % (
                path, " ".join(takes[0].endings())))
        out.extend(fish_option(path, option) for option in verb.options)
    return "".join(out)
