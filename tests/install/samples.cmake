# tests/install/samples.cmake: what the samples of examples/cpp say of bundled characters. Included by install_test.cmake.
set(samples ${WORK}/samples)
run(${samples}/smooth_pose ${ASSETS}/humanoid.rig.json Walk 0.4 ${WORK}/walk.ply)
expect_match("${output}" "walk.ply: [1-9][0-9]+ vertices, [1-9][0-9]+ triangles")
file(READ ${WORK}/walk.ply head LIMIT 40)
expect_match("${head}" "^ply\nformat binary_little_endian")
run_failing(1 ${samples}/smooth_pose ${ASSETS}/humanoid.rig.json Swim 0.4 ${WORK}/swim.ply)
expect_match("${output}" "Swim: the character has no clip of this name")

run(${samples}/play_clip ${ASSETS}/horse.rig.json Walk 5)
string(REGEX MATCHALL "frame [0-9]+, [0-9.]+ s: [1-9][0-9]+ vertices" frames "${output}")
list(LENGTH frames count)
if(NOT count EQUAL 6)  # 1.1 s of clip at 5 frames a second.
  message(FATAL_ERROR "${count} frames, expected 6:\n${output}")
endif()

run(${samples}/crowd ${ASSETS}/demo.rig.json Walk 20)
expect_match("${output}" "^20 surfaces of [1-9][0-9]+ vertices, on [1-9][0-9]* threads: [0-9.]+ ms each\non one thread: the same bits\n$")

# A folder: what is wrong with one file is said, and the others are made.
file(MAKE_DIRECTORY ${WORK}/rigs)
file(COPY ${ASSETS}/demo.glb ${ASSETS}/demo.rig.json ${ASSETS}/horse.glb ${ASSETS}/horse.rig.json DESTINATION ${WORK}/rigs)
run(${samples}/batch ${WORK}/rigs ${WORK}/meshes)
expect_match("${output}" "^demo.ply: [A-Za-z]+, [1-9][0-9]* muscles, [1-9][0-9]+ vertices\nhorse.ply: [^\n]* vertices\n2 of 2 rigs\n$")
file(WRITE ${WORK}/rigs/broken.rig.json "{}")
run_failing(1 ${samples}/batch ${WORK}/rigs ${WORK}/meshes)
expect_match("${output}" "broken.rig.json: .*2 of 3 rigs")
run_failing(1 ${samples}/batch ${WORK}/nowhere ${WORK}/meshes)
expect_match("${output}" "nowhere: No such file")

# What one writes another one reads; a broken copy is refused with its place.
run(${samples}/make_rig ${ASSETS}/humanoid.glb ${WORK}/arms.rig.json)
expect_match("${output}" "arms.rig.json: 2 muscles")
run(${samples}/facts ${WORK}/arms.rig.json)
expect_match("${output}" "^humanoid: [1-9][0-9]+ vertices, .*clip \"Walk\".*\n2 muscles, 0 lines, 1 groups, mode swell\n$")
file(READ ${WORK}/arms.rig.json rig)
string(REPLACE "\"depth\": 3" "\"depth\": 99" rig "${rig}")
file(WRITE ${WORK}/broken.rig.json "${rig}")
run_failing(1 ${samples}/facts ${WORK}/broken.rig.json)
expect_match("${output}" "file: [^\n]*broken.rig.json\nplace: smoothing.depth\nreason: [^\n]*got 99\n")
