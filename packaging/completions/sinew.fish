# packaging/completions/sinew.fish: completion for fish. Made by packaging/make_pages.py from the program's help.

# The verbs of the command line so far, "bench drag" as "bench-drag"; "" for none.
function __sinew_verb
    set -l verb ""
    for word in (commandline -opc)[2..-1]
        switch "$verb:$word"
            case :edit
                set verb edit
            case :inspect
                set verb inspect
            case :check
                set verb check
            case :muscle
                set verb muscle
            case :retarget
                set verb retarget
            case :fit
                set verb fit
            case :smooth
                set verb smooth
            case :export
                set verb export
            case :pack
                set verb pack
            case :render
                set verb render
            case :farm
                set verb farm
            case :bench
                set verb bench
        end
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
complete -c sinew -n '__sinew_in ""' -a edit -d 'Open the editor'
complete -c sinew -n '__sinew_in ""' -a inspect -d 'Describe characters and rigs, and what is wrong with them'
complete -c sinew -n '__sinew_in ""' -a check -d 'Find muscles that leave the flesh, and mend them'
complete -c sinew -n '__sinew_in ""' -a muscle -d 'Give a character a set of muscles that fits its body'
complete -c sinew -n '__sinew_in ""' -a retarget -d 'Put the muscles of a rig on another character'
complete -c sinew -n '__sinew_in ""' -a fit -d 'Change muscles until the skin looks like a sculpt'
complete -c sinew -n '__sinew_in ""' -a smooth -d 'Write the smoothed surface of one moment, or of each frame'
complete -c sinew -n '__sinew_in ""' -a export -d 'Write the character for games'
complete -c sinew -n '__sinew_in ""' -a pack -d 'Write a character and its rig as one file that a game loads'
complete -c sinew -n '__sinew_in ""' -a render -d 'Make pictures, off screen'
complete -c sinew -n '__sinew_in ""' -a farm -d 'Write a batch job for Slurm, GNU parallel or another farm'
complete -c sinew -n '__sinew_in ""' -a bench -d 'Measure on this machine'
complete -c sinew -n '__sinew_in ""' -a '(__sinew_files glb gltf vrm rig.json)'
complete -c sinew -n '__sinew_in ""' -l version -d 'Print the version and exit'
complete -c sinew -n '__sinew_in ""' -s h -l help -d 'Print this and exit'
complete -c sinew -n '__sinew_in "edit"' -a '(__sinew_files glb gltf vrm rig.json)'
complete -c sinew -n '__sinew_in "edit"' -s h -l help -d 'Print this and exit'
complete -c sinew -n '__sinew_in "edit"' -l log-state -x -a '(__sinew_files )' -d 'Append a JSON line per drawn frame that changed'
complete -c sinew -n '__sinew_in "edit"' -l scale -x -d 'Size of the interface: 1, 1.5, 2; without it, the system\'s'
complete -c sinew -n '__sinew_in "inspect"' -a '(__sinew_files glb gltf vrm rig.json)'
complete -c sinew -n '__sinew_in "inspect"' -s h -l help -d 'Print this and exit'
complete -c sinew -n '__sinew_in "inspect"' -l clips -x -a '(__sinew_files glb gltf)' -d 'Add the clips of this file (.glb, .gltf, .vrm), with a mesh or without; once for each'
complete -c sinew -n '__sinew_in "inspect"' -l json -d 'Print JSON, for programs: an object, or an array where there are several files'
complete -c sinew -n '__sinew_in "inspect"' -l strict -d 'Exit with status 1 if a rig names bones that its character lacks, or clip files that cannot be read'
complete -c sinew -n '__sinew_in "check"' -a '(__sinew_files glb gltf vrm rig.json)'
complete -c sinew -n '__sinew_in "check"' -s h -l help -d 'Print this and exit'
complete -c sinew -n '__sinew_in "check"' -l json -d 'JSON instead of text'
complete -c sinew -n '__sinew_in "check"' -l strict -d 'Exit status 1 if anything is found, after mending if that is asked for'
complete -c sinew -n '__sinew_in "check"' -l cloth -d 'Count the vertices of cloth that are below the skin, with and without muscles; takes a while'
complete -c sinew -n '__sinew_in "check"' -l mend -x -a '(__sinew_files json)' -d 'Mend the lines with findings, and write the rig there'
complete -c sinew -n '__sinew_in "muscle"' -a '(__sinew_files glb gltf vrm rig.json)'
complete -c sinew -n '__sinew_in "muscle"' -s h -l help -d 'Print this and exit'
complete -c sinew -n '__sinew_in "muscle"' -s o -l output -x -a '(__sinew_files json)' -d 'Rig to write (.rig.json)'
complete -c sinew -n '__sinew_in "muscle"' -l set -x -d 'Set of muscles: athlete, sculpted, animal, one of your own, or a file (.json); without it, the one for this kind of body'
complete -c sinew -n '__sinew_in "muscle"' -l mass -x -d 'Girth of all muscles, 0.5 to 2 (1)'
complete -c sinew -n '__sinew_in "muscle"' -l definition -x -d 'How far muscles stand out, 0 to 1 (the set\'s)'
complete -c sinew -n '__sinew_in "muscle"' -l report -x -a '(__sinew_files json)' -d 'Muscles, and what was left out and why, as JSON'
complete -c sinew -n '__sinew_in "retarget"' -a '(__sinew_files glb gltf vrm rig.json)'
complete -c sinew -n '__sinew_in "retarget"' -s h -l help -d 'Print this and exit'
complete -c sinew -n '__sinew_in "retarget"' -s o -l output -x -a '(__sinew_files json)' -d 'Rig to write (.rig.json)'
complete -c sinew -n '__sinew_in "retarget"' -l report -x -a '(__sinew_files json)' -d 'What was left out and why, as JSON'
complete -c sinew -n '__sinew_in "fit"' -a '(__sinew_files glb gltf vrm rig.json)'
complete -c sinew -n '__sinew_in "fit"' -s h -l help -d 'Print this and exit'
complete -c sinew -n '__sinew_in "fit"' -s o -l output -x -a '(__sinew_files json)' -d 'Rig to write (.rig.json)'
complete -c sinew -n '__sinew_in "fit"' -l prior -x -d 'Between keeping the muscles, 1, and matching the sculpt, 0.01 (0.1)'
complete -c sinew -n '__sinew_in "fit"' -l carves -x -d 'Add up to N carves where the sculpt is lower (0)'
complete -c sinew -n '__sinew_in "fit"' -l each-side -d 'Follow the sculpt on each side: twins are no longer linked'
complete -c sinew -n '__sinew_in "fit"' -l report -x -a '(__sinew_files json)' -d 'How near the skin has come, as JSON'
complete -c sinew -n '__sinew_in "smooth"' -a '(__sinew_files glb gltf vrm rig.json)'
complete -c sinew -n '__sinew_in "smooth"' -s h -l help -d 'Print this and exit'
complete -c sinew -n '__sinew_in "smooth"' -l clip -x -d 'Pose from this clip, or "Range of motion", made from the joints; without it, the bind pose'
complete -c sinew -n '__sinew_in "smooth"' -l clips -x -a '(__sinew_files glb gltf)' -d 'Add the clips of this file (.glb, .gltf, .vrm), with a mesh or without; once for each'
complete -c sinew -n '__sinew_in "smooth"' -l time -x -d 'Seconds into the clip (0)'
complete -c sinew -n '__sinew_in "smooth"' -l frames -x -d 'One file per clip frame from A to B, both included, or every STEPth'
complete -c sinew -n '__sinew_in "smooth"' -l fps -x -d 'Clip frames per second (30)'
complete -c sinew -n '__sinew_in "smooth"' -l depth -x -d 'Every triangle becomes N x N, in place of the rig\'s detail, even detail that follows the size on screen'
complete -c sinew -n '__sinew_in "smooth"' -l detail -x -a 'adaptive uniform' -d 'adaptive (as fine as the tolerance asks for) or uniform (the depth everywhere)'
complete -c sinew -n '__sinew_in "smooth"' -l tolerance -x -d 'Adaptive: how far triangles may lie off the surface, fraction of the height (0.001)'
complete -c sinew -n '__sinew_in "smooth"' -l mode -x -a 'swell replace' -d 'swell (the skin rises over the muscles) or replace (the paper\'s method)'
complete -c sinew -n '__sinew_in "smooth"' -l patch -x -a 'pn phong spherigon flat' -d 'Curved patch over each triangle: pn, phong, spherigon or flat'
complete -c sinew -n '__sinew_in "smooth"' -l crease -x -d 'Shade faces that meet at more than this angle apart; 180: smooth everywhere'
complete -c sinew -n '__sinew_in "smooth"' -l shape -x -d 'Weight of a shape (morph target) in place of the rig\'s, -10 to 10; once for each'
complete -c sinew -n '__sinew_in "smooth"' -l projection -x -a 'newton bisection analytic' -d 'How roots are found: newton, or to compare, by the slow reference, the paper\'s bisection or analytic'
complete -c sinew -n '__sinew_in "smooth"' -s o -l output -x -a '(__sinew_files obj ply glb)' -d 'Surface to write: .obj, .ply or .glb'
complete -c sinew -n '__sinew_in "smooth"' -l report -x -a '(__sinew_files json)' -d 'Counts, class sizes, residuals and seconds as JSON'
complete -c sinew -n '__sinew_in "smooth"' -l list -x -a '(__sinew_files )' -d 'Instead of FILE: a text file, one input per line, or - for stdin; {name} in OUT is its name'
complete -c sinew -n '__sinew_in "smooth"' -l shard -x -d 'Make part I of N, 0 to N-1; auto: from the Slurm or Grid Engine array job'
complete -c sinew -n '__sinew_in "smooth"' -l resume -d 'Skip files that exist already: files appear whole or not at all'
complete -c sinew -n '__sinew_in "smooth"' -l dry-run -d 'Print the names of the files, and make none'
complete -c sinew -n '__sinew_in "smooth"' -l threads -x -d 'Work on N cores at most; without it, on all; the files are the same'
complete -c sinew -n '__sinew_in "smooth"' -l progress -d 'Report progress on stderr every 5 percent; a terminal always shows it'
complete -c sinew -n '__sinew_in "export"' -a '(__sinew_files glb gltf vrm rig.json)'
complete -c sinew -n '__sinew_in "export"' -s h -l help -d 'Print this and exit'
complete -c sinew -n '__sinew_in "export"' -l as -x -a 'helpers skinned baked' -d 'helpers: with joints that move as the muscles do, keyed in every clip (default); skinned: the file\'s joints alone, muscles at rest; baked: one clip as it is, in morph targets (.glb, .gltf) or points (.usda; .pc2 or .mdd, a cache beside an .obj)'
complete -c sinew -n '__sinew_in "export"' -l clips -x -a '(__sinew_files glb gltf)' -d 'Add the clips of this file (.glb, .gltf, .vrm), with a mesh or without; once for each'
complete -c sinew -n '__sinew_in "export"' -l mesh -x -a 'refined original' -d 'refined, or original: the file\'s own vertices, in its order'
complete -c sinew -n '__sinew_in "export"' -l depth -x -d 'Every triangle becomes N x N, in place of the rig\'s detail, even detail that follows the size on screen'
complete -c sinew -n '__sinew_in "export"' -l detail -x -a 'adaptive uniform' -d 'adaptive (as fine as the tolerance asks for) or uniform (the depth everywhere)'
complete -c sinew -n '__sinew_in "export"' -l tolerance -x -d 'Adaptive: how far triangles may lie off the surface, fraction of the height (0.001)'
complete -c sinew -n '__sinew_in "export"' -l weights -x -a 'refitted transferred' -d 'refitted to the muscles\' surface over the clips and the range of motion, or transferred from the file'
complete -c sinew -n '__sinew_in "export"' -l clip -x -d 'Keep this clip; may be given several times; without it, all are kept'
complete -c sinew -n '__sinew_in "export"' -l joints -x -d 'helpers: how many joints may be added (24), for muscle lines or rigid, whichever serve best'
complete -c sinew -n '__sinew_in "export"' -l joint-scale -x -a 'full uniform none' -d 'helpers: how joints of muscle lines may scale: full, uniform, or none (two joints a line)'
complete -c sinew -n '__sinew_in "export"' -l fps -x -d 'baked: frames per second (30), and one at the clip\'s end'
complete -c sinew -n '__sinew_in "export"' -l substeps -x -d 'baked: samples per frame (1); more hold the bound between frames, too'
complete -c sinew -n '__sinew_in "export"' -l bound -x -d 'baked: how far any vertex may be off in any frame, percent of the height (0.1)'
complete -c sinew -n '__sinew_in "export"' -l json -d 'Report as JSON'
complete -c sinew -n '__sinew_in "export"' -l error-map -x -a '(__sinew_files ply)' -d 'The exported mesh at rest, each vertex with its largest distance to the live surface as color and number'
complete -c sinew -n '__sinew_in "export"' -s o -l output -x -a '(__sinew_files glb gltf usda pc2 mdd)' -d 'File to write: .glb, .gltf or .usda; baked: .glb, .gltf, .usda, .pc2 or .mdd'
complete -c sinew -n '__sinew_in "export"' -l list -x -a '(__sinew_files )' -d 'Instead of FILE: a text file, one input per line, or - for stdin; {name} in OUT is its name'
complete -c sinew -n '__sinew_in "export"' -l shard -x -d 'Make part I of N, 0 to N-1; auto: from the Slurm or Grid Engine array job'
complete -c sinew -n '__sinew_in "export"' -l resume -d 'Skip files that exist already: files appear whole or not at all'
complete -c sinew -n '__sinew_in "export"' -l dry-run -d 'Print the names of the files, and make none'
complete -c sinew -n '__sinew_in "export"' -l threads -x -d 'Work on N cores at most; without it, on all; the files are the same'
complete -c sinew -n '__sinew_in "export"' -l progress -d 'Report progress on stderr every 5 percent; a terminal always shows it'
complete -c sinew -n '__sinew_in "pack"' -a '(__sinew_files glb gltf vrm rig.json)'
complete -c sinew -n '__sinew_in "pack"' -s h -l help -d 'Print this and exit'
complete -c sinew -n '__sinew_in "pack"' -s o -l output -x -a '(__sinew_files sinew)' -d 'File to write (.sinew)'
complete -c sinew -n '__sinew_in "pack"' -l depth -x -d 'Every triangle becomes N x N, in place of the rig\'s detail, even detail that follows the size on screen'
complete -c sinew -n '__sinew_in "pack"' -l detail -x -a 'adaptive uniform' -d 'adaptive (as fine as the tolerance asks for) or uniform (the depth everywhere)'
complete -c sinew -n '__sinew_in "pack"' -l tolerance -x -d 'Adaptive: how far triangles may lie off the surface, fraction of the height (0.001)'
complete -c sinew -n '__sinew_in "render"' -a '(__sinew_files glb gltf vrm rig.json)'
complete -c sinew -n '__sinew_in "render"' -s h -l help -d 'Print this and exit'
complete -c sinew -n '__sinew_in "render"' -l clips -x -a '(__sinew_files glb gltf)' -d 'Add the clips of this file (.glb, .gltf, .vrm), with a mesh or without; once for each'
complete -c sinew -n '__sinew_in "render"' -l clip -x -d 'Pose from this clip, or "Range of motion", made from the joints; without any of these, the bind pose'
complete -c sinew -n '__sinew_in "render"' -l time -x -d 'Seconds into the clip (of the first, if none is named)'
complete -c sinew -n '__sinew_in "render"' -l frames -x -d 'One file per clip frame from A to B, both included, or every STEPth'
complete -c sinew -n '__sinew_in "render"' -l fps -x -d 'Clip frames per second (30)'
complete -c sinew -n '__sinew_in "render"' -l turntable -x -d 'Go around the character in N pictures, of one moment or with --frames as the clip plays'
complete -c sinew -n '__sinew_in "render"' -l sheet -x -d 'One picture of C columns and R rows, each as large as --size: of the frames, the turntable, the whole clip, or from all sides'
complete -c sinew -n '__sinew_in "render"' -l view -x -a 'front back left right top bottom three-quarter' -d 'front, back, left, right, top, bottom, three-quarter, or YAW,PITCH in degrees'
complete -c sinew -n '__sinew_in "render"' -l orthographic -d 'Orthographic: no perspective'
complete -c sinew -n '__sinew_in "render"' -l shading -x -a 'textured clay classes heat' -d 'textured, clay, classes (implicit, straddling, normal) or heat (displacement)'
complete -c sinew -n '__sinew_in "render"' -l show -x -a 'muscles skeleton primitives influence wire control anchors classes relief' -d 'Any of muscles (flesh under glass), skeleton, primitives, influence, wire, control, anchors, classes, relief (normal maps on clay)'
complete -c sinew -n '__sinew_in "render"' -l glass -x -d 'With --show muscles: how clear the skin is, 0 to 1 (0.8)'
complete -c sinew -n '__sinew_in "render"' -l surface -l no-surface -d 'The smoothed surface (on)'
complete -c sinew -n '__sinew_in "render"' -l ground -l no-ground -d 'Grid and shadow (on)'
complete -c sinew -n '__sinew_in "render"' -l on -x -a 'processor gpu' -d 'Compute the surface on the processor or, with gpu, on the graphics card (processor)'
complete -c sinew -n '__sinew_in "render"' -l transparent -d 'No background: an alpha channel instead'
complete -c sinew -n '__sinew_in "render"' -l light -x -d 'studio, outdoor, rim or white (studio)'
complete -c sinew -n '__sinew_in "render"' -l background -x -d 'studio, dark, mid, light, gradient or checker (studio)'
complete -c sinew -n '__sinew_in "render"' -l ao -d 'Ambient occlusion: crevices and folds are darker'
complete -c sinew -n '__sinew_in "render"' -l size -x -d 'Pixels, each 16 to 8192 (1280x800)'
complete -c sinew -n '__sinew_in "render"' -l samples -x -d 'Samples per pixel, at most what the driver offers; 4 or 16 with --ao; above 4, 16 with --show muscles (4)'
complete -c sinew -n '__sinew_in "render"' -l depth -x -d 'Every triangle becomes N x N, in place of the rig\'s detail, even detail that follows the size on screen'
complete -c sinew -n '__sinew_in "render"' -l detail -x -a 'adaptive uniform' -d 'adaptive (as fine as the tolerance asks for) or uniform (the depth everywhere)'
complete -c sinew -n '__sinew_in "render"' -l tolerance -x -d 'Adaptive: how far triangles may lie off the surface, fraction of the height (0.001)'
complete -c sinew -n '__sinew_in "render"' -l mode -x -a 'swell replace' -d 'swell (the skin rises over the muscles) or replace (the paper\'s method)'
complete -c sinew -n '__sinew_in "render"' -l patch -x -a 'pn phong spherigon flat' -d 'Curved patch over each triangle: pn, phong, spherigon or flat'
complete -c sinew -n '__sinew_in "render"' -l crease -x -d 'Shade faces that meet at more than this angle apart; 180: smooth everywhere'
complete -c sinew -n '__sinew_in "render"' -l shape -x -d 'Weight of a shape (morph target) in place of the rig\'s, -10 to 10; once for each'
complete -c sinew -n '__sinew_in "render"' -s o -l output -x -a '(__sinew_files png webp gif mp4)' -d 'Picture to write: OUT.png, OUT_%04d.png with --frames or --turntable, or all of them as one moving picture, OUT.webp, or OUT.gif or OUT.mp4 where ffmpeg is installed'
complete -c sinew -n '__sinew_in "render"' -l list -x -a '(__sinew_files )' -d 'Instead of FILE: a text file, one input per line, or - for stdin; {name} in OUT is its name'
complete -c sinew -n '__sinew_in "render"' -l shard -x -d 'Make part I of N, 0 to N-1; auto: from the Slurm or Grid Engine array job'
complete -c sinew -n '__sinew_in "render"' -l resume -d 'Skip files that exist already: files appear whole or not at all'
complete -c sinew -n '__sinew_in "render"' -l dry-run -d 'Print the names of the files, and make none'
complete -c sinew -n '__sinew_in "render"' -l threads -x -d 'Work on N cores at most; without it, on all; the files are the same'
complete -c sinew -n '__sinew_in "render"' -l progress -d 'Report progress on stderr every 5 percent; a terminal always shows it'
complete -c sinew -n '__sinew_in "farm"' -s h -l help -d 'Print this and exit'
complete -c sinew -n '__sinew_in "farm"' -l to -x -a 'slurm parallel openjd commands' -d 'slurm (sbatch), parallel (GNU parallel), openjd (Deadline), commands (a line each)'
complete -c sinew -n '__sinew_in "farm"' -l tasks -x -d 'How many tasks share the work (16), no more than there are files'
complete -c sinew -n '__sinew_in "farm"' -l program -x -d 'What the machines call this program; without it, its path here'
complete -c sinew -n '__sinew_in "farm"' -l job -x -a '(__sinew_files )' -d 'Write the job here, not to stdout'
complete -c sinew -n '__sinew_in "bench"' -a '(__sinew_files glb gltf vrm rig.json)'
complete -c sinew -n '__sinew_in "bench"' -s h -l help -d 'Print this and exit'
complete -c sinew -n '__sinew_in "bench"' -l json -x -a '(__sinew_files json)' -d 'Print JSON, for programs; or write it to FILE.json beside the table'
complete -c sinew -n '__sinew_in "bench"' -l rounds -x -d 'Times everything is timed (7)'
complete -c sinew -n '__sinew_in "bench"' -l crowd -x -d 'With gpu: bodies, each in a moment of its own (1000; none where there is no graphics card)'
complete -c sinew -n '__sinew_in "bench"' -l frames -x -d 'With gpu: moments of the first clip (10)'
complete -c sinew -n '__sinew_in "bench"' -l progress -d 'Report progress on stderr every 5 percent; a terminal always shows it'
