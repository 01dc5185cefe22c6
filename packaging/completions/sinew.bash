# packaging/completions/sinew.bash: completion for bash. Made by packaging/make_pages.py from the program's help.

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
    for ((i = 1; i < COMP_CWORD; ++i)); do
        word=${COMP_WORDS[i]}
        case "$verb:$word" in
            :edit) verb=edit ;;
            :inspect) verb=inspect ;;
            :check) verb=check ;;
            :muscle) verb=muscle ;;
            :retarget) verb=retarget ;;
            :fit) verb=fit ;;
            :smooth) verb=smooth ;;
            :export) verb=export ;;
            :pack) verb=pack ;;
            :render) verb=render ;;
            :farm) verb=farm ;;
            :bench) verb=bench ;;
        esac
    done
    # Without a verb the file is the editor's.
    [[ -z $verb ]] && ((COMP_CWORD > 1)) && verb=edit
    case "$verb:$prev" in
        edit:--log-state) _sinew_files -; return ;;
        edit:--scale) :; return ;;
        inspect:--clips) _sinew_files glb gltf; return ;;
        check:--mend) _sinew_files json; return ;;
        muscle:-o|muscle:--output) _sinew_files json; return ;;
        muscle:--set) :; return ;;
        muscle:--mass) :; return ;;
        muscle:--definition) :; return ;;
        muscle:--report) _sinew_files json; return ;;
        retarget:-o|retarget:--output) _sinew_files json; return ;;
        retarget:--report) _sinew_files json; return ;;
        fit:-o|fit:--output) _sinew_files json; return ;;
        fit:--prior) :; return ;;
        fit:--carves) :; return ;;
        fit:--report) _sinew_files json; return ;;
        smooth:--clip) :; return ;;
        smooth:--clips) _sinew_files glb gltf; return ;;
        smooth:--time) :; return ;;
        smooth:--frames) :; return ;;
        smooth:--fps) :; return ;;
        smooth:--depth) :; return ;;
        smooth:--detail) _sinew_words adaptive uniform; return ;;
        smooth:--tolerance) :; return ;;
        smooth:--mode) _sinew_words swell replace; return ;;
        smooth:--patch) _sinew_words pn phong spherigon flat; return ;;
        smooth:--crease) :; return ;;
        smooth:--shape) :; return ;;
        smooth:--projection) _sinew_words newton bisection analytic; return ;;
        smooth:-o|smooth:--output) _sinew_files obj ply glb; return ;;
        smooth:--report) _sinew_files json; return ;;
        smooth:--list) _sinew_files -; return ;;
        smooth:--shard) :; return ;;
        smooth:--threads) :; return ;;
        export:--as) _sinew_words helpers skinned baked; return ;;
        export:--clips) _sinew_files glb gltf; return ;;
        export:--mesh) _sinew_words refined original; return ;;
        export:--depth) :; return ;;
        export:--detail) _sinew_words adaptive uniform; return ;;
        export:--tolerance) :; return ;;
        export:--weights) _sinew_words refitted transferred; return ;;
        export:--clip) :; return ;;
        export:--joints) :; return ;;
        export:--joint-scale) _sinew_words full uniform none; return ;;
        export:--fps) :; return ;;
        export:--substeps) :; return ;;
        export:--bound) :; return ;;
        export:--error-map) _sinew_files ply; return ;;
        export:-o|export:--output) _sinew_files glb gltf usda pc2 mdd; return ;;
        export:--list) _sinew_files -; return ;;
        export:--shard) :; return ;;
        export:--threads) :; return ;;
        pack:-o|pack:--output) _sinew_files sinew; return ;;
        pack:--depth) :; return ;;
        pack:--detail) _sinew_words adaptive uniform; return ;;
        pack:--tolerance) :; return ;;
        render:--clips) _sinew_files glb gltf; return ;;
        render:--clip) :; return ;;
        render:--time) :; return ;;
        render:--frames) :; return ;;
        render:--fps) :; return ;;
        render:--turntable) :; return ;;
        render:--sheet) :; return ;;
        render:--view) _sinew_words front back left right top bottom three-quarter; return ;;
        render:--shading) _sinew_words textured clay classes heat; return ;;
        render:--show) _sinew_words muscles skeleton primitives influence wire control anchors classes relief; return ;;
        render:--glass) :; return ;;
        render:--on) _sinew_words processor gpu; return ;;
        render:--light) :; return ;;
        render:--background) :; return ;;
        render:--size) :; return ;;
        render:--samples) :; return ;;
        render:--depth) :; return ;;
        render:--detail) _sinew_words adaptive uniform; return ;;
        render:--tolerance) :; return ;;
        render:--mode) _sinew_words swell replace; return ;;
        render:--patch) _sinew_words pn phong spherigon flat; return ;;
        render:--crease) :; return ;;
        render:--shape) :; return ;;
        render:-o|render:--output) _sinew_files png webp gif mp4; return ;;
        render:--list) _sinew_files -; return ;;
        render:--shard) :; return ;;
        render:--threads) :; return ;;
        farm:--to) _sinew_words slurm parallel openjd commands; return ;;
        farm:--tasks) :; return ;;
        farm:--program) :; return ;;
        farm:--job) _sinew_files -; return ;;
        bench:--json) _sinew_files json; return ;;
        bench:--rounds) :; return ;;
        bench:--crowd) :; return ;;
        bench:--frames) :; return ;;
    esac
    case "$verb:$cur" in
        :-*) _sinew_words --version -h --help ;;
        :*) _sinew_words edit inspect check muscle retarget fit smooth export pack render farm bench; _sinew_files glb gltf vrm rig.json ;;
        edit:-*) _sinew_words -h --help --log-state --scale ;;
        edit:*) _sinew_files glb gltf vrm rig.json ;;
        inspect:-*) _sinew_words -h --help --clips --json --strict ;;
        inspect:*) _sinew_files glb gltf vrm rig.json ;;
        check:-*) _sinew_words -h --help --json --strict --cloth --mend ;;
        check:*) _sinew_files glb gltf vrm rig.json ;;
        muscle:-*) _sinew_words -h --help -o --output --set --mass --definition --report ;;
        muscle:*) _sinew_files glb gltf vrm rig.json ;;
        retarget:-*) _sinew_words -h --help -o --output --report ;;
        retarget:*) _sinew_files glb gltf vrm rig.json ;;
        fit:-*) _sinew_words -h --help -o --output --prior --carves --each-side --report ;;
        fit:*) _sinew_files glb gltf vrm rig.json ;;
        smooth:-*) _sinew_words -h --help --clip --clips --time --frames --fps --depth --detail --tolerance --mode --patch --crease --shape --projection -o --output --report --list --shard --resume --dry-run --threads --progress ;;
        smooth:*) _sinew_files glb gltf vrm rig.json ;;
        export:-*) _sinew_words -h --help --as --clips --mesh --depth --detail --tolerance --weights --clip --joints --joint-scale --fps --substeps --bound --json --error-map -o --output --list --shard --resume --dry-run --threads --progress ;;
        export:*) _sinew_files glb gltf vrm rig.json ;;
        pack:-*) _sinew_words -h --help -o --output --depth --detail --tolerance ;;
        pack:*) _sinew_files glb gltf vrm rig.json ;;
        render:-*) _sinew_words -h --help --clips --clip --time --frames --fps --turntable --sheet --view --orthographic --shading --show --glass --surface --no-surface --ground --no-ground --on --transparent --light --background --ao --size --samples --depth --detail --tolerance --mode --patch --crease --shape -o --output --list --shard --resume --dry-run --threads --progress ;;
        render:*) _sinew_files glb gltf vrm rig.json ;;
        farm:-*) _sinew_words -h --help --to --tasks --program --job ;;
        bench:-*) _sinew_words -h --help --json --rounds --crowd --frames --progress ;;
        bench:*) _sinew_files glb gltf vrm rig.json ;;
    esac
}
complete -F _sinew sinew
