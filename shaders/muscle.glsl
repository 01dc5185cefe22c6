// shaders/muscle.glsl: what the vertices of bellies and tendons tell muscle.frag.
out vec3 world;
out vec3 shapeNormal;
out vec3 around;       // World: the way of a growing angle around the muscle.
out vec3 inMuscle;     // x, z: the direction around it; y: along it, in half lengths of the belly from its middle.
flat out vec4 fibres;  // Activation 0..1, strands around, how oval the section is (-1..1), a number of its own 0..1.
flat out float glow;   // 0..1
